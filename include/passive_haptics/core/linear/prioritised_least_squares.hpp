/// @file
/// Least squares with priorities and bounds.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Finds x with lower <= x <= upper that minimises |A_1 x - b_1|, among those |A_2 x - b_2|, and so on:
///
///     prioritised_least_squares<T, N, MaxRows> x(lower, upper);
///     x.minimise(A1, b1);  // the most important first
///     x.minimise(A2, b2);  // changes nothing of A1 x
///     x.solution();
///
/// Each level is a convex quadratic problem in what the levels before leave free; a primal active set over
/// the bounds solves it: step to the minimum on the free variables, stop at the first bound, release a bound
/// that holds the minimum back. Orthogonal decompositions only, no normal equations. x is within its bounds
/// exactly at any time. Bounds may be infinite; variables with lower = upper are fixed. No allocation. Cost:
/// for each change of the active set a decomposition of the earlier rows and one of the level's. Reference:
/// Escande, Mansard, Wieber, Hierarchical quadratic programming, IJRR 33 (7), 2014.
template <class T, int N, int MaxRows>
class prioritised_least_squares {
 public:
  static constexpr int row_count = MaxRows;  ///< Of a level's matrix.
  using rows = matrix<T, MaxRows, N>;        ///< A level's matrix; rows that it does not need are 0.
  using targets = vector<T, MaxRows>;        ///< A level's right-hand side, 0 there.

  /// Starts at the point of the box that is nearest to 0. lower <= upper.
  prioritised_least_squares(const vector<T, N>& lower, const vector<T, N>& upper)
      : lower_(lower), upper_(upper) {
    for (int i = 0; i < N; ++i) {
      x_[i] = std::min(std::max(T(0), lower[i]), upper[i]);
      at_[idx(i)] = !(lower[i] < upper[i]) ? bound::fixed
                    : x_[i] == lower[i]    ? bound::lower
                    : x_[i] == upper[i]    ? bound::upper
                                           : bound::none;
    }
  }

  /// Minimises |A x - b| without changing what earlier calls reached; all calls but the last together may
  /// have MaxRows rows that are not 0. False if rounding kept the active set from settling; x is then
  /// feasible all the same.
  bool minimise(const rows& A, const targets& b) {
    std::array<bool, static_cast<std::size_t>(N)> refused{};
    bool settled = false;
    for (int change = 0; change < 10 * (N + 1) && !settled; ++change) {
      const decomposition held(on_free(done_), tolerance());
      const T made = advance(constrained_step(A, b, held));
      if (made == T(1)) settled = !release_worst(A, b, held, refused);
      else if (made > T(0)) refused.fill(false);
    }
    for (int i = 0; i < MaxRows && done_rows_ < MaxRows; ++i) {
      if (!(A.row(i).array() == T(0)).all()) done_.row(done_rows_++) = A.row(i);
    }
    return settled;
  }

  /// x so far; within its bounds exactly.
  const vector<T, N>& solution() const { return x_; }

 private:
  enum class bound { none, lower, upper, fixed };
  using decomposition = orthogonal_decomposition<T, MaxRows, N>;

  static std::size_t idx(int i) { return static_cast<std::size_t>(i); }
  // Relative size under which a row or a multiplier is rounding.
  static constexpr T tolerance() { return T(16) * rounding_tolerance<T>(N + MaxRows); }

  // b - A x
  targets residual(const rows& A, const targets& b) const { return b - A * x_; }

  rows on_free(const rows& A) const {
    rows picked = A;
    for (int j = 0; j < N; ++j) {
      if (at_[idx(j)] != bound::none) picked.col(j).setZero();
    }
    return picked;
  }

  // The shortest step of the free variables to the least |A x - b| that changes nothing of the earlier rows.
  vector<T, N> constrained_step(const rows& A, const targets& b, const decomposition& held) const {
    const rows Af = on_free(A);
    rows reduced;
    for (int i = 0; i < MaxRows; ++i) reduced.row(i) = held.without_row_space(Af.row(i)).transpose();
    // A level that sees only rounding of itself in what is left free has nothing to say.
    if (!(reduced.norm() > tolerance() * Af.norm())) return vector<T, N>::Zero();
    const vector<T, N> step = decomposition(reduced, tolerance()).solve(residual(A, b));
    return held.without_row_space(step);
  }

  // Goes along the step up to the first bound; the share of the step that was made, 1 if no bound was met.
  T advance(const vector<T, N>& step) {
    T share = T(1);
    int blocking = -1;
    for (int i = 0; i < N; ++i) {
      const T room = step[i] > T(0) ? upper_[i] - x_[i] : lower_[i] - x_[i];
      if (at_[idx(i)] == bound::none && std::abs(step[i]) * share > std::abs(room)) {
        share = room / step[i];
        blocking = i;
      }
    }
    for (int i = 0; i < N; ++i) {
      if (at_[idx(i)] == bound::none) x_[i] = std::clamp(x_[i] + share * step[i], lower_[i], upper_[i]);
    }
    if (blocking < 0) return T(1);
    const bool up = step[blocking] > T(0);
    at_[idx(blocking)] = up ? bound::upper : bound::lower;
    x_[blocking] = up ? upper_[blocking] : lower_[blocking];
    return std::min(share, T(1) - std::numeric_limits<T>::epsilon());
  }

  // Releases the bound whose multiplier has the wrong sign by most. If there is none, fixes the bounds that
  // hold this level back, since no later level may release them, and returns false.
  bool release_worst(const rows& A, const targets& b, const decomposition& held,
                     std::array<bool, static_cast<std::size_t>(N)>& refused) {
    const targets r = residual(A, b);
    vector<T, N> pull = A.transpose() * r;  // - gradient of |A x - b|^2 / 2
    vector<T, N> on_free_pull = pull;
    for (int i = 0; i < N; ++i) {
      if (at_[idx(i)] != bound::none) on_free_pull[i] = T(0);
    }
    // What the earlier rows take up of it
    pull -= done_.transpose() * held.solve_transposed(on_free_pull);

    const T size = b.norm() + r.norm();  // at least |A x|
    const auto noise = [&](int i) { return tolerance() * A.col(i).norm() * size; };
    int worst = -1;
    T most = T(0);
    for (int i = 0; i < N; ++i) {
      const bound at = at_[idx(i)];
      const T inward = at == bound::lower ? pull[i] : (at == bound::upper ? -pull[i] : T(0));
      if (inward > noise(i) && inward > most && !refused[idx(i)]) {
        most = inward;
        worst = i;
      }
    }
    if (worst >= 0) {
      at_[idx(worst)] = bound::none;
      return refused[idx(worst)] = true;
    }
    for (int i = 0; i < N; ++i) {
      if (at_[idx(i)] != bound::none && std::abs(pull[i]) > noise(i)) at_[idx(i)] = bound::fixed;
    }
    return false;
  }

  vector<T, N> lower_, upper_, x_;
  std::array<bound, static_cast<std::size_t>(N)> at_;
  rows done_ = rows::Zero();  // rows of the levels before: A x of these must not change
  int done_rows_ = 0;
};

}  // namespace passive_haptics
