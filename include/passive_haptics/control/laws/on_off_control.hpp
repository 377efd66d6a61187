/// On-off control: all or none of the approximated force, by a relay with hysteresis.
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
  double reference_depth = 1.5e-3;  ///< Depth about which the relay switches [m].
  double hysteresis = 0.1e-3;       ///< h, half width of the hysteresis [m].
  double lead = 0.02;               ///< tau [s]: the depth is predicted over this time; about the brake lag.

  static constexpr auto members() {
    using p = on_off_parameters;
    return member_table(member("reference_depth", &p::reference_depth, "m", range::finite),
                        member("hysteresis", &p::hysteresis, "m", range::not_negative),
                        member("lead", &p::lead, "s", range::not_negative));
  }
};

/// Uses a relay of the predicted depth for each wall,
///
///     sigma = depth - reference_depth - tau n . (v - v_wall):   on if sigma > h, off if sigma < -h, else as
///     before (initially off),
///
/// so a sinking handle is braked before it is too deep, and a leaving one is released before it is out. "On"
/// displays the whole approximated force like no_direct_control: one contact by force approximation, several
/// by priorities. Brakes can only return a handle to the reference depth if the approximation pulls.
///
/// A contact held by a slow virtual environment is extrapolated to the handle. Its relay is off until the
/// touch. Supports any mechanism and needs only the state. Cost: that of the approximation.
///
/// Sources: switching line in the plane of error and rate, Tsypkin, Relay control systems, Cambridge
/// University Press, 1984; brakes with on-off hysteresis and no force sensor that guide a walker along a
/// path, Andreetto, Divan, Fontanelli, Palopoli, Passive robotic walker path following with bang-bang hybrid
/// control paradigm, IEEE/RSJ Int. Conf. on Intelligent Robots and Systems, 2016. Differences: the depth is
/// predicted over a time instead of a length, to match the brake lag at any speed; a wall lets the hand
/// leave; the approximated force replaces a locked brake.
struct on_off_control {
  static constexpr bool commands_torques = true;  ///< Required by TorqueLaw.
  static constexpr bool needs_sensed_at = true;   ///< Extrapolates held contacts to the handle.
  static constexpr int max_contacts = 8;          ///< Maximum number of walls.

  /// State of one wall.
  struct relay {
    bool on = false;  ///< True if the force is displayed.
  };
  /// Memory between cycles.
  struct memory {
    contact_memory<relay, max_contacts> walls;  ///< One relay per wall.
    approximation_start start;                  ///< Start of the next approximation.
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

  /// Switches all relays off.
  void released(memory& remembered, double) const noexcept { remembered.walls.clear(); }

 private:
  bool switched(bool on, double depth, double outward) const {
    const double sigma = depth - parameters.reference_depth - parameters.lead * outward;
    if (sigma > parameters.hysteresis) return true;
    return sigma < -parameters.hysteresis ? false : on;
  }
};

}  // namespace passive_haptics
