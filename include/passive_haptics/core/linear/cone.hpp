/// Projection onto a polyhedral cone given by half-spaces.
#pragma once

#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/plane_cone.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>

namespace passive_haptics {

/// Returns the nearest point p of the cone { p : B^T p <= 0 } to f.
///
/// Moreau's decomposition f = p + B mu, mu = argmin |B mu - f|, mu >= 0, makes this a non-negative
/// least-squares problem with residual p. Without a Gram matrix or an inverse, p is feasible to rounding at
/// any condition number of B. One dimension, one or two half-spaces in the plane (plane_cone.hpp) and three
/// in space (space_cone.hpp) are solved in closed form, to a few roundings of |f|. All others use an active
/// set (active_set.hpp), with an accuracy limited by the condition number of B.
///
/// From three half-spaces on, the search begins at `start` and stores the start for the next cycle there. A
/// good start halves the time; the result does not depend on it, except for rounding. Zero, parallel and
/// dependent columns are allowed. B must be finite and f of moderate norm (normalise it first).
template <class T, int Rows, int Columns>
half_space_projection<T, Rows, Columns> project_onto_half_spaces(const matrix<T, Rows, Columns>& B,
                                                                 const vector<T, Rows>& f,
                                                                 half_space_start& start) {
  static_assert(Columns <= 32, "passive_haptics: a cone has at most 32 half-spaces.");
  if constexpr (Rows == 1) return detail::nearest_on_line(B, f);
  else if constexpr (Rows == 2 && Columns <= 2) return detail::nearest_in_plane(B, f);
  else if constexpr (Rows == 3 && Columns == 3) return detail::nearest_in_space(B, f, start);
  else return detail::active_set<T, Rows, Columns>(B, f).nearest(start);
}

/// As above, without a start.
template <class T, int Rows, int Columns>
half_space_projection<T, Rows, Columns> project_onto_half_spaces(const matrix<T, Rows, Columns>& B,
                                                                 const vector<T, Rows>& f) {
  half_space_start start;
  return project_onto_half_spaces(B, f, start);
}

}  // namespace passive_haptics
