/// Guidance along a line or plane by resistance to deviations.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effect.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

namespace passive_haptics {

/// Shape of a guide.
enum class guide_along {
  line,   ///< The line through `point` along `direction`.
  plane,  ///< The plane through `point` with the normal `direction`.
};

/// Parameters of a guide.
template <class T, int D>
struct guide_parameters {
  guide_along along = guide_along::line;           ///< Line or plane.
  vector<T, D> point = vector<T, D>::Zero();       ///< Any point of the guide [m].
  vector<T, D> direction = vector<T, D>::UnitX();  ///< Along the line or normal to the plane; any length > 0.
  T stiffness = T(0);  ///< Increase of the resistance with the deviation [N/m], >= 0.
  T tolerance = T(0);  ///< Deviation without this resistance [m], >= 0.
  T viscosity = T(0);  ///< Viscous resistance across the guide, in both directions [N s/m], >= 0.
  T velocity_dead_band = default_velocity_dead_band<T>;  ///< Speed counted as at rest [m/s], > 0.

  static constexpr const char* type_name = "a guide";  ///< For errors.
  static constexpr auto members() {
    using p = guide_parameters;
    return member_table(choice("along", &p::along, "line, plane"),
                        member("point", &p::point, "m", range::finite),
                        member("direction", &p::direction, "1", range::direction),
                        member("stiffness", &p::stiffness, "N/m", range::not_negative),
                        member("tolerance", &p::tolerance, "m", range::not_negative),
                        member("viscosity", &p::viscosity, "N s/m", range::not_negative),
                        member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::positive));
  }
};

/// A virtual fixture made of resistance. With the deviation e, the velocity v_e across it and u = e / |e|:
///
///   F = -k max(|e| - tolerance, 0) u  while u . v > 0, else 0;   plus -b v_e always.
///
/// Motion along the guide and back to it is free of stiffness. The force is continuous in x, and in v outside
/// the dead band of its one_way_resistance(). See scene/shapes/virtual_fixtures.hpp for walls. Sources: L. B.
/// Rosenberg, Virtual fixtures: perceptual tools for telerobotic manipulation, IEEE VRAIS 1993, pp. 76-82; D.
/// K. Swanson, W. J. Book, Path-following control for dissipative passive haptic displays, 11th Symposium on
/// Haptics, 2003, pp. 101-108 (the paper's [5]).
template <class T, int D>
class guide {
 public:
  using scalar = T;                    ///< Scalar type.
  static constexpr int dimension = D;  ///< Task dimension d.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit guide(const guide_parameters<T, D>& p) : p_(require_valid(p)) {
    p_.direction = direction_of(p_.direction);
  }

  /// Deviation perpendicular to the guide [m].
  vector<T, D> deviation(const vector<T, D>& x) const { return across(x - p_.point); }

  /// Force [N] at x [m] with velocity v [m/s]. The hand force [N] only matters in the dead band.
  vector<T, D> force(const vector<T, D>& x, const vector<T, D>& v,
                     const vector<T, D>& hand_force = vector<T, D>::Zero()) const {
    const vector<T, D> drag = -p_.viscosity * across(v);
    const vector<T, D> e = deviation(x);
    const T way_off = e.norm();
    if (way_off <= p_.tolerance) return drag;
    const vector<T, D> u = e / way_off;
    const T limit = p_.stiffness * (way_off - p_.tolerance);
    return drag - one_way_resistance(limit, u.dot(v), p_.velocity_dead_band, u.dot(hand_force)) * u;
  }

 private:
  vector<T, D> across(const vector<T, D>& r) const {
    const vector<T, D> along = p_.direction * p_.direction.dot(r);
    return p_.along == guide_along::line ? vector<T, D>(r - along) : along;
  }

  guide_parameters<T, D> p_;
};

}  // namespace passive_haptics
