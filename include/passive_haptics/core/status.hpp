/// Status of a control cycle.
#pragma once

#include <passive_haptics/core/text.hpp>

namespace passive_haptics {

/// Outcome of a calculation. A control cycle never throws; its capacity is zero unless the status is ok.
enum class status {
  ok,                ///< The result is valid.
  state_not_finite,  ///< NaN or infinity in time, q, qd or hand_force.
  contact_invalid,   ///< NaN or infinity in a contact, a normal without unit length, a negative stiffness, or
                     ///< k * depth overflows. sensed_at is NaN until it is set.
  parameters_invalid,  ///< NaN, infinity or a value out of range in the brakes, the law or the options.
  pose_undefined,  ///< No finite position, Jacobian or inverse of the transmission at this pose. In design/
                   ///< also joint positions so large (4.5e11 rad in double) that their rounding exceeds 1e-4
                   ///< rad.
  scale_out_of_range,  ///< The law returned a scale that is NaN or outside [0, 1].
  result_not_finite,   ///< Finite input, but the result overflows.
  singular_jacobian,   ///< J has no inverse to working accuracy. Only for results that need the inverse.
  out_of_reach,        ///< No pose of the mechanism reaches the point.
  too_many_contacts,   ///< More walls are touched than the law supports (max_contacts).
  scene_stale,         ///< The scene of another thread is older than allowed.
  time_not_rising,     ///< Time has not increased, under a law or an observer that uses time differences.
};

/// Text of the status, for a log or a message.
constexpr std::string_view to_string(status s) {
  return detail::word_of(
      s, {"ok", "NaN or infinity in the device state (its time is NaN until it is set)",
          "a contact that is not finite, without a unit normal or of negative stiffness (its sensed_at is "
          "NaN until it is set)",
          "invalid parameters of brakes or law, or invalid options",
          "no finite position or Jacobian at this pose", "the law's scale is not in [0, 1]", "overflow",
          "singular Jacobian", "out of reach", "more walls are touched than the law supports",
          "the scene is out of date", "the time did not increase since the last cycle", "unknown status"});
}

}  // namespace passive_haptics
