// Locks one brake, so that the handle follows its path.
#pragma once

#include "intended_rates.hpp"

#include <cmath>

namespace experiments {

// Constants of single_degree_of_freedom_control.
struct single_degree_of_freedom_parameters {
  double reference_depth = 1e-3;  // Depth that the handle follows [m].
  double band = 0.3e-3;           // Half width of the depth band in which the locked brake is kept [m].

  static constexpr auto members() {
    using p = single_degree_of_freedom_parameters;
    return ph::member_table(ph::member("reference_depth", &p::reference_depth, "m", ph::range::finite),
                            ph::member("band", &p::band, "m", ph::range::not_negative));
  }
};

// Locks one brake i, so that the others allow motion on a planar path,
//
//     v_i = E (w - e_i w_i).
//
// With slope_i = n . v_i / |v_i| and the depth error e = depth - reference_depth:
//
//   - e > band: the flattest path out, 0 <= slope_i; all brakes are locked if every path leads in;
//   - e < -band: the flattest path in, slope_i <= 0; if there is none, the flattest out;
//   - else the brake that is already locked; at first that of the flattest path.
//
// The handle zigzags within the band. A hand that leaves the wall must follow the path, too. For m = n = d >=
// 2. Spatial handles follow a surface, that of the locked brake. Of several contacts the one with the maximum
// desired force counts. Uses the hand force (for the direction of a brake at rest). Cost: E w.
//
// Reference: Swanson and Book, Obstacle avoidance methods for a passive haptic display, IEEE/ASME Int. Conf.
// on Advanced Intelligent Mechatronics, 2001, 1187-1192; the band: Sakaguchi, Furusho, Takesue, Passive force
// display using ER brakes and its control experiments, Virtual Reality 2001, 7-12. Both as described by the
// paper. Assumed: the reference depth, the band's width, the flattest path among several, a capacity of a
// locked brake equal to its torque limit.
struct single_degree_of_freedom_control {
  static constexpr bool needs_hand_force = true;  // Requires a force sensor at the handle.
  static constexpr bool commands_torques = true;  // A TorqueLaw.
  static constexpr bool needs_sensed_at = true;   // Extrapolates held contacts.
  static constexpr int max_contacts = 8;          // Maximum number of remembered walls.

  // State at one wall.
  struct locked_brake {
    int brake = -1;  // Locked brake; < 0 for none in particular.
  };
  struct memory {
    ph::contact_memory<locked_brake, max_contacts> walls;  // Locked brake at each wall.
  };

  single_degree_of_freedom_parameters parameters = {};

  // Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B&) const noexcept {
    return ph::touch_margin;
  }

  // Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& device,
                             const ph::contacts<D, Capacity>& touched, memory& remembered) const noexcept {
    static_assert(M::brake_count == M::dof && M::dof == M::task_dimension && M::dof >= 2,
                  "single_degree_of_freedom_control needs brake_count == dof == task_dimension >= 2");
    const ph::contact<D> c = ph::carried_to(device.x, touched[ph::governing_contact(touched)]);
    if (c.depth <= 0) {
      remembered.walls.clear();
      return ph::brake_vector<M>::Zero();
    }
    remembered.walls.begin_cycle(ph::single_contact<D>{c});
    int& locked = remembered.walls[0].brake;
    locked = choose(slopes(device, c), c.depth - parameters.reference_depth, locked);

    ph::brake_vector<M> t = ph::brake_vector<M>::Zero();
    ph::unrolled<M::brake_count>([&](auto i) {
      if (locked == i || locked == all) t[i] = holding_torque(device.s[i], device.brakes.torque_limit[i]);
    });
    return t;
  }

  // Free space or a fault: no brake is locked.
  void released(memory& remembered, double) const noexcept { remembered.walls.clear(); }

 private:
  static constexpr int all = -2;

  // Sines of the angles at which the handle leaves the wall with brake i locked; 0 if that stops it
  template <class M, class EMatrix, int D, class B>
  static ph::brake_vector<M> slopes(const ph::brake_situation<M, EMatrix, B>& device,
                                    const ph::contact<D>& c) {
    using T = typename M::scalar;
    const ph::brake_vector<M> w = intended_rates(device);
    const T nothing =
        ph::rounding_tolerance<T>(M::brake_count) * ph::length_of(ph::vector<T, D>(device.E * w));
    ph::brake_vector<M> slope;
    ph::unrolled<M::brake_count>([&](auto i) {
      ph::brake_vector<M> others = w;
      others[i] = T(0);
      const ph::vector<T, D> v = device.E * others - ph::as<T>(c.wall_velocity);
      const T speed = ph::length_of(v);
      slope[i] = speed > nothing ? ph::as<T>(c.normal).dot(v) / speed : T(0);
    });
    return slope;
  }

  // The brake to lock, or all
  template <class Slopes>
  int choose(const Slopes& slope, double error, int locked) const {
    const bool deep = error > parameters.band, shallow = error < -parameters.band;
    if (!deep && !shallow && locked >= 0) return locked;
    const auto fits = [&](int i) { return deep ? slope[i] >= 0 : (!shallow || slope[i] <= 0); };
    int best = 0;
    for (int i = 1; i < slope.size(); ++i) {
      const bool flatter = std::abs(slope[i]) < std::abs(slope[best]);
      if (fits(i) == fits(best) ? flatter : fits(i)) best = i;
    }
    return deep && !fits(best) ? all : best;
  }
};

}  // namespace experiments
