/// @file
/// Projection onto a cone given by its generators.
#pragma once

#include <passive_haptics/core/linear/least_norm.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>

namespace passive_haptics {

/// Nearest point of a cone { V x : x >= 0 }, from project_onto_generators.
template <class T, int D, int M>
struct generated_point {
  vector<T, D> point = vector<T, D>::Zero();         ///< p = V x; f itself where f lies in the cone.
  vector<T, M> coefficients = vector<T, M>::Zero();  ///< x >= 0, of least norm.
};

namespace detail {

/// Where the nearest point lies.
template <class T, int D, int M>
struct generated_face {
  bool inside;                ///< f is in the cone: p = f.
  half_space_set basis = 0;   ///< Independent generators that make p.
  half_space_set usable = 0;  ///< All that lie in the same face.
  vector<T, D> point;         ///< p
  vector<T, M> coefficients;  ///< x of the basis; unspecified where the basis does not determine it.
};

template <int M>
inline constexpr half_space_set all_of = ~half_space_set(0) >> (32 - M);

/// In the plane: f lies between its neighbours, the generators at the least angles to its left and right, or
/// outside, nearest to that neighbour which is less than 90 degrees away. No lengths are compared.
template <class T, int M>
[[gnu::always_inline]] inline generated_face<T, 2, M> face_of(const matrix<T, 2, M>& V,
                                                              const vector<T, 2>& f) {
  generated_face<T, 2, M> face{true, 0, all_of<M>, f, vector<T, M>::Zero()};
  constexpr T none = T(-2);  // the angle a by (cos a) / (|cos a| + |sin a|), which falls from 1 to -1
  int left = -1, right = -1;
  T most_left = none, most_right = none;
  unrolled<M>([&](auto i) {
    const T c = f[0] * V(1, i) - f[1] * V(0, i), d = f[0] * V(0, i) + f[1] * V(1, i);
    const T nearness = d / (std::abs(c) + std::abs(d));  // NaN of a zero column
    const T on_left = c >= T(0) ? nearness : none, on_right = c < T(0) ? nearness : none;
    left = on_left > most_left ? int(i) : left;
    most_left = on_left > most_left ? on_left : most_left;
    right = on_right > most_right ? int(i) : right;
    most_right = on_right > most_right ? on_right : most_right;
  });
  if (left >= 0 && right >= 0) {
    const vector<T, 2> r = V.col(right), l = V.col(left);
    const T area = cross_in_plane(r, l);
    const bool both_ahead = std::min(most_left, most_right) > T(0);
    if (both_ahead || (area > T(0) && !are_parallel(area, r.squaredNorm(), l.squaredNorm()))) {
      face.basis = 1u << left | 1u << right;
      face.coefficients[right] = cross_in_plane(f, l) / area;
      face.coefficients[left] = cross_in_plane(r, f) / area;
      return face;
    }
  }
  const bool is_left = most_left > most_right;
  const int held = is_left ? left : right;
  face.inside = false;
  face.point.setZero();
  face.usable = 0;
  if (!((is_left ? most_left : most_right) > T(0))) return face;
  const vector<T, 2> v = V.col(held);
  const T square = v.squaredNorm(), along = v.dot(f) / square;
  face.point = along * v;
  // Those that are parallel to it share
  T shared = T(0);
  for (int i = 0; i < M; ++i) {
    const vector<T, 2> other = V.col(i);
    const T length = other.squaredNorm();
    if (!are_parallel(cross_in_plane(v, other), square, length) || !(other.dot(v) > T(0))) continue;
    shared += length;
    face.coefficients[i] = other.dot(face.point);
  }
  face.coefficients /= shared;
  return face;
}

/// In space and beyond: f less its nearest point is the projection of f on the polar cone { r : V^T r <= 0 },
/// by non-negative least squares. The face is normal to r.
template <class T, int D, int M>
[[gnu::always_inline]] inline generated_face<T, D, M> face_of(const matrix<T, D, M>& V,
                                                              const vector<T, D>& f) {
  const auto polar = project_onto_half_spaces(V, f);
  const vector<T, D>& r = polar.point;
  const T square = r.squaredNorm();
  constexpr T rounding = rounding_tolerance<T>(D);
  if (!(square > rounding * rounding * f.squaredNorm()))
    return {true, polar.active, all_of<M>, f, polar.coefficients};
  generated_face<T, D, M> face{false, polar.active, 0, f - r, polar.coefficients};
  const vector<T, M> above = V.transpose() * r;
  for (int i = 0; i < M; ++i) {
    const T whole = V.col(i).squaredNorm() * square;
    if (whole > T(0) && above[i] * above[i] <= rounding * rounding * whole) face.usable |= 1u << i;
  }
  face.usable |= face.basis;
  return face;
}

}  // namespace detail

/// Nearest point p of the cone { V x : x >= 0 } to f, D <= 3, and the x of least norm that makes p. Both are
/// unique, and continuous in V and f. f must be of moderate norm; V finite, of any scale but where its
/// squares are no numbers. Zero columns make nothing.
///
/// Where f is in the cone, p = f. Else p = f - r lies on a face, whose generators make it. Cost: one
/// projection onto M half-spaces (in the plane M angles), and a least_norm where more columns can make p
/// than it takes.
template <class T, int D, int M>
PASSIVE_HAPTICS_FLATTEN generated_point<T, D, M> project_onto_generators(const matrix<T, D, M>& V,
                                                                         const vector<T, D>& f) {
  const auto face = detail::face_of(V, f);
  generated_point<T, D, M> answer{face.point, face.coefficients};
  // Three in space are solved in closed form, whose coefficients lose digits
  if ((face.usable == face.basis && !(D == 3 && M == 3)) || face.usable == 0) return answer;
  vector<T, M> shortest;
  if (detail::least_norm<T, D, M>(V, answer.point).solve(face.basis, face.usable, shortest))
    answer.coefficients = shortest;
  return answer;
}

}  // namespace passive_haptics
