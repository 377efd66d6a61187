/// Projection onto a cone given by its generators.
#pragma once

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/least_norm.hpp>

#include <algorithm>
#include <bit>

namespace passive_haptics {

/// Nearest point of a cone { V x : x >= 0 }; see project_onto_generators.
template <class T, int D, int M>
struct generated_point {
  vector<T, D> point = vector<T, D>::Zero();         ///< p = V x; equal to f if f is in the cone.
  vector<T, M> coefficients = vector<T, M>::Zero();  ///< x >= 0, of least norm.
};

namespace detail {

/// The face of the cone that contains the nearest point.
template <class T, int D, int M>
struct generated_face {
  using columns = lane_mask<T, M>;  ///< A set of generators.
  bool is_shortest;                 ///< True if the coefficients have the least norm.
  columns basis;                    ///< Independent generators of p; some may be parallel to one of them.
  columns usable;                   ///< All generators in the same face.
  vector<T, D> point;
  vector<T, M> coefficients;  ///< x of the basis; 0 in the plane if p = f.
};

/// Planar case: f lies between its neighbours, the generators at the smallest angles to its left and right,
/// or it is outside and nearest to the neighbour less than 90 degrees away. No lengths are compared.
template <class T, int M>
PASSIVE_HAPTICS_INLINE inline generated_face<T, 2, M> face_of(const matrix<T, 2, M>& V,
                                                              const vector<T, 2>& f) {
  using per_column = lanes<T, M>;
  using columns = lane_mask<T, M>;
  const per_column x = row(V, 0), y = row(V, 1), none(T(0));
  const per_column across = f[0] * y - f[1] * x, along = f[0] * x + f[1] * y;
  // Monotone in the angle a: 2 + (cos a) / (|cos a| + |sin a|), from 3 to 1; NaN for a zero column
  const per_column nearness = max(none, T(2) + along / (abs(across) + abs(along)));
  const per_column on_left = select(across >= none, nearness, none),
                   on_right = select(across < none, nearness, none);
  const T left = max_value(on_left), right = max_value(on_right);
  if (left + right > T(4) + rounding_tolerance<T>(3))  // less than 180 degrees
    return {.is_shortest = false,
            .basis = (on_left >= per_column(left)) | (on_right >= per_column(right)),
            .usable = columns::of(all_columns<M>),
            .point = f,
            .coefficients = vector<T, M>::Zero()};
  if (!(std::max(left, right) > T(2)))
    return {true, columns::of(0), columns::of(0), vector<T, 2>::Zero(), vector<T, M>::Zero()};
  const columns nearest = left > right ? on_left >= per_column(left) : on_right >= per_column(right);
  const vector<T, 2> v(sum(select(nearest, x, none)), sum(select(nearest, y, none)));
  const T square = v.squaredNorm(), share_of_f = v.dot(f) / square;
  // Generators parallel to the nearest one share its coefficient
  const per_column ahead = v[0] * x + v[1] * y, beside = v[0] * y - v[1] * x, squares = x * x + y * y;
  constexpr T parallel = rounding_tolerance<T>(1) * rounding_tolerance<T>(1);
  const columns share = (beside * beside <= parallel * square * squares) & (ahead > none);
  const T of_each = share_of_f / sum(select(share, squares, none));
  return {.is_shortest = true,
          .basis = share,
          .usable = share,
          .point = share_of_f * v,
          .coefficients = select(share, of_each * ahead, none)};
}

/// x for an f between its neighbours in the plane.
template <class T, int M>
vector<T, M> coefficients_between(const matrix<T, 2, M>& V, half_space_set neighbours,
                                  const vector<T, 2>& f) {
  vector<T, M> x = vector<T, M>::Zero();
  int left = 0, right = 0;
  for (half_space_set rest = neighbours; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    (cross_in_plane<T>(f, V.col(i)) >= T(0) ? left : right) = i;
  }
  const vector<T, 2> l = V.col(left), r = V.col(right);
  x[left] = cross_in_plane(r, f) / cross_in_plane(r, l);
  x[right] = cross_in_plane(f, l) / cross_in_plane(r, l);
  return x;
}

/// Three or more dimensions: f minus its nearest point is the projection r of f on the polar cone { r : V^T r
/// <= 0 }, by non-negative least squares. The face is normal to r.
template <class T, int D, int M>
PASSIVE_HAPTICS_INLINE inline generated_face<T, D, M> face_of(const matrix<T, D, M>& V,
                                                              const vector<T, D>& f) {
  using per_column = lanes<T, M>;
  using columns = lane_mask<T, M>;
  // Three half-spaces in space have a closed form with less accurate coefficients
  constexpr bool loses_digits = D == 3 && M == 3;
  const auto polar = project_onto_half_spaces(V, f);
  const vector<T, D>& r = polar.point;
  const columns basis = columns::of(polar.active), all = columns::of(all_columns<M>);
  const T square = r.squaredNorm();
  constexpr T rounding = rounding_tolerance<T>(D);
  if (!(square > rounding * rounding * f.squaredNorm()))
    return {basis == all && !loses_digits, basis, all, f, polar.coefficients};
  per_column along(T(0)), squares(T(0));
  unrolled<D>([&](auto k) PASSIVE_HAPTICS_INLINE {
    const per_column v([&](int j) { return V(k, j); });
    along += r[k] * v;
    squares += v * v;
  });
  const columns normal = along * along <= rounding * rounding * square * squares,
                usable = basis | (normal & (squares > per_column(T(0))));
  const bool is_shortest = loses_digits ? polar.active == 0 : usable == basis;
  return {is_shortest, basis, usable, f - r, polar.coefficients};
}

}  // namespace detail

/// Returns the nearest point p of the cone { V x : x >= 0 } to f, D <= 3, and the least-norm x with V x = p.
/// Both are unique and continuous in V and f. f must be of moderate norm, V finite, and its squares must not
/// overflow. Zero columns contribute nothing. Cost: one projection onto M half-spaces (in the plane M
/// angles), and a least_norm if p has several representations.
template <class T, int D, int M>
PASSIVE_HAPTICS_FLATTEN generated_point<T, D, M> project_onto_generators(const matrix<T, D, M>& V,
                                                                         const vector<T, D>& f) {
  const auto face = detail::face_of(V, f);
  if (face.is_shortest) return {face.point, face.coefficients};
  generated_point<T, D, M> answer{face.point};
  constexpr bool always_basis = D == 2 && M == 2;
  if (!always_basis &&
      detail::least_norm<T, D, M>(V, answer.point).solve(face.basis, face.usable, answer.coefficients))
    return answer;
  if constexpr (D == 2) return {f, detail::coefficients_between(V, bits(face.basis), f)};
  else return {face.point, face.coefficients};
}

}  // namespace passive_haptics
