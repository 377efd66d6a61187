/// @file
/// Projection onto a cone of half-spaces in closed form: on the line, and of one or two in the plane.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/matrix.hpp>

namespace passive_haptics {

/// A set of half-spaces: bit j stands for column j.
using half_space_set = unsigned;

namespace detail {
// All of N half-spaces or columns.
template <int N>
inline constexpr half_space_set all_columns = ~half_space_set(0) >> (32 - N);
}  // namespace detail

/// Where a search for the nearest point begins: left by one problem for the next, best one cycle later.
struct half_space_start {
  half_space_set active = 0;    ///< Those that held p back.
  half_space_set violated = 0;  ///< Those that f lay beyond, b_j . f > 0; other ones mean that f has jumped.
};

/// Nearest point of a cone { p : B^T p <= 0 }, from project_onto_half_spaces.
template <class T, int Rows, int Columns>
struct half_space_projection {
  vector<T, Rows> point;            ///< p, the nearest point of the cone.
  vector<T, Columns> coefficients;  ///< mu >= 0 in f = p + B mu; 0 but for active half-spaces.
  half_space_set active;            ///< Those that hold p back, b_j . p = 0.
};

/// True if vectors a and b, area = a x b, are parallel to rounding: then a point on one edge is on the other,
/// too, whatever the sign of the computed product.
template <class T>
bool are_parallel(T area, T a_square, T b_square) {
  return !(area * area > rounding_tolerance<T>(1) * rounding_tolerance<T>(1) * a_square * b_square);
}

/// a x b of vectors with these squares; 0 where they are parallel to rounding.
template <class T, int N>
lanes<T, N> cross_or_zero(const lanes<T, N>& area, const lanes<T, N>& a_square, const lanes<T, N>& b_square) {
  constexpr T tolerance = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);
  return select(area * area > tolerance * a_square * b_square, area, T(0));
}

/// b_0 x b_1; 0 where they are parallel to rounding.
template <class T>
T area_between(const matrix<T, 2, 2>& B, const vector<T, 2>& square) {
  const T area = B(0, 0) * B(1, 1) - B(1, 0) * B(0, 1);
  return are_parallel(area, square[0], square[1]) ? T(0) : area;
}

namespace detail {

/// On the line the nearest point is f or 0.
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

/// In the plane the nearest point of one or two half-spaces is f, its foot on an edge, or the apex. Two that
/// are not parallel have two edges: the nearest point lies on the edge of a half-space which f is outside of,
/// if f points along this edge into the other half-space. No lengths are compared: near an edge that would
/// lose half of the digits.
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
    // The foot on one of two that are parallel lies on the other; of an f along a normal it is the apex
    if (area == T(0) || along == T(0)) return lie_on_edge(j, along / square[j], outside[j] / square[j]);
    if (!(into_other > T(0))) continue;
    const T inverse = T(1) / square[j];  // one quotient in place of two
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
