/// A delta: three arms that translate a platform in space.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/models/delta_parameters.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>
#include <passive_haptics/mechanism/models/leg_chain.hpp>

#include <array>
#include <limits>

namespace passive_haptics {

/// Branch of one arm of a delta.
enum class delta_elbow {
  outward,  ///< The elbow is on the outer side of the line from the base joint to the platform: usual.
  inward,   ///< The elbow is on the inner side.
};

/// Three arms at 0, 120 and 240 deg about z with radial directions e_i. The base joints in the plane z = 0
/// are measured and braked, q_i [rad] downwards from the horizontal. The forearms are parallelograms, so the
/// platform only translates. With R = base_radius - platform_radius, the middle x of the platform is on three
/// spheres of radius l about the elbows:
///
///     P_i = (R + L cos q_i) e_i - L sin q_i e_z,   |x - P_i| = l.
///
/// If the spheres do not meet or two elbows coincide to rounding, all results are NaN, and a step reports
/// status::pose_undefined. Singular, see conditioning(): type 1, a forearm in the plane of upper arm and
/// joint axis; type 2, forearms coplanar or two parallel, with unbounded J.
///
/// Dynamics with lumped forearms: half of each mass at its elbow, half at the platform. Cost: three sines and
/// cosines and some square roots; jacobian adds some products and a division.
template <class T>
class delta : public leg_chain<delta<T>, T, 3> {
 public:
  static constexpr int brake_count = 3;          ///< Brakes m.
  static constexpr bool handle_rotates = false;  ///< The platform only translates.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit delta(const delta_parameters<T>& p = {})
      : p_(require_valid(p)),
        rounding_square_(square_of_rounding(p)),
        side_(p.assembly == delta_assembly::upper ? T(1) : T(-1)) {}

  const delta_parameters<T>& parameters() const { return p_; }  ///< The parameters as given.

  using leg_chain<delta<T>, T, 3>::position;

  /// Middle of the platform [m], base frame, for any scalar S that multiplies with T. From the circumcentre
  /// of the elbows.
  template <class S = T>
  vector<S, 3> position(const vector<S, 3>& q) const {
    const auto angle = sine_cosine(q);
    return handle(elbow_point(0, lever(0, angle[0])), elbow_point(1, lever(1, angle[1])),
                  elbow_point(2, lever(2, angle[2])));
  }

  /// Base angles in [-pi, pi] for the platform at x [m] with these elbows; out_of_reach if an arm is too
  /// short or too long (it then points at x), or if the platform is in the other assembly; position(q) is
  /// then not x.
  joint_solution<T, 3> inverse(const vector<T, 3>& x, const std::array<delta_elbow, 3>& elbows = {}) const {
    joint_solution<T, 3> solution;
    for (int i = 0; i < 3; ++i) {
      // In the plane of the arm: outwards and down; the forearm leaves it by `aside`
      const vector<T, 3> e = radial(i);
      const T outwards = x[0] * e[0] + x[1] * e[1] - (p_.base_radius - p_.platform_radius);
      const T aside = x[1] * e[0] - x[0] * e[1];
      const T square = (p_.forearm - aside) * (p_.forearm + aside);
      const elbow branch = nth(elbows, i) == delta_elbow::outward ? elbow::right : elbow::left;
      const auto arm = two_link_inverse<T>(p_.upper_arm, std::sqrt(std::max(square, T(0))),
                                           vector<T, 2>(outwards, -x[2]), branch);
      solution.q[i] = detail::principal_angle(arm.q[0]);
      if (solution.outcome == status::ok) solution.outcome = arm.outcome;
      if (solution.outcome == status::ok && square < T(0)) solution.outcome = status::out_of_reach;
    }
    if (solution.outcome != status::ok) return solution;
    const T above = side_ * determinant(legs(solution.q, &x).link);
    if (above < -rounding_tolerance<T>(3) * p_.forearm * p_.forearm * p_.forearm)
      solution.outcome = status::out_of_reach;
    return solution;
  }

  /// M [kg m^2], including rotors.
  matrix<T, 3, 3> mass_matrix(const distal_links<T, 3>& at) const {
    const matrix<T, 3, 3> J = at.jacobian();
    const T arm = (p_.upper_arm_mass / T(3) + p_.forearm_mass / T(2)) * p_.upper_arm * p_.upper_arm;
    matrix<T, 3, 3> M = moved_mass() * J.transpose() * J;
    M.diagonal() += p_.rotor_inertia + vector<T, 3>::Constant(arm);
    return M.template selfadjointView<Eigen::Lower>();
  }
  matrix<T, 3, 3> mass_matrix(const vector<T, 3>& q) const { return mass_matrix(legs(q)); }  ///< M(q)

