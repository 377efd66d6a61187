/// Base class of mechanisms that extend or change another one.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <utility>

namespace passive_haptics {

/// A copy of M with its members that the library uses, required and optional. Derived classes redefine some.
template <class M>
class wrapped_mechanism {
  static_assert(is_mechanism<M, explain>());

 public:
  using scalar = typename M::scalar;                        ///< Scalar of M.
  static constexpr int dof = M::dof;                        ///< Joints n.
  static constexpr int task_dimension = M::task_dimension;  ///< Task dimensions d.
  static constexpr int brake_count = M::brake_count;        ///< Brakes m.

  const M& mechanism() const { return mechanism_; }  ///< The wrapped mechanism.

  /// Parameters of M.
  decltype(auto) parameters() const
    requires requires(const M& m) { m.parameters(); }
  {
    return mechanism_.parameters();
  }

  // The return types let a concept check these members without compiling their bodies

  /// @{
  /// The member of M with this name, if M has it.
  template <class Q, class X = M>
  auto position(const Q& q) const -> decltype(std::declval<const X&>().position(q)) {
    return mechanism_.position(q);
  }
  template <class... Q, class X = M>
  auto jacobian(const Q&... q) const -> decltype(std::declval<const X&>().jacobian(q...)) {
    return mechanism_.jacobian(q...);
  }
  template <class... Q, class X = M>
  auto transmission(const Q&... q) const -> decltype(std::declval<const X&>().transmission(q...)) {
    return mechanism_.transmission(q...);
  }
  template <class Q, class X = M>
  auto pose(const Q& q) const -> decltype(std::declval<const X&>().pose(q)) {
    return mechanism_.pose(q);
  }
  template <class Q, class X = M>
  auto inverse_jacobian(const Q& q) const -> decltype(std::declval<const X&>().inverse_jacobian(q)) {
    return mechanism_.inverse_jacobian(q);
  }
  template <class Q, class X = M>
  auto inverse_transposed_jacobian(const Q& q) const
      -> decltype(std::declval<const X&>().inverse_transposed_jacobian(q)) {
    return mechanism_.inverse_transposed_jacobian(q);
  }
  template <class Q, class X = M>
  auto conditioning(const Q& q) const -> decltype(std::declval<const X&>().conditioning(q)) {
    return mechanism_.conditioning(q);
  }
  template <class Q, class X = M>
  auto mass_matrix(const Q& q) const -> decltype(std::declval<const X&>().mass_matrix(q)) {
    return mechanism_.mass_matrix(q);
  }
  template <class Q, class X = M>
  auto bias_torque(const Q& q, const joint_vector<M>& qd) const
      -> decltype(std::declval<const X&>().bias_torque(q, qd)) {
    return mechanism_.bias_torque(q, qd);
  }
  template <class Q, class X = M>
  auto bias_acceleration(const Q& q, const joint_vector<M>& qd) const
      -> decltype(std::declval<const X&>().bias_acceleration(q, qd)) {
    return mechanism_.bias_acceleration(q, qd);
  }
  template <class Q, class X = M>
  auto brake_bias_acceleration(const Q& q, const joint_vector<M>& qd) const
      -> decltype(std::declval<const X&>().brake_bias_acceleration(q, qd)) {
    return mechanism_.brake_bias_acceleration(q, qd);
  }
  /// @}

 protected:
  /// Only for derived classes.
  /// @{
  explicit wrapped_mechanism(M mechanism) : mechanism_(std::move(mechanism)) {}
  ~wrapped_mechanism() = default;
  wrapped_mechanism(const wrapped_mechanism&) = default;
  wrapped_mechanism& operator=(const wrapped_mechanism&) = default;
  /// @}

 private:
  M mechanism_;
};

}  // namespace passive_haptics
