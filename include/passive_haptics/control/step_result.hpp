/// Result of a control cycle.
#pragma once

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/force/classification.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace passive_haptics {

/// One touched wall and its normal force.
template <class T>
struct contact_report {
  int wall_number = -1;  ///< Wall of the scene.
  /// Normal force required by the law [N]: alpha_j |Fd_j|; under a TorqueLaw n_j . F before the limits, < 0
  /// if it pushes the handle into this wall.
  T wanted = T(0);
  T displayed = T(0);         ///< Normal force n_j . F of the commanded torques [N].
  bool has_priority = false;  ///< The wall is being left under direct control, so it is met first.
};

/// Brake command for a driver.
template <class M>
struct brake_command {
  /// Maximum torque each brake may hold [N m], 0 <= capacity_i <= limit_i; 0 unless outcome is ok.
  brake_vector<M> capacity = brake_vector<M>::Zero();
  status outcome = status::ok;  ///< ok, or why the brakes were released.
};

/// Extra result members for mechanisms with a settled self-motion (n > d); empty otherwise.
template <class M>
struct settled_part {};
/// For a settled self-motion.
template <Settles M>
struct settled_part<M> {
  /// s* (m): brake signs after the self-motion has settled, 0 for brakes at rest.
  brake_vector<M> settled_signs = brake_vector<M>::Zero();
  /// v' [m/s], the velocity used for them: that of a handle that no longer sinks and follows the hand.
  task_vector<M> settled_velocity = task_vector<M>::Zero();
};

/// Result of step(). Unless outcome is ok, capacity and torque are zero and the rest is meaningless.
template <class M>
struct step_result : settled_part<M> {
  static_assert(is_mechanism<M, explain>());
  using scalar = typename M::scalar;  ///< Scalar type.

  /// Command for the driver: maximum torque each brake may hold [N m], 0 <= capacity_i <= limit_i. The
  /// current sets the magnitude, the motion the sign.
  brake_vector<M> capacity = brake_vector<M>::Zero();
  /// Predicted torque on the mechanism by the passive constraint (3) [N m], s_i t_i <= 0.
  brake_vector<M> torque = brake_vector<M>::Zero();
  status outcome = status::ok;  ///< ok, or why the brakes were released.

  power_class power = power_class::none;  ///< Class of the desired force and the device velocity.
  /// Display of Fd before alpha and limits; exact if there is no desired force. Under a TorqueLaw: exact if
  /// its torques produce Fd, approximate if their force has a component along Fd.
  display_class display = display_class::exact;
  bool saturated = false;                                 ///< A torque limit was reached.
  int wall_number = -1;                                   ///< Wall that demands the force; -1 in free space.
  scalar alpha = scalar(1);                               ///< Scale factor of the law (12).
  scalar approximation_cosine = scalar(1);                ///< cos(gamma); 0 if nothing is displayed.
  task_vector<M> desired_force = task_vector<M>::Zero();  ///< Fd [N], base frame.
  /// Fc [N], base frame, before alpha and limits; for n > d after the self-motion has settled.
  task_vector<M> control_force = task_vector<M>::Zero();
  /// Brake torques of Fc [N m], before alpha and limits: Fc = sum_i c_i R_i+ with s_i c_i <= 0, or s*_i c_i
  /// <= 0 for a settled self-motion (settled_signs).
  brake_vector<M> cone_coefficients = brake_vector<M>::Zero();
  brake_vector<M> signs = brake_vector<M>::Zero();  ///< s: -1, 0 or 1 for each brake.

  /// gamma, the angle between Fd and Fc [rad]; pi/2 if nothing is displayed.
  scalar approximation_angle() const {
    return std::acos(approximation_cosine < scalar(1) ? approximation_cosine : scalar(1));
  }
};

/// Result of a step for scenes with up to MaxContacts > 1 simultaneous walls, with reports.
template <class M, int MaxContacts>
struct step_result_of_contacts : step_result<M> {
  /// The first contact_count entries are valid.
  std::array<contact_report<typename M::scalar>, static_cast<std::size_t>(MaxContacts)> contacts{};
  /// Number of walls that demand a force, without those in the margin of a law or without stiffness.
  int contact_count = 0;
};

namespace detail {
template <class M, class Contacts>
struct result_of : std::conditional<(Contacts::capacity > 1), step_result_of_contacts<M, Contacts::capacity>,
                                    step_result<M>> {};
template <class M, class Contacts>
  requires requires { typename Contacts::template result_type<M>; }
struct result_of<M, Contacts> {
  using type = typename Contacts::template result_type<M>;
};
}  // namespace detail

/// Result type of step(): the `result_type<M>` of the contacts, or a step_result<M> with reports for several.
template <class M, class Contacts>
using step_result_for = typename detail::result_of<M, Contacts>::type;

/// Text of the display class, or "no force demanded" if no wall demands one.
template <class Result>
constexpr std::string_view display_text(const Result& r) {
  const bool is_demanded = r.outcome != status::ok || r.power != power_class::none;
  return is_demanded ? to_string(r.display) : "no force demanded";
}

/// Released brakes and the reason: ok in free space, or a fault. For a step_result or a brake_command.
template <class Result>
Result released(status outcome) {
  Result result;
  result.capacity.setZero();
  result.outcome = outcome;
  if constexpr (requires { result.display; })
    if (outcome != status::ok) result.display = display_class::none;
  return result;
}

}  // namespace passive_haptics
