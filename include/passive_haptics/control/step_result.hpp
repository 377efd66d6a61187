/// @file
/// What one control cycle decides, and why.
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

/// One touched wall, and the normal force that it gets.
template <class T>
struct contact_report {
  int wall_number = -1;  ///< Wall of the scene.
  /// Normal force that the law requires [N]: alpha_j |Fd_j|. Under a TorqueLaw n_j . F of its torques before
  /// the limits, which is < 0 where they push the handle into this wall.
  T wanted = T(0);
  T displayed = T(0);         ///< Normal force n_j . F of the commanded torques [N].
  bool has_priority = false;  ///< The hand is leaving this wall, and the law gives way: met before others.
};

/// What a driver needs of a cycle.
template <class M>
struct brake_command {
  /// The most each brake may hold [N m], 0 <= capacity_i <= limit_i; 0 unless outcome is ok.
  brake_vector<M> capacity = brake_vector<M>::Zero();
  status outcome = status::ok;  ///< ok, or why the brakes were released.
};

/// What a result has besides of a device whose self-motion settles (n > d): nothing for others.
template <class M>
struct settled_part {};
/// Of a device whose self-motion settles.
template <Settles M>
struct settled_part<M> {
  /// s* (m): the signs of the brakes once the self-motion has settled, 0 for those that have come to rest.
  brake_vector<M> settled_signs = brake_vector<M>::Zero();
  /// v' [m/s], the velocity that gave them: of a handle that no longer sinks, and goes where the hand pushes.
  task_vector<M> settled_velocity = task_vector<M>::Zero();
};

/// Result of step(). Unless outcome is ok, capacity and torque are zero and the rest has no meaning.
template <class M>
struct step_result : settled_part<M> {
  static_assert(is_mechanism<M, explain>());
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// What the driver commands: the most each brake may hold [N m], 0 <= capacity_i <= limit_i. A brake's
  /// electricity sets a magnitude, its motion the sign.
  brake_vector<M> capacity = brake_vector<M>::Zero();
  /// What the mechanism is predicted to feel by the passive constraint (3) [N m], s_i t_i <= 0.
  brake_vector<M> torque = brake_vector<M>::Zero();
  status outcome = status::ok;  ///< ok, or why the brakes were released.

  power_class power = power_class::none;  ///< Of the desired force and the device's own velocity.
  /// How Fd is displayed before alpha and limits. No desired force is displayed exactly, by no torque. Under
  /// a TorqueLaw: exact where its torques make Fd, approximate where they make a force with a component along
  /// it.
  display_class display = display_class::exact;
  bool saturated = false;                                 ///< A torque limit was reached.
  int wall_number = -1;                                   ///< Wall that demands the force; -1 in free space.
  scalar alpha = scalar(1);                               ///< Scale factor of the law (12).
  scalar approximation_cosine = scalar(1);                ///< cos(gamma); 0 where nothing is displayed.
  task_vector<M> desired_force = task_vector<M>::Zero();  ///< Fd [N], base frame.
  /// Fc [N], base frame, before alpha and limits; for n > d that which is felt once the self-motion has
  /// settled.
  task_vector<M> control_force = task_vector<M>::Zero();
  /// Brake torques that make Fc [N m], before alpha and limits: its coefficients on the reference forces,
  /// Fc = sum_i c_i R_i+; those of a brake with sign s_i fulfil s_i c_i <= 0. Where the self-motion settles
  /// it is s*_i c_i <= 0 (settled_signs).
  brake_vector<M> cone_coefficients = brake_vector<M>::Zero();
  brake_vector<M> signs = brake_vector<M>::Zero();  ///< s: -1, 0 or 1 for each brake.

  /// gamma, the angle between Fd and Fc [rad]; pi/2 where nothing is displayed.
  scalar approximation_angle() const {
    return std::acos(approximation_cosine < scalar(1) ? approximation_cosine : scalar(1));
  }
};

/// Result of a step for a scene in which up to MaxContacts > 1 walls can be touched at once. The result for a
/// scene of one wall has no reports.
template <class M, int MaxContacts>
struct step_result_of_contacts : step_result<M> {
  /// The first contact_count are of this cycle.
  std::array<contact_report<typename M::scalar>, static_cast<std::size_t>(MaxContacts)> contacts{};
  /// Touched walls, under any law: those that demand a force. A wall within the margin of a law, or without
  /// stiffness, is not counted.
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

/// What step() returns for these contacts: a step_result<M>, with reports if there can be several; or what
/// the contacts themselves name as `result_type<M>`.
template <class M, class Contacts>
using step_result_for = typename detail::result_of<M, Contacts>::type;

/// How Fd is displayed, for people to read: "no force demanded" where no wall demands one.
template <class Result>
constexpr std::string_view display_text(const Result& r) {
  const bool is_demanded = r.outcome != status::ok || r.power != power_class::none;
  return is_demanded ? to_string(r.display) : "no force demanded";
}

/// All brakes released, and why: in free space (ok), or for a fault. A step_result or a brake_command.
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
