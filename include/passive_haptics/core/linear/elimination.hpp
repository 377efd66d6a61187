/// Prioritised least squares without bounds, by elimination.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <algorithm>

namespace passive_haptics {

/// One level of a prioritised least-squares problem, |A x - b|. A row of zeros imposes no constraint.
template <class T, int Rows, int N>
struct least_squares_level {
  matrix<T, Rows, N> A = matrix<T, Rows, N>::Zero();  ///< Coefficients.
  vector<T, Rows> b = vector<T, Rows>::Zero();        ///< Right-hand side.
};

/// A level with b = 0.
template <class T, int Rows, int N>
least_squares_level(const Eigen::Matrix<T, Rows, N>&) -> least_squares_level<T, Rows, N>;
/// A level of A and b.
template <class T, int Rows, int N>
least_squares_level(const Eigen::Matrix<T, Rows, N>&, const Eigen::Matrix<T, Rows, 1>&)
    -> least_squares_level<T, Rows, N>;

/// Finds the x that minimises |A_1 x - b_1|, among those |A_2 x - b_2|, and so on; some unknowns can be held:
///
///     elimination<T, N> x(values, held);
///     x.minimise(level_1) || x.minimise(level_2);  // highest priority first; true if x is determined
///     x.solution();
///
/// Each step solves a level for the unknown of its longest column a_p,
///
///     x_p = beta - sum_j rho_j x_j,   beta = a_p . b / |a_p|^2,   |rho_j| = |a_p . a_j| / |a_p|^2 <= 1,
///
/// and substitutes it into the level, where the part orthogonal to a_p remains, and into all later levels.
/// This repeats until only rounding is left of the level: Gram-Schmidt with pivoting, without normal
/// equations. Cost: N^2 k for levels of k rows; nothing once x is determined.
template <class T, int N>
class elimination {
 public:
  /// Held unknowns have these values. Unknowns that no level determines become 0.
  elimination(const vector<T, N>& values, const vector<bool, N>& held) : known_(held) {
    for (int i = 0; i < N; ++i) {
      if (!held[i]) continue;
      x_[i] = values[i];
      --left_;
    }
  }

  /// Minimises |A x - b| in the unknowns that remain. Returns true if x is then determined.
  template <int Rows>
  bool minimise(const least_squares_level<T, Rows, N>& level) {
    matrix<T, Rows, N> A = level.A;
    vector<T, Rows> b = level.b - A * x_;
    const T square = A.squaredNorm(), least = square * min_share<Rows>() * growth_;
    for (int k = 0; k < count_; ++k) substitute(k, A, b);
    while (left_ > 0) {
      int p = -1;
      T longest = T(-1);
      for (int j = 0; j < N; ++j) {
        if (known_[j]) continue;
        if (const T length = column(A, j).squaredNorm(); !(length <= longest)) longest = length, p = j;
      }
      if (longest <= least) break;  // false for NaN
      known_[p] = true;
      --left_;
      pivot_[count_] = p;
      const vector<T, Rows> a = column(A, p);
      beta_[count_] = a.dot(b) / longest;
      for (int j = 0; j < N; ++j) rho_(j, count_) = known_[j] ? T(0) : a.dot(column(A, j)) / longest;
      substitute(count_++, A, b);
      growth_ = std::max(growth_, square / longest);
    }
    return left_ == 0;
  }

  /// The solution x.
  vector<T, N> solution() const {
    vector<T, N> x = x_;
    for (int k = count_ - 1; k >= 0; --k) x[pivot_[k]] = beta_[k] - column(rho_, k).dot(x);
    return x;
  }

 private:
  // Share of a level's square below which it is rounding.
  template <int Rows>
  static constexpr T min_share() {
    return rounding_tolerance<T>(N + Rows) * rounding_tolerance<T>(N + Rows);
  }

  template <int Rows>
  void substitute(int k, matrix<T, Rows, N>& A, vector<T, Rows>& b) const {
    const vector<T, Rows> a = column(A, pivot_[k]);
    b -= beta_[k] * a;
    for (int j = 0; j < N; ++j) A.col(j) -= rho_(j, k) * a;
  }

  vector<T, N> x_ = vector<T, N>::Zero();  // values of the held unknowns
  vector<bool, N> known_;
  int left_ = N, count_ = 0;
  T growth_ = T(1);  // square of the amplification of rounding errors
  vector<int, N> pivot_;
  vector<T, N> beta_;
  matrix<T, N, N> rho_;
};

}  // namespace passive_haptics
