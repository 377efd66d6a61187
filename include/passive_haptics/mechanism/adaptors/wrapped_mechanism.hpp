/// @file
/// A mechanism with everything that another one has: the base of those that add or change something.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <utility>

namespace passive_haptics {

/// Each member of a mechanism M that the library reads, required or optional, if M has it. A class that is
/// made of it defines those that it changes.
template <class M>
class wrapped_mechanism {
  static_assert(is_mechanism<M, explain>());

 public:
  using scalar = typename M::scalar;                        ///< Of M.
  static constexpr int dof = M::dof;                        ///< n
  static constexpr int task_dimension = M::task_dimension;  ///< d
  static constexpr int brake_count = M::brake_count;        ///< m

  /// The mechanism inside.
  const M& mechanism() const { return mechanism_; }

  /// Parameters of M.
  decltype(auto) parameters() const
    requires requires(const M& m) { m.parameters(); }
  {
    return mechanism_.parameters();
  }

  // Each has its type in its declaration, so that a concept need not compile the body

  /// x [m] of q or of a pose.
  template <class Q, class X = M>
  auto position(const Q& q) const -> decltype(std::declval<const X&>().position(q)) {
    return mechanism_.position(q);
  }
  /// J of q, of a pose or of nothing.
  template <class... Q, class X = M>
  auto jacobian(const Q&... q) const -> decltype(std::declval<const X&>().jacobian(q...)) {
    return mechanism_.jacobian(q...);
  }
  /// T of q, of a pose or of nothing.
  template <class... Q, class X = M>
  auto transmission(const Q&... q) const -> decltype(std::declval<const X&>().transmission(q...)) {
    return mechanism_.transmission(q...);
  }
  /// What position and jacobian have in common.
  template <class Q, class X = M>
  auto pose(const Q& q) const -> decltype(std::declval<const X&>().pose(q)) {
    return mechanism_.pose(q);
  }
  /// J^-1 of q.
  template <class Q, class X = M>
  auto inverse_jacobian(const Q& q) const -> decltype(std::declval<const X&>().inverse_jacobian(q)) {
    return mechanism_.inverse_jacobian(q);
  }
  /// J^-T of q.
  template <class Q, class X = M>
  auto inverse_transposed_jacobian(const Q& q) const
      -> decltype(std::declval<const X&>().inverse_transposed_jacobian(q)) {
    return mechanism_.inverse_transposed_jacobian(q);
  }
  /// How near q is to the singular poses of a closed chain.
  template <class Q, class X = M>
  auto conditioning(const Q& q) const -> decltype(std::declval<const X&>().conditioning(q)) {
    return mechanism_.conditioning(q);
  }
  /// M of q or of a pose.
  template <class Q, class X = M>
  auto mass_matrix(const Q& q) const -> decltype(std::declval<const X&>().mass_matrix(q)) {
    return mechanism_.mass_matrix(q);
  }
  /// c of q or of a pose.
  template <class Q, class X = M>
  auto bias_torque(const Q& q, const joint_vector<M>& qd) const
      -> decltype(std::declval<const X&>().bias_torque(q, qd)) {
    return mechanism_.bias_torque(q, qd);
  }
  /// Jd qd of q or of a pose.
  template <class Q, class X = M>
  auto bias_acceleration(const Q& q, const joint_vector<M>& qd) const
      -> decltype(std::declval<const X&>().bias_acceleration(q, qd)) {
    return mechanism_.bias_acceleration(q, qd);
  }
  /// Td qd of q.
  template <class Q, class X = M>
  auto brake_bias_acceleration(const Q& q, const joint_vector<M>& qd) const
      -> decltype(std::declval<const X&>().brake_bias_acceleration(q, qd)) {
    return mechanism_.brake_bias_acceleration(q, qd);
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
