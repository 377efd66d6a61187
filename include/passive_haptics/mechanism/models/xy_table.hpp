/// An XY table: two orthogonal slides with a brake each (Figs. 4 and 5).
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>

namespace passive_haptics {

/// Moved masses of an XY table (none in the paper).
template <class T>
struct xy_table_parameters {
  T mass_x = T(0.5);  ///< Total mass moved along x [kg].
  T mass_y = T(0.5);  ///< Total mass moved along y [kg].

  static constexpr auto members() {
    using p = xy_table_parameters;
    return member_table(member("mass_x", &p::mass_x, "kg", range::positive),
                        member("mass_y", &p::mass_y, "kg", range::positive));
  }
};

/// x = q [m]; brake i acts on axis i. J = I, constant and diagonal, without singular poses.
template <class T>
class xy_table {
 public:
  using scalar = T;                         ///< Scalar type.
  static constexpr int dof = 2;             ///< Joints n.
  static constexpr int task_dimension = 2;  ///< Task dimensions d.
  static constexpr int brake_count = 2;     ///< Brakes m.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit xy_table(const xy_table_parameters<T>& p = {}) : p_(require_valid(p)) {}

  /// End effector [m].
  template <class S = T>
  vector<S, 2> position(const vector<S, 2>& q) const {
    return q;
  }

  diagonal_matrix<T, 2> jacobian() const { return diagonal_matrix<T, 2>(T(1), T(1)); }  ///< J = I.

  /// Joint positions for the handle at x [m]; always within reach.
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
