/// @file
/// Gram-Schmidt orthogonalisation of one vector against others.
#pragma once

#include <passive_haptics/core/matrix.hpp>

namespace passive_haptics {

/// Takes from x its parts along the first `count` columns of Q, which are orthonormal, and returns how much
/// of each that was, the others 0.
///
/// Classical Gram-Schmidt, twice: once leaves rounding of x, twice is enough (Kahan). Exact where the columns
/// are units of the base frame. What grows and shrinks by a column a step has a form of its own
/// (updatable_qr.hpp).
template <class T, int N, int Columns>
vector<T, Columns> orthogonalise(vector<T, N>& x, const matrix<T, N, Columns>& Q, int count) {
  vector<T, Columns> parts = vector<T, Columns>::Zero(), part;
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < count; ++k) part[k] = Q.col(k).dot(x);
    for (int k = 0; k < count; ++k) {
      x -= part[k] * Q.col(k);
      parts[k] += part[k];
    }
  }
  return parts;
}

}  // namespace passive_haptics
