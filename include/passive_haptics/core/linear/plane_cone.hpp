/// @file
/// Projection onto a cone of half-spaces in closed form: on the line and in the plane.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// A set of half-spaces: bit j stands for column j.
using half_space_set = unsigned;

/// Where a search for the nearest point begins: left by one problem for the next, best one cycle later.
struct half_space_start {
  half_space_set active = 0;    ///< Those that held p back.
  half_space_set violated = 0;  ///< Those that f lay beyond, b_j . f > 0; other ones tell that f has jumped.
};

/// Nearest point of a cone { p : B^T p <= 0 }, from project_onto_half_spaces.
template <class T, int Rows, int Columns>
struct half_space_projection {
  vector<T, Rows> point;            ///< p, the nearest point of the cone.
  vector<T, Columns> coefficients;  ///< mu >= 0 in f = p + B mu; 0 but for active half-spaces.
  half_space_set active;            ///< Those that hold p back, b_j . p = 0.
};

/// True if vectors a and b, area = a x b, are parallel to rounding: then the foot on one edge lies on the
/// other, whatever its product says.
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

/// The edge of two half-spaces on which the nearest point to an f outside of them lies.
template <class T>
struct plane_edge {
  int held;                ///< Its half-space; -1: neither edge but the apex is nearest.
  vector<T, 2> direction;  ///< r, along the edge into the other half-space, as long as b_held.
  T square;                ///< |r|^2
  T along;                 ///< r . f > 0
};

/// Two half-spaces s_j e_j that are not parallel have two edges: the answer lies on that of a half-space
/// which f is outside of, if f points along it. No lengths are compared: near an edge that would lose half of
/// the digits. outside: s_j e_j . f, one of them > 0; square: |e_0|^2 and |e_1|^2; area: s_0 e_0 x s_1 e_1;
/// s_j = -1 or 1.
template <class T>
plane_edge<T> nearest_edge(const matrix<T, 2, 2>& e, const vector<T, 2>& s, const vector<T, 2>& f,
                           const vector<T, 2>& outside, const vector<T, 2>& square, T area) {
  const T side = std::copysign(T(1), area), turn_0 = side * s[0], turn_1 = -side * s[1];
  const T along_0 = turn_0 * (e(1, 0) * f[0] - e(0, 0) * f[1]);
  const T along_1 = turn_1 * (e(1, 1) * f[0] - e(0, 1) * f[1]);
  const bool first = outside[0] > T(0) && along_0 > T(0), second = outside[1] > T(0) && along_1 > T(0);
  const T turn = first ? turn_0 : turn_1, x = first ? e(0, 0) : e(0, 1), y = first ? e(1, 0) : e(1, 1);
  return {first ? 0 : (second ? 1 : -1),
          {turn * y, -turn * x},
          first ? square[0] : square[1],
          first ? along_0 : along_1};
}

/// |b_j|^2 of all columns.
template <class T, int Columns>
vector<T, Columns> column_squares(const matrix<T, 2, Columns>& B) {
  return B.colwise().squaredNorm();
}

/// b_0 x b_1; 0 where they are parallel to rounding.
template <class T>
T area_between(const matrix<T, 2, 2>& B, const vector<T, 2>& square) {
  const T area = B(0, 0) * B(1, 1) - B(1, 0) * B(0, 1);
  return are_parallel(area, square[0], square[1]) ? T(0) : area;
}

namespace detail {

/// True if p with b . p = product lies beyond the half-space of b by more than rounding. A looser test would
/// let through an error of its tolerance times the condition of B.
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

/// In the plane the answer is f, its foot on one edge, or the apex. Any edge may be the one.
template <class T, int Columns>
half_space_projection<T, 2, Columns> nearest_of_all_edges(const matrix<T, 2, Columns>& B,
                                                          const vector<T, 2>& f,
                                                          const vector<T, Columns>& square) {
  half_space_projection<T, 2, Columns> result{f, vector<T, Columns>::Zero(), 0};
  bool free = true;
  for (int j = 0; j < Columns; ++j) {
    const vector<T, 2> b = B.col(j);
    const T outside = b.dot(f);
    if (!(outside > T(0) && square[j] > T(0))) continue;
    free = false;
    const T along = cross_in_plane(b, f) / square[j];
    const vector<T, 2> p = along_edge(b, along);
    bool inside = true;
    for (int i = 0; i < Columns; ++i) {
      const vector<T, 2> other = B.col(i);
      const T beyond = other.dot(p);
      inside &= i == j || are_parallel(cross_in_plane(other, b), square[i], square[j]) ||
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

/// The nearest point of a cone in the plane.
template <class T, int Columns>
half_space_projection<T, 2, Columns> nearest_in_plane(const matrix<T, 2, Columns>& B, const vector<T, 2>& f) {
  const vector<T, Columns> square = column_squares(B);
  if constexpr (Columns == 2) {
    if (const T area = area_between(B, square); area != T(0)) {
      const vector<T, 2> outside = B.transpose() * f;
      half_space_projection<T, 2, 2> result{f, vector<T, 2>::Zero(), 0};
      if (!(outside[0] > T(0) || outside[1] > T(0))) return result;
      if (const auto edge = nearest_edge<T>(B, {T(1), T(1)}, f, outside, square, area); edge.held >= 0) {
        const T inverse = T(1) / edge.square;
        result.point = edge.along * inverse * edge.direction;
        result.coefficients[edge.held] = outside[edge.held] * inverse;
        result.active = 1u << edge.held;
        return result;
      }
    }
  }
  return nearest_of_all_edges(B, f, square);
}

}  // namespace detail
}  // namespace passive_haptics
