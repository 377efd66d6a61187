/// @file
/// Least squares with priorities and bounds, in the way that fits the number of unknowns.
#pragma once

#include <passive_haptics/core/linear/elimination.hpp>
#include <passive_haptics/core/linear/prioritised_least_squares.hpp>

#include <algorithm>

namespace passive_haptics {

namespace detail {

// x without bounds, of the unknowns that are not held. Levels of zeros, of which most problems have some,
// cost nothing.
template <class T, int N, int... Rows>
vector<T, N> without_bounds(const vector<T, N>& x, const vector<bool, N>& held,
                            const least_squares_level<T, Rows, N>&... levels) {
  elimination<T, N> free(x, held);
  static_cast<void>(((!levels.A.isZero(T(0)) && free.minimise(levels)) || ...));
  return free.solution();
}

// The best x in the box, `Free` unknowns of which are not held; holds those that end at a bound. One of the
// bounds that the best x without bounds violates holds the best x in the box, as on the way from one to the
// other all levels get better: so each of these is tried.
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
      // Rightly held if it would leave the box again, could it move with those that are not held
      vector<bool, N> others = held;
      others[i] = given[i];
      if (others == given) return;
      if (std::clamp(without_bounds(x, others, levels...)[i], lower[i], upper[i]) == x[i]) return;
    }
  }
}

}  // namespace detail

/// The x with lower <= x <= upper that minimises |A_1 x - b_1|, among those |A_2 x - b_2|, and so on:
///
///     x = least_squares_by_priority(lower, upper, least_squares_level{A_1, b_1}, least_squares_level{A_2});
///
/// The last level decides every unknown that is left, by N rows. x is within its bounds exactly; they may be
/// infinite. Cost: up to four unknowns are eliminated in closed form, for each set of bounds that may hold
/// them, two to six times mostly. More take an active set (core/linear/prioritised_least_squares.hpp).
/// MostRows is for the active set: how many rows but those of the last level may not be 0; all if it is -1.
template <int MostRows = -1, class T, int N, int... Rows>
vector<T, N> least_squares_by_priority(const vector<T, N>& lower, const vector<T, N>& upper,
                                       const least_squares_level<T, Rows, N>&... levels) {
  if constexpr (N <= 4) {
    vector<T, N> x;
    if constexpr (N == 1) x.setZero();  // g++ 12 takes it for read where the one unknown is held
    vector<bool, N> held = vector<bool, N>::Constant(false);
    detail::settle<N>(x, held, lower, upper, levels...);
    return x;
  } else {
    // Room for each level alone, and for all but the last together
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
