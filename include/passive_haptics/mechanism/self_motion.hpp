/// @file
/// Devices with self-motion, n > d: whether their brakes may drive it.
#pragma once

#include <passive_haptics/mechanism/dynamics.hpp>

#include <utility>

namespace passive_haptics {

/// A device whose brakes may drive its self-motion: a force is displayed if they accelerate the end effector
/// as it would, whatever becomes of the other joints (brake/force_generators.hpp). The default where n > d
/// and the mechanism models Dynamics; `static constexpr bool inertial_forces` of the mechanism says
/// otherwise.
template <class M>
concept has_inertial_forces =
    (M::dof > M::task_dimension) &&
    (requires { requires M::inertial_forces; } || (!requires { M::inertial_forces; } && Dynamics<M>));

/// A mechanism whose displayable forces are told by generators, F = G t: redundant brakes, or inertial
/// forces. Of all others they are the common part of half-spaces.
template <class M>
concept displays_by_generators = has_inertial_forces<M> || (M::brake_count > M::dof);

/// M, whose brakes must leave its self-motion alone: a force is displayed if their torques balance it, with
/// nothing left for the other joints. Needs no inertia. Often no force at all is left that they can display
/// (display_class::empty_cone): of a planar arm of three links in a third of the states that move into a
/// wall, of four links in more than half; inertially in a few of a hundred.
template <class M>
class kinetostatic_mechanism {
  static_assert(mechanism_requirements<M>::met);
  static_assert(M::dof > M::task_dimension,
                "passive_haptics: kinetostatic(mechanism) is for mechanisms with dof > task_dimension.");

 public:
  using scalar = typename M::scalar;                        ///< Of M.
  static constexpr int dof = M::dof;                        ///< n
  static constexpr int task_dimension = M::task_dimension;  ///< d
  static constexpr int brake_count = M::brake_count;        ///< m
  static constexpr bool inertial_forces = false;            ///< Chooses the kinetostatic form.

  /// Wraps a mechanism.
  explicit kinetostatic_mechanism(M mechanism) : mechanism_(std::move(mechanism)) {}

  /// The mechanism inside.
  const M& mechanism() const { return mechanism_; }

  /// x [m] of q or of a pose.
  template <class Q>
  decltype(auto) position(const Q& q) const
    requires requires(const M& m) { m.position(q); }
  {
    return mechanism_.position(q);
  }
  /// J of q, of a pose or of nothing, where M has it.
  template <class... Q>
  decltype(auto) jacobian(const Q&... q) const
    requires requires(const M& m) { m.jacobian(q...); }
  {
    return mechanism_.jacobian(q...);
  }
  /// T of q, of a pose or of nothing, where M has it.
  template <class... Q>
  decltype(auto) transmission(const Q&... q) const
    requires requires(const M& m) { m.transmission(q...); }
  {
    return mechanism_.transmission(q...);
  }
  /// What position and jacobian have in common, where M has it.
  template <class Q>
  decltype(auto) pose(const Q& q) const
    requires requires(const M& m) { m.pose(q); }
  {
    return mechanism_.pose(q);
  }
  /// M of q or of a pose, where the mechanism has Dynamics.
  template <class Q>
  decltype(auto) mass_matrix(const Q& q) const
    requires requires(const M& m) { m.mass_matrix(q); }
  {
    return mechanism_.mass_matrix(q);
  }
  /// c of q or of a pose, where the mechanism has Dynamics.
  template <class Q>
  decltype(auto) bias_torque(const Q& q, const joint_vector<M>& qd) const
    requires requires(const M& m) { m.bias_torque(q, qd); }
  {
    return mechanism_.bias_torque(q, qd);
  }
  /// Jd qd of q or of a pose, where the mechanism has Dynamics.
  template <class Q>
  decltype(auto) bias_acceleration(const Q& q, const joint_vector<M>& qd) const
    requires requires(const M& m) { m.bias_acceleration(q, qd); }
  {
    return mechanism_.bias_acceleration(q, qd);
  }

 private:
  M mechanism_;
};

/// The mechanism with brakes that must leave its self-motion alone.
template <class M>
kinetostatic_mechanism<M> kinetostatic(M mechanism) {
  return kinetostatic_mechanism<M>(std::move(mechanism));
}

/// The mechanism as it is, once it is sure that its brakes may drive its self-motion.
template <class M>
auto inertial(M mechanism) {  // auto: the messages come before those of its use
  static_assert(mechanism_requirements<M>::met);
  static_assert(M::dof > M::task_dimension,
                "passive_haptics: inertial(mechanism) is for mechanisms with dof > task_dimension.");
  static_assert(Dynamics<M>,
                "passive_haptics: inertial(mechanism) needs a mechanism that models Dynamics: give it "
                "mass_matrix, bias_torque and bias_acceleration (mechanism/dynamics.hpp).");
  static_assert(has_inertial_forces<M> || !Dynamics<M>,
                "passive_haptics: this mechanism says that its forces are not inertial.");
  return mechanism;
}

/// What must hold of a device with self-motion before its forces can be told.
template <class M>
struct self_motion_requirements {
  static_assert(
      M::dof == M::task_dimension || Dynamics<M> || requires { requires !M::inertial_forces; },
      "passive_haptics: this mechanism has more joints than task dimensions and no inertia. Give it "
      "mass_matrix, bias_torque and bias_acceleration (mechanism/dynamics.hpp), or take "
      "kinetostatic(mechanism), whose brakes leave the self-motion alone: of a planar arm they then "
      "display no wall in 35 % (3 joints) or 58 % (4) of the states that move into it.");
  static constexpr bool met = true;  ///< Or the compiler says what to choose.
};

}  // namespace passive_haptics
