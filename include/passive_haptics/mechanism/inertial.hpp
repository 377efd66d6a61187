/// @file
/// A device with self-motion whose brakes may drive it.
#pragma once

#include <passive_haptics/mechanism/dynamics.hpp>

#include <utility>

namespace passive_haptics {

/// M, whose brakes may drive its self-motion: a force is displayed if the brakes accelerate the end effector
/// as it would, whatever becomes of the other joints (brake/force_generators.hpp). For n > d. The brakes of M
/// itself must leave the self-motion alone, and often nothing is left that they can display.
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

}  // namespace passive_haptics
