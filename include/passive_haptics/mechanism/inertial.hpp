/// @file
/// A device with self-motion whose brakes may drive it.
#pragma once

#include <passive_haptics/mechanism/dynamics.hpp>

#include <utility>

namespace passive_haptics {

/// M, but forces of its brakes are understood inertially: those that accelerate the end effector as the
/// brakes do, whatever becomes of the self-motion (brake/force_generators.hpp). For n > d, where the brakes
/// of M itself are asked to leave the self-motion alone, which often leaves them nothing to display.
template <class M>
class inertial : public M {
  static_assert(mechanism_requirements<M>::met);
  static_assert(M::dof > M::task_dimension,
                "passive_haptics: inertial<M> is for mechanisms with dof > task_dimension.");
  static_assert(
      Dynamics<M>,
      "passive_haptics: inertial<M> needs a mechanism that models Dynamics (mechanism/dynamics.hpp).");

 public:
  static constexpr bool inertial_forces = true;  ///< Chooses the inertial form.

  /// Wraps a mechanism.
  explicit inertial(M mechanism) : M(std::move(mechanism)) {}
};

namespace detail {
template <class M>
concept has_inertial_forces = requires { requires M::inertial_forces; };
}  // namespace detail

}  // namespace passive_haptics
