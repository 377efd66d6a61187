/// End stops: limits of the joints.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

#include <limits>
#include <string>

namespace passive_haptics {

/// Joint limits and their resistance. For a sliding joint, read N for N m and m for rad.
template <class T, int N>
struct end_stops_parameters {
  /// Lower limits [rad], or -infinity.
  vector<T, N> lower = vector<T, N>::Constant(-std::numeric_limits<T>::infinity());
  /// Upper limits [rad], or infinity.
  vector<T, N> upper = vector<T, N>::Constant(std::numeric_limits<T>::infinity());
  vector<T, N> stiffness =
      vector<T, N>::Zero();  ///< Increase of the resistance beyond a limit [N m/rad], >= 0.
  /// Rate below which a joint is at rest [rad/s], > 0; as in brake_parameters.
  vector<T, N> rate_dead_band = vector<T, N>::Constant(T(0.02));

  static constexpr const char* type_name = "end_stops";  ///< For errors.
  static constexpr auto members() {
    using p = end_stops_parameters;
    return member_table(member("lower", &p::lower, "rad"), member("upper", &p::upper, "rad"),
                        member("stiffness", &p::stiffness, "N m/rad", range::not_negative),
                        member("rate_dead_band", &p::rate_dead_band, "rad/s", range::positive));
  }
  /// Each lower limit is below the upper one.
  std::string rules() const {
    for (int i = 0; i < N; ++i) {
      if (lower[i] < upper[i]) continue;
      return detail::error_text(detail::indexed("lower[", i, "] of end_stops [rad]"), lower[i],
                                detail::indexed("less than upper[", i, "]"));
    }
    return {};
  }
};

/// Desired joint torques: beyond a limit, stiffness times overshoot against motion further out. The way back
/// is free because an elastic force would be active (equation 3). For task space, use a half_space.
template <class T, int N>
class end_stops {
 public:
  using scalar = T;              ///< Scalar type.
  static constexpr int dof = N;  ///< Number of joints n.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit end_stops(const end_stops_parameters<T, N>& p) : p_(require_valid(p)) {}

  /// Joint torques (n) [N m] at q (n) [rad] with rates qd (n) [rad/s]. hand_torque: J^T Fh (n) [N m].
  vector<T, N> torque(const vector<T, N>& q, const vector<T, N>& qd,
                      const vector<T, N>& hand_torque = vector<T, N>::Zero()) const {
    vector<T, N> t;
    for (int i = 0; i < N; ++i) {
      const T side = q[i] > p_.upper[i] ? T(1) : T(-1);
      const T behind = side > T(0) ? q[i] - p_.upper[i] : p_.lower[i] - q[i];
      const T limit = p_.stiffness[i] * (behind < T(0) ? T(0) : behind);
      t[i] = -side * one_way_resistance(limit, side * qd[i], p_.rate_dead_band[i], side * hand_torque[i]);
    }
    return t;
  }

 private:
  end_stops_parameters<T, N> p_;
};

}  // namespace passive_haptics
