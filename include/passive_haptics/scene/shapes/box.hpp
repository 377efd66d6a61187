/// Rectangles (2-D) and boxes (3-D) in any orientation.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <array>
#include <utility>

namespace passive_haptics {

/// Maximum |a_i . a_j - delta_ij| of the axes of a box (six printed digits); the box orthonormalises them.
inline constexpr double box_axes_tolerance = 1e-5;

/// Parameters of box.
template <int D>
struct box_parameters {
  point<D> centre = point<D>::Zero();                            ///< [m]
  point<D> half_extents = point<D>::Zero();                      ///< From the centre to the faces [m], >= 0.
  matrix<double, D, D> axes = matrix<double, D, D>::Identity();  ///< Orthonormal columns, base frame.

  static constexpr const char* type_name = "a box";  ///< In errors.
  static constexpr auto members() {
    using p = box_parameters;
    return member_table(member("centre", &p::centre, "m", range::finite),
                        member("half_extents", &p::half_extents, "m", range::not_negative),
                        member("axes", &p::axes, "1", range::finite));
  }
  /// Requires orthonormal axes within box_axes_tolerance.
  error_message rules() const {
    const double skew = (axes.transpose() * axes - matrix<double, D, D>::Identity()).cwiseAbs().maxCoeff();
    if (skew <= box_axes_tolerance) return {};
    return detail::error_text("|axes^T axes - I| of a box", skew, "orthonormal columns");
  }
};

/// In the frame of the box, with q = |R^T (x - c)| - h by components: distance(x) = |max(q, 0)| outside and
/// max_i q_i inside; exact on both sides. Among equally near faces inside, the first determines the gradient.
template <int D>
class box {
 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit box(const box_parameters<D>& p)
      : centre_(require_valid(p).centre), half_extents_(p.half_extents), axes_(orthonormal(p.axes)) {}

  /// Box about centre [m] with half_extents [m] along the base frame.
  box(const point<D>& centre, const point<D>& half_extents) : box(box_parameters<D>{centre, half_extents}) {}

  /// Signed distance [m].
  double distance(const point<D>& x) const {
    const point<D> q = beyond_faces(local(x));
    const double inside = q.maxCoeff();
    return inside > 0 ? q.cwiseMax(0).norm() : inside;
  }

  /// Unit vector to the free side.
  point<D> gradient(const point<D>& x) const {
    const point<D> at = local(x);
    const point<D> q = beyond_faces(at);
    const point<D> side = at.unaryExpr([](double u) { return u < 0 ? -1.0 : 1.0; });
    int nearest = 0;
    q.maxCoeff(&nearest);
    const point<D> face = point<D>::Unit(nearest);
    return axes_ * side.cwiseProduct(detail::direction_or<D>(q.cwiseMax(0), face));
  }

  /// Zero inside and in front of a face. Beyond an edge or corner (P - n n^T) / distance(x) [1/m], with the
  /// projection P onto the directions in which x is outside the box.
  matrix<double, D, D> hessian(const point<D>& x) const {
    const point<D> at = local(x);
    const point<D> q = beyond_faces(at).cwiseMax(0);
    const point<D> is_beyond = (q.array() > 0).template cast<double>();
    if (is_beyond.sum() < 2) return matrix<double, D, D>::Zero();
    const point<D> r = (at.array() < 0).select(-q, q);
    return axes_ * detail::hessian_of_length<D>(r, is_beyond.asDiagonal()) * axes_.transpose();
  }

  double thickness() const { return 2 * half_extents_.minCoeff(); }  ///< Minimum extent [m].

  /// The 2 D faces, with the box as common inside: axis 0 positive, axis 0 negative, axis 1, ...
  std::array<half_space<D>, std::size_t(2 * D)> faces() const {
    const auto face = [this](int k) {
      const point<D> normal = (k % 2 == 0 ? 1 : -1) * axes_.col(k / 2);
      return half_space<D>(centre_ + half_extents_[k / 2] * normal, normal);
    };
    return [&]<int... k>(std::integer_sequence<int, k...>) {
      return std::array{face(k)...};
    }(std::make_integer_sequence<int, 2 * D>());
  }

  /// Axis-aligned bounding box.
  bounding_box<D> bounds() const {
    const point<D> half = axes_.cwiseAbs() * half_extents_;
    return {centre_ - half, centre_ + half};
  }

 private:
  point<D> local(const point<D>& x) const { return axes_.transpose() * (x - centre_); }
  point<D> beyond_faces(const point<D>& local_point) const { return local_point.cwiseAbs() - half_extents_; }

  static matrix<double, D, D> orthonormal(matrix<double, D, D> axes) {
    for (int i = 0; i < D; ++i) {
      point<D> axis = axes.col(i);
      orthogonalise(axis, axes, i);
      axes.col(i) = axis.normalized();
    }
    return axes;
  }

  point<D> centre_;
  point<D> half_extents_;
  matrix<double, D, D> axes_;
};

/// A planar box.
using rectangle = box<2>;

}  // namespace passive_haptics
