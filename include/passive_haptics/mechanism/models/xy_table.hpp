/// @file
/// An XY table: two orthogonal slides, a brake on each (Figs. 4 and 5).
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>

namespace passive_haptics {

/// Moved masses of an XY table (the paper prints none).
template <class T>
struct xy_table_parameters {
  T mass_x = T(0.5);  ///< All that moves along x [kg].
  T mass_y = T(0.5);  ///< All that moves along y [kg].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = xy_table_parameters;
    return member_table(member("mass_x", &p::mass_x, "kg", range::positive),
                        member("mass_y", &p::mass_y, "kg", range::positive));
  }
};

/// x = q [m]; brake i acts on axis i. J = I, constant and diagonal: later layers solve nothing. No singular
/// pose.
template <class T>
class xy_table {
 public:
  using scalar = T;                         ///< Scalar of all lengths.
  static constexpr int dof = 2;             ///< n
  static constexpr int task_dimension = 2;  ///< d
  static constexpr int brake_count = 2;     ///< m

  /// Throws std::invalid_argument with the text of validate(p).
  explicit xy_table(const xy_table_parameters<T>& p = {}) : p_(require_valid(p)) {}

  /// End effector [m].
  template <class S = T>
  vector<S, 2> position(const vector<S, 2>& q) const {
    return q;
  }

  /// J = I.
  diagonal_matrix<T, 2> jacobian() const { return diagonal_matrix<T, 2>(T(1), T(1)); }

  /// Joint positions that put the handle at x [m]; always reached.
  joint_solution<T, 2> inverse(const vector<T, 2>& x) const {
    return {x, all_finite(x) ? status::ok : status::state_not_finite};
  }

  /// M [kg].
  matrix<T, 2, 2> mass_matrix(const vector<T, 2>&) const {
    return matrix<T, 2, 2>{{p_.mass_x, T(0)}, {T(0), p_.mass_y}};
  }

  /// c = 0 [N].
  vector<T, 2> bias_torque(const vector<T, 2>&, const vector<T, 2>&) const { return vector<T, 2>::Zero(); }

  /// Jd qd = 0 [m/s^2].
  vector<T, 2> bias_acceleration(const vector<T, 2>&, const vector<T, 2>&) const {
    return vector<T, 2>::Zero();
  }

 private:
  xy_table_parameters<T> p_;
};

}  // namespace passive_haptics
