/// Convex polytopes by their half-spaces.
#pragma once

#include <passive_haptics/core/linear/least_distance.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <array>
#include <concepts>
#include <string>
#include <tuple>

namespace passive_haptics {

namespace detail {

template <int D, std::size_t K>
matrix<double, D, static_cast<int>(K)> normals_of(const std::array<half_space<D>, K>& faces) {
  matrix<double, D, static_cast<int>(K)> N;
  for (int i = 0; i < N.cols(); ++i) N.col(i) = nth(faces, i).gradient(point<D>::Zero());
  return N;
}

template <int D, std::size_t K>
vector<double, static_cast<int>(K)> distances_from(const std::array<half_space<D>, K>& faces,
                                                   const point<D>& x) {
  vector<double, static_cast<int>(K)> g;
  for (int i = 0; i < g.size(); ++i) g[i] = nth(faces, i).distance(x);
  return g;
}

template <int D, std::size_t K>
std::array<half_space<D>, K> half_spaces(const std::array<half_space_parameters<D>, K>& p) {
  return std::apply([](const auto&... face) { return std::array{half_space<D>(face)...}; }, p);
}

/// Error text for half-spaces without a common inside. Planes within 1e-8 rad count as parallel.
template <int D, std::size_t K>
std::string check_common_inside(const std::array<half_space<D>, K>& faces) {
  constexpr int k = static_cast<int>(K);
  constexpr double parallel = 1e-8;  // rad, about the square root of the rounding of double
  const matrix<double, D, k> N = normals_of(faces);
  const vector<double, k> g = distances_from<D, K>(faces, point<D>::Zero());
  if (g.maxCoeff() <= 0 || least_distance<double, D, k>(N, g).residual >= parallel) return {};
  return "faces of a convex_polytope have no common inside: expected normals that point out of it";
}

}  // namespace detail

/// Parameters of convex_polytope: the planes of its faces. It may be unbounded; planes may be redundant.
template <int D, int K>
struct convex_polytope_parameters {
  std::array<half_space_parameters<D>, static_cast<std::size_t>(K)>
      faces;  ///< Faces with normals out of the polytope.

  static constexpr const char* type_name = "a convex_polytope";  ///< In errors.
  static constexpr auto members() {
    using p = convex_polytope_parameters;
    return member_table(member("faces", &p::faces));
  }
  /// Requires a common inside.
  std::string rules() const { return detail::check_common_inside(detail::half_spaces(faces)); }
};

/// distance(x) = max_i n_i . (x - p_i) inside, the distance to the nearest point outside, exact to rounding
/// by the sine of the sharpest angle between faces. Among equally near faces inside, the first determines the
/// gradient. Like every shape it has at most one contact; for a room use walls_of.
template <int D, int K>
class convex_polytope {
  static_assert(K >= 1, "passive_haptics: a convex_polytope has one face or more.");
  static constexpr auto face_count = static_cast<std::size_t>(K);

 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit convex_polytope(const convex_polytope_parameters<D, K>& p)
      : faces_(detail::half_spaces(require_valid(p).faces)), normals_(detail::normals_of(faces_)) {}

  /// Common inside of these half-spaces; throws std::invalid_argument if there is none.
  template <std::same_as<half_space<D>>... Rest>
    requires(sizeof...(Rest) + 1 == face_count)
  explicit convex_polytope(const half_space<D>& first, const Rest&... rest)
      : faces_{first, rest...}, normals_(detail::normals_of(faces_)) {
    require_no_error(detail::check_common_inside(faces_));
  }

  /// Signed distance [m]: K D multiplications inside, in addition a cone projection outside.
  double distance(const point<D>& x) const { return nearest(x).distance; }

  /// Unit vector to the free side; cost as distance().
  point<D> gradient(const point<D>& x) const { return nearest(x).gradient; }

  /// (P - n n^T) / distance(x) [1/m] if an edge or corner is nearest from outside, else zero. P is the
  /// projection onto the normals of the faces there.
  matrix<double, D, D> hessian(const point<D>& x) const {
    const result at = nearest(x);
    matrix<double, D, D> Q = matrix<double, D, D>::Zero();  // orthonormal basis of these normals
    int rank = 0;
    for (int i = 0; i < K; ++i) {
      if (!(at.multipliers[i] > 0) || rank == D) continue;
      point<D> n = normals_.col(i);
      orthogonalise(n, Q, rank);
      Q.col(rank++) = n.normalized();
    }
    if (rank < 2) return matrix<double, D, D>::Zero();
    return detail::hessian_of_length<D>(at.distance * at.gradient, Q * Q.transpose());
  }

  /// The half-spaces with the polytope as their common inside.
  const std::array<half_space<D>, face_count>& faces() const { return faces_; }

 private:
  struct result {
    double distance;
    point<D> gradient;
    vector<double, K> multipliers;  // > 0 for the faces at the nearest edge or corner
  };

  result nearest(const point<D>& x) const {
    const vector<double, K> g = detail::distances_from(faces_, x);
    int nearest_plane = 0;
    const double largest = g.maxCoeff(&nearest_plane);
    if (largest > 0) {
      // The nearest point is the shortest displacement to behind all planes
      const least_distance<double, D, K> least(normals_, g);
      const double length = least.way.norm(), distance = least.multipliers.dot(g) / length;
      if (distance > largest) return {distance, least.way / length, least.multipliers};
    }
    return {largest, normals_.col(nearest_plane), vector<double, K>::Zero()};
  }

  std::array<half_space<D>, face_count> faces_;
  matrix<double, D, K> normals_;
};

/// Deduces dimension and number of faces from the half-spaces.
template <int D, class... Rest>
convex_polytope(const half_space<D>&, const Rest&...)
    -> convex_polytope<D, 1 + static_cast<int>(sizeof...(Rest))>;

}  // namespace passive_haptics
