/// @file
/// A round wall: disc (2-D) or ball (3-D), touched from outside or from inside.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>

namespace passive_haptics {

/// Which side of a round wall is free.
enum class filling {
  solid,   ///< Free outside: the wall is convex for the hand.
  hollow,  ///< Free inside: the wall is concave for the hand.
};

/// Centre, radius and free side of a round wall.
template <int D>
struct ball_parameters {
  point<D> centre = point<D>::Zero();  ///< [m]
  double radius = 0;                   ///< [m], > 0
  filling inside = filling::solid;     ///< Which side is free.

  static constexpr const char* type_name = "a ball";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = ball_parameters;
    return member_table(member("centre", &p::centre, "m", range::finite),
                        member("radius", &p::radius, "m", range::positive),
                        choice("inside", &p::inside, "solid, hollow"));
  }
};

/// distance(x) = |x - c| - r if solid, r - |x - c| if hollow. At the centre, where the gradient does not
/// exist, it is the x axis.
template <int D>
class ball {
 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit ball(const ball_parameters<D>& p)
      : centre_(require_valid(p).centre), radius_(p.radius), sign_(p.inside == filling::solid ? 1.0 : -1.0) {}

  /// Round wall about centre [m] with radius [m].
  ball(const point<D>& centre, double radius, filling inside = filling::solid)
      : ball(ball_parameters<D>{centre, radius, inside}) {}

  /// Not in this order.
  ball(double, const point<D>&, filling = filling::solid) {
    static_assert(D < 0, "passive_haptics: the arguments of a ball are (centre, radius), in this order.");
  }

  /// Signed distance [m]; one square root.
  double distance(const point<D>& x) const { return sign_ * ((x - centre_).norm() - radius_); }

  /// Unit vector away from the surface, to the free side; one square root.
  point<D> gradient(const point<D>& x) const {
    const point<D> r = x - centre_;
    const double length = r.norm();
    return length > 0 ? point<D>(sign_ / length * r) : point<D>(sign_ * point<D>::UnitX());
  }

  /// (I - n n^T) / |x - c| if solid, its negative if hollow [1/m]; zero at the centre.
  matrix<double, D, D> hessian(const point<D>& x) const {
    return sign_ * detail::hessian_of_length<D>(x - centre_, matrix<double, D, D>::Identity());
  }

  /// The cube about a solid ball; a hollow one is everywhere.
  bounding_box<D> bounds() const { return sign_ > 0 ? box_about(centre_, radius_) : everywhere<D>(); }

 private:
  point<D> centre_;
  double radius_;
  double sign_;  // 1 solid, -1 hollow
};

/// A ball in the plane.
using disc = ball<2>;

}  // namespace passive_haptics
