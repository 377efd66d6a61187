// The nearest force of a cone of generators, in 50 digits, and the least torques that make it, by trying
// every set of generators; by their squares, so in 100 digits.
#pragma once

#include "../core/cone_oracle.hpp"

namespace oracle {

using wide = boost::multiprecision::cpp_bin_float_100;
using wide_column = std::vector<wide>;

struct min_torque {
  column force;          // F, of { V x : x >= 0 } the nearest to f
  wide_column x;         // >= 0, of least norm with V x = F
  double condition = 1;  // of the generators that make it
};

inline wide inner(const wide_column& a, const wide_column& b) {
  wide sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// X of A X = B by elimination with full rows pivoted; false if A is singular to 1e-80.
inline bool solve(std::vector<wide_column> A, std::vector<wide_column> B, std::vector<wide_column>& X) {
  const std::size_t n = A.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i) {
      if (abs(A[i][k]) > abs(A[pivot][k])) pivot = i;
    }
    if (abs(A[pivot][k]) < wide(1e-80)) return false;
    std::swap(A[k], A[pivot]);
    std::swap(B[k], B[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const wide factor = A[i][k] / A[k][k];
      for (std::size_t j = 0; j < n; ++j) A[i][j] -= factor * A[k][j];
      for (std::size_t j = 0; j < B[i].size(); ++j) B[i][j] -= factor * B[k][j];
    }
  }
  X = B;
  for (std::size_t k = 0; k < n; ++k) {
    for (wide& x : X[k]) x /= A[k][k];
  }
  return true;
}

// The shortest x with V_S x = F for the columns V_S, if there is one, and the condition of V_S.
inline bool shortest_on(const std::vector<wide_column>& columns, const wide_column& F, wide_column& x,
                        double& condition) {
  const std::size_t n = columns.size(), d = F.size(), least = std::min(n, d);
  std::vector<wide_column> gram(least, wide_column(least, 0)), right(least, wide_column(least + 1, 0)),
      solution;
  wide size = 0;
  for (const wide_column& v : columns) size += inner(v, v);
  for (std::size_t i = 0; i < least; ++i) {
    for (std::size_t j = 0; j < least; ++j) {
      if (n < d) gram[i][j] = inner(columns[i], columns[j]);
      else
        for (const wide_column& v : columns) gram[i][j] += v[i] * v[j];
    }
    right[i][i] = 1;
    right[i][least] = n < d ? inner(columns[i], F) : F[i];
  }
  if (!solve(gram, right, solution)) return false;
  wide inverse = 0;
  wide_column y;
  for (std::size_t i = 0; i < least; ++i) {
    inverse += solution[i][i];
    y.push_back(solution[i][least]);
  }
  condition = static_cast<double>(sqrt(size * inverse));
  x.clear();
  for (std::size_t i = 0; i < n; ++i) x.push_back(n < d ? y[i] : inner(columns[i], y));
  wide_column left = F;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < d; ++k) left[k] -= x[i] * columns[i][k];
  }
  return sqrt(inner(left, left)) < wide(1e-30);
}

template <class T, int D, int M>
min_torque min_torque_of(const passive_haptics::matrix<T, D, M>& V, const passive_haptics::vector<T, D>& f) {
  const column beyond = project(V, f).point;
  min_torque best;
  for (int k = 0; k < D; ++k) best.force.push_back(real(f[k]) - beyond[static_cast<std::size_t>(k)]);
  const wide_column force(best.force.begin(), best.force.end());
  wide least = -1;
  for (unsigned set = 1; set < (1u << M); ++set) {
    std::vector<wide_column> columns;
    for (int i = 0; i < M; ++i) {
      if (set >> i & 1u) columns.emplace_back(V.col(i).data(), V.col(i).data() + D);
    }
    wide_column x;
    double condition;
    if (!shortest_on(columns, force, x, condition)) continue;
    if (!std::all_of(x.begin(), x.end(), [](const wide& xi) { return xi >= wide(-1e-30); })) continue;
    if (const wide size = sqrt(inner(x, x)); least >= 0 && !(size < least)) continue;
    least = sqrt(inner(x, x));
    best.condition = condition;
    best.x.assign(static_cast<std::size_t>(M), 0);
    for (std::size_t i = 0, k = 0; i < static_cast<std::size_t>(M); ++i) {
      if (set >> i & 1u) best.x[i] = x[k++];
    }
  }
  if (best.x.empty()) best.x.assign(static_cast<std::size_t>(M), 0);
  return best;
}

}  // namespace oracle
