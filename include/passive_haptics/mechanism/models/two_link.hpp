/// Two-link planar arm with a brake on each joint (Figs. 2 and 3).
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>

#include <cmath>

namespace passive_haptics {

/// Geometry and inertia of a two-link arm: uniform rods with a point mass at the handle. Default lengths are
/// from the paper; it gives no masses, so these are those of a light desktop device.
template <class T>
struct two_link_parameters {
  T length_1 = T(0.15);         ///< l1 [m], section 5.1.
  T length_2 = T(0.15);         ///< l2 [m], section 5.1.
  T mass_1 = T(0.2);            ///< Link 1 [kg].
  T mass_2 = T(0.2);            ///< Link 2 [kg].
  T handle_mass = T(0.1);       ///< Point mass at the end effector [kg].
  T rotor_inertia_1 = T(5e-5);  ///< On the axis of brake 1 [kg m^2].
  T rotor_inertia_2 = T(5e-5);  ///< On the axis of brake 2 [kg m^2].

  static constexpr auto members() {
    using p = two_link_parameters;
    return member_table(member("length_1", &p::length_1, "m", range::positive),
                        member("length_2", &p::length_2, "m", range::positive),
                        member("mass_1", &p::mass_1, "kg", range::positive),
                        member("mass_2", &p::mass_2, "kg", range::positive),
                        member("handle_mass", &p::handle_mass, "kg", range::not_negative),
                        member("rotor_inertia_1", &p::rotor_inertia_1, "kg m^2", range::not_negative),
                        member("rotor_inertia_2", &p::rotor_inertia_2, "kg m^2", range::not_negative));
  }
};

/// Link vectors of a two-link arm.
template <class T>
struct two_link_pose {
  vector<T, 2> link_1;  ///< From base to elbow [m].
  vector<T, 2> link_2;  ///< From elbow to handle [m].
};

/// Two-link arm in a horizontal plane, q1 from the x axis, q2 from link 1 [rad]:
///
///     x = l1 (cos q1, sin q1) + l2 (cos q12, sin q12),   q12 = q1 + q2.
///
/// Singular at q2 = 0 and q2 = +-pi (det J = l1 l2 sin q2): straight or folded, no radial velocity. Cost of a
/// pose: two sines and cosines; position and jacobian add a few additions.
template <class T>
class two_link {
 public:
  using scalar = T;                         ///< Scalar type.
  static constexpr int dof = 2;             ///< Joints n.
  static constexpr int task_dimension = 2;  ///< Task dimensions d.
  static constexpr int brake_count = 2;     ///< Brakes m.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit two_link(const two_link_parameters<T>& p = {}) : p_(require_valid(p)) {}

  /// Prevents slicing of derived classes.
  template <detail::extends<two_link> Larger>
  two_link(const Larger&) = delete;  // passive_haptics: would lose what the larger class adds
  /// Prevents slicing of derived classes.
  template <detail::extends<two_link> Larger>
  two_link& operator=(const Larger&) = delete;  // passive_haptics: would lose what the larger class adds

  const two_link_parameters<T>& parameters() const { return p_; }  ///< The parameters as given.

  /// End effector [m], base frame, for any scalar S that multiplies with T.
  template <class S = T>
  vector<S, 2> position(const vector<S, 2>& q) const {
    using std::cos, std::sin;
    const S q12 = q[0] + q[1];
    return {p_.length_1 * cos(q[0]) + p_.length_2 * cos(q12),
            p_.length_1 * sin(q[0]) + p_.length_2 * sin(q12)};
  }

  /// The links [m].
  PASSIVE_HAPTICS_PART two_link_pose<T> pose(const vector<T, 2>& q) const {
    const auto [q1, q12] = sine_cosine(q[0], q[0] + q[1]);
    return {{p_.length_1 * q1.cosine, p_.length_1 * q1.sine},
            {p_.length_2 * q12.cosine, p_.length_2 * q12.sine}};
  }

