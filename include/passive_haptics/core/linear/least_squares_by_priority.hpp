/// Prioritised least squares with bounds, by the method that suits the number of unknowns.
#pragma once

#include <passive_haptics/core/linear/elimination.hpp>
#include <passive_haptics/core/linear/prioritised_least_squares.hpp>

#include <algorithm>

namespace passive_haptics {

namespace detail {

// Solves without bounds for the unknowns that are not held. Skips levels of zeros, which are common.
template <class T, int N, int... Rows>
vector<T, N> without_bounds(const vector<T, N>& x, const vector<bool, N>& held,
                            const least_squares_level<T, Rows, N>&... levels) {
  elimination<T, N> free(x, held);
  static_cast<void>(((!levels.A.isZero(T(0)) && free.minimise(levels)) || ...));
  return free.solution();
}

// Finds the best x in the box with `Free` free unknowns, and holds those at a bound. At least one bound that
// the unbounded optimum violates is active at the bounded one: each of them is tried.
template <int Free, class T, int N, int... Rows>
void settle(vector<T, N>& x, vector<bool, N>& held, const vector<T, N>& lower, const vector<T, N>& upper,
            const least_squares_level<T, Rows, N>&... levels) {
  const vector<bool, N> given = held;
  const vector<T, N> best = without_bounds(x, held, levels...), inside = best.cwiseMax(lower).cwiseMin(upper);
  x = inside;
  if constexpr (Free == 1) {
    held = held.array() || best.array() != inside.array();
  } else {
    for (int i = 0; i < N; ++i) {
      if (given[i] || best[i] == inside[i]) continue;
      x = inside;
      held = given;
      held[i] = true;
      settle<Free - 1>(x, held, lower, upper, levels...);
      // Correctly held if it would leave the box again when released together with the free unknowns
      vector<bool, N> others = held;
      others[i] = given[i];
      if (others == given) return;
      if (std::clamp(without_bounds(x, others, levels...)[i], lower[i], upper[i]) == x[i]) return;
    }
  }
}

}  // namespace detail

/// Returns the x with lower <= x <= upper that minimises |A_1 x - b_1|, among those |A_2 x - b_2|, and so on:
///
///     x = least_squares_by_priority(lower, upper, least_squares_level{A_1, b_1}, least_squares_level{A_2});
///
/// The last level must have N rows and determine all remaining unknowns. x satisfies its bounds exactly; they
/// may be infinite. Up to four unknowns are eliminated in closed form for each set of bounds tried, usually
/// two to six; more use an active set (core/linear/prioritised_least_squares.hpp) with up to MostRows nonzero
/// rows before the last level, -1 for all.
template <int MostRows = -1, class T, int N, int... Rows>
vector<T, N> least_squares_by_priority(const vector<T, N>& lower, const vector<T, N>& upper,
                                       const least_squares_level<T, Rows, N>&... levels) {
  if constexpr (N <= 4) {
    vector<T, N> x;
    if constexpr (N == 1) x.setZero();  // avoids a warning of g++ 12 if the only unknown is held
    vector<bool, N> held = vector<bool, N>::Constant(false);
    detail::settle<N>(x, held, lower, upper, levels...);
    return x;
  } else {
    // Enough rows for each level and for all before the last
    constexpr int rows = std::max({MostRows >= 0 ? MostRows : (Rows + ...) - N, Rows...});
    prioritised_least_squares<T, N, rows> x(lower, upper);
    const auto minimise = [&](const auto& level) {
      if (!level.A.isZero(T(0))) x.minimise(padded<rows>(level.A), padded<rows>(level.b));
    };
    (minimise(levels), ...);
    return x.solution();
  }
}

}  // namespace passive_haptics
