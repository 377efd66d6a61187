// Brakes that are locked or free turn the handle towards a wanted direction of motion.
#pragma once

#include "intended_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace experiments {

// Constants of bang_bang_control.
struct bang_bang_parameters {
  double reference_depth = 1e-3;      // In the wall, to which the wanted direction leads [m].
  double approach_length = 2e-3;      // Depth error for a slope of 1 of the wanted direction [m].
  double approach_slope = 0.7;        // Of the wanted direction, far from the reference depth [1].
  double approach_hysteresis = 0.6;   // Error of the slope at which a turn begins, far from it [1],
  double following_hysteresis = 0.6;  // and near it.

  // The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = bang_bang_parameters;
    return ph::member_table(
        ph::member("reference_depth", &p::reference_depth, "m", ph::range::finite),
        ph::member("approach_length", &p::approach_length, "m", ph::range::positive),
        ph::member("approach_slope", &p::approach_slope, "1", ph::range::not_negative),
        ph::member("approach_hysteresis", &p::approach_hysteresis, "1", ph::range::not_negative),
        ph::member("following_hysteresis", &p::following_hysteresis, "1", ph::range::not_negative));
  }
};

// The slope of the motion, n . v / |v| against the wall, is compared with a wanted one, constant far from
// the reference depth and proportional to the depth error e = depth - reference_depth near it:
//
//     error = clip(e / approach_length, +-approach_slope) - n . v / |v|.
//
// One of three states: straight on, all brakes free; turn out of the wall from error > h, turn into it from
// error < -h, each until the error has changed its sign. h is approach_hysteresis where the wanted slope is
// clipped, else following_hysteresis. A turn out locks each brake that moves the handle in, w_i (E^T n)_i <
// 0, a turn in each that moves it out; a brake so locked stays locked for the turn.
//
// For any mechanism. Needs nothing but the state; at rest there is no direction, and all brakes are free: a
// hand that presses without moving along sinks. A hand that wants to leave is turned in, too. Of several
// contacts the one that demands the largest force governs. Cost: E^T n.
//
// Reference: Divan, Fontanelli, Palopoli, Hybrid feedback path following for robotic walkers via bang-bang
// control actions, arXiv 1603.00295, 2016 (four actions of two brakes, far away a fixed angle of approach,
// near the path one that depends on the state); Andreetto, Divan, Fontanelli, Palopoli, Passive robotic
// walker path following with bang-bang hybrid control paradigm, IEEE/RSJ Int. Conf. on Intelligent Robots
// and Systems, 2016 (three states, two independent hystereses, no force sensor). Their abstracts. Assumed:
// the path is the surface at the reference depth; which brakes turn a device that is no walker; slopes for
// angles; when a turn ends; all constants. They prove convergence for a walker, which goes forward and turns
// with a fixed radius as soon as it brakes. That proof does not reach a device with inertia and lag.
struct bang_bang_control {
  static constexpr bool commands_torques = true;  // It is a TorqueLaw.
  static constexpr bool needs_sensed_at = true;   // Carries a held contact on to where the handle is.
  static constexpr int max_contacts = 8;          // Walls that it remembers at once.
  static constexpr int max_brakes = 16;           // Of a device.

  // At one wall.
  struct steering {
    int turn = 0;                              // 1 out of the wall, -1 into it, 0 straight on.
    std::array<bool, max_brakes> locked = {};  // Which brakes are.
  };
  // What it remembers.
  struct memory {
    ph::contact_memory<steering, max_contacts> walls;  // Of each wall.
  };

  bang_bang_parameters parameters = {};  // The constants.

  // Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B&) const noexcept {
    return ph::touch_margin;
  }

  // Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& device,
                             const ph::contacts<D, Capacity>& touched, memory& remembered) const noexcept {
    using T = typename M::scalar;
    static_assert(M::brake_count <= max_brakes, "bang_bang_control supports at most 16 brakes");
    const ph::contact<D> c = ph::carried_to(device.x, touched[ph::governing_contact(touched)]);
    if (c.depth <= 0) {
      remembered.walls.clear();
      return ph::brake_vector<M>::Zero();
    }
    const ph::vector<T, D> n = ph::as<T>(c.normal);
    const ph::brake_vector<M> w = slipping_rates(device);
    const ph::vector<T, D> v = device.E * w - ph::as<T>(c.wall_velocity);
    const T speed = ph::length_of(v), slope = speed > T(0) ? n.dot(v) / speed : T(0);

    remembered.walls.begin_cycle(ph::single_contact<D>{c});
    steering& wall = remembered.walls[0];
    wall.turn = w.isZero(T(0)) ? 0 : turned(wall.turn, c.depth, static_cast<double>(slope));

    const ph::brake_vector<M> outward = ph::brake_torque(device.E, n).cwiseProduct(w);  // parts of n . v
    ph::brake_vector<M> t = ph::brake_vector<M>::Zero();
    ph::unrolled<M::brake_count>([&](auto i) {
      bool& locked = wall.locked[static_cast<std::size_t>(i)];
      if (wall.turn == 0) locked = false;
      else if (w[i] != T(0)) locked = static_cast<T>(wall.turn) * outward[i] < T(0);
      if (locked) t[i] = holding_torque(device.s[i], device.brakes.torque_limit[i]);
    });
    return t;
  }

  // Free space or a fault: straight on.
  void released(memory& remembered, double) const noexcept { remembered.walls.clear(); }

 private:
  // Rates of the brakes, 0 at rest
  template <class M, class EMatrix, class B>
  static ph::brake_vector<M> slipping_rates(const ph::brake_situation<M, EMatrix, B>& device) {
    using T = typename M::scalar;
    ph::brake_vector<M> w;
    ph::unrolled<M::brake_count>([&](auto i) {
      w[i] = ph::slips(device.w[i], ph::rate_dead_band_of<T>(device.brakes, i)) ? device.w[i] : T(0);
    });
    return w;
  }

  int turned(int turn, double depth, double slope) const {
    const double e = (depth - parameters.reference_depth) / parameters.approach_length;
    const double wanted = std::clamp(e, -parameters.approach_slope, parameters.approach_slope);
    const double error = wanted - slope;
    const double h = wanted == e ? parameters.following_hysteresis : parameters.approach_hysteresis;
    if (std::abs(error) > h) return error > 0 ? 1 : -1;
    return turn * error > 0 ? turn : 0;
  }
};

}  // namespace experiments
