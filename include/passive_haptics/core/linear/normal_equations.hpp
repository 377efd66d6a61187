/// Normal equations of selected columns of a matrix with up to three rows.
#pragma once

#include <passive_haptics/core/linear/lane_products.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics::detail {

/// A = V_S V_S^T for columns S of V (D x M), D <= 3, by Cramer's rule to trace(A)^D / det A roundings.
template <class T, int D, int M>
class normal_equations {
  static_assert(D <= 3);

 public:
  /// V by rows.
  PASSIVE_HAPTICS_INLINE normal_equations(const lanes<T, M> (&V)[std::size_t(D)], const lane_mask<T, M>& S) {
    matrix<T, D, D> A;
    unrolled<D>([&](auto i) {
      const lanes<T, M> in_set = select(S, V[i], T(0));
      for (int j = i; j < D; ++j) A(i, j) = A(j, i) = dot(in_set, V[j]);
    });
    if constexpr (D == 1) {
      cofactors_(0, 0) = T(1);
    } else if constexpr (D == 2) {
      cofactors_ << A(1, 1), -A(0, 1), -A(0, 1), A(0, 0);
    } else {
      const vector<T, 3> x = A.col(0), y = A.col(1), z = A.col(2);
      cofactors_ << cross(y, z), cross(z, x), cross(x, y);
    }
    determinant_ = A.col(0).dot(cofactors_.col(0));
    trace_ = A.trace();
    inverse_ = T(1) / determinant_;
  }

  /// True if a solution has at least half of its digits; false for NaN.
  bool are_sharp() const {
    const T least = T(8) * std::sqrt(std::numeric_limits<T>::epsilon());
    T size = T(1);
    unrolled<D>([&](auto) { size *= trace_; });
    return determinant_ > least * size;
  }

  /// Returns l with A l = f.
  PASSIVE_HAPTICS_INLINE vector<T, D> solve(const vector<T, D>& f) const {
    vector<T, D> l;
    unrolled<D>([&](auto i) {
      T sum = cofactors_(i, 0) * f[0];
      for (int j = 1; j < D; ++j) sum += cofactors_(i, j) * f[j];
      l[i] = inverse_ * sum;
    });
    return l;
  }

 private:
  matrix<T, D, D> cofactors_;  // A^-1 det A
  T determinant_, trace_, inverse_;
};

}  // namespace passive_haptics::detail
