/// Prioritised least squares with bounds.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/nth.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace passive_haptics {

/// Finds the x with lower <= x <= upper that minimises |A_1 x - b_1|, among those |A_2 x - b_2|, and so on:
///
///     prioritised_least_squares<T, N, MaxRows> x(lower, upper);
///     x.minimise(A1, b1);  // highest priority first
///     x.minimise(A2, b2);  // keeps A1 x
///     x.solution();
///
/// Each level is a convex quadratic problem in the remaining freedom, solved by a primal active set over the
/// bounds: step to the minimum on the free variables, stop at the first bound, release a bound that blocks
/// the minimum. Where several bounds meet, the one with the lowest index is released, which prevents cycling
/// (Chang, Cottle, Math. Programming 18, 1980). Uses orthogonal decompositions, no normal equations.
///
/// x satisfies its bounds exactly; they may be infinite. Cost: two decompositions per change of the active
/// set. Source: Escande, Mansard, Wieber, Hierarchical quadratic programming, IJRR 33 (7), 2014.
template <class T, int N, int MaxRows>
class prioritised_least_squares {
 public:
  static constexpr int row_count = MaxRows;  ///< Rows of a level's matrix.
  using rows = matrix<T, MaxRows, N>;        ///< A level's matrix, padded with rows of zeros.
  using targets = vector<T, MaxRows>;        ///< A level's right-hand side, padded with zeros.

  /// Starts at the point of the box nearest to 0. Requires lower <= upper.
  prioritised_least_squares(const vector<T, N>& lower, const vector<T, N>& upper)
      : lower_(lower), upper_(upper) {
    for (int i = 0; i < N; ++i) {
      x_[i] = std::min(std::max(T(0), lower[i]), upper[i]);
      nth(at_, i) = !(lower[i] < upper[i]) ? bound::fixed
                    : x_[i] == lower[i]    ? bound::lower
                    : x_[i] == upper[i]    ? bound::upper
                                           : bound::none;
    }
  }

  /// Minimises |A x - b| without changing the residuals of earlier levels. Calls before the last may have
  /// MaxRows nonzero rows in total. False if rounding kept the active set from settling; x is still feasible.
  bool minimise(const rows& A, const targets& b) {
    flags refused{};     // bounds released because of rounding
    int released = -1;   // the last bound released, or -1
    bool stuck = false;  // the last step met a bound immediately: several meet here
    bool settled = false;
    for (int change = 0; change < 10 * (N + 1) && !settled; ++change) {
      const decomposition held(on_free(done_), tolerance()), free = reduced(A, held);
      const auto [share, blocking] = advance(held.without_row_space(free.solve(residual(A, b))));
      if (released >= 0 && blocking == released && share == T(0))
        nth(refused, std::exchange(released, -1)) = true;
      else if (released >= 0) refused.fill(false);
      if (blocking >= 0) {
        stuck = share == T(0);
        continue;
      }
      released = to_release(A, clean_residual(A, b, free), held, refused, stuck);
      settled = released < 0;
      if (!settled) nth(at_, released) = bound::none;
    }
    for (int i = 0; i < MaxRows && done_rows_ < MaxRows; ++i) {
      if (!(A.row(i).array() == T(0)).all()) done_.row(done_rows_++) = A.row(i);
    }
    return settled;
  }

  const vector<T, N>& solution() const { return x_; }  ///< The current x, exactly within its bounds.

 private:
  enum class bound { none, lower, upper, fixed };
  using decomposition = orthogonal_decomposition<T, MaxRows, N>;
  using flags = std::array<bool, static_cast<std::size_t>(N)>;

  // Relative size of rounding in rows and multipliers; later levels contain that of the earlier ones.
  static constexpr T tolerance() { return T(16) * rounding_tolerance<T>(N + MaxRows); }
  static constexpr T sharp = rounding_tolerance<T>(N);
  T rank_tolerance() const { return done_rows_ == 0 ? sharp : tolerance(); }

