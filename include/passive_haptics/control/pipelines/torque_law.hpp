/// Section 4 under a TorqueLaw: its torques, as far as the brakes can produce them.
#pragma once

#include <passive_haptics/control/cycle_result.hpp>
#include <passive_haptics/control/pipeline.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <algorithm>
#include <type_traits>

namespace passive_haptics {

/// Torques of a law, which receives all walls.
template <class Result, class Setup, class Walls>
struct torques_of_law {
  using M = typename Setup::mechanism_type;    ///< Mechanism.
  using L = typename Setup::law_type;          ///< Law.
  using T = typename M::scalar;                ///< Scalar.
  static constexpr int d = M::task_dimension;  ///< Task dimensions.
  static constexpr int m = M::brake_count;     ///< Brakes.

  /// From walls to td.
  struct steps {
    vector<T, m> wanted;        ///< Demand of the law; 0 for a brake that would have to drive.
    saturated_torque<T, m> td;  ///< Limited separately.
    [[no_unique_address]] law_memory<L> memory;  ///< New memory of the law, kept if the cycle succeeds.
  };

  const Setup& setup;                                ///< Setup of the cycle.
  const Walls& touched;                              ///< The walls.
  const int governing = governing_contact(touched);  ///< Wall with the maximum demand; -1 if there is none.
  const desired_force<T, d> Fd = force_of_governing();  ///< Its demand.

  /// True if there is a force to display, or a wall within the margin of the law.
  bool demands_force() const { return is_nonzero(Fd) || is_near(); }

  /// Steps 1 to 3 by the law, then step 4 for each brake separately.
  template <class Device>
  PASSIVE_HAPTICS_PART steps command(const Device& device, step_memory<L>& memory) const {
    steps done{{}, {}, memory.law};
    done.wanted = torques_wanted(device, done.memory);
    if (all_finite(done.wanted)) {  // otherwise a fault of the law, even for released brakes
      done.wanted = form_of<M>::without_driving(done.wanted, device.s);
      [[maybe_unused]] const auto off = passive_haptics::brakes_off(device.s, device.brakes);
      unrolled<m>([&](auto i) {
        if (detail::is_off(off, i)) done.wanted[i] = T(0);
      });
    }
    done.td = passive_haptics::within_limits(done.wanted, device.brakes, saturation::clamp_each);
    return done;
  }

  /// Result of a cycle, for the force of the law's torques before the limits.
  template <class Device>
  PASSIVE_HAPTICS_PART Result result(const Device& device, const steps& done, const brake_vector<M>& t,
                                     step_memory<L>& memory) const {
    if (const status s = verdict(); s != status::ok)
      return passive_haptics::released<Result>(setup, device.time, s, memory);
    constexpr bool is_account = requires(Result result) { result.torque; };
    display_steps<M> as_force{.td = done.td};
    as_force.Fc.display = display_class::exact;
    as_force.Fc.torque = as_force.Fc_scaled.torque = done.wanted;
    if constexpr (is_account) find_force(as_force.Fc, device, done.memory);
    Result result =
        passive_haptics::result_of<Result>(device, touched, touched[governing].wall_number, Fd, as_force, t);
    if (result.outcome != status::ok) {
      passive_haptics::tell_released(setup.law, device.time, memory);
      return result;
    }
    memory.law = done.memory;
    if constexpr (is_account)
      result.power = is_nonzero(Fd) ? classify_power(Fd.direction.dot(device.v), can_be_displayed(device))
                                    : power_class::none;
    if constexpr (HasReports<Result>) {
      auto F = as_force.Fc;
      if (done.td.limited) {
        F.torque = done.td.torque;
        find_force(F, device, done.memory);
      }
      passive_haptics::report_contacts(result, touched, F.force, [&](int j) {
        return contact_report<T>{.wanted = desired_force_of<T>(touched[j]).direction.dot(as_force.Fc.force)};
      });
    }
    return result;
  }

 private:
  bool is_near() const {
    if constexpr (has_margin<L, std::remove_cvref_t<decltype(setup.brakes)>>)
      return !touched.empty() && touched[governing].stiffness > 0 &&
             touched[governing].depth > -setup.law.margin(setup.brakes);
    else return false;
  }

  status verdict() const {
    if (walls_of_law().size() > max_contacts<L>) return status::too_many_contacts;
    if constexpr (needs_sensed_at<L>)
      for (const auto& c : touched)
        if (!all_finite(c.sensed_at)) return status::contact_invalid;
    return check_contacts<T>(touched);
  }

  // All contacts, or only the touched ones if these are too many for the law
  decltype(auto) walls_of_law() const {
    if constexpr (Walls::capacity > max_contacts<L>) {
      if (touched.size() <= max_contacts<L>) return Walls(touched);
      Walls deep;
      for (const auto& c : touched)
        if (!(c.depth <= 0)) deep.append_unchecked(c);
      return deep;
    } else {
      return (touched);
    }
  }

  // No force in free space or before the touch
  desired_force<T, d> force_of_governing() const {
    if (touched.empty()) return {vector<T, d>::Zero(), T(0), vector<T, d>::Zero()};
    desired_force<T, d> force = desired_force_of<T>(touched[governing]);
    force.magnitude = std::max(force.magnitude, T(0));  // keeps NaN
    return force;
  }

  template <class Device>
  vector<T, m> torques_wanted(const Device& device, law_memory<L>& memory) const {
    if constexpr (requires { typename L::memory; }) {
      static_assert(
          requires { setup.law.torque(device, touched, memory); },
          "passive_haptics: torque() of this law accepts only brakes_of<M>; let it accept a "
          "brake_situation<M, "
          "E, B> of any brakes B, or give the step brakes_of<M>.");
      return setup.law.torque(device, walls_of_law(), memory);
    } else {
      return setup.law.torque(device, walls_of_law());
    }
  }

  // F = G t of the law's torques. Exact if F = Fd, approximate if F has a component along Fd
  template <class Device>
  void find_force(typename form_of<M>::force& F, const Device& device,
                  [[maybe_unused]] const law_memory<L>& memory) const {
    approximation_start start;
    if constexpr (requires { memory.start; }) start = memory.start;
    const T terms = form_of<M>::set_force(F, device, Fd, start);
    F.cosine_squared = cosine_squared(F.force, Fd.direction);
    const T off = (F.force - Fd.magnitude * Fd.direction).norm();
    F.display = off <= rounding_tolerance<T>(d + m) * terms ? display_class::exact
                : F.cosine_squared > T(0)                   ? display_class::approximate
                                                            : display_class::none;
  }

  template <class Device>
  bool can_be_displayed(const Device& device) const {
    approximation_start start;
    const T min_cosine = setup.options.min_cosine;
    return form_of<M>::nearest(device, Fd, min_cosine, start).display == display_class::exact;
  }
};

}  // namespace passive_haptics
