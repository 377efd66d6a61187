/// The optional Dynamics concept, for simulations and acceleration-level laws.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

namespace detail {
template <class M>
concept has_mass_matrix = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.mass_matrix(q) } -> ExactMatrix<typename M::scalar, M::dof, M::dof>;
};
template <class M>
concept has_bias_torque = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.bias_torque(q, q) } -> ExactVector<typename M::scalar, M::dof>;
};
template <class M>
concept has_bias_acceleration = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.bias_acceleration(q, q) } -> ExactVector<typename M::scalar, M::task_dimension>;
};
}  // namespace detail

/// A mechanism with inertia: M(q) qdd + c(q, qd) = J^T F + T^T t and xdd = J qdd + Jd qd.
///
/// Minimal complete definition, in addition to that of Mechanism:
///   - `matrix<scalar, n, n> mass_matrix(q) const`: M, symmetric and positive definite, including rotors [kg
///     m^2, kg m or kg];
///   - `vector<scalar, n> bias_torque(q, qd) const`: c, Coriolis, centrifugal and gravity torques [N m or N];
///   - `vector<scalar, d> bias_acceleration(q, qd) const`: Jd qd [m/s^2].
///
/// Laws: M is symmetric positive definite. Jd is the derivative of J along qd. Without gravity qd . (Md qd /
/// 2 - c) = 0, so that only external work changes the kinetic energy.
template <class M>
concept Dynamics = Mechanism<M> && detail::has_mass_matrix<M> && detail::has_bias_torque<M> &&
                   detail::has_bias_acceleration<M>;

}  // namespace passive_haptics
