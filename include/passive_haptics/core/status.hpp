/// @file
/// What can go wrong inside a control cycle, as a value.
#pragma once

#include <string_view>

namespace passive_haptics {

/// Outcome of a calculation. A control cycle never throws: it returns a status, and zero capacity unless that
/// is ok.
enum class status {
  ok,                  ///< The result is valid.
  state_not_finite,    ///< NaN or infinity in time, q, qd or hand_force.
  contact_not_finite,  ///< NaN or infinity in a contact, or k * depth overflows.
  parameters_invalid,  ///< NaN, infinity or a negative limit or dead band of the brakes, or such options.
  pose_undefined,      ///< No finite position, Jacobian or inverse of the transmission at this pose.
  scale_out_of_range,  ///< The law returned a scale that is NaN or outside [0, 1].
  result_not_finite,   ///< Finite input whose result overflows.
  singular_jacobian,   ///< J has no inverse to working accuracy. Only what needs the inverse says so.
  out_of_reach,        ///< No pose of the mechanism reaches the point.
  scene_stale,         ///< The scene of another thread is older than its user allows.
};

/// The status in words, for a log or a message.
constexpr std::string_view to_string(status s) {
  switch (s) {
    case status::ok: return "ok";
    case status::state_not_finite: return "NaN or infinity in the device state";
    case status::contact_not_finite: return "NaN or infinity in a contact";
    case status::parameters_invalid: return "invalid brake parameters or options";
    case status::pose_undefined: return "no finite position or Jacobian at this pose";
    case status::scale_out_of_range: return "the law's scale is not in [0, 1]";
    case status::result_not_finite: return "overflow";
    case status::singular_jacobian: return "singular Jacobian";
    case status::out_of_reach: return "out of reach";
    case status::scene_stale: return "the scene is out of date";
  }
  return "unknown status";
}

}  // namespace passive_haptics
