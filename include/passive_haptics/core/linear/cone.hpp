/// @file
/// Projection onto a polyhedral cone given by half-spaces.
#pragma once

#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/plane_cone.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>

namespace passive_haptics {

/// Nearest point p of the cone { p : B^T p <= 0 } to f.
///
/// By Moreau's decomposition f = p + B mu with mu = argmin |B mu - f|, mu >= 0: a non-negative least-squares
/// problem whose residual is p. No Gram matrix and no inverse, so p is feasible to rounding at any condition
/// of B. Cones on the line, of one or two half-spaces in the plane (plane_cone.hpp) and of three in space
/// (space_cone.hpp) take a closed form: exact to a few roundings of |f| however flat the cone is. Others take
/// an active set (active_set.hpp): as exact as the condition of B allows. From three half-spaces on the
/// search begins at `start`, and leaves there the start of the next cycle. A right start halves the time, a
/// wrong one costs nothing to speak of. From any start p is the same to rounding.
///
/// Zero columns restrict nothing; parallel and dependent ones, f = 0 and f on a face are fine. B must be
/// finite and f of moderate norm (normalise it first).
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

/// Nearest point p of the cone { p : B^T p <= 0 } to f, without a start.
template <class T, int Rows, int Columns>
half_space_projection<T, Rows, Columns> project_onto_half_spaces(const matrix<T, Rows, Columns>& B,
                                                                 const vector<T, Rows>& f) {
  half_space_start start;
  return project_onto_half_spaces(B, f, start);
}

}  // namespace passive_haptics
