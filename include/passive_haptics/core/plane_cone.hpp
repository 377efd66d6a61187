/// @file
/// Projection onto a cone of half-spaces in closed form: on the line and in the plane.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// A set of half-spaces: bit j stands for column j.
using half_space_set = unsigned;

/// Nearest point of a cone { p : B^T p <= 0 }, from project_onto_half_spaces.
template <class T, int Rows, int Columns>
struct half_space_projection {
  vector<T, Rows> point;            ///< p, the nearest point of the cone.
  vector<T, Columns> coefficients;  ///< mu >= 0 in f = p + B mu; 0 but for active half-spaces.
  half_space_set active;  ///< Those that hold p back, b_j . p = 0: a good start for a neighbouring problem.
};

namespace detail {

/// True if p with b . p = product lies beyond the half-space of b by more than rounding. A looser test would let through
/// an error of its tolerance times the condition of B.
template <class T>
bool is_beyond(T product, T b_square, T p_square) {
  constexpr T eps = std::numeric_limits<T>::epsilon();
  return product > T(0) && product * product > eps * eps * b_square * p_square;
}

/// On the line the answer is f or 0.
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

/// The point `along` on the edge of a half-space's normal b, in units of |b|.
template <class T>
vector<T, 2> along_edge(const vector<T, 2>& b, T along) {
  return {-b[1] * along, b[0] * along};
}

/// f = mu_i b_i + mu_j b_j, mu >= 0, of those pairs the least parallel: what holds f back at the apex.
template <class T, int Columns>
void split_between_two(const matrix<T, 2, Columns>& B, const vector<T, 2>& f,
                       const vector<T, Columns>& square, half_space_projection<T, 2, Columns>& result) {
  T widest = T(0);
  for (int i = 0; i < Columns; ++i) {
    for (int j = i + 1; j < Columns; ++j) {
      const vector<T, 2> bi = B.col(i), bj = B.col(j);
      const T area = cross_in_plane(bi, bj);
      if (!(area * area > widest * square[i] * square[j])) continue;
      const T mu_i = cross_in_plane(f, bj) / area, mu_j = cross_in_plane(bi, f) / area;
      if (!(mu_i >= T(0) && mu_j >= T(0))) continue;
      widest = area * area / (square[i] * square[j]);
      result.coefficients.setZero();
      result.coefficients[i] = mu_i;
      result.coefficients[j] = mu_j;
      result.active = 1u << i | 1u << j;
    }
  }
}

/// True if a and b are parallel to rounding: then the foot on one edge lies on the other, whatever its product says.
template <class T>
bool are_parallel(const vector<T, 2>& a, const vector<T, 2>& b, T a_square, T b_square) {
  const T area = cross_in_plane(a, b);
  return !(area * area > rounding_tolerance<T>(1) * rounding_tolerance<T>(1) * a_square * b_square);
}

/// In the plane the answer is f, its foot on one edge, or the apex. Any edge may be the one.
template <class T, int Columns>
half_space_projection<T, 2, Columns> nearest_of_all_edges(const matrix<T, 2, Columns>& B,
                                                          const vector<T, 2>& f,
                                                          const vector<T, Columns>& square) {
  half_space_projection<T, 2, Columns> result{f, vector<T, Columns>::Zero(), 0};
  bool free = true;
  for (int j = 0; j < Columns; ++j) {
    const vector<T, 2> b = B.col(j);
    const T outside = dot(b, f);
    if (!(outside > T(0) && square[j] > T(0))) continue;
    free = false;
    const T along = cross_in_plane(b, f) / square[j];
    const vector<T, 2> p = along_edge(b, along);
    bool inside = true;
    for (int i = 0; i < Columns; ++i) {
      const vector<T, 2> other = B.col(i);
      const T beyond = dot(other, p);
      inside &= i == j || are_parallel(other, b, square[i], square[j]) ||
                !is_beyond(beyond, square[i], along * along * square[j]);
    }
    if (!inside) continue;
    result.point = p;
    result.coefficients[j] = outside / square[j];
    result.active = 1u << j;
    return result;
  }
  if (free) return result;
  result.point.setZero();
  split_between_two(B, f, square, result);
  return result;
}

/// The same; two half-spaces that are not parallel have two edges: the answer lies on that which f points along more.
template <class T, int Columns>
half_space_projection<T, 2, Columns> nearest_in_plane(const matrix<T, 2, Columns>& B, const vector<T, 2>& f) {
  vector<T, Columns> square;
  unrolled<Columns>([&](int j) { square[j] = B(0, j) * B(0, j) + B(1, j) * B(1, j); });
  if constexpr (Columns == 2) {
    const vector<T, 2> b0(B(0, 0), B(1, 0)), b1(B(0, 1), B(1, 1));
    const T area = cross_in_plane(b0, b1);
    if (!are_parallel(b0, b1, square[0], square[1])) {
      const T outside_0 = dot(b0, f), outside_1 = dot(b1, f);
      half_space_projection<T, 2, 2> result{f, vector<T, 2>::Zero(), 0};
      if (!(outside_0 > T(0) || outside_1 > T(0))) return result;
      const T side = std::copysign(T(1), area);
      const T along_0 = side * cross_in_plane(f, b0),
              along_1 = side * cross_in_plane(b1, f);  // inwards on each edge
      const bool first = along_0 > T(0) && (!(along_1 > T(0)) ||
                                            along_0 * along_0 * square[1] >= along_1 * along_1 * square[0]);
      if (first || along_1 > T(0)) {
        const T inverse = T(1) / (first ? square[0] : square[1]);
        const T along = (first ? along_0 : along_1) * inverse, mu = (first ? outside_0 : outside_1) * inverse;
        result.point = first ? along_edge(b0, -side * along) : along_edge(b1, side * along);
        result.coefficients = {first ? mu : T(0), first ? T(0) : mu};
        result.active = first ? 1u : 2u;
        return result;
      }
    }
  }
  return nearest_of_all_edges(B, f, square);
}

}  // namespace detail
}  // namespace passive_haptics
