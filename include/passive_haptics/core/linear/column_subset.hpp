/// Least-norm solutions of linear equations on a subset of their columns.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace passive_haptics::detail {

/// Factorisation V_S = L Q by rows for a set S of the columns of V (D x M), with R = L^-1 V for all columns
/// and z = L^-1 f. On S, u = R^T z is the least-norm solution of V_S x = f; elsewhere it is V^T l with the
/// multipliers l. Uses Gram-Schmidt with pivoted rows and reorthogonalisation after cancellation. u is as
/// accurate as the equations. Rows that are only rounding are dropped. Cost: 4 M D^2 flops.
template <class T, int D, int M>
class column_subset {
 public:
  using per_column = lanes<T, M>;                      ///< One number per column of V.
  static constexpr std::size_t rows = std::size_t(D);  ///< Rows of V.

  /// V by rows and f. in_set: 1 for the columns in S, else 0.
  PASSIVE_HAPTICS_INLINE column_subset(const per_column (&V)[rows], const vector<T, D>& f,
                                       const per_column& in_set) {
    unrolled<D>([&](auto k) {
      r_[k] = V[k];
      z_[k] = f[k];
      equation_[k] = k;
      before_[k] = rest_[k] = product(in_set, r_[k], r_[k]);
      total_ += rest_[k];
    });
    unrolled<D>([&](auto k) { take(k, in_set); });
  }

  /// False if f has a component outside the range of V_S, beyond rounding.
  bool reaches(T tolerance) const { return unreached_ <= tolerance; }

  /// Returns u and the magnitude of its terms, for rounding bounds.
  PASSIVE_HAPTICS_INLINE std::pair<per_column, per_column> solution() const {
    per_column u{}, size{};
    unrolled<D>([&](auto k) {
      const T c = z_[k] * inverse_[k], magnitude = std::abs(c);
      u += c * r_[k];
      size += magnitude * abs(r_[k]);
    });
    return {u, size};
  }

  /// Returns the least-norm solution of V_S x = g for another g. Undefined outside S.
  PASSIVE_HAPTICS_INLINE per_column solution_of(const vector<T, D>& g) const {
    per_column u{};
    T z[rows];
    unrolled<D>([&](auto k) {
      z[k] = g[equation_[k]];
      for (int l = 0; l < k; ++l) z[k] -= lower_[k][l] * z[l];
      const T c = z[k] * inverse_[k];
      u += c * r_[k];
    });
    return u;
  }

 private:
  static constexpr T cancelled = T(0.01), much_shorter = T(0.01);
  static constexpr T dependent = rounding_tolerance<T>(D) * rounding_tolerance<T>(D);

  PASSIVE_HAPTICS_INLINE static T product(const per_column& weight, const per_column& a,
                                          const per_column& b) {
    return dot(weight * a, b);
  }

  // Subtracts from row l its projection on row k
  PASSIVE_HAPTICS_INLINE void project(int l, int k, const per_column& in_set) {
    const T h = product(in_set, r_[k], r_[l]) * inverse_[k];
    r_[l] -= h * r_[k];
    z_[l] -= h * z_[k];
    lower_[l][k] += h;
  }

  // Makes row k the next row of Q and removes its component from those below
  PASSIVE_HAPTICS_INLINE void take(int k, const per_column& in_set) {
    int longest = k;
    for (int l = k + 1; l < D; ++l) longest = rest_[l] > rest_[longest] ? l : longest;
    if (rest_[k] < much_shorter * rest_[longest]) swap_rows(k, longest);
    for (int pass = 0; pass < 2 && rest_[k] < cancelled * before_[k]; ++pass) {  // twice is enough (Kahan)
      for (int l = 0; l < k; ++l) project(k, l, in_set);
      before_[k] = rest_[k];
      rest_[k] = product(in_set, r_[k], r_[k]);
    }
    const bool counts = rest_[k] > dependent * total_;
    if (!counts) unreached_ = std::max(unreached_, std::abs(z_[k]));
    inverse_[k] = counts ? T(1) / rest_[k] : T(0);
    for (int l = k + 1; l < D; ++l) {
      project(l, k, in_set);
      rest_[l] = product(in_set, r_[l], r_[l]);
    }
  }

  [[gnu::noinline]] void swap_rows(int k, int l) {
    std::swap(r_[k], r_[l]);
    std::swap(z_[k], z_[l]);
    std::swap(rest_[k], rest_[l]);
    std::swap(before_[k], before_[l]);
    std::swap(equation_[k], equation_[l]);
    std::swap(lower_[k], lower_[l]);
  }

  per_column r_[rows];
  T z_[rows];
  T rest_[rows], before_[rows];  // |r_k|^2 on S, now and at the last orthogonalisation
  T inverse_[rows];
  T lower_[rows][rows] = {};           // L below its unit diagonal
  int equation_[rows];                 // original index of row k
  T total_ = T(0), unreached_ = T(0);  // |V_S|^2; the largest |z| of a dropped row
};

}  // namespace passive_haptics::detail
