// Distances found by search and by enumeration, to check the shapes' formulas against.
#pragma once

#include <passive_haptics/scene/shapes/half_space.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace closest_points {
namespace ph = passive_haptics;

// Distance to the segment a b: golden-section search in long double.
template <int D>
long double from_segment(const ph::point<D>& x, const ph::point<D>& a, const ph::point<D>& b) {
  using wide = ph::vector<long double, D>;
  const wide wx = x.template cast<long double>(), wa = a.template cast<long double>(),
             wb = b.template cast<long double>();
  const auto at = [&](long double t) { return (wx - wa - t * (wb - wa)).norm(); };
  const long double golden = (std::sqrt(5.0L) - 1) / 2;
  long double low = 0, high = 1;
  for (int k = 0; k < 150; ++k) {
    const long double left = high - golden * (high - low), right = low + golden * (high - low);
    (at(left) < at(right) ? high : low) = at(left) < at(right) ? right : left;
  }
  return std::fmin(at((low + high) / 2), std::fmin(at(0), at(1)));
}

// Signed distance from what lies behind all planes, in long double: among the projections of x on the
// intersections of up to D planes, the nearest that is behind all others.
template <int D>
double from_polytope(const ph::point<D>& x, const std::vector<ph::half_space_parameters<D>>& planes) {
  using number = long double;
  using direction = std::array<number, std::size_t(D)>;
  const auto dot = [](const direction& a, const direction& b) {
    number sum = 0;
    for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
    return sum;
  };
  std::vector<direction> n;
  std::vector<number> g;
  for (const auto& plane : planes) {
    direction unit, r;
    for (std::size_t i = 0; i < D; ++i) {
      const int k = static_cast<int>(i);
      unit[i] = plane.normal[k];
      r[i] = number(x[k]) - plane.surface_point[k];
    }
    const number length = std::sqrt(dot(unit, unit));
    for (number& u : unit) u /= length;
    n.push_back(unit);
    g.push_back(dot(unit, r));
  }

  number nearest = -1;
  bool outside = false;
  for (const number& over : g) outside = outside || over > 0;
  // Solves (N^T N) m = g for the planes in `active` by elimination; d = -N m is the step onto their
  // intersection.
  const auto try_active = [&](const std::vector<std::size_t>& active) {
    const std::size_t size = active.size();
    std::vector<std::vector<number>> gram(size, std::vector<number>(size + 1));
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) gram[i][j] = dot(n[active[i]], n[active[j]]);
      gram[i][size] = g[active[i]];
    }
    for (std::size_t i = 0; i < size; ++i) {  // positive definite, so no pivoting
      if (std::abs(gram[i][i]) < 1e-12L) return;
      for (std::size_t k = 0; k < size; ++k) {
        if (k == i) continue;
        const number factor = gram[k][i] / gram[i][i];
        for (std::size_t j = 0; j <= size; ++j) gram[k][j] -= factor * gram[i][j];
      }
    }
    direction d{};
    for (std::size_t i = 0; i < size; ++i) {
      const number m = gram[i][size] / gram[i][i];
      for (std::size_t k = 0; k < D; ++k) d[k] -= m * n[active[i]][k];
    }
    for (std::size_t i = 0; i < n.size(); ++i) {
      if (g[i] + dot(n[i], d) > 1e-15L) return;
    }
    const number length = std::sqrt(dot(d, d));
    if (nearest < 0 || length < nearest) nearest = length;
  };
  for (std::size_t i = 0; i < n.size(); ++i) {
    try_active({i});
    for (std::size_t j = i + 1; j < n.size(); ++j) {
      try_active({i, j});
      if constexpr (D == 3) {
        for (std::size_t k = j + 1; k < n.size(); ++k) try_active({i, j, k});
      }
    }
  }
  return static_cast<double>(outside ? nearest : number(-nearest));
}

}  // namespace closest_points
