/// Td qd, the velocity-dependent part of the brake axis accelerations wd = T qdd + Td qd.
#pragma once

#include <passive_haptics/core/scalar/dual_number.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {
namespace detail {

template <class M>
concept has_brake_bias_acceleration = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.brake_bias_acceleration(q, q) } -> ExactVector<typename M::scalar, M::brake_count>;
};

template <class M>
using line_scalar = dual_number<typename M::scalar, 1>;

template <class M>
concept differentiates_transmission =
    transmission_depends_on_pose<M> && requires(const M mechanism, const vector<line_scalar<M>, M::dof> q) {
      { mechanism.transmission(q) } -> exact_or_diagonal<line_scalar<M>, M::brake_count, M::dof>;
    };

// dT/ds qd along q + s qd, exact to rounding
template <class M>
brake_vector<M> transmission_derivative(const M& mechanism, const joint_vector<M>& q,
                                        const joint_vector<M>& qd) {
  using scalar = line_scalar<M>;
  using derivative = typename scalar::derivative_vector;
  vector<scalar, M::dof> along;
  for (int i = 0; i < M::dof; ++i) along[i] = scalar(q[i], derivative::Constant(qd[i]));
  const matrix<scalar, M::brake_count, M::dof> T(mechanism.transmission(along));
  brake_vector<M> drift = brake_vector<M>::Zero();
  for (int i = 0; i < M::brake_count; ++i)
    for (int j = 0; j < M::dof; ++j) drift[i] += T(i, j).derivatives()[0] * qd[j];
  return drift;
}

// Central difference over +-eps^(1/3) rad or m
template <class M>
brake_vector<M> transmission_difference(const M& mechanism, const joint_vector<M>& q,
                                        const joint_vector<M>& qd) {
  using T = typename M::scalar;
  const T speed = qd.norm();
  if (!(speed > T(0))) return brake_vector<M>::Zero();
  const T step = std::cbrt(std::numeric_limits<T>::epsilon()) / speed;  // of s in q + s qd
  const auto rates = [&](T s) {
    return passive_haptics::brake_rates(mechanism, joint_vector<M>(q + s * qd), qd);
  };
  return (rates(step) - rates(-step)) / (T(2) * step);
}

}  // namespace detail

/// Td qd (m) [rad/s^2 or m/s^2] at q with rates qd; 0 if T is constant. From the mechanism's `vector<scalar,
/// m> brake_bias_acceleration(q, qd) const`, or dual numbers if transmission is a template over the scalar,
/// else a central difference with a relative error of about 4e-11 in double, 2e-5 in float. Cost: one or two
/// transmissions.
template <class M>
brake_vector<M> brake_bias_acceleration(const M& mechanism, const joint_vector<M>& q,
                                        const joint_vector<M>& qd) {
  if constexpr (detail::has_brake_bias_acceleration<M>) return mechanism.brake_bias_acceleration(q, qd);
  else if constexpr (!detail::has_exact_transmission<M> || detail::transmission_is_constant<M>)
    return brake_vector<M>::Zero();
  else if constexpr (detail::differentiates_transmission<M>)
    return detail::transmission_derivative(mechanism, q, qd);
  else return detail::transmission_difference(mechanism, q, qd);
}

}  // namespace passive_haptics
