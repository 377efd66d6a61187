/// Planar walls.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/shape.hpp>

namespace passive_haptics {

/// Parameters of half_space.
template <int D>
struct half_space_parameters {
  point<D> surface_point = point<D>::Zero();  ///< Any point of the surface [m].
  point<D> normal = point<D>::Zero();         ///< Outward direction, any length > 0.

  static constexpr const char* type_name = "a half_space";  ///< In errors.
  static constexpr auto members() {
    using p = half_space_parameters;
    return member_table(member("surface_point", &p::surface_point, "m", range::finite),
                        member("normal", &p::normal, "1", range::direction));
  }
};

/// The wall behind a plane, distance(x) = n . (x - p).
template <int D>
class half_space {
 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit half_space(const half_space_parameters<D>& p)
      : normal_(direction_of(require_valid(p).normal)), point_(p.surface_point) {}

  /// Wall through surface_point with this outward normal.
  half_space(const point<D>& surface_point, const point<D>& normal)
      : half_space(half_space_parameters<D>{surface_point, normal}) {}

  double distance(const point<D>& x) const { return normal_.dot(x - point_); }  ///< Signed distance [m].

  point<D> gradient(const point<D>&) const { return normal_; }  ///< The unit normal.

 private:
  point<D> normal_;
  point<D> point_;
};

}  // namespace passive_haptics