  /// c [N m]: Coriolis, centrifugal and gravity torques.
  vector<T, 3> bias_torque(const distal_links<T, 3>& at, const vector<T, 3>& qd) const {
    const matrix<T, 3, 3> J = at.jacobian();
    const T arm = (p_.upper_arm_mass + p_.forearm_mass) / T(2);  // as if at the elbow
    return moved_mass() * J.transpose() * (at.bias_acceleration(J, qd) - p_.gravity) -
           arm * at.tangent.transpose() * p_.gravity;
  }
  /// c(q, qd)
  vector<T, 3> bias_torque(const vector<T, 3>& q, const vector<T, 3>& qd) const {
    return bias_torque(legs(q), qd);
  }

 private:
  friend class leg_chain<delta<T>, T, 3>;
  // Mass that moves with the platform [kg]
  T moved_mass() const { return p_.platform_mass + T(3) / T(2) * p_.forearm_mass; }

  static vector<T, 3> radial(int i) {
    constexpr T half = T(1) / T(2), height = std::numbers::sqrt3_v<T> / T(2);
    if (i == 0) return {T(1), T(0), T(0)};
    return {-half, i == 1 ? height : -height, T(0)};
  }

  template <class S>
  vector<S, 3> lever(int i, const sine_cosine_pair<S>& angle) const {
    const vector<T, 3> e = radial(i);
    const S out = p_.upper_arm * angle.cosine;
    return {e[0] * out, e[1] * out, -p_.upper_arm * angle.sine};
  }

  // Moved inwards by the platform radius
  template <class S>
  vector<S, 3> elbow_point(int i, const vector<S, 3>& arm) const {
    const vector<T, 3> e = radial(i);
    const S radius = S(p_.base_radius) - S(p_.platform_radius);
    return {arm[0] + e[0] * radius, arm[1] + e[1] * radius, arm[2]};
  }

  template <class S>
  vector<S, 3> handle(const vector<S, 3>& P1, const vector<S, 3>& P2, const vector<S, 3>& P3) const {
    using std::sqrt;
    const vector<S, 3> a = P2 - P1, b = P3 - P1, c = P3 - P2;
    const vector<S, 3> n = cross(a, b);
    const S aa = a.squaredNorm(), bb = b.squaredNorm(), nn = nan_if_degenerate(n.squaredNorm());
    const vector<S, 3> bn = cross(b, n), na = cross(n, a);
    const S circumradius = sqrt(S(aa * bb * c.squaredNorm() / nn)) / T(2);
    const S height = side_ * sqrt(S((p_.forearm - circumradius) * (p_.forearm + circumradius) / nn));
    const S to_centre = T(1) / (T(2) * nn);
    return P1.array() + (aa * bn.array() + bb * na.array()) * to_centre + height * n.array();
  }

  // With the platform at x, or at its pose for q
  distal_links<T, 3> legs(const vector<T, 3>& q, const vector<T, 3>* x = nullptr) const {
    distal_links<T, 3> at;
    std::array<vector<T, 3>, 3> P;
    const auto angle = sine_cosine(q);
    for (int i = 0; i < 3; ++i) {
      const vector<T, 3> a = lever(i, nth(angle, i)), e = radial(i);
      nth(P, i) = elbow_point(i, a);
      at.lever.col(i) = a;
      at.tangent.col(i) = vector<T, 3>(a[2] * e[0], a[2] * e[1], -a.dot(e));
    }
    at.handle = x != nullptr ? *x : handle(P[0], P[1], P[2]);
    at.lengths = p_.forearm * p_.forearm * p_.forearm;
    for (int i = 0; i < 3; ++i) at.link.row(i) = at.handle.transpose() - nth(P, i).transpose();
    return at;
  }

  template <class S>
  S nan_if_degenerate(const S& square) const {
    return square > S(rounding_square_) ? square : S(std::numeric_limits<T>::quiet_NaN());
  }

  // Square of the rounding error of the area of the elbows [m^4]; angles are rounded to eps, too.
  static T square_of_rounding(const delta_parameters<T>& p) {
    const T size = p.base_radius + p.platform_radius + p.upper_arm;
    const T rounding = rounding_tolerance<T>(1) * size * size;
    return rounding * rounding;
  }

  delta_parameters<T> p_;
  T rounding_square_;
  T side_;  // 1: the platform is above the plane of the elbows
};

}  // namespace passive_haptics
