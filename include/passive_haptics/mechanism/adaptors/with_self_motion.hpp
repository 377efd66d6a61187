/// @file
/// A mechanism with another reading of its self-motion than it names itself.
#pragma once

#include <passive_haptics/mechanism/adaptors/wrapped_mechanism.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>

#include <utility>

namespace passive_haptics {

namespace detail {
template <class M, self_motion_form Form>
class with_self_motion : public wrapped_mechanism<M> {
 public:
  static constexpr self_motion_form self_motion = Form;  ///< The form.

  /// Wraps a mechanism.
  explicit with_self_motion(M mechanism) : wrapped_mechanism<M>(std::move(mechanism)) {
    static_assert(M::dof > M::task_dimension,
                  "passive_haptics: settled(mechanism), inertial(mechanism) and kinetostatic(mechanism) are "
                  "for mechanisms with dof > task_dimension.");
    static_assert(Form != self_motion_form::inertial || Dynamics<M>,
                  "passive_haptics: inertial(mechanism) needs a mechanism that models Dynamics: give it "
                  "mass_matrix, bias_torque and bias_acceleration (mechanism/dynamics.hpp).");
  }
};
}  // namespace detail

/// M, whose self-motion settles: the default.
template <class M>
using settled_mechanism = detail::with_self_motion<M, self_motion_form::settled>;
/// M, whose brakes drive its self-motion.
template <class M>
using inertial_mechanism = detail::with_self_motion<M, self_motion_form::inertial>;
/// M, whose brakes leave its self-motion alone.
template <class M>
using kinetostatic_mechanism = detail::with_self_motion<M, self_motion_form::kinetostatic>;

/// The mechanism with self_motion_form::settled, whatever it says itself.
template <class M>
settled_mechanism<M> settled(M mechanism) {
  return settled_mechanism<M>(std::move(mechanism));
}

/// The mechanism with self_motion_form::inertial.
template <class M>
inertial_mechanism<M> inertial(M mechanism) {
  return inertial_mechanism<M>(std::move(mechanism));
}

/// The mechanism with self_motion_form::kinetostatic.
template <class M>
kinetostatic_mechanism<M> kinetostatic(M mechanism) {
  return kinetostatic_mechanism<M>(std::move(mechanism));
}

}  // namespace passive_haptics
