/// Results of a control cycle: a command, or released brakes and the reason.
#pragma once

#include <passive_haptics/control/cycle_inputs.hpp>
#include <passive_haptics/control/saturation.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/force/forms/form_of.hpp>

#include <type_traits>

namespace passive_haptics {

/// Status of a cycle without a demanded force: ok in free space, or the fault of the position or a contact.
template <class M, int D, class Walls>
status status_without_force(const point<D>& x, const Walls& touched) {
  if (touched.empty()) return status::ok;
  return all_finite(x) ? check_contacts<typename M::scalar>(touched) : status::pose_undefined;
}

/// Calls released() of the law, if it has one.
template <class L>
void tell_released(const L& law, double time, step_memory<L>& memory) {
  if constexpr (requires { law.released(memory.law, time); }) law.released(memory.law, time);
}

/// Releases all brakes, in free space or for a fault.
template <class Result, class Setup, class Memory>
Result released(const Setup& setup, double time, status outcome, Memory& memory) {
  passive_haptics::tell_released(setup.law, time, memory);
  return released<Result>(outcome);
}

/// ok, or the fault; a NaN of any input appears in the command. is_share: the law's scale is in [0, 1].
template <class T, class Contacts, class Outward, class... Numbers>
status check_command(const Contacts& touched, const Outward& outward, bool is_share,
                     const Numbers&... command) {
  if (is_share && all_finite(outward, command...)) return status::ok;
  if (check_contacts<T>(touched) != status::ok) return status::contact_invalid;
  if (!all_finite(outward)) return status::pose_undefined;
  return is_share ? status::result_not_finite : status::scale_out_of_range;
}

/// Steps 1 to 4 of section 4 for one desired force.
template <class M>
struct display_steps {
  using T = typename M::scalar;              ///< Scalar.
  using force = typename form_of<M>::force;  ///< Force with its torques.

  force Fc = {};                                                              ///< 1: before alpha and limits.
  T alpha = T(1);                                                             ///< 2
  force Fc_scaled = {};                                                       ///< 3: Fc' = alpha Fc.
  saturated_torque<T, M::brake_count> td = {brake_vector<M>::Zero(), false};  ///< 4
};

/// Result of these steps for Fd of a wall. t: predicted torque [N m]. Only members of Result are computed.
template <class Result, class M, class Device, class Walls, class T, int D>
PASSIVE_HAPTICS_PART Result result_of(const Device& device, const Walls& touched, int wall,
                                      const desired_force<T, D>& Fd, const display_steps<M>& steps,
                                      const brake_vector<M>& t) {
  const auto& [Fc, alpha, Fc_scaled, td] = steps;
  const bool is_share = alpha >= T(0) && alpha <= T(1);
  const T leaving = outward(Fd, device.v);
  status outcome;
  if constexpr (requires(Result result) { result.control_force; })  // not smaller than Fc_scaled
    outcome = check_command<T>(touched, leaving, is_share, Fc.force, Fc.torque);
  else outcome = check_command<T>(touched, leaving, is_share, Fc_scaled.torque);
  if (outcome != status::ok) return released<Result>(outcome);

  Result result;
  result.outcome = status::ok;
  result.capacity = td.torque.cwiseAbs();
  if constexpr (requires { result.torque; }) {
    result.torque = t;
    result.power = classify_power(Fd.direction.dot(device.v), Fc.display == display_class::exact);
    result.display = Fc.display;
    result.saturated = td.limited;
    result.wall_number = wall;
    result.alpha = alpha;
    result.approximation_cosine = Fc.cosine();
    result.desired_force = lanes(Fd.direction) * Fd.magnitude;
    result.control_force = Fc.force;
    result.cone_coefficients = Fc.torque;
    result.signs = device.s;
    if constexpr (requires { result.settled_signs; }) {
      result.settled_signs = Fc.signs;
      result.settled_velocity = Fc.velocity;
    }
  }
  return result;
}

/// A result with a report for each touched wall.
template <class Result>
concept HasReports = requires(Result result) { result.contact_count; };

/// Reports the walls that demand a force. F [N]: of the commanded torques; wanted(j): demand of wall j.
template <HasReports Result, class Walls, class T, int D, class Wanted>
void report_contacts(Result& result, const Walls& touched, const vector<T, D>& F, const Wanted& wanted) {
  for (int j = 0; j < touched.size(); ++j) {
    const auto Fd = desired_force_of<T>(touched[j]);
    if (!is_nonzero(Fd)) continue;
    contact_report<T>& report = nth(result.contacts, result.contact_count++);
    report = wanted(j);
    report.wall_number = touched[j].wall_number;
    report.displayed = Fd.direction.dot(F);
  }
}

}  // namespace passive_haptics