  targets residual(const rows& A, const targets& b) const { return b - A * x_; }

  static T max_row_norm(const rows& A) { return A.rowwise().norm().maxCoeff(); }

  rows on_free(const rows& A) const {
    rows picked = A;
    for (int j = 0; j < N; ++j) {
      if (nth(at_, j) != bound::none) picked.col(j).setZero();
    }
    return picked;
  }

  // b - A x without the range of the free variables, which is only rounding; 0 if all of it is.
  targets clean_residual(const rows& A, const targets& b, const decomposition& free) const {
    targets r = residual(A, b);
    const T size = b.norm() + (A.cwiseAbs() * x_.cwiseAbs()).norm();
    r = free.without_column_space(r);
    return r.norm() > sharp * size ? r : targets(targets::Zero());
  }

  // A on the free variables, projected off the earlier rows, for the shortest step that preserves them.
  decomposition reduced(const rows& A, const decomposition& held) const {
    const rows Af = on_free(A);
    rows rest;
    for (int i = 0; i < MaxRows; ++i) rest.row(i) = held.without_row_space(Af.row(i)).transpose();
    // Ignore a level that only has rounding errors left in the free variables.
    if (!(rest.norm() > tolerance() * Af.norm())) rest.setZero();
    return decomposition(rest, rank_tolerance());
  }

  // Moves up to the first bound. Returns the share of the step and the blocking variable, or -1.
  std::pair<T, int> advance(const vector<T, N>& step) {
    T share = T(1);
    int blocking = -1;
    for (int i = 0; i < N; ++i) {
      const T room = step[i] > T(0) ? upper_[i] - x_[i] : lower_[i] - x_[i];
      if (nth(at_, i) == bound::none && std::abs(step[i]) * share > std::abs(room)) {
        share = room / step[i];
        blocking = i;
      }
    }
    for (int i = 0; i < N; ++i) {
      if (nth(at_, i) == bound::none) x_[i] = std::clamp(x_[i] + share * step[i], lower_[i], upper_[i]);
    }
    if (blocking >= 0) {
      const bool up = step[blocking] > T(0);
      nth(at_, blocking) = up ? bound::upper : bound::lower;
      x_[blocking] = up ? upper_[blocking] : lower_[blocking];
    }
    return {share, blocking};
  }

  // Returns the bound with the most wrong multiplier, or the first wrong one; -1 if none. In that case, the
  // bounds that block this level become fixed because no later level may release them.
  int to_release(const rows& A, const targets& r, const decomposition& held, const flags& refused,
                 bool first) {
    vector<T, N> pull = A.transpose() * r;  // negative gradient of |A x - b|^2 / 2
    vector<T, N> on_free_pull = pull;
    for (int i = 0; i < N; ++i) {
      if (nth(at_, i) != bound::none) on_free_pull[i] = T(0);
    }
    // Component absorbed by the earlier rows
    const targets taken = held.solve_transposed(on_free_pull);
    pull -= done_.transpose() * taken;
    // Columns that the decompositions consider dependent have no pull
    const T noise = rank_tolerance() * (max_row_norm(A) * r.norm() + max_row_norm(done_) * taken.norm());
    int worst = -1;
    T largest = noise;
    for (int i = 0; i < N && !(first && worst >= 0); ++i) {
      const bound at = nth(at_, i);
      const T inward = at == bound::lower ? pull[i] : (at == bound::upper ? -pull[i] : T(0));
      if (!(inward > largest) || nth(refused, i)) continue;
      largest = inward;
      worst = i;
    }
    for (int i = 0; i < N && worst < 0; ++i) {
      if (nth(at_, i) != bound::none && std::abs(pull[i]) > noise) nth(at_, i) = bound::fixed;
    }
    return worst;
  }

  vector<T, N> lower_, upper_, x_;
  std::array<bound, static_cast<std::size_t>(N)> at_;
  rows done_ = rows::Zero();  // rows of the earlier levels, with fixed products with x
  int done_rows_ = 0;
};

}  // namespace passive_haptics
