// What holds after every control cycle, whatever went in: cheap enough for 1e8 cycles, and for any kind of
// test.
#pragma once

#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/force/forms/form_of.hpp>

#include <cmath>
#include <limits>

namespace stress {

namespace ph = passive_haptics;

// x divided by its largest entry, so that nothing made of it overflows.
template <class T, int N>
struct scaled_vector {
  ph::vector<T, N> unit;
  T size;
  explicit scaled_vector(const ph::vector<T, N>& x) : unit(x), size(x.cwiseAbs().maxCoeff()) {
    if (size > T(0)) unit = x / size;
  }
  // Relative rounding of its entries: more than usual where they are denormal.
  T rounding(T tolerance) const {
    return size > T(0) ? tolerance + std::numeric_limits<T>::denorm_min() / size : T(0);
  }
};

// Whether the brakes can make the displayed force F, to rounding. One contact: s_i (E^T F)_i <= 0 relative to
// |E_i| |F|; as the projection Fp is feasible to rounding of n, Fc = Fp / cos^2 is to rounding of |Fc| / cos.
// Several contacts: relative to the terms of F = G t, which grow with the condition of J, and to the torque
// limits, up to which the search for the best torques may go. In generator form F = G t, where Fp = Fc cos^2
// has the rounding of the terms of Fp, so Fc that of |Fc| / cos, too.
template <class M>
bool force_is_feasible(const M& mechanism, const ph::brakes_of<M>& brakes, const ph::joint_vector<M>& q,
                       bool projected, const ph::step_result<M>& result) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension, m = M::brake_count;
  // Of several contacts that of prioritised_least_squares, with three of them at most
  const T tolerance =
      projected ? ph::rounding_tolerance<T>(d + m) : T(16) * ph::rounding_tolerance<T>(m + m + d + 3);
  const scaled_vector<T, d> F(result.control_force);
  if (F.size < std::numeric_limits<T>::min() / tolerance)
    return true;                   // denormal: signs are all that is left
  if constexpr (ph::Settles<M>) {  // T^T c = J^T F
    const ph::matrix<T, M::dof, m> Tt = ph::transposed_transmission(mechanism, q);
    const ph::matrix<T, M::dof, d> Jt = ph::transposed(ph::jacobian_matrix<M>(ph::jacobian(mechanism, q)));
    const scaled_vector<T, m> t(result.cone_coefficients);
    const ph::vector<T, M::dof> left = Jt * F.unit - Tt * (t.unit * (t.size / F.size));
    const T terms = Jt.norm() + (Tt.cwiseAbs() * t.unit.cwiseAbs()).norm() * (t.size / F.size);
    const T condition = T(1) / ph::settled_rates<M>::default_share;
    const T cosine = projected ? result.approximation_cosine : T(1);
    return !(left.norm() * cosine > (F.rounding(tolerance) + t.rounding(tolerance)) * condition * terms);
  } else if constexpr (m != M::dof) {
    const ph::matrix<T, d, m> G = ph::force_generators(mechanism, q);
    const scaled_vector<T, m> t(result.cone_coefficients);
    const ph::vector<T, d> left = F.unit - G * (t.unit * (t.size / F.size));
    const T terms = (G.cwiseAbs() * t.unit.cwiseAbs()).norm() * (t.size / F.size) + T(1);
    const T cosine = projected ? result.approximation_cosine : T(1);
    return !(left.norm() * cosine > (F.rounding(tolerance) + t.rounding(tolerance)) * terms);
  } else {
    const ph::matrix<T, d, m> E(ph::brake_jacobian(mechanism, q));
    T terms = T(0);
    if (!projected) {
      const ph::matrix<T, d, m> G = ph::invert_brake_jacobian(E).G;
      terms = E.cwiseAbs().maxCoeff() *
                  (G.cwiseAbs() * (result.cone_coefficients.cwiseAbs() / F.size)).maxCoeff() +
              brakes.torque_limit.maxCoeff() / F.size;
    }
    for (int i = 0; i < m; ++i) {
      const scaled_vector<T, d> e(ph::vector<T, d>(E.col(i)));
      const T wrong = result.signs[i] * e.unit.dot(F.unit);
      const T allowed = projected
                            ? (e.rounding(tolerance) + F.rounding(tolerance)) / result.approximation_cosine
                            : tolerance * terms / e.size;
      if (wrong > allowed) return false;
    }
    return true;
  }
}

