/// Coulomb friction of coupled brakes with exact stick.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/nth.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Impulses of m brakes over one time step.
template <class T, int Brakes>
struct friction_impulses {
  vector<T, Brakes> impulse;                     ///< p [N m s], |p_i| <= limit_i.
  std::array<bool, std::size_t(Brakes)> sticks;  ///< True for brakes that end the step at rest.
  bool solved = true;                            ///< False if rounding prevented convergence.
};

namespace detail {

// Clamps p to |p_i| <= limit_i
template <class T, int Brakes>
vector<T, Brakes> within(const vector<T, Brakes>& p, const vector<T, Brakes>& limit) {
  vector<T, Brakes> q;
  for (int i = 0; i < Brakes; ++i) q[i] = std::max(std::min(p[i], limit[i]), -limit[i]);
  return q;
}

}  // namespace detail

/// Solves w = w0 + A p with |p_i| <= limit_i, so that each brake either sticks (w_i = 0) or slips with the
/// full impulse against its motion (p_i = -limit_i sgn(w_i)): a box-constrained linear complementarity
/// problem.
///
/// A = T M^-1 T^T (m x m) symmetric positive definite, w0 [rad/s] the rates without brakes, limit [N m s] >=
/// 0. The solution exists and is unique. Least-index principal pivoting is exact and finite for any such A
/// (Murty 1974; with bounds: Judice and Pires 1992). Cost: one m x m Cholesky per pivot, few in practice.
template <class T, int Brakes>
friction_impulses<T, Brakes> solve_box_friction(const matrix<T, Brakes, Brakes>& A,
                                                const vector<T, Brakes>& w0, const vector<T, Brakes>& limit) {
  enum class mode { stick, upper, lower };
  std::array<mode, std::size_t(Brakes)> modes;
  modes.fill(mode::stick);
  const T slack = rounding_tolerance<T>(Brakes);
  const vector<T, Brakes> added = absolute(A) * limit;  // at most, to each rate

  vector<T, Brakes> p, w;
  const int max_pivots = 1 << (2 * Brakes + 2);
  for (int pivot = 0; pivot < max_pivots; ++pivot) {
    // Sticking brakes solve w_i = 0; the others keep p_i at its bound.
    matrix<T, Brakes, Brakes> K = A;
    vector<T, Brakes> rhs = -w0;
    const auto sticks = [&](int i) { return nth(modes, i) == mode::stick && limit[i] > T(0); };
    for (int i = 0; i < Brakes; ++i) {
      if (sticks(i)) continue;
      p[i] = nth(modes, i) == mode::lower ? -limit[i] : (nth(modes, i) == mode::upper ? limit[i] : T(0));
      rhs -= column(A, i) * p[i];
      for (int j = 0; j < Brakes; ++j) K(i, j) = K(j, i) = T(i == j);
    }
    for (int i = 0; i < Brakes; ++i) {
      if (!sticks(i)) rhs[i] = p[i];
    }
    p = cholesky<T, Brakes>(K).solve(rhs);
    w = w0 + A * p;

    int violating = -1;
    for (int i = 0; i < Brakes && violating < 0; ++i) {
      if (!(limit[i] > T(0))) continue;
      const T rate_slack = slack * (std::abs(w0[i]) + added[i]);
      const bool over = nth(modes, i) == mode::stick
                            ? std::abs(p[i]) > limit[i] * (T(1) + slack)
                            : (nth(modes, i) == mode::upper ? w[i] > rate_slack : w[i] < -rate_slack);
      if (over) violating = i;
    }
    if (violating < 0) {
      friction_impulses<T, Brakes> result{detail::within(p, limit), {}, true};
      for (int i = 0; i < Brakes; ++i) nth(result.sticks, i) = sticks(i);
      return result;
    }
    mode& m = nth(modes, violating);
    m = m != mode::stick ? mode::stick : (p[violating] > T(0) ? mode::upper : mode::lower);
  }
  return {detail::within(p, limit), {}, false};
}

/// Box friction of redundant brakes, m > n, with A only positive semi-definite: w is unique, p is not.
/// Proximal point iteration, p <- the solution for A + eps I and w0 - eps p: two or three rounds (Rockafellar
/// 1976). From p = 0 it ends near the minimum-norm p.
template <class T, int Brakes>
friction_impulses<T, Brakes> solve_redundant_box_friction(const matrix<T, Brakes, Brakes>& A,
                                                          const vector<T, Brakes>& w0,
                                                          const vector<T, Brakes>& limit) {
  const T eps = std::sqrt(std::numeric_limits<T>::epsilon()) * A.trace() / T(Brakes);
  const matrix<T, Brakes, Brakes> regular = A + eps * matrix<T, Brakes, Brakes>::Identity();
  friction_impulses<T, Brakes> result{vector<T, Brakes>::Zero(), {}, false};
  constexpr int max_rounds = 30;
  for (int round = 0; round < max_rounds; ++round) {
    const vector<T, Brakes> before = result.impulse;
    result = solve_box_friction<T, Brakes>(regular, w0 - eps * before, limit);
    if (!result.solved) return result;
    const T scale = w0.norm() + A.norm() * result.impulse.norm();
    if (eps * (result.impulse - before).norm() <= std::numeric_limits<T>::epsilon() * scale) return result;
  }
  result.solved = false;
  return result;
}

}  // namespace passive_haptics
