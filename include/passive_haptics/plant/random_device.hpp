/// Random devices, hands and planes, to test laws outside the values they were tuned for.
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

/// Ranges of random devices. Ratios and ranges of more than a decade are drawn uniformly in their logarithm.
struct device_ranges {
  /// A closed interval.
  struct interval {
    double low;   ///< Minimum.
    double high;  ///< Maximum.
  };
  interval gain{0.7, 1.3};                    ///< Per brake [1].
  interval residual_torque{0, 0.050};         ///< Per brake [N m].
  interval rise_time_constant{0.002, 0.040};  ///< All brakes [s].
  interval fall_ratio{0.25, 4};         ///< All brakes [1]; the fall is limited to the range of the rise.
  interval torque_limit{0.3, 2};        ///< All brakes [N m].
  interval inertia{0.3, 3};             ///< Of links and rotors, relative to the nominal device [1].
  interval sensor_scale{0.6, 1.5};      ///< Force sensor [1].
  interval encoder_counts{1000, 8192};  ///< Per turn.
  interval hand_speed{0.02, 0.4};  ///< Along the wall [m/s], limited so that the path takes at least 0.25 s.
  interval push{0.5, 6};           ///< Into the wall at its surface [N].
  interval target_depth{0.005, 0.030};            ///< For every second hand, an impedance [m].
  interval normal_damping{12, 30};                ///< For those hands [N s/m]; 20 for the others.
  interval hand_mass{0.1, 1.5};                   ///< [kg]
  interval wall_stiffness{200, 1e7};              ///< [N/m]
  interval gap{0.002, 0.006};                     ///< Distance from the wall at the start [m].
  interval approach{0.05, 0.12};                  ///< Speed into the wall at the start [m/s].
  double sensor_noise = 0.02;                     ///< Standard deviation [N].
  double environment_rates[3] = {1000, 200, 20};  ///< Candidates [Hz].
};

/// A device, a hand and a plane to follow.
template <class M>
struct random_device {
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  double inertia;                          ///< Of links and rotors, relative to the nominal device.
  brake_models_of<M> brakes;               ///< Actual brakes.
  brakes_of<M> known_brakes;               ///< Brakes as in a data sheet: limit and rise.
  random_plane<M> plane;                   ///< Start and path.
  following_hand_parameters<scalar> hand;  ///< Hand.
  wall_following_parameters run;           ///< Sensors, length and time of the path.
  double environment_rate;                 ///< [Hz]
  double wall_stiffness;                   ///< [N/m]
};

/// Returns device number k of this seed, equal on every platform. Along the path the condition of J is at
/// most workspace::max_condition and the elbow stays on one side. At the start some brake pulls within 80
/// degrees of the normal. All brakes of a device have one lag and one limit. A run ends at a depth of 50 mm.
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
  // Torque of a rotating brake, or force of a sliding one
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
    brake.torque_limit *= brake.gain;  // the gain also scales the torque at full current
  }

  const double push = even(r.push);
  const bool impedance = uniform_number(bits) < 0.5;
  const double depth = even(r.target_depth), damping = even(r.normal_damping);
  constexpr double min_time = 0.25;  // along the path [s], so that a fast hand can land at all
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
