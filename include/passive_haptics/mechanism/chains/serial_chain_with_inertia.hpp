/// A serial chain that models Dynamics.
#pragma once

#include <passive_haptics/mechanism/chains/link_inertia.hpp>
#include <passive_haptics/mechanism/chains/serial_chain.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

namespace passive_haptics {

/// Serial chain with inertia: M by composite rigid bodies, c by recursive Newton-Euler. Rotors add inertia
/// only about the joint axis. M is positive definite if each joint moves a rotor or link inertia; a rotor
/// inertia > 0 on every joint suffices. Cost: jacobian plus about N^2 (M) or N (c, Jd qd) cross products.
template <class T, int N, int D>
class serial_chain_with_inertia : public serial_chain<T, N, D> {
 public:
  /// Throws std::invalid_argument if validate(geometry) or validate(inertia) returns an error.
  serial_chain_with_inertia(const serial_chain_parameters<T, N, D>& geometry,
                            const serial_chain_inertia<T, N, D>& inertia)
      : serial_chain<T, N, D>(geometry), inertia_(require_valid(inertia)), links_(inertia_.links) {
    const inertia_matrix<T, D> no_inertia = inertia_matrix<T, D>::Zero();
    links_[last] = joined<T, D>(links_[last], {inertia_.handle_mass, geometry.handle, no_inertia});
    for (std::size_t i = 0; i < size; ++i) {
      const matrix<T, D, D> back = transposed(this->zero_turn(i));
      links_[i].centre = back * (links_[i].centre - this->zero_point(i));
      links_[i].about_centre = algebra::inertia(back, links_[i].about_centre);
    }
  }

  const serial_chain_inertia<T, N, D>& inertia() const { return inertia_; }  ///< The inertia as given.

  /// Joints, handle and bodies.
  chain_bodies<T, N, D> pose(const vector<T, N>& q) const { return this->bodies(q); }

  /// M [kg m^2, kg m or kg], including rotors.
  matrix<T, N, N> mass_matrix(const chain_bodies<T, N, D>& at) const {
    matrix<T, N, N> M;
    link_inertia<T, D> outer;  // all bodies from j outwards
    for (std::size_t j = size; j-- > 0;) {
      outer = j == last ? placed(at, j) : joined<T, D>(placed(at, j), outer);
      // Momentum of these bodies for a unit rate of joint j
      const vector<T, D> v = at.sliding[j] + algebra::velocity(at.rotation[j], outer.centre - at.point[j]);
      const vector<T, D> linear = outer.mass * v;
      const angular angular_about_centre = outer.about_centre * at.rotation[j];
      for (std::size_t i = 0; i <= j; ++i) {
        const angular moment = angular_about_centre + algebra::moment(outer.centre - at.point[i], linear);
        M(int(i), int(j)) = M(int(j), int(i)) = at.sliding[i].dot(linear) + at.rotation[i].dot(moment);
      }
      M(int(j), int(j)) += inertia_.rotor_inertia[int(j)];
    }
    return M;
  }

  matrix<T, N, N> mass_matrix(const vector<T, N>& q) const { return mass_matrix(pose(q)); }  ///< M(q)

  /// c [N m or N]: Coriolis, centrifugal and gravity torques.
  vector<T, N> bias_torque(const chain_bodies<T, N, D>& at, const vector<T, N>& qd) const {
    const motion moves(at, qd);
    vector<T, N> c;
    vector<T, D> force = vector<T, D>::Zero();  // on the bodies from i outwards [N]
    angular moment = angular::Zero();           // about the point of joint i [N m]
    for (std::size_t i = size; i-- > 0;) {
      if (i < last) moment += algebra::moment(at.point[i + 1] - at.point[i], force);
      const link_inertia<T, D> link = placed(at, i);
      const vector<T, D> r = link.centre - at.point[i];
      const vector<T, D> own = link.mass * (moves.acceleration_at(i, r) - inertia_.gravity);
      const angular spin = link.about_centre * moves.w[i];
      force += own;
      moment +=
          link.about_centre * moves.wd[i] + algebra::gyroscopic(moves.w[i], spin) + algebra::moment(r, own);
      c[int(i)] = at.sliding[i].dot(force) + at.rotation[i].dot(moment);
    }
    return c;
  }

  /// c(q, qd)
  vector<T, N> bias_torque(const vector<T, N>& q, const vector<T, N>& qd) const {
    return bias_torque(pose(q), qd);
  }

  /// Jd qd [m/s^2], the handle acceleration at constant joint rates.
  vector<T, D> bias_acceleration(const chain_bodies<T, N, D>& at, const vector<T, N>& qd) const {
    return motion(at, qd).acceleration_at(last, at.handle - at.point[last]);
  }
  /// Jd qd in pose q.
  vector<T, D> bias_acceleration(const vector<T, N>& q, const vector<T, N>& qd) const {
    return bias_acceleration(pose(q), qd);
  }

 private:
  using algebra = detail::rigid_body_algebra<T, D>;
  using angular = angular_vector<T, D>;
  static constexpr std::size_t size = std::size_t(N), last = size - 1;

  // Angular velocities of all bodies, and accelerations at constant joint rates
  struct motion {
    std::array<angular, size> w, wd;
    std::array<vector<T, D>, size> a;  // of the bodies' points

    motion(const chain_bodies<T, N, D>& at, const vector<T, N>& qd) {
      angular w0 = angular::Zero(), wd0 = angular::Zero();
      vector<T, D> a0 = vector<T, D>::Zero(), p0 = vector<T, D>::Zero();
      for (std::size_t i = 0; i < size; ++i) {
        const vector<T, D> r = at.point[i] - p0;
        const vector<T, D> slip = qd[int(i)] * at.sliding[i];
        const angular turn = qd[int(i)] * at.rotation[i];
        // The last term is the Coriolis acceleration in a prismatic joint
        a0 += algebra::velocity(wd0, r) + algebra::velocity(w0, algebra::velocity(w0, r)) +
              T(2) * algebra::velocity(w0, slip);
        wd0 += algebra::gyroscopic(w0, turn);
        w0 += turn;
        p0 = at.point[i];
        w[i] = w0, wd[i] = wd0, a[i] = a0;
      }
    }

    // Acceleration of the point at r [m] from the point of body i
    vector<T, D> acceleration_at(std::size_t i, const vector<T, D>& r) const {
      return a[i] + algebra::velocity(wd[i], r) + algebra::velocity(w[i], algebra::velocity(w[i], r));
    }
  };

  link_inertia<T, D> placed(const chain_bodies<T, N, D>& at, std::size_t i) const {
    const link_inertia<T, D>& link = links_[i];
    return {link.mass, at.point[i] + at.turn[i] * link.centre,
            algebra::inertia(at.turn[i], link.about_centre)};
  }

  serial_chain_inertia<T, N, D> inertia_;
  // Relative to the body's point and frame; the last one includes the handle
  std::array<link_inertia<T, D>, size> links_;
};

}  // namespace passive_haptics
