// Bang-bang control: locked or free brakes turn the handle towards the desired direction of motion.
#pragma once

#include "intended_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace experiments {

// Constants of bang_bang_control.
struct bang_bang_parameters {
  double reference_depth = 1e-3;      // Depth to which the desired direction leads [m].
  double approach_length = 2e-3;      // Depth error for a desired slope of 1 [m].
  double approach_slope = 0.7;        // Desired slope far from the reference depth [1].
  double approach_hysteresis = 0.6;   // Slope error at which a turn begins, far from the reference depth [1].
  double following_hysteresis = 0.6;  // The same near it [1].

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

// The slope of the motion, n . v / |v|, is compared with a desired one, which is constant far from the
// reference depth and proportional to the depth error e = depth - reference_depth near it:
//
//     error = clip(e / approach_length, +-approach_slope) - n . v / |v|.
//
// Three states: straight on with all brakes free; a turn out of the wall from error > h; a turn into it from
// error < -h. A turn ends when the error changes sign. h is approach_hysteresis if the desired slope is
// clipped, else following_hysteresis. A turn out locks each brake that moves the handle in, w_i (E^T n)_i <
// 0, a turn in each that moves it out; locked brakes stay locked for the turn.
//
// For any mechanism. Uses only the state. At rest there is no direction and all brakes are free, so a hand
// that presses without moving along the wall sinks. A hand that leaves is turned in, too. Of several contacts
// the one with the maximum desired force counts. Cost: E^T n.
//
// Reference: Divan, Fontanelli, Palopoli, Hybrid feedback path following for robotic walkers via bang-bang
// control actions, arXiv 1603.00295, 2016 (four actions of two brakes; a fixed angle of approach far away,
// one that depends on the state near the path); Andreetto, Divan, Fontanelli, Palopoli, Passive robotic
// walker path following with bang-bang hybrid control paradigm, IEEE/RSJ Int. Conf. on Intelligent Robots and
// Systems, 2016 (three states, two independent hystereses, no force sensor). Their abstracts. Assumed: the
// path is the surface at the reference depth; the brakes that turn a device that is not a walker; slopes
// instead of angles; the end of a turn; all constants. Their proof of convergence is for a walker that moves
// forward and turns with a fixed radius as soon as it brakes; it does not cover a device with inertia and
// lag.
struct bang_bang_control {
  static constexpr bool commands_torques = true;  // A TorqueLaw.
  static constexpr bool needs_sensed_at = true;   // Extrapolates held contacts.
  static constexpr int max_contacts = 8;          // Maximum number of remembered walls.
  static constexpr int max_brakes = 16;           // Maximum of a device.

  // State at one wall.
  struct steering {
    int turn = 0;                              // 1 out of the wall, -1 into it, 0 straight on.
    std::array<bool, max_brakes> locked = {};  // Locked brakes.
  };
  struct memory {
    ph::contact_memory<steering, max_contacts> walls;  // State of each wall.
  };

  bang_bang_parameters parameters = {};

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