// The law that the torques of a step broke, in words; nullptr if none.
template <class M>
const char* broken_law_of_torques(const M& mechanism, const ph::brakes_of<M>& brakes,
                                  const ph::device_state<M>& state, const ph::step_result<M>& result) {
  using T = typename M::scalar;
  const auto &t = result.torque, &capacity = result.capacity;
  if (result.outcome != ph::status::ok)
    return capacity.isZero(T(0)) && t.isZero(T(0)) ? nullptr : "a fault releases all brakes";
  if (!ph::all_finite(t) || !ph::all_finite(capacity)) return "torque and capacity are finite";
  if ((capacity.array() < T(0)).any()) return "0 <= capacity";
  if (result.wall_number < 0)
    return capacity.isZero(T(0)) ? nullptr : "where no force is desired no brake works";
  if ((capacity.array() > brakes.torque_limit.array()).any()) return "capacity <= limit";
  if ((t.array().abs() > capacity.array()).any()) return "|torque| <= capacity";
  if ((result.signs.array() * t.array() > T(0)).any()) return "s_i t_i <= 0";
  const ph::brake_vector<M> w = ph::brake_rates(mechanism, state.q, state.qd);
  for (int i = 0; i < M::brake_count; ++i) {
    if (!ph::slips(w[i], brakes.rate_dead_band[i])) continue;
    if (result.signs[i] != ph::sgn(w[i])) return "a slipping brake has the sign of its rate";
    if (t[i] * w[i] > T(0)) return "a slipping brake takes power";
  }
  return nullptr;
}

// The law that a step with so many contacts broke, by a law that scales forces.
template <class M>
const char* broken_law(const M& mechanism, const ph::brakes_of<M>& brakes, const ph::device_state<M>& state,
                       int contact_count, const ph::step_result<M>& result) {
  using T = typename M::scalar;
  if (const char* law = broken_law_of_torques(mechanism, brakes, state, result)) return law;
  if (result.outcome != ph::status::ok || result.wall_number < 0) return nullptr;
  const auto& c = result.cone_coefficients;
  const auto& F = result.control_force;
  if (!(result.alpha >= T(0) && result.alpha <= T(1))) return "0 <= alpha <= 1";
  if (!ph::all_finite(result.desired_force) || !ph::all_finite(F)) return "forces are finite";
  if (!std::isfinite(result.approximation_cosine)) return "the cosine is finite";
  // Over that, E^T F may overflow
  const bool moderate = F.cwiseAbs().maxCoeff() < std::sqrt(std::numeric_limits<T>::max());
  if (moderate && !ph::all_finite(c)) return "coefficients are finite";
  const auto& of_cone = [&]() -> const ph::brake_vector<M>& {
    if constexpr (ph::Settles<M>) return result.settled_signs;
    else return result.signs;
  }();
  if ((of_cone.array() * c.array() > T(0)).any()) return "s_i c_i <= 0";
  const bool projected = contact_count == 1;
  const T invisible = projected ? T(0) : std::sqrt(std::numeric_limits<T>::min());  // its norm is 0
  if (!ph::is_displayed(result.display) && F.cwiseAbs().maxCoeff() > invisible)
    return "what is not displayed makes no force";
  return force_is_feasible<M>(mechanism, brakes, state.q, projected, result)
             ? nullptr
             : "the displayed force is in the cone";
}

// The one that a step by this law broke.
template <class L, class M>
const char* broken_law_of(const M& mechanism, const ph::brakes_of<M>& brakes,
                          const ph::device_state<M>& state, int contact_count,
                          const ph::step_result<M>& result) {
  if constexpr (ph::ScalingLaw<L>) return broken_law(mechanism, brakes, state, contact_count, result);
  else return broken_law_of_torques(mechanism, brakes, state, result);
}

}  // namespace stress
