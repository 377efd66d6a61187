// The desired direction of motion is a ratio of brake rates; brakes that are too fast are braked.
#pragma once

#include "intended_rates.hpp"

#include <algorithm>
#include <limits>

namespace experiments {

// Constants of velocity_ratio_control.
struct velocity_ratio_parameters {
  double reference_depth = 1e-3;   // Depth to which the desired direction leads [m].
  double approach_length = 10e-3;  // Depth error for a desired slope of 1 [m].
  double max_slope = 0.2;          // Maximum desired slope [1].
  double gain = 1;                 // Share of the torque limit per share by which a brake is too fast [1].

  static constexpr auto members() {
    using p = velocity_ratio_parameters;
    return ph::member_table(ph::member("reference_depth", &p::reference_depth, "m", ph::range::finite),
                            ph::member("approach_length", &p::approach_length, "m", ph::range::positive),
                            ph::member("max_slope", &p::max_slope, "1", ph::range::not_negative),
                            ph::member("gain", &p::gain, "1", ph::range::not_negative));
  }
};

// The desired velocity keeps the part of v along the wall, v_t, and leads to the reference depth:
//
//     v* = v_t + clip((depth - reference_depth) / approach_length, +-max_slope) |v_t| n,   w* = E^+ v*.
//
// Of the brakes with the right sign, the slowest relative to w* sets the common factor, lambda = min w_i /
// w*_i; the others are too fast by the share 1 - lambda w*_i / w_i, those with the wrong sign by 1. Each is
// braked in proportion:
//
//     t_i = -s_i limit_i min(1, gain share_i).
//
// Brakes cannot accelerate, so the whole device is slowed to its slowest brake, which is free. A hand that
// presses without moving along sinks with it: by 7 to 37 mm in 1 s in simulations. For as many brakes as
// joints. Of several contacts the one with the maximum desired force counts. Uses the hand force (for the
// direction of a brake at rest). Cost: one orthogonal decomposition of d x m.
//
// Reference: Book, Charles, Davis, Gomes, The concept and implementation of a passive trajectory enhancing
// robot, ASME Dynamic Systems and Control Division, 1996, 633-638; Davis and Book, Torque control of a
// redundantly actuated passive manipulator, American Control Conference, 1997, 959-963. Both as described by
// the paper. Assumed: the reference depth, the correction towards it, braking in proportion to the share (so
// that it has no unit), E^+ for more joints than task dimensions.
struct velocity_ratio_control {
  static constexpr bool needs_hand_force = true;  // Requires a force sensor at the handle.
  static constexpr bool commands_torques = true;  // A TorqueLaw.
  static constexpr bool needs_sensed_at = true;   // Extrapolates held contacts.

  velocity_ratio_parameters parameters = {};

  // Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B&) const noexcept {
    return ph::touch_margin;
  }

  // Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& device,
                             const ph::contacts<D, Capacity>& touched) const noexcept {
    using T = typename M::scalar;
    static_assert(M::brake_count == M::dof, "velocity_ratio_control needs brake_count == dof");
    const ph::contact<D> c = ph::carried_to(device.x, touched[ph::governing_contact(touched)]);
    if (c.depth <= 0) return ph::brake_vector<M>::Zero();
    const ph::brake_vector<M> w = intended_rates(device), wanted = wanted_rates(device, c, w);

    T slowest = std::numeric_limits<T>::infinity();  // lambda
    ph::unrolled<M::brake_count>([&](auto i) {
      if (ph::sgn(w[i]) * wanted[i] > T(0)) slowest = std::min(slowest, w[i] / wanted[i]);
    });
    ph::brake_vector<M> t = ph::brake_vector<M>::Zero();
    ph::unrolled<M::brake_count>([&](auto i) {
      if (w[i] == T(0)) return;
      const bool right_way = ph::sgn(w[i]) * wanted[i] > T(0);
      const T too_fast = right_way ? T(1) - slowest * (wanted[i] / w[i]) : T(1);
      const T share = std::clamp(static_cast<T>(parameters.gain) * too_fast, T(0), T(1));
      t[i] = holding_torque(device.s[i], share * device.brakes.torque_limit[i]);
    });
    return t;
  }

 private:
  // w* [rad/s or m/s]: w + E^+ (v* - v)
  template <class M, class EMatrix, int D, class B>
  ph::brake_vector<M> wanted_rates(const ph::brake_situation<M, EMatrix, B>& device, const ph::contact<D>& c,
                                   const ph::brake_vector<M>& w) const {
    using T = typename M::scalar;
    const ph::matrix<T, D, M::brake_count> E(device.E);
    const ph::vector<T, D> n = ph::as<T>(c.normal), v = E * w - ph::as<T>(c.wall_velocity);
    const T outward = n.dot(v);
    const double slope = std::clamp((c.depth - parameters.reference_depth) / parameters.approach_length,
                                    -parameters.max_slope, parameters.max_slope);
    const T wanted_outward = static_cast<T>(slope) * ph::length_of(ph::vector<T, D>(v - outward * n));
    const ph::orthogonal_decomposition<T, D, M::brake_count> inverse(
        E, ph::rounding_tolerance<T>(M::brake_count));
    return w + inverse.solve((wanted_outward - outward) * n);
  }
};

}  // namespace experiments
