/// @file
/// End stops: limits of the joints.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

#include <limits>
#include <string>

namespace passive_haptics {

/// Where the joints end. For a sliding joint read N for N m and m for rad.
template <class T, int N>
struct end_stops_parameters {
  /// Lower limits [rad]; -infinity for none.
  vector<T, N> lower = vector<T, N>::Constant(-std::numeric_limits<T>::infinity());
  /// Upper limits [rad]; infinity for none.
  vector<T, N> upper = vector<T, N>::Constant(std::numeric_limits<T>::infinity());
  vector<T, N> stiffness =
      vector<T, N>::Zero();  ///< Growth of the resistance behind a limit [N m/rad], >= 0.
  /// Slower counts as at rest [rad/s], > 0; as rate_dead_band of brake_parameters.
  vector<T, N> rate_dead_band = vector<T, N>::Constant(T(0.02));

  static constexpr const char* type_name = "end_stops";  ///< In errors.
  /// The table of core/parameters.hpp.
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

/// Desired joint torques: behind a limit, k times the way behind it against motion further out. On the way
/// back the joint is free, as at every wall of brakes: the elastic part would be active there (equation 3).
///
/// An Effect in joint space: with no hand torque, t_i qd_i <= 0 for each joint and t = 0 at rest. A limit in
/// the task space is a half_space.
template <class T, int N>
class end_stops {
 public:
  using scalar = T;              ///< Scalar of torques.
  static constexpr int dof = N;  ///< n

  /// Throws std::invalid_argument with the text of validate(p).
  explicit end_stops(const end_stops_parameters<T, N>& p) : p_(require_valid(p)) {}

  /// Joint torque (n) [N m] at q (n) [rad] with rates qd (n) [rad/s]; hand_torque (n) [N m], what the hand
  /// does to the joints, J^T Fh, matters in the dead band only.
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