  /// End effector [m].
  vector<T, 2> position(const two_link_pose<T>& at) const {
    return {at.link_1[0] + at.link_2[0], at.link_1[1] + at.link_2[1]};
  }

  /// J [m/rad]
  matrix<T, 2, 2> jacobian(const two_link_pose<T>& at) const {
    const vector<T, 2> x = position(at);
    return matrix_of<2, 2>(-x[1], -at.link_2[1], x[0], at.link_2[0]);
  }

  matrix<T, 2, 2> jacobian(const vector<T, 2>& q) const { return jacobian(pose(q)); }  ///< J [m/rad]

  /// J^-T = [J_1 J_2] [1/m]: column i is the force of a unit torque at joint i. With the links l_1, l_2 as
  /// vectors, J_1 = l_2 / det J and J_2 = -(l_1 + l_2) / det J, det J = l_1 x l_2. Not finite if det J = 0.
  /// @equation{5}
  matrix<T, 2, 2> inverse_transposed_jacobian(const vector<T, 2>& q) const {
    const auto [l_1, l_2] = pose(q);
    matrix<T, 2, 2> J_1_J_2;
    J_1_J_2 << l_2, -(l_1 + l_2);
    return J_1_J_2 / cross_in_plane(l_1, l_2);
  }

  /// Joint positions for the handle at x [m]; see two_link_inverse.
  joint_solution<T, 2> inverse(const vector<T, 2>& x, elbow branch) const {
    return two_link_inverse(p_.length_1, p_.length_2, x, branch);
  }

  /// M [kg m^2], including rotors on the joint axes.
  matrix<T, 2, 2> mass_matrix(const two_link_pose<T>& at) const {
    matrix<T, 2, 2> M = link_mass_matrix(at);
    M(0, 0) += p_.rotor_inertia_1;
    M(1, 1) += p_.rotor_inertia_2;
    return M;
  }
  matrix<T, 2, 2> mass_matrix(const vector<T, 2>& q) const { return mass_matrix(pose(q)); }  ///< M(q)

  /// c [N m]: Coriolis and centrifugal torques; the plane is horizontal.
  vector<T, 2> bias_torque(const two_link_pose<T>& at, const vector<T, 2>& qd) const {
    const T h = outer_mass() * cross_in_plane(at.link_1, at.link_2);
    return {-h * (T(2) * qd[0] * qd[1] + qd[1] * qd[1]), h * qd[0] * qd[0]};
  }
  /// c(q, qd)
  vector<T, 2> bias_torque(const vector<T, 2>& q, const vector<T, 2>& qd) const {
    return bias_torque(pose(q), qd);
  }

  /// Jd qd [m/s^2]: centripetal accelerations of the links.
  vector<T, 2> bias_acceleration(const two_link_pose<T>& at, const vector<T, 2>& qd) const {
    const T w12 = qd[0] + qd[1];
    return -qd[0] * qd[0] * at.link_1 - w12 * w12 * at.link_2;
  }
  /// Jd qd in pose q.
  vector<T, 2> bias_acceleration(const vector<T, 2>& q, const vector<T, 2>& qd) const {
    return bias_acceleration(pose(q), qd);
  }

 protected:
  /// M [kg m^2] without rotors.
  matrix<T, 2, 2> link_mass_matrix(const two_link_pose<T>& at) const {
    const T l1 = p_.length_1, l2 = p_.length_2, m1 = p_.mass_1, m2 = p_.mass_2, mh = p_.handle_mass;
    const T third = T(1) / T(3);  // uniform rod about its end: m l^2 / 3
    const T outer = (third * m2 + mh) * l2 * l2;
    const T cross = outer_mass() * at.link_1.dot(at.link_2);
    const T M11 = (third * m1 + m2 + mh) * l1 * l1 + outer + T(2) * cross;
    return matrix<T, 2, 2>{{M11, outer + cross}, {outer + cross, outer}};
  }

 private:
  T outer_mass() const { return p_.mass_2 / T(2) + p_.handle_mass; }  // as if at the handle [kg]

  two_link_parameters<T> p_;
};

}  // namespace passive_haptics
