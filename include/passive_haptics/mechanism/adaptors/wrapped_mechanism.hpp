/// @file
/// A mechanism with everything that another one has: the base of those that add or change something.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <utility>

namespace passive_haptics {

/// Position, Jacobian, pose and, where M has them, transmission and Dynamics of a mechanism M.
template <class M>
class wrapped_mechanism {
  static_assert(mechanism_requirements<M>::met);

 public:
  using scalar = typename M::scalar;                        ///< Of M.
  static constexpr int dof = M::dof;                        ///< n
  static constexpr int task_dimension = M::task_dimension;  ///< d
  static constexpr int brake_count = M::brake_count;        ///< m

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

 protected:
  /// Of the mechanism.
  explicit wrapped_mechanism(M mechanism) : mechanism_(std::move(mechanism)) {}
  ~wrapped_mechanism() = default;                                    ///< By what is made of it.
  wrapped_mechanism(const wrapped_mechanism&) = default;             ///< By what is made of it.
  wrapped_mechanism& operator=(const wrapped_mechanism&) = default;  ///< By what is made of it.

 private:
  M mechanism_;
};

}  // namespace passive_haptics
