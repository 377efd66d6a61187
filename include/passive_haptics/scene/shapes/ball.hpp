/// Discs (2-D) and balls (3-D), solid or hollow.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>

namespace passive_haptics {

/// The free side of a round wall.
enum class filling {
  solid,   ///< Free outside.
  hollow,  ///< Free inside.
};

/// Parameters of ball.
template <int D>
struct ball_parameters {
  point<D> centre = point<D>::Zero();  ///< [m]
  double radius = 0;                   ///< [m], > 0
  filling inside = filling::solid;     ///< The free side.

  static constexpr const char* type_name = "a ball";  ///< In errors.
  static constexpr auto members() {
    using p = ball_parameters;
    return member_table(member("centre", &p::centre, "m", range::finite),
                        member("radius", &p::radius, "m", range::positive),
                        choice("inside", &p::inside, "solid, hollow"));
  }
};

/// distance(x) = |x - c| - r if solid, r - |x - c| if hollow. The gradient at the centre is the x axis.
template <int D>
class ball {
 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit ball(const ball_parameters<D>& p)
      : centre_(require_valid(p).centre), radius_(p.radius), sign_(p.inside == filling::solid ? 1.0 : -1.0) {}

  /// Centre [m] and radius [m].
  ball(const point<D>& centre, double radius, filling inside = filling::solid)
      : ball(ball_parameters<D>{centre, radius, inside}) {}

  /// Rejects the wrong order of arguments.
  ball(double, const point<D>&, filling = filling::solid) {
    static_assert(D < 0, "passive_haptics: the arguments of a ball are (centre, radius), in this order.");
  }

  /// Signed distance [m].
  double distance(const point<D>& x) const { return sign_ * ((x - centre_).norm() - radius_); }

  /// Unit vector to the free side.
  point<D> gradient(const point<D>& x) const {
    const point<D> r = x - centre_;
    const double length = r.norm();
    return length > 0 ? point<D>(sign_ / length * r) : point<D>(sign_ * point<D>::UnitX());
  }

  /// (I - n n^T) / |x - c| if solid, its negative if hollow [1/m]; zero at the centre.
  matrix<double, D, D> hessian(const point<D>& x) const {
    return sign_ * detail::hessian_of_length<D>(x - centre_, matrix<double, D, D>::Identity());
  }

  /// Bounding cube of a solid ball; infinite for a hollow one.
  bounding_box<D> bounds() const { return sign_ > 0 ? box_about(centre_, radius_) : everywhere<D>(); }

 private:
  point<D> centre_;
  double radius_;
  double sign_;  // 1 solid, -1 hollow
};

/// A planar ball.
using disc = ball<2>;

}  // namespace passive_haptics
