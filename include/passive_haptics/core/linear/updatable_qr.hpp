/// Thin QR decomposition of a set of columns that grows and shrinks.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/nth.hpp>

#include <array>
#include <limits>
#include <utility>

namespace passive_haptics::detail {

/// A = V R with up to MaxColumns columns, orthogonal columns of V and a unit upper triangular R. Also keeps
/// the residual r = f - V (V^T V)^-1 V^T f of a target f. Uses Gram-Schmidt with an explicit V,
/// reorthogonalised after cancellation, so r stays orthogonal to the columns at any condition number of A.
/// There is no Gram matrix, inverse or root. Columns may differ in length. Cost of append: 4 Rows size flops,
/// twice that for a nearly dependent column. Source: Daniel, Gragg, Kaufman, Stewart, Reorthogonalization and
/// stable algorithms for updating the Gram-Schmidt QR factorization, Math. Comp. 30 (1976).
template <class T, int Rows, int MaxColumns>
class updatable_qr {
 public:
  using column = lanes<T, Rows>;                                             ///< A column of A or V.
  using coefficients = std::array<T, static_cast<std::size_t>(MaxColumns)>;  ///< One number per column.

  /// Starts without columns: r = f.
  PASSIVE_HAPTICS_INLINE explicit updatable_qr(const column& f) : r_(f) {}

  int size() const { return size_; }                            ///< Number of columns.
  const column& residual() const { return r_; }                 ///< The residual r.
  const column& orthogonal(int k) const { return nth(v_, k); }  ///< Column k of V.
  T along(int k) const { return nth(c_, k); }                   ///< Returns v_k . f / |v_k|^2.
  /// Returns v_k . b / |v_k|^2.
  PASSIVE_HAPTICS_INLINE T along(int k, const column& b) const {
    return dot(nth(v_, k), b) * nth(inverse_square_, k);
  }
  T inverse_square(int k) const { return nth(inverse_square_, k); }  ///< Returns 1 / |v_k|^2.

  /// Appends a column b with the square |b|^2. Returns false without appending if b depends on the others to
  /// rounding (r is then orthogonal to b) or the square underflows.
  PASSIVE_HAPTICS_INLINE bool append(const column& b, T square) {
    return append(b, square, [&](int k) PASSIVE_HAPTICS_INLINE { return along(k, b); });
  }

  /// As above, with precomputed along_b(k) = v_k . b / |v_k|^2.
  template <class F>
  PASSIVE_HAPTICS_INLINE bool append(const column& b, T square, F&& along_b) {
    column v = b;
    coefficients& h = nth(upper_, size_);
    T rest = square;
    if (size_ > 0) {
      // All products before the first difference: in modified Gram-Schmidt they wait for each other
      each([&](int k) PASSIVE_HAPTICS_INLINE { nth(h, k) = along_b(k); });
      each([&](int k) PASSIVE_HAPTICS_INLINE { v -= nth(h, k) * nth(v_, k); });
      rest = dot(v, v);
      if (rest < cancelled * square) rest = reorthogonalise(v, square, rest);
    }
    if (!(rest > dependent * square + std::numeric_limits<T>::min())) return false;
    nth(v_, size_) = v;
    nth(inverse_square_, size_) = T(1) / rest;
    nth(c_, size_) = dot(v, r_) / rest;
    r_ -= nth(c_, size_) * v;
    ++size_;
    return true;
  }

  /// Keeps the first `count` columns, with the target f.
  void truncate(int count, const column& f) {
    size_ = count;
    r_ = f;
    for (int k = 0; k < count; ++k) {
      nth(c_, k) = along(k, r_);
      r_ -= nth(c_, k) * nth(v_, k);
    }
  }

  /// Computes the least-squares coefficients y: R y = (V^T V)^-1 V^T f, by back substitution.
  PASSIVE_HAPTICS_INLINE void solve(coefficients& y) const {
    for (int k = size_ - 1; k >= 0; --k) {
      T rest = nth(c_, k);
      for (int l = k + 1; l < size_; ++l) rest -= nth(nth(upper_, l), k) * nth(y, l);
      nth(y, k) = rest;
    }
  }

  /// Returns r after another projection, orthogonal to V to rounding of |r|; exactly 0 if V spans the space.
  PASSIVE_HAPTICS_INLINE column clean_residual() const {
    if (size_ == Rows) return column{};
    column r = r_;
    coefficients h{};
    each([&](int k) PASSIVE_HAPTICS_INLINE { nth(h, k) = along(k, r_); });
    each([&](int k) PASSIVE_HAPTICS_INLINE { r -= nth(h, k) * nth(v_, k); });
    return r;
  }

 private:
  static constexpr T cancelled = T(0.1);  // share of |v|^2 below which digits were lost
  static constexpr T dependent = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);

  // Calls f(k) for each column, unrolled because a loop counter would take a third of the time
  template <class F>
  PASSIVE_HAPTICS_INLINE void each(F&& f) const {
    [&]<int... K>(std::integer_sequence<int, K...>) PASSIVE_HAPTICS_INLINE {
      (void)((K < size_ && (f(K), true)) && ...);
    }(std::make_integer_sequence<int, MaxColumns>());
  }

  // Makes v orthogonal to V, and updates R. before, rest: |v|^2 around the first projection.
  [[gnu::noinline]] T reorthogonalise(column& v, T before, T rest) {
    coefficients& h = nth(upper_, size_);
    for (int pass = 0; pass < 2 && rest < cancelled * before; ++pass) {  // twice is enough (Kahan)
      coefficients again{};
      for (int k = 0; k < size_; ++k) nth(again, k) = along(k, v);
      for (int k = 0; k < size_; ++k) {
        nth(h, k) += nth(again, k);
        v -= nth(again, k) * nth(v_, k);
      }
      before = rest;
      rest = dot(v, v);
    }
    return rest;
  }

  // Not initialised: only the first size() entries are read
  std::array<column, static_cast<std::size_t>(MaxColumns)> v_;
  std::array<coefficients, static_cast<std::size_t>(MaxColumns)>
      upper_;                    // R by columns, without its diagonal
  coefficients inverse_square_;  // 1 / |v_k|^2
  coefficients c_;               // (V^T V)^-1 V^T f
  column r_;
  int size_ = 0;
};

}  // namespace passive_haptics::detail
