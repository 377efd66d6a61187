/// @file
/// What property suites ask of a small matrix, in loops over numbers: Eigen's decompositions take the
/// compiler seconds for every size and scalar.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics::testing {

/// A matrix of any size, for functions that are compiled once.
struct small_matrix {
  int rows = 0;                ///< Rows.
  int cols = 0;                ///< Columns.
  std::vector<double> values;  ///< Column after column.

  /// A copy of A.
  template <class T, int R, int C>
  explicit small_matrix(const matrix<T, R, C>& A) : rows(R), cols(C) {
    for (int j = 0; j < C; ++j) {
      for (int i = 0; i < R; ++i) values.push_back(static_cast<double>(A(i, j)));
    }
  }

  /// Entry in row i, column j.
  double& operator()(int i, int j) { return values[static_cast<std::size_t>(j * rows + i)]; }
};

/// Largest magnitude of an entry; NaN if one is NaN.
template <class Expression>
auto largest_entry(const Expression& A) {
  return A.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
}

/// The entries, column after column, on one line of a message.
template <class T, int R, int C>
std::string in_a_row(const matrix<T, R, C>& A) {
  std::string text;
  for (const double value : small_matrix(A).values) {
    char number[32];
    std::snprintf(number, sizeof number, text.empty() ? "%.6g" : " %.6g", value);
    text += number;
  }
  return text;
}

/// Largest over smallest singular value of a matrix with at least as many rows as columns; infinite or NaN if
/// a column depends on others exactly. One-sided Jacobi rotations (Hestenes) until all columns are orthogonal
/// to rounding.
inline double condition_of(small_matrix A) {
  const auto dot = [&](int a, int b) {
    double sum = 0;
    for (int i = 0; i < A.rows; ++i) sum += A(i, a) * A(i, b);
    return sum;
  };
  bool turned = true;
  for (int sweep = 0; turned && sweep < 60; ++sweep) {
    turned = false;
    for (int a = 0; a < A.cols; ++a) {
      for (int b = a + 1; b < A.cols; ++b) {
        const double aa = dot(a, a), bb = dot(b, b), ab = dot(a, b);
        if (!(std::abs(ab) > 4 * std::numeric_limits<double>::epsilon() * std::sqrt(aa * bb))) continue;
        turned = true;
        const double zeta = (bb - aa) / (2 * ab);
        const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::hypot(1.0, zeta));
        const double cosine = 1 / std::hypot(1.0, tangent), sine = cosine * tangent;
        for (int i = 0; i < A.rows; ++i) {
          const double left = A(i, a), right = A(i, b);
          A(i, a) = cosine * left - sine * right;
          A(i, b) = sine * left + cosine * right;
        }
      }
    }
  }
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (int a = 0; a < A.cols; ++a) {
    const double length = std::sqrt(dot(a, a));
    if (std::isnan(length)) return length;
    smallest = std::min(smallest, length);
    largest = std::max(largest, length);
  }
  return largest / smallest;
}

/// The x with A x = b of a matrix of full column rank; where there are more rows than columns, with the rows
/// alone that elimination with full pivoting takes.
inline std::vector<double> solution_of(small_matrix A, small_matrix b) {
  std::vector<int> order(static_cast<std::size_t>(A.cols));
  for (int j = 0; j < A.cols; ++j) order[static_cast<std::size_t>(j)] = j;
  for (int k = 0; k < A.cols; ++k) {
    int row = k, col = k;
    for (int j = k; j < A.cols; ++j) {
      for (int i = k; i < A.rows; ++i) {
        if (std::abs(A(i, j)) > std::abs(A(row, col))) row = i, col = j;
      }
    }
    for (int j = 0; j < A.cols; ++j) std::swap(A(row, j), A(k, j));
    std::swap(b(row, 0), b(k, 0));
    for (int i = 0; i < A.rows; ++i) std::swap(A(i, col), A(i, k));
    std::swap(order[static_cast<std::size_t>(col)], order[static_cast<std::size_t>(k)]);
    for (int i = k + 1; i < A.rows; ++i) {
      const double factor = A(i, k) / A(k, k);
      for (int j = k; j < A.cols; ++j) A(i, j) -= factor * A(k, j);
      b(i, 0) -= factor * b(k, 0);
    }
  }
  std::vector<double> x(static_cast<std::size_t>(A.cols));
  for (int k = A.cols - 1; k >= 0; --k) {
    double rest = b(k, 0);
    for (int j = k + 1; j < A.cols; ++j)
      rest -= A(k, j) * x[static_cast<std::size_t>(order[static_cast<std::size_t>(j)])];
    x[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])] = rest / A(k, k);
  }
  return x;
}

}  // namespace passive_haptics::testing
