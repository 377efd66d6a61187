/// @file
/// Thin QR decomposition of a set of columns that grows and shrinks.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace passive_haptics {

/// A = Q R of up to MaxColumns columns, with the residual r = f - Q Q^T f of a target f kept beside it.
///
/// By modified Gram-Schmidt. Q is explicit and reorthogonalised where digits were lost, so r stays orthogonal to the
/// columns at any condition of A: no Gram matrix, no inverse. Columns of different lengths are welcome.
/// Cost of append: 4 Rows size flops, twice that where a column nearly depends on those before it.
/// Reference: Daniel, Gragg, Kaufman, Stewart, Reorthogonalization and stable algorithms for updating the
/// Gram-Schmidt QR factorization, Math. Comp. 30 (1976).
template <class T, int Rows, int MaxColumns>
class growing_qr {
 public:
  using column = vector<T, Rows>;                                            ///< A column of A or Q.
  using coefficients = std::array<T, static_cast<std::size_t>(MaxColumns)>;  ///< One for each column.

  /// No columns: r = f.
  explicit growing_qr(const column& f) : r_(f) {}

  /// Columns so far.
  int size() const { return size_; }
  /// r
  const column& residual() const { return r_; }

  /// Appends a column b; false, and nothing appended, if it depends on the others to rounding: then r is orthogonal
  /// to it as well. square = |b|^2 > 0.
  bool append(const column& b, T square) {
    column v = b;
    coefficients& h = upper_[at(size_)];
    for (int k = 0; k < size_; ++k) {
      h[at(k)] = q_[at(k)].dot(v);
      v -= h[at(k)] * q_[at(k)];
    }
    T before = square, rest = size_ > 0 ? v.squaredNorm() : square;
    for (int pass = 0; pass < 2 && rest < cancelled * before; ++pass) {  // twice is enough (Kahan)
      before = rest;
      for (int k = 0; k < size_; ++k) {
        const T again = q_[at(k)].dot(v);
        h[at(k)] += again;
        v -= again * q_[at(k)];
      }
      rest = v.squaredNorm();
    }
    if (!(rest > dependent * square)) return false;
    const T length = std::sqrt(rest);
    inverse_diagonal_[at(size_)] = T(1) / length;
    q_[at(size_)] = v * inverse_diagonal_[at(size_)];
    project(size_++);
    return true;
  }

  /// Keeps the first `count` columns.
  void truncate(int count, const column& f) {
    size_ = count;
    r_ = f;
    for (int k = 0; k < size_; ++k) project(k);
  }

  /// Least-squares coefficients y: R y = Q^T f by back substitution.
  void solve(coefficients& y) const {
    for (int k = size_ - 1; k >= 0; --k) {
      T rest = c_[at(k)];
      for (int l = k + 1; l < size_; ++l) rest -= upper_[at(l)][at(k)] * y[at(l)];
      y[at(k)] = rest * inverse_diagonal_[at(k)];
    }
  }

  /// r orthogonal to Q to rounding of |r|, however little it is of f: one more pass. Exactly 0 where Q spans all.
  column clean_residual() const {
    if (size_ == Rows) return column::Zero();
    column r = r_;
    for (int k = 0; k < size_; ++k) r -= q_[at(k)].dot(r) * q_[at(k)];
    return r;
  }

 private:
  static constexpr T cancelled = T(0.1);  // of |v|^2: what is left has lost digits against Q
  static constexpr T dependent = rounding_tolerance<T>(Rows) * rounding_tolerance<T>(Rows);
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }

  void project(int k) {
    c_[at(k)] = q_[at(k)].dot(r_);
    r_ -= c_[at(k)] * q_[at(k)];
  }

  // Not initialised: only the first size() entries are ever read
  std::array<column, static_cast<std::size_t>(MaxColumns)> q_;
  std::array<coefficients, static_cast<std::size_t>(MaxColumns)>
      upper_;  // R by columns, without its diagonal
  coefficients inverse_diagonal_;
  coefficients c_;  // Q^T f
  column r_;
  int size_ = 0;
};

}  // namespace passive_haptics
