/// @file
/// Random devices, hands and planes: what a law meets that nobody tuned it for.
#pragma once

#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/random_numbers.hpp>
#include <passive_haptics/plant/random_plane.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace passive_haptics {

/// What devices may differ in from the nominal one. Ratios and what spans more than a decade are drawn evenly
/// in their logarithm.
struct device_ranges {
  /// From low to high.
  struct interval {
    double low;   ///< Least.
    double high;  ///< Most.
  };
  interval gain{0.7, 1.3};                    ///< Of each brake [1].
  interval residual_torque{0, 0.050};         ///< Of each brake [N m].
  interval rise_time_constant{0.002, 0.040};  ///< Of all brakes [s].
  interval fall_ratio{0.25, 4};         ///< Of all brakes [1]; the fall is kept within the range of the rise.
  interval torque_limit{0.3, 2};        ///< Of all brakes [N m].
  interval inertia{0.3, 3};             ///< Of links and rotors, for each kg of the nominal device [1].
  interval sensor_scale{0.6, 1.5};      ///< Of the force sensor [1].
  interval encoder_counts{1000, 8192};  ///< A turn.
  interval hand_speed{0.02, 0.4};       ///< Along the wall, but the whole way not within 0.25 s [m/s].
  interval push{0.5, 6};                ///< Into the wall at its surface [N].
  interval target_depth{0.005, 0.030};  ///< Of every second hand, which is an impedance [m].
  interval normal_damping{12, 30};      ///< Of those hands [N s/m]; of the others 20.
  interval hand_mass{0.1, 1.5};         ///< [kg]
  interval wall_stiffness{200, 1e7};    ///< [N/m]
  interval gap{0.002, 0.006};           ///< Off the wall at the start [m].
  interval approach{0.05, 0.12};        ///< Speed into the wall there [m/s].
  double sensor_noise = 0.02;           ///< Standard deviation [N].
  double environment_rates[3] = {1000, 200, 20};  ///< One of them [Hz].
};

/// A device, a hand and a plane to follow.
template <class M>
struct random_device {
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  double inertia;                          ///< Of links and rotors, for each kg of the nominal device.
  brake_models_of<M> brakes;               ///< What they really are;
  brakes_of<M> known_brakes;               ///< and what their data sheet says: limit and rise.
  random_plane<M> plane;                   ///< Where it starts and goes.
  following_hand_parameters<scalar> hand;  ///< The hand.
  wall_following_parameters run;           ///< Sensors, length and time of the path.
  double environment_rate;                 ///< [Hz]
  double wall_stiffness;                   ///< [N/m]
};

/// Device number k of this seed, equal on every platform.
///
/// Not drawn: along the whole way the condition of J is at most 8 (workspace::max_condition) and the elbow
/// stays on one side. At its start some brake pulls within 80 degrees of the normal
/// (workspace::min_cosine). All brakes of a device have one lag and one limit. A run ends where the hand is
/// 50 mm deep.
template <class M>
random_device<M> draw_device(const M& nominal, const workspace<M>& where, std::uint64_t seed, std::uint64_t k,
                             const device_ranges& r = {}) {
  using T = typename M::scalar;
  using interval = device_ranges::interval;
  std::mt19937_64 bits = random_bits(seed, k);
  const auto even = [&](const interval& i) { return i.low + (i.high - i.low) * uniform_number(bits); };
  const auto ratio = [&](const interval& i) {
    return i.low * std::pow(i.high / i.low, uniform_number(bits));
  };

  random_device<M> d{};
  d.inertia = ratio(r.inertia);
  // A torque on a turning brake, or a force on a sliding one
  const T per_torque = T(1) / static_cast<T>(where.brake_radius);
  const double rise = ratio(r.rise_time_constant);
  const double fall =
      std::clamp(rise * ratio(r.fall_ratio), r.rise_time_constant.low, r.rise_time_constant.high);
  const T limit = per_torque * static_cast<T>(ratio(r.torque_limit));
  d.known_brakes.torque_limit.setConstant(limit);
  d.known_brakes.time_constant.setConstant(static_cast<T>(rise));
  d.known_brakes.rate_dead_band /= per_torque;
  d.brakes = ideal_brakes(d.known_brakes);
  for (coulomb_brake<T>& brake : d.brakes) {
    brake.fall_ratio = static_cast<T>(fall / rise);
    brake.gain = static_cast<T>(even(r.gain));
    brake.residual.strength = per_torque * static_cast<T>(even(r.residual_torque));
    brake.torque_limit *= brake.gain;  // a gain scales what a brake makes of its full current, too
  }

  const double push = even(r.push);
  const bool impedance = uniform_number(bits) < 0.5;
  const double depth = even(r.target_depth), damping = even(r.normal_damping);
  constexpr double min_time = 0.25;  // along the way [s], so that a hand in a hurry can land at all
  d.hand.speed = static_cast<T>(std::min(ratio(r.hand_speed), where.path_length / min_time));
  d.hand.mass = static_cast<T>(ratio(r.hand_mass));
  d.hand.push = static_cast<T>(impedance ? 0 : push);
  if (impedance) {
    d.hand.normal_stiffness = static_cast<T>(push / depth);
    d.hand.target_depth = static_cast<T>(depth);
    d.hand.normal_damping = static_cast<T>(damping);
  }

  d.run.sensor_scale = ratio(r.sensor_scale);
  d.run.sensor_noise = r.sensor_noise;
  d.run.noise_seed = seed + k;
  d.run.encoder_resolution = 2 * std::numbers::pi / ratio(r.encoder_counts) * where.brake_radius;
  d.run.max_depth = 0.05;
  d.run.max_duration = 1 + 2 * where.path_length / static_cast<double>(d.hand.speed);
  d.environment_rate = r.environment_rates[std::min(2, static_cast<int>(3 * uniform_number(bits)))];
  d.wall_stiffness = ratio(r.wall_stiffness);
  const double gap = even(r.gap), approach = even(r.approach);
  d.plane = draw_plane(nominal, where, static_cast<double>(d.hand.speed), gap, approach, bits);
  d.run.path_end = static_cast<double>(d.plane.direction.dot(d.plane.start)) + where.path_length;
  return d;
}

}  // namespace passive_haptics
