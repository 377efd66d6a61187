// The nearest point of a cone in 50 digits, by trying every set of active half-spaces.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <vector>

namespace oracle {

using real = boost::multiprecision::cpp_bin_float_50;
using column = std::vector<real>;

inline real dot(const column& a, const column& b) {
  real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline real norm(const column& a) { return sqrt(dot(a, a)); }

struct projection {
  column point;      // nearest point of { p : B^T p <= 0 } to f
  double angle = 1;  // least sine between an active column and those before it: small where ill-conditioned
  double least_angle = 1;  // the same over all sets of half-spaces
};

// f less its part in the span of some columns, if its coefficients there are >= 0: classical Gram-Schmidt
// would not do in double, in 50 digits it loses nothing that matters.
inline bool cut(const std::vector<column>& columns, const column& f, projection& result) {
  std::vector<column> q;                 // orthonormal
  std::vector<std::vector<real>> upper;  // columns = q * upper
  result.angle = 1;
  for (const column& b : columns) {
    column rest = b;
    std::vector<real> along;
    for (const column& axis : q) {
      along.push_back(dot(axis, b));
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= along.back() * axis[i];
    }
    const real length = norm(rest), sine = length / norm(b);
    if (sine < real(1e-30)) return false;  // depends on the others: a smaller set does as well
    result.angle = std::min(result.angle, static_cast<double>(sine));
    for (real& x : rest) x /= length;
    along.push_back(length);
    q.push_back(rest);
    upper.push_back(along);
  }
  std::vector<real> y;
  result.point = f;
  for (const column& axis : q) {
    y.push_back(dot(axis, f));
    for (std::size_t i = 0; i < f.size(); ++i) result.point[i] -= y.back() * axis[i];
  }
  for (std::size_t k = q.size(); k-- > 0;) {
    for (std::size_t l = k + 1; l < q.size(); ++l) y[k] -= upper[l][k] * y[l];
    y[k] /= upper[k][k];
    if (y[k] < 0) return false;
  }
  return true;
}

// Of all sets of half-spaces that hold f back with coefficients >= 0, the one that leaves least: f - p = B mu
// with mu >= 0 of least residual.
template <class T, int Rows, int Columns>
projection project(const passive_haptics::matrix<T, Rows, Columns>& B,
                   const passive_haptics::vector<T, Rows>& f) {
  const column target(f.data(), f.data() + Rows);
  projection best{target};
  double least_angle = 1;
  real least = norm(target);
  for (unsigned set = 1; set < (1u << Columns); ++set) {
    std::vector<column> active;
    bool usable = true;
    for (int j = 0; j < Columns; ++j) {
      if (!((set >> j) & 1u)) continue;
      active.emplace_back(B.col(j).data(), B.col(j).data() + Rows);
      usable = usable && norm(active.back()) > 0;
    }
    projection candidate;
    if (!usable || active.size() > Rows) continue;
    const bool holds = cut(active, target, candidate);
    least_angle = std::min(least_angle, candidate.angle);
    if (!holds) continue;
    if (const real left = norm(candidate.point); left < least) {
      least = left;
      best = candidate;
    }
  }
  best.least_angle = least_angle;
  return best;
}

}  // namespace oracle
