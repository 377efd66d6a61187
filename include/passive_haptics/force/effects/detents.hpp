/// @file
/// Detents: periodic positions along a direction that resist being left.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effect.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

#include <cmath>
#include <numbers>

namespace passive_haptics {

/// Where detents are and how strong.
template <class T, int D>
struct detents_parameters {
  vector<T, D> origin = vector<T, D>::Zero();            ///< A point at a detent [m].
  vector<T, D> direction = vector<T, D>::UnitX();        ///< Across the detents; any length > 0.
  T spacing = T(0);                                      ///< From one to the next [m], > 0.
  T strength = T(0);                                     ///< Largest resistance [N], >= 0.
  T velocity_dead_band = default_velocity_dead_band<T>;  ///< Slower counts as at rest [m/s], > 0.

  static constexpr const char* type_name = "detents";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = detents_parameters;
    return member_table(member("origin", &p::origin, "m", range::finite),
                        member("direction", &p::direction, "1", range::direction),
                        member("spacing", &p::spacing, "m", range::positive),
                        member("strength", &p::strength, "N", range::not_negative),
                        member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::positive));
  }
};

/// With a the direction, e the way from the nearest detent along a, P the spacing and f the strength:
///
///   F = -f |sin(2 pi e / P)| sgn(e) a  while e grows away from the detent, else 0.
///
/// This is the leaving half of a magnetic detent's sinusoidal force. The other half would pull the handle in;
/// a brake cannot (equation 3), so on the way in the handle is free. Continuous in x; in v outside the dead
/// band, where it is a one_way_resistance() and holds against a hand force under the limit.
template <class T, int D>
class detents {
 public:
  using scalar = T;                    ///< Scalar of forces.
  static constexpr int dimension = D;  ///< d

  /// Throws std::invalid_argument with the text of validate(p).
  explicit detents(const detents_parameters<T, D>& p) : p_(require_valid(p)) {
    p_.direction = direction_of(p_.direction);
  }

  /// Way from the nearest detent along the direction [m], at most spacing / 2 in size.
  T offset(const vector<T, D>& x) const {
    const T s = p_.direction.dot(x - p_.origin);
    return s - p_.spacing * std::round(s / p_.spacing);
  }

  /// Force [N] at x [m] with velocity v [m/s]; the hand force [N] matters in the dead band only.
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
