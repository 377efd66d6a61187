/// Closed-form projection onto cones in one dimension, and of one or two half-spaces in the plane.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/matrix.hpp>

namespace passive_haptics {

/// A set of half-spaces: bit j is column j.
using half_space_set = unsigned;

namespace detail {
template <int N>
inline constexpr half_space_set all_columns = ~half_space_set(0) >> (32 - N);
}  // namespace detail

/// Start of a search for the nearest point, left by the previous problem. Use it in the next control cycle.
struct half_space_start {
  half_space_set active = 0;    ///< Active half-spaces of the last solution.
  half_space_set violated = 0;  ///< Half-spaces with b_j . f > 0. A change means that f has jumped.
};

/// Result of project_onto_half_spaces: the nearest point of a cone { p : B^T p <= 0 }.
template <class T, int Rows, int Columns>
struct half_space_projection {
  vector<T, Rows> point;            ///< Nearest point p.
  vector<T, Columns> coefficients;  ///< mu >= 0 in f = p + B mu; 0 if inactive.
  half_space_set active;            ///< Active half-spaces, b_j . p = 0.
};

/// True if vectors a and b with area = a x b are parallel to rounding.
template <class T>
bool are_parallel(T area, T a_square, T b_square) {
  return !(area * area > rounding_tolerance<T>(1) * rounding_tolerance<T>(1) * a_square * b_square);
}

/// Returns a x b of vectors with these squares, or 0 if they are parallel to rounding.
template <class T, int N>
lanes<T, N> cross_or_zero(const lanes<T, N>& area, const lanes<T, N>& a_square, const lanes<T, N>& b_square) {
  constexpr T tolerance = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);
  return select(area * area > tolerance * a_square * b_square, area, T(0));
}

/// Returns b_0 x b_1, or 0 if they are parallel to rounding.
template <class T>
T area_between(const matrix<T, 2, 2>& B, const vector<T, 2>& square) {
  const T area = B(0, 0) * B(1, 1) - B(1, 0) * B(0, 1);
  return are_parallel(area, square[0], square[1]) ? T(0) : area;
}

namespace detail {

template <class T, int Columns>
half_space_projection<T, 1, Columns> nearest_on_line(const matrix<T, 1, Columns>& B, const vector<T, 1>& f) {
  half_space_projection<T, 1, Columns> result{f, vector<T, Columns>::Zero(), 0};
  for (int j = 0; j < Columns; ++j) {
    if (result.active != 0 || !(B(0, j) * f[0] > T(0))) continue;
    result.point[0] = T(0);
    result.coefficients[j] = f[0] / B(0, j);
    result.active = 1u << j;
  }
  return result;
}

/// The nearest point is f, its foot on an edge, or the apex. If two half-spaces are not parallel, it is on
/// the edge of a violated half-space if f points along this edge into the other one. Lengths are not compared
/// because this would lose half of the digits near an edge.
template <class T, int Columns>
half_space_projection<T, 2, Columns> nearest_in_plane(const matrix<T, 2, Columns>& B, const vector<T, 2>& f) {
  half_space_projection<T, 2, Columns> result{f, vector<T, Columns>::Zero(), 0};
  const vector<T, Columns> square = B.colwise().squaredNorm();
  const vector<T, Columns> outside = (square.array() > T(0)).select(B.transpose() * f, T(0));
  if (!(outside.array() > T(0)).any()) return result;
  const auto lie_on_edge = [&](int j, T along, T coefficient) {
    result.point = {-B(1, j) * along, B(0, j) * along};
    result.coefficients[j] = coefficient;
    result.active = 1u << j;
    return result;
  };
  T area = T(0);
  if constexpr (Columns == 2) area = area_between(B, square);
  for (int j = 0; j < Columns; ++j) {
    if (!(outside[j] > T(0))) continue;
    const T along = cross_in_plane<T>(B.col(j), f), into_other = (area > T(0)) == (j == 0) ? -along : along;
    // If the two are parallel, the foot on one is on the other; for an f along a normal it is the apex
    if (area == T(0) || along == T(0)) return lie_on_edge(j, along / square[j], outside[j] / square[j]);
    if (!(into_other > T(0))) continue;
    const T inverse = T(1) / square[j];  // one division instead of two
    return lie_on_edge(j, along * inverse, outside[j] * inverse);
  }
  result.point.setZero();
  if constexpr (Columns == 2) {
    const vector<T, 2> mu{cross_in_plane<T>(f, B.col(1)) / area, cross_in_plane<T>(B.col(0), f) / area};
    if (!(mu[0] >= T(0) && mu[1] >= T(0))) return result;
    result.coefficients = mu;
    result.active = 3;
  }
  return result;
}

}  // namespace detail
}  // namespace passive_haptics
