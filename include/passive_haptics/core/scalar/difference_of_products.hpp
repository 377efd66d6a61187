/// a b - c d and the cross product without cancellation.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>

namespace passive_haptics {

/// Returns a b - c d within 1.5 units in the last place, by two fused multiply-adds. Source: Jeannerod,
/// Louvet, Muller, Further analysis of Kahan's algorithm, Mathematics of Computation 82 (2013).
template <class T>
T difference_of_products(T a, T b, T c, T d) {
  const T cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

/// Returns a x b, each entry to a few roundings, for nearly parallel vectors.
template <class T>
vector<T, 3> accurate_cross(const vector<T, 3>& a, const vector<T, 3>& b) {
  return {difference_of_products(a[1], b[2], a[2], b[1]), difference_of_products(a[2], b[0], a[0], b[2]),
          difference_of_products(a[0], b[1], a[1], b[0])};
}

}  // namespace passive_haptics
