/// @file
/// Single-degree-of-freedom control: one brake is locked, and the handle follows its path.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/laws/contact_memory.hpp>
#include <passive_haptics/control/laws/rivals/intended_rates.hpp>
#include <passive_haptics/control/laws/rivals/touch_margin.hpp>
#include <passive_haptics/control/ways/torque_law.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/desired_force.hpp>

#include <cmath>

namespace passive_haptics {

/// Constants of single_degree_of_freedom_control.
struct single_degree_of_freedom_parameters {
  double reference_depth = 1e-3;  ///< In the wall, that the handle follows [m].
  double band = 0.3e-3;           ///< Half width of the band about it, in which the locked brake is kept [m].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = single_degree_of_freedom_parameters;
    return member_table(member("reference_depth", &p::reference_depth, "m", range::finite),
                        member("band", &p::band, "m", range::not_negative));
  }
};

/// Locks one brake i, so that the handle moves as the others let it: on a path in the plane,
///
///     v_i = E (w - e_i w_i / P_ii),   P = T T^+ (I for m = n),
///
/// the motion with brake i at rest that changes the brakes' rates least, m rates of n joints. With slope_i =
/// n . v_i / |v_i| and the depth error e = depth - reference_depth:
///
///   - e > band: the flattest path out, 0 <= slope_i; all brakes are locked where every path leads in;
///   - e < -band: the flattest path in, slope_i <= 0; where there is none, the flattest out;
///   - else the brake that is locked already; at first the one of the flattest path.
///
/// The handle zigzags within the band. A hand that wants to leave the wall must follow the path, too.
/// For m >= n = d >= 2: the more brakes, the more paths. In space the handle follows a surface, that of the
/// one locked brake. Of several contacts the one that demands the largest force governs. Needs the hand
/// force (which way a brake at rest would turn); cost: E w, and for m > n one T^+.
///
/// Reference: Swanson and Book, Obstacle avoidance methods for a passive haptic display, IEEE/ASME Int. Conf.
/// on Advanced Intelligent Mechatronics, 2001, 1187-1192; the band: Sakaguchi, Furusho, Takesue, Passive
/// force display using ER brakes and its control experiments, Virtual Reality 2001, 7-12. Both as the paper
/// describes them. Assumed: the reference depth, the band's width, the flattest path among several, that the
/// capacity of a locked brake is its torque limit, and for m > n which motion is left.
struct single_degree_of_freedom_control {
  static constexpr bool needs_hand_force = true;    ///< Needs a force sensor at the handle.
  static constexpr bool commands_torques = true;    ///< It is a TorqueLaw.
  static constexpr bool needs_sensed_at = true;     ///< Carries a held contact on to where the handle is.
  static constexpr bool needs_torque_limit = true;  ///< As the capacity of a locked brake.
  static constexpr int most_contacts = 8;           ///< Walls that it remembers at once.

  /// Of one wall.
  struct locked_brake {
    int brake = -1;  ///< Which is locked; < 0 for none in particular.
  };
  /// What it remembers.
  struct memory {
    contact_memory<locked_brake, most_contacts> walls;  ///< The brake locked at each.
  };

  single_degree_of_freedom_parameters parameters = {};  ///< The constants.

  /// Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B&) const noexcept {
    return touch_margin;
  }

  /// Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  brake_vector<M> torque(const brake_situation<M, EMatrix, B>& device, const contacts<D, Capacity>& touched,
                         memory& remembered) const noexcept {
    static_assert(
        M::brake_count >= M::dof && M::dof == M::task_dimension && M::dof >= 2,
        "passive_haptics: single_degree_of_freedom_control needs brake_count >= dof == task_dimension >= 2.");
    const contact<D> c = carried_to(device.x, touched[governing_contact(touched)]);
    if (c.depth <= 0) {
      remembered.walls.clear();
      return brake_vector<M>::Zero();
    }
    remembered.walls.begin_cycle(single_contact<D>{c});
    int& locked = remembered.walls[0].brake;
    locked = choose(slopes(device, c), passive_haptics::brakes_off(device.s, device.brakes),
                    c.depth - parameters.reference_depth, locked);

    brake_vector<M> t = brake_vector<M>::Zero();
    unrolled<M::brake_count>([&](auto i) {
      if (locked == i || locked == all) t[i] = holding_torque(device.s[i], device.brakes.torque_limit[i]);
    });
    return t;
  }

  /// Free space or a fault: no brake is locked.
  void released(memory& remembered, double) const noexcept { remembered.walls.clear(); }

 private:
  static constexpr int all = -2;

  // Sines of the angles at which the handle leaves the wall with brake i locked; 0 where that stops it
  template <class M, class EMatrix, int D, class B>
  static brake_vector<M> slopes(const brake_situation<M, EMatrix, B>& device, const contact<D>& c) {
    using T = typename M::scalar;
    brake_vector<M> w = intended_rates(device), share = brake_vector<M>::Ones();  // P w, P_ii
    if constexpr (M::brake_count > M::dof) {
      const transmission_matrix<M> map = passive_haptics::transmission(device.mechanism, device.q);
      const auto P = times(map, pseudo_inverse(map));
      w = P * w;
      share = P.diagonal();
    }
    const T nothing = rounding_tolerance<T>(M::brake_count) * length_of(vector<T, D>(device.E * w));
    brake_vector<M> slope;
    unrolled<M::brake_count>([&](auto i) {
      brake_vector<M> others = w;
      if (share[i] > T(0)) others[i] -= w[i] / share[i];  // else no joint turns it
      const vector<T, D> v = device.E * others - as<T>(c.wall_velocity);
      const T speed = length_of(v);
      slope[i] = speed > nothing ? as<T>(c.normal).dot(v) / speed : T(0);
    });
    return slope;
  }

  // The brake to lock, none that is off, or all
  template <class Slopes, class Off>
  int choose(const Slopes& slope, const Off& off, double error, int locked) const {
    const bool deep = error > parameters.band, shallow = error < -parameters.band;
    if (!deep && !shallow && locked >= 0 && !detail::is_off(off, locked)) return locked;
    const auto fits = [&](int i) { return deep ? slope[i] >= 0 : (!shallow || slope[i] <= 0); };
    int best = 0;
    for (int i = 1; i < slope.size(); ++i) {
      const bool flatter = std::abs(slope[i]) < std::abs(slope[best]);
      if (detail::is_off(off, i)) continue;
      if (detail::is_off(off, best)) best = i;
      else if (fits(i) == fits(best) ? flatter : fits(i)) best = i;
    }
    return deep && !fits(best) ? all : best;
  }
};

}  // namespace passive_haptics
