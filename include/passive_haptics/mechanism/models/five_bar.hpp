/// A five-bar (pantograph): two base joints and two legs that meet at the handle.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/models/five_bar_parameters.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>
#include <passive_haptics/mechanism/models/leg_chain.hpp>

#include <limits>

namespace passive_haptics {

/// Planar closed chain. The base joints at (-+b/2, 0) are measured and braked, q_i [rad] from the x axis. Leg
/// i has a proximal link l_i to the elbow P_i and a distal link r_i to the handle x:
///
///     P_i = (-+b/2, 0) + l_i (cos q_i, sin q_i),   |x - P_1| = r_1,   |x - P_2| = r_2.
///
/// If |P_2 - P_1| is above r_1 + r_2, below |r_1 - r_2| or 0 to rounding, all results are NaN, and a step
/// reports status::pose_undefined. Singular, see conditioning(): type 1, a leg is straight or folded; type 2,
/// the distal links are aligned, J is unbounded and the assemblies meet.
///
/// Brakes = 4: brakes on both base rates, their difference and their sum, as in Book's P-TER; T is a constant
/// 4 x 2. Cost: two sines, cosines and square roots; jacobian adds some products and a division.
template <class T, int Brakes = 2>
class five_bar : public leg_chain<five_bar<T, Brakes>, T, 2> {
  static_assert(Brakes == 2 || Brakes == 4, "passive_haptics: a five_bar has 2 or 4 brakes.");

 public:
  static constexpr int brake_count = Brakes;  ///< Brakes m.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit five_bar(const five_bar_parameters<T, Brakes>& p = {})
      : p_(require_valid(p)),
        rounding_square_(square_of_rounding(p)),
        side_(p.assembly == five_bar_assembly::left ? T(1) : T(-1)) {}

  const five_bar_parameters<T, Brakes>& parameters() const { return p_; }  ///< The parameters as given.

  using leg_chain<five_bar<T, Brakes>, T, 2>::position;

  /// Handle [m], base frame, for any scalar S that multiplies with T, without cancellation of squares.
  template <class S = T>
  vector<S, 2> position(const vector<S, 2>& q) const {
    const auto angle = sine_cosine(q);
    return handle(elbow_point(0, lever(0, angle[0])), elbow_point(1, lever(1, angle[1])));
  }

  /// T in w = T qd for four brakes: q1, q2, q1 - q2, q1 + q2.
  matrix<T, 4, 2> transmission() const
    requires(Brakes == 4)
  {
    return matrix<T, 4, 2>{{T(1), T(0)}, {T(0), T(1)}, {T(1), T(-1)}, {T(1), T(1)}};
  }

  /// Base angles in [-pi, pi] for the handle at x [m] with these elbows; out_of_reach if a leg is too short
  /// or too long (it then points at x), or if the handle is in the other assembly; position(q) is then not x.
  joint_solution<T, 2> inverse(const vector<T, 2>& x, elbow leg_1 = elbow::left,
                               elbow leg_2 = elbow::right) const {
    const vector<T, 2> to_base(p_.base_distance / T(2), T(0));
    const auto q1 = two_link_inverse<T>(p_.proximal_1, p_.distal_1, x + to_base, leg_1);
    const auto q2 = two_link_inverse<T>(p_.proximal_2, p_.distal_2, x - to_base, leg_2);
    const vector<T, 2> q(detail::principal_angle(q1.q[0]), detail::principal_angle(q2.q[0]));
    if (q1.outcome != status::ok) return {q, q1.outcome};
    if (q2.outcome != status::ok) return {q, q2.outcome};
    const T left_of = side_ * determinant(legs(q, &x).link);
    const bool other_side = left_of < -rounding_tolerance<T>(2) * p_.distal_1 * p_.distal_2;
    return {q, other_side ? status::out_of_reach : status::ok};
  }

  /// M [kg m^2], including rotors on the brake axes.
  matrix<T, 2, 2> mass_matrix(const distal_links<T, 2>& at) const {
    const matrix<T, 2, 2> J = at.jacobian();
    matrix<T, 2, 2> M = rotor_mass_matrix() + p_.handle_mass * J.transpose() * J;
    for (int i = 0; i < 2; ++i) {
      M(i, i) += third * p_.proximal_mass * at.lever.col(i).squaredNorm();
      // Uniform rod with end velocities a, b: (a.a + a.b + b.b) m / 6; E qd is that of the elbow
      const matrix<T, 2, 2> E = elbow_jacobian(at, i), EJ = E.transpose() * J;
      M += third * p_.distal_mass * (E.transpose() * E + (EJ + EJ.transpose()) / T(2) + J.transpose() * J);
    }
    M(1, 0) = M(0, 1);
    return M;
  }
  matrix<T, 2, 2> mass_matrix(const vector<T, 2>& q) const { return mass_matrix(legs(q)); }  ///< M(q)

