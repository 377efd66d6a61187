// The nearest point of a cone in 50 digits: by trying every set of active half-spaces, or from a set that is
// nearly right.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
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
  double min_angle = 1;  // the same over all sets of half-spaces
};

// The foot of f on the space at right angles to some columns: f less its part in their span.
struct foot {
  column point;
  std::vector<real> coefficients;  // of the columns, in f - point
  double angle = 1;                // least sine between a column and those before it; 0: it depends on them
};

// By modified Gram-Schmidt.
inline foot foot_beside(const std::vector<column>& columns, const column& f) {
  std::vector<column> q;                 // orthonormal
  std::vector<std::vector<real>> upper;  // columns = q * upper
  foot result{f, {}};
  for (const column& b : columns) {
    column rest = b;
    std::vector<real> along;
    for (const column& axis : q) {
      along.push_back(dot(axis, rest));
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= along.back() * axis[i];
    }
    const real length = norm(rest), sine = length / norm(b);
    if (!(sine > real(1e-30))) return {f, {}, 0};
    result.angle = std::min(result.angle, static_cast<double>(sine));
    for (real& x : rest) x /= length;
    along.push_back(length);
    q.push_back(rest);
    upper.push_back(along);
  }
  std::vector<real>& y = result.coefficients;
  for (const column& axis : q) {
    y.push_back(dot(axis, result.point));
    for (std::size_t i = 0; i < f.size(); ++i) result.point[i] -= y.back() * axis[i];
  }
  for (std::size_t k = q.size(); k-- > 0;) {
    for (std::size_t l = k + 1; l < q.size(); ++l) y[k] -= upper[l][k] * y[l];
    y[k] /= upper[k][k];
  }
  return result;
}

template <class T, int Rows, int Columns>
column half_space(const passive_haptics::matrix<T, Rows, Columns>& B, int j) {
  return {B.col(j).data(), B.col(j).data() + Rows};
}

// Of all sets of half-spaces that hold f back with coefficients >= 0, the one that leaves least: f - p = B mu
// with mu >= 0 of least residual.
template <class T, int Rows, int Columns>
projection project(const passive_haptics::matrix<T, Rows, Columns>& B,
                   const passive_haptics::vector<T, Rows>& f) {
  const column target(f.data(), f.data() + Rows);
  projection best{target};
  double min_angle = 1;
  real least = norm(target);
  for (unsigned set = 1; set < (1u << Columns); ++set) {
    if (std::popcount(set) > Rows) continue;
    std::vector<column> active;
    for (int j = 0; j < Columns; ++j)
      if ((set >> j & 1u) != 0) active.push_back(half_space(B, j));
    const foot candidate = foot_beside(active, target);
    if (candidate.angle == 0) continue;  // a smaller set does as well
    min_angle = std::min(min_angle, candidate.angle);
    if (std::ranges::any_of(candidate.coefficients, [](const real& y) { return y < 0; })) continue;
    if (const real left = norm(candidate.point); left < least) {
      least = left;
      best = {candidate.point, candidate.angle};
    }
  }
  best.min_angle = min_angle;
  return best;
}

// The same point by exchanges of one half-space, from a set that is nearly the right one, until it holds f
// back with coefficients >= 0 and its foot violates no other: the conditions of Karush, Kuhn and Tucker,
// which make it the answer whatever the set began as. Where that takes long, by trying every set.
template <class T, int Rows, int Columns>
column nearest_point(const passive_haptics::matrix<T, Rows, Columns>& B,
                     const passive_haptics::vector<T, Rows>& f, unsigned set) {
  const column target(f.data(), f.data() + Rows);
  for (int exchange = 0; exchange < 2 * Columns; ++exchange) {
    std::vector<column> active;
    std::vector<int> member;
    for (int j = 0; j < Columns; ++j) {
      if ((set >> j & 1u) == 0) continue;
      member.push_back(j);
      active.push_back(half_space(B, j));
    }
    const foot candidate = foot_beside(active, target);
    if (candidate.angle == 0) break;
    const auto& y = candidate.coefficients;
    if (const auto least = std::ranges::min_element(y); least != y.end() && *least < 0) {
      set &= ~(1u << member[static_cast<std::size_t>(least - y.begin())]);
      continue;
    }
    int entering = -1;
    real worst = 1e-30;  // what 50 digits leave of a right angle at condition 1e16
    for (int j = 0; j < Columns; ++j) {
      const column b = half_space(B, j);
      const real outside = dot(b, candidate.point), length = norm(b);
      if ((set >> j & 1u) != 0 || !(outside > worst * length)) continue;
      worst = outside / length;
      entering = j;
    }
    if (entering < 0) return candidate.point;
    set |= 1u << entering;
  }
  return project(B, f).point;
}

}  // namespace oracle
