/// @file
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

/// A = V R of up to MaxColumns columns, V with orthogonal columns and R upper triangular with ones on its
/// diagonal; the residual r = f - V (V^T V)^-1 V^T f of a target f is kept beside it.
///
/// By Gram-Schmidt. V is explicit and reorthogonalised where digits were lost, so r stays orthogonal to the
/// columns at any condition of A: no Gram matrix, no inverse; and no root, for which the next column would
/// wait. Columns of different lengths are welcome. Cost of append: 4 Rows size flops, twice that where a
/// column nearly depends on those before it. Reference: Daniel, Gragg, Kaufman, Stewart, Reorthogonalization
/// and stable algorithms for updating the Gram-Schmidt QR factorization, Math. Comp. 30 (1976).
template <class T, int Rows, int MaxColumns>
class updatable_qr {
 public:
  using column = lanes<T, Rows>;                                             ///< A column of A or V.
  using coefficients = std::array<T, static_cast<std::size_t>(MaxColumns)>;  ///< One for each column.

  /// No columns: r = f.
  [[gnu::always_inline]] explicit updatable_qr(const column& f) : r_(f) {}

  /// Columns so far.
  int size() const { return size_; }
  /// r
  const column& residual() const { return r_; }
  /// Column k of V.
  const column& orthogonal(int k) const { return nth(v_, k); }
  /// v_k . f / |v_k|^2
  T along(int k) const { return nth(c_, k); }
  /// v_k . b / |v_k|^2
  [[gnu::always_inline]] T along(int k, const column& b) const {
    return dot(nth(v_, k), b) * nth(inverse_square_, k);
  }
  /// 1 / |v_k|^2
  T inverse_square(int k) const { return nth(inverse_square_, k); }

  /// Appends a column b of square |b|^2; false, and nothing appended, if it depends on the others to
  /// rounding, so that r is orthogonal to it as well, or if its square is no number any more.
  [[gnu::always_inline]] bool append(const column& b, T square) {
    return append(b, square, [&](int k) PASSIVE_HAPTICS_INLINE { return along(k, b); });
  }

  /// Overload of append for precomputed products along_b(k) = v_k . b / |v_k|^2.
  template <class F>
  [[gnu::always_inline]] bool append(const column& b, T square, F&& along_b) {
    column v = b;
    coefficients& h = nth(upper_, size_);
    T rest = square;
    if (size_ > 0) {
      // All products before the first difference: in turns, as in modified Gram-Schmidt, they wait for each
      // other
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

  /// Keeps the first `count` columns.
  void truncate(int count, const column& f) {
    size_ = count;
    r_ = f;
    for (int k = 0; k < count; ++k) {
      nth(c_, k) = along(k, r_);
      r_ -= nth(c_, k) * nth(v_, k);
    }
  }

  /// Least-squares coefficients y: R y = (V^T V)^-1 V^T f by back substitution.
  [[gnu::always_inline]] void solve(coefficients& y) const {
    for (int k = size_ - 1; k >= 0; --k) {
      T rest = nth(c_, k);
      for (int l = k + 1; l < size_; ++l) rest -= nth(nth(upper_, l), k) * nth(y, l);
      nth(y, k) = rest;
    }
  }

  /// r orthogonal to V to rounding of |r|, however little it is of f: one more pass. Exactly 0 where V spans
  /// all.
  [[gnu::always_inline]] column clean_residual() const {
    if (size_ == Rows) return column{};
    column r = r_;
    coefficients h{};
    each([&](int k) PASSIVE_HAPTICS_INLINE { nth(h, k) = along(k, r_); });
    each([&](int k) PASSIVE_HAPTICS_INLINE { r -= nth(h, k) * nth(v_, k); });
    return r;
  }

 private:
  static constexpr T cancelled = T(0.1);  // of |v|^2: what is left has lost digits against V
  static constexpr T dependent = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);

  // f(k) for each column so far, unrolled: a loop's counting would take a third of the time
  template <class F>
  [[gnu::always_inline]] void each(F&& f) const {
    [&]<int... K>(std::integer_sequence<int, K...>) PASSIVE_HAPTICS_INLINE {
      (void)((K < size_ && (f(K), true)) && ...);
    }(std::make_integer_sequence<int, MaxColumns>());
  }

  // v orthogonal to V, what it loses added to R. before, rest: |v|^2 before it was projected first and since.
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

  // Not initialised: only the first size() entries are ever read
  std::array<column, static_cast<std::size_t>(MaxColumns)> v_;
  std::array<coefficients, static_cast<std::size_t>(MaxColumns)>
      upper_;                    // R by columns, without its diagonal
  coefficients inverse_square_;  // 1 / |v_k|^2
  coefficients c_;               // (V^T V)^-1 V^T f
  column r_;
  int size_ = 0;
};

}  // namespace passive_haptics::detail
