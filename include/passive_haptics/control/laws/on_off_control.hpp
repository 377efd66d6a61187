/// @file
/// On-off control: the whole approximated force or none, by a relay with hysteresis.
#pragma once

#include <passive_haptics/control/laws/contact_memory.hpp>
#include <passive_haptics/control/laws/touch_margin.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <array>

namespace passive_haptics {

/// Constants of on_off_control.
struct on_off_parameters {
  double reference_depth = 1.5e-3;  ///< In the wall, about which the relay switches [m].
  double hysteresis = 0.1e-3;       ///< h, half width of the relay's hysteresis [m].
  double lead = 0.02;  ///< tau [s]: the depth is judged as it will be then; about the brakes' lag.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = on_off_parameters;
    return member_table(member("reference_depth", &p::reference_depth, "m", range::finite),
                        member("hysteresis", &p::hysteresis, "m", range::not_negative),
                        member("lead", &p::lead, "s", range::not_negative));
  }
};

/// For each wall a relay of the depth to come,
///
///     sigma = depth - reference_depth - tau n . (v - v_wall):   on if sigma > h, off if sigma < -h, else as
///     before (off at first),
///
/// so a handle that sinks is braked before it is too deep, and one that leaves is let go before it is out. On
/// displays the approximated force whole, as no_direct_control does: one contact by force approximation,
/// several by priorities. Brakes can only lead a handle back to the reference depth where the approximation
/// pulls; a hand that leaves is free.
///
/// A contact held by a slow virtual environment is carried on to the handle. Its relay is off until the
/// touch; with the margin it is known by then, also at 20 Hz.
///
/// For any mechanism. Needs nothing but the state; cost: that of the approximation.
///
/// Reference: the switching line in the plane of error and rate, Tsypkin, Relay control systems, Cambridge
/// University Press, 1984. Brakes that are on or off, with a hysteresis and without a force sensor, lead a
/// walker along a path in Andreetto, Divan, Fontanelli, Palopoli, Passive robotic walker path following with
/// bang-bang hybrid control paradigm, IEEE/RSJ Int. Conf. on Intelligent Robots and Systems, 2016: for small
/// angles sigma / (tau |v|) is the error of its slope, with an approach length of tau |v|. Assumed: here the
/// depth is judged a time ahead and not a length, so that the brakes' lag is met at any speed; a wall lets a
/// hand leave, so there is no turn into it; the approximated force for a locked brake.
struct on_off_control {
  static constexpr bool commands_torques = true;  ///< It is a TorqueLaw.
  static constexpr bool needs_sensed_at = true;   ///< Carries a held contact on to where the handle is.
  static constexpr int max_contacts = 8;          ///< Walls that it remembers at once.

  /// Of one wall.
  struct relay {
    bool on = false;  ///< Its force is displayed.
  };
  /// What it remembers.
  struct memory {
    contact_memory<relay, max_contacts> walls;  ///< The relay of each.
    approximation_start start;                  ///< Where the next approximation begins.
  };

  on_off_parameters parameters = {};  ///< The constants.

  /// Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B&) const noexcept {
    return touch_margin;
  }

  /// Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  brake_vector<M> torque(const brake_situation<M, EMatrix, B>& device, const contacts<D, Capacity>& touched,
                         memory& remembered) const noexcept {
    using T = typename M::scalar;
    std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)> demands;
    std::array<desired_force<T, D>, static_cast<std::size_t>(Capacity)> on;
    int count = 0;
    remembered.walls.begin_cycle(touched);
    for (int j = 0; j < touched.size(); ++j) {
      const contact<D> c = carried_to(device.x, touched[j]);
      const auto Fd = desired_force_of<T>(c);
      relay& wall = remembered.walls[j];
      wall.on = c.depth > 0 && switched(wall.on, c.depth, static_cast<double>(outward(Fd, device.v)));
      if (!wall.on) continue;
      nth(on, count) = Fd;
      nth(demands, count++) = {Fd.direction, Fd.magnitude, false};
    }
    if (count == 0) return brake_vector<M>::Zero();
    if (count == 1) {
      const auto Fc =
          on[0].magnitude * form_of<M>::nearest(device, on[0], device.options.min_cosine, remembered.start);
      return passive_haptics::within_limits(Fc.torque, device.brakes, device.options.limits).torque;
    }
    typename form_of<M>::force F;
    const brake_vector<M> signs = form_of<M>::template signs<Capacity>(
        device, demands, count, count, [&](int j) { return nth(on, j); }, remembered.start, F);
    const auto map = form_of<M>::map(device.pose, device.E);
    const auto box = passive_haptics::torque_box_of(signs, device.brakes);
    return contact_forces<T, D, M::brake_count, Capacity>(map, box, demands, count, map.G,
                                                          form_of<M>::units(signs, device.brakes))
        .torque;
  }

  /// Free space or a fault: all relays are off.
  void released(memory& remembered, double) const noexcept { remembered.walls.clear(); }

 private:
  bool switched(bool on, double depth, double outward) const {
    const double sigma = depth - parameters.reference_depth - parameters.lead * outward;
    if (sigma > parameters.hysteresis) return true;
    return sigma < -parameters.hysteresis ? false : on;
  }
};

}  // namespace passive_haptics
