/// Detents: periodic positions along a direction that the handle leaves against a resistance.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effect.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

#include <cmath>
#include <numbers>

namespace passive_haptics {

/// Parameters of detents.
template <class T, int D>
struct detents_parameters {
  vector<T, D> origin = vector<T, D>::Zero();            ///< Position of one detent [m].
  vector<T, D> direction = vector<T, D>::UnitX();        ///< Direction across the detents, of any length > 0.
  T spacing = T(0);                                      ///< Distance between detents [m], > 0.
  T strength = T(0);                                     ///< Maximum resistance [N], >= 0.
  T velocity_dead_band = default_velocity_dead_band<T>;  ///< Speed counted as at rest [m/s], > 0.

  static constexpr const char* type_name = "detents";  ///< For errors.
  static constexpr auto members() {
    using p = detents_parameters;
    return member_table(member("origin", &p::origin, "m", range::finite),
                        member("direction", &p::direction, "1", range::direction),
                        member("spacing", &p::spacing, "m", range::positive),
                        member("strength", &p::strength, "N", range::not_negative),
                        member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::positive));
  }
};

/// With the direction a, the offset e from the nearest detent along a, the spacing P and the strength f:
///
///   F = -f |sin(2 pi e / P)| sgn(e) a  while e grows away from the detent, else 0.
///
/// This is the leaving half of the sinusoidal force of a magnetic detent. The other half would pull the
/// handle in, which a brake cannot do (equation 3), so the handle moves in freely. The force is continuous in
/// x, and in v outside the dead band of its one_way_resistance().
template <class T, int D>
class detents {
 public:
  using scalar = T;                    ///< Scalar type.
  static constexpr int dimension = D;  ///< Task dimension d.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit detents(const detents_parameters<T, D>& p) : p_(require_valid(p)) {
    p_.direction = direction_of(p_.direction);
  }

  /// Offset from the nearest detent along the direction [m], at most spacing / 2 in magnitude.
  T offset(const vector<T, D>& x) const {
    const T s = p_.direction.dot(x - p_.origin);
    return s - p_.spacing * std::round(s / p_.spacing);
  }

  /// Force [N] at x [m] with velocity v [m/s]. The hand force [N] only matters in the dead band.
  vector<T, D> force(const vector<T, D>& x, const vector<T, D>& v,
                     const vector<T, D>& hand_force = vector<T, D>::Zero()) const {
    const T e = offset(x);
    const T limit = p_.strength * std::abs(std::sin(T(2) * std::numbers::pi_v<T> * e / p_.spacing));
    const vector<T, D> out = e < T(0) ? vector<T, D>(-p_.direction) : p_.direction;
    return -one_way_resistance(limit, out.dot(v), p_.velocity_dead_band, out.dot(hand_force)) * out;
  }

 private:
  detents_parameters<T, D> p_;
};

}  // namespace passive_haptics