  /// c [N m]: Coriolis, centrifugal and gravity torques.
  vector<T, 2> bias_torque(const distal_links<T, 2>& at, const vector<T, 2>& qd) const {
    const matrix<T, 2, 2> J = at.jacobian();
    const vector<T, 2> handle = at.bias_acceleration(J, qd) - p_.gravity;
    vector<T, 2> c = p_.handle_mass * J.transpose() * handle;
    for (int i = 0; i < 2; ++i) {
      c[i] -= p_.proximal_mass / T(2) * at.tangent.col(i).dot(p_.gravity);
      const vector<T, 2> elbow = -qd[i] * qd[i] * at.lever.col(i) - p_.gravity;
      c += third * p_.distal_mass *
           (elbow_jacobian(at, i).transpose() * (elbow + handle / T(2)) +
            J.transpose() * (handle + elbow / T(2)));
    }
    return c;
  }
  /// c(q, qd)
  vector<T, 2> bias_torque(const vector<T, 2>& q, const vector<T, 2>& qd) const {
    return bias_torque(legs(q), qd);
  }

 private:
  friend class leg_chain<five_bar<T, Brakes>, T, 2>;
  static constexpr T third = T(1) / T(3);  // uniform rod about its end: m l^2 / 3

  template <class S>
  vector<S, 2> lever(int i, const sine_cosine_pair<S>& angle) const {
    const T l = i == 0 ? p_.proximal_1 : p_.proximal_2;
    return {l * angle.cosine, l * angle.sine};
  }

  template <class S>
  vector<S, 2> elbow_point(int i, const vector<S, 2>& arm) const {
    const T half_base = p_.base_distance / T(2);
    return {arm[0] + (i == 0 ? -half_base : half_base), arm[1]};
  }

  template <class S>
  vector<S, 2> handle(const vector<S, 2>& P1, const vector<S, 2>& P2) const {
    using std::sqrt;
    const vector<S, 2> apart = P2 - P1;
    const S square = nan_if_degenerate(apart.squaredNorm()), distance = sqrt(square);
    const S sum = S(p_.distal_1) + S(p_.distal_2), difference = S(p_.distal_1) - S(p_.distal_2);
    const S along = difference * sum / (T(2) * square);
    const S stretched = (sum - distance) * (sum + distance);
    const S folded = (distance - difference) * (distance + difference);
    const S across = side_ * sqrt(S(stretched * folded)) / (T(2) * square);
    return {(P1[0] + P2[0]) * S(T(1) / T(2)) + along * apart[0] - across * apart[1],
            (P1[1] + P2[1]) * S(T(1) / T(2)) + along * apart[1] + across * apart[0]};
  }

  // With the handle at x, or at its pose for q
  PASSIVE_HAPTICS_PART distal_links<T, 2> legs(const vector<T, 2>& q, const vector<T, 2>* x = nullptr) const {
    distal_links<T, 2> at;
    const auto angle = sine_cosine(q);
    const vector<T, 2> a1 = lever(0, angle[0]), a2 = lever(1, angle[1]);
    const vector<T, 2> P1 = elbow_point(0, a1), P2 = elbow_point(1, a2);
    at.handle = x != nullptr ? *x : handle(P1, P2);
    at.lengths = p_.distal_1 * p_.distal_2;
    at.lever << a1, a2;
    at.tangent.row(0) = -at.lever.row(1);
    at.tangent.row(1) = at.lever.row(0);
    at.link.row(0) = at.handle - P1;
    at.link.row(1) = at.handle - P2;
    return at;
  }

  static matrix<T, 2, 2> elbow_jacobian(const distal_links<T, 2>& at, int i) {
    matrix<T, 2, 2> E = matrix<T, 2, 2>::Zero();
    E.col(i) = at.tangent.col(i);
    return E;
  }

  matrix<T, 2, 2> rotor_mass_matrix() const {
    if constexpr (Brakes == 2) return p_.rotor_inertia.asDiagonal();
    else return transmission().transpose() * p_.rotor_inertia.asDiagonal() * transmission();
  }

  template <class S>
  S nan_if_degenerate(const S& square) const {
    return square > S(rounding_square_) ? square : S(std::numeric_limits<T>::quiet_NaN());
  }

  // Square of the rounding error of an elbow position [m^2]; angles are rounded to eps, too.
  static T square_of_rounding(const five_bar_parameters<T, Brakes>& p) {
    const T rounding = rounding_tolerance<T>(1) * (p.base_distance + p.proximal_1 + p.proximal_2);
    return rounding * rounding;
  }

  five_bar_parameters<T, Brakes> p_;
  T rounding_square_;
  T side_;  // 1: the handle is left of the line from elbow 1 to elbow 2
};

}  // namespace passive_haptics
