/// @file
/// Velocity ratio control: the wanted direction of motion is a ratio of the brakes' rates; who is too fast is
/// braked.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/laws/rivals/intended_rates.hpp>
#include <passive_haptics/control/laws/rivals/touch_margin.hpp>
#include <passive_haptics/control/ways/torque_law.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/desired_force.hpp>

#include <algorithm>
#include <limits>

namespace passive_haptics {

/// Constants of velocity_ratio_control.
struct velocity_ratio_parameters {
  double reference_depth = 1e-3;   ///< In the wall, to which the wanted direction leads [m].
  double approach_length = 10e-3;  ///< Depth error for a slope of 1 of the wanted direction [m].
  double steepest_slope = 0.2;     ///< Of the wanted direction against the wall [1].
  double gain = 1;                 ///< Share of the torque limit for each share that a brake is too fast [1].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = velocity_ratio_parameters;
    return member_table(member("reference_depth", &p::reference_depth, "m", range::finite),
                        member("approach_length", &p::approach_length, "m", range::positive),
                        member("steepest_slope", &p::steepest_slope, "1", range::not_negative),
                        member("gain", &p::gain, "1", range::not_negative));
  }
};

/// The wanted velocity keeps the part of v along the wall, v_t, and leads to the reference depth:
///
///     v* = v_t + clip((depth - reference_depth) / approach_length, +-steepest_slope) |v_t| n,   w* = E^+ v*.
///
/// Of the brakes that turn the right way the slowest against w* sets the common factor, lambda = min w_i /
/// w*_i; the others are too fast by the share 1 - lambda w*_i / w_i, those that turn the wrong way by 1. Each
/// is braked in proportion to it:
///
///     t_i = -s_i limit_i min(1, gain share_i).
///
/// A brake cannot be sped up, so the whole device is slowed by its slowest brake, which is free. A hand that
/// presses without moving along sinks with it: by 7 to 37 mm in 1 s in simulations. For as many brakes as
/// joints. Of several contacts the one that demands the largest force governs. Needs the hand force (which
/// way a brake at rest would turn); cost: one orthogonal decomposition of d x m.
///
/// Reference: Book, Charles, Davis, Gomes, The concept and implementation of a passive trajectory enhancing
/// robot, ASME Dynamic Systems and Control Division, 1996, 633-638; Davis and Book, Torque control of a
/// redundantly actuated passive manipulator, American Control Conference, 1997, 959-963. Both as the paper
/// describes them. Assumed: the reference depth, the correction towards it, a braking that is proportional to
/// the share (so that it has no unit), E^+ for more joints than task dimensions.
struct velocity_ratio_control {
  static constexpr bool needs_hand_force = true;    ///< Needs a force sensor at the handle.
  static constexpr bool commands_torques = true;    ///< It is a TorqueLaw.
  static constexpr bool needs_sensed_at = true;     ///< Carries a held contact on to where the handle is.
  static constexpr bool needs_torque_limit = true;  ///< As the capacity of a locked brake.

  velocity_ratio_parameters parameters = {};  ///< The constants.

  /// Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B&) const noexcept {
    return touch_margin;
  }

  /// Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  brake_vector<M> torque(const brake_situation<M, EMatrix, B>& device,
                         const contacts<D, Capacity>& touched) const noexcept {
    using T = typename M::scalar;
    static_assert(M::brake_count == M::dof,
                  "passive_haptics: velocity_ratio_control needs brake_count == dof.");
    const contact<D> c = carried_to(device.x, touched[governing_contact(touched)]);
    if (c.depth <= 0) return brake_vector<M>::Zero();
    const brake_vector<M> w = intended_rates(device), wanted = wanted_rates(device, c, w);

    T slowest = std::numeric_limits<T>::infinity();  // lambda
    unrolled<M::brake_count>([&](auto i) {
      if (sgn(w[i]) * wanted[i] > T(0)) slowest = std::min(slowest, w[i] / wanted[i]);
    });
    brake_vector<M> t = brake_vector<M>::Zero();
    unrolled<M::brake_count>([&](auto i) {
      if (w[i] == T(0)) return;
      const bool right_way = sgn(w[i]) * wanted[i] > T(0);
      const T too_fast = right_way ? T(1) - slowest * (wanted[i] / w[i]) : T(1);
      const T share = std::clamp(static_cast<T>(parameters.gain) * too_fast, T(0), T(1));
      t[i] = holding_torque(device.s[i], share * device.brakes.torque_limit[i]);
    });
    return t;
  }

 private:
  // w* [rad/s or m/s]: w + E^+ (v* - v)
  template <class M, class EMatrix, int D, class B>
  brake_vector<M> wanted_rates(const brake_situation<M, EMatrix, B>& device, const contact<D>& c,
                               const brake_vector<M>& w) const {
    using T = typename M::scalar;
    const matrix<T, D, M::brake_count> E(device.E);
    const vector<T, D> n = as<T>(c.normal), v = E * w - as<T>(c.wall_velocity);
    const T outward = n.dot(v);
    const double slope = std::clamp((c.depth - parameters.reference_depth) / parameters.approach_length,
                                    -parameters.steepest_slope, parameters.steepest_slope);
    const T wanted_outward = static_cast<T>(slope) * length_of(v - outward * n);
    const orthogonal_decomposition<T, D, M::brake_count> inverse(E, rounding_tolerance<T>(M::brake_count));
    return w + inverse.solve((wanted_outward - outward) * n);
  }
};

}  // namespace passive_haptics
