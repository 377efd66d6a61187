// Closed chains by nothing but their constraint equations, in 50 digits, and the chains that are tested.
#pragma once

#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <limits>
#include <numbers>

#include "../high_precision.hpp"

namespace closed_chains {

namespace ph = passive_haptics;
using namespace high_precision;

// A thin rod between two moving points, by Simpson's rule along it (exact for a rigid rod).
template <int N>
real rod_energy(const real& mass, const vec<N>& v0, const vec<N>& v1) {
  const vec<N> middle = (v0 + v1) / real(2);
  return mass / 12 * (v0.squaredNorm() + 4 * middle.squaredNorm() + v1.squaredNorm());
}

// What both share: |x - P_i(q_i)| = length_i, and the side of the elbows on which the handle lies.
template <class Mechanism>
struct oracle;

template <int Brakes>
struct oracle<ph::five_bar<double, Brakes>> {
  static constexpr int N = 2;
  ph::five_bar_parameters<double, Brakes> p;

  vec<2> base(int i) const { return {(i == 0 ? -1 : 1) * real(p.base_distance) / 2, 0}; }
  vec<2> elbow(int i, const real& q) const {
    return base(i) + real(i == 0 ? p.proximal_1 : p.proximal_2) * vec<2>(cos(q), sin(q));
  }
  real distal(int i) const { return i == 0 ? p.distal_1 : p.distal_2; }
  real side() const { return p.assembly == ph::five_bar_assembly::left ? 1 : -1; }

  // > 0 where the loop can be closed, 0 at its edge
  real slack(const vec<2>& q) const {
    const real apart = (elbow(1, q[1]) - elbow(0, q[0])).norm();
    return std::min(real(distal(0) + distal(1) - apart), real(apart - abs(real(distal(0) - distal(1)))));
  }
  real side_of(const vec<2>& x, const vec<2>& q) const {
    const vec<2> a = elbow(1, q[1]) - elbow(0, q[0]), b = x - elbow(0, q[0]);
    return a[0] * b[1] - a[1] * b[0];
  }

  real kinetic_energy(const vec<2>& qd, const vec<2>& v, const mat<2, 2>& elbow_velocity) const {
    real energy = real(p.handle_mass) * v.squaredNorm() / 2;
    for (int i = 0; i < 2; ++i) {
      const vec<2> e = elbow_velocity.col(i);
      energy += rod_energy<2>(p.proximal_mass, vec<2>::Zero(), e) + rod_energy<2>(p.distal_mass, e, v);
    }
    const vec<2> rotors = exact(ph::vector<double, Brakes>(p.rotor_inertia)).template head<2>();
    energy += (rotors[0] * qd[0] * qd[0] + rotors[1] * qd[1] * qd[1]) / 2;
    if constexpr (Brakes == 4) {
      const real difference = qd[0] - qd[1], sum = qd[0] + qd[1];
      energy +=
          (real(p.rotor_inertia[2]) * difference * difference + real(p.rotor_inertia[3]) * sum * sum) / 2;
    }
    return energy;
  }
  real potential_energy(const vec<2>& x, const vec<2>& q) const {
    vec<2> moment = real(p.handle_mass) * x;
    for (int i = 0; i < 2; ++i) {
      moment += real(p.proximal_mass) / 2 * (base(i) + elbow(i, q[i]));
      moment += real(p.distal_mass) / 2 * (elbow(i, q[i]) + x);
    }
    return -exact(p.gravity).dot(moment);
  }
};

template <>
struct oracle<ph::delta<double>> {
  static constexpr int N = 3;
  ph::delta_parameters<double> p;

  // The arms' directions as the library has them, in double
  vec<3> radial(int i) const {
    const real height = std::sqrt(3.0) / 2, half = real(1) / 2;
    return i == 0 ? vec<3>(1, 0, 0) : vec<3>(-half, i == 1 ? height : -height, 0);
  }
  vec<3> real_elbow(int i, const real& q) const {
    return (real(p.base_radius) + real(p.upper_arm) * cos(q)) * radial(i) -
           real(p.upper_arm) * sin(q) * vec<3>::UnitZ();
  }
  // Moved inwards by the platform's radius
  vec<3> elbow(int i, const real& q) const { return real_elbow(i, q) - real(p.platform_radius) * radial(i); }
  real distal(int) const { return p.forearm; }
  real side() const { return p.assembly == ph::delta_assembly::upper ? 1 : -1; }

  vec<3> normal(const vec<3>& q) const {
    const vec<3> a = elbow(1, q[1]) - elbow(0, q[0]), b = elbow(2, q[2]) - elbow(0, q[0]);
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  real slack(const vec<3>& q) const {
    const vec<3> A = elbow(0, q[0]), B = elbow(1, q[1]), C = elbow(2, q[2]);
    const real product = (B - A).norm() * (C - A).norm() * (C - B).norm();
    return real(p.forearm) - product / (2 * normal(q).norm());
  }
  real side_of(const vec<3>& x, const vec<3>& q) const { return normal(q).dot(x - elbow(0, q[0])); }

  real kinetic_energy(const vec<3>& qd, const vec<3>& v, const mat<3, 3>& elbow_velocity) const {
    const real half_forearm = real(p.forearm_mass) / 2;
    real energy = (real(p.platform_mass) + 3 * half_forearm) * v.squaredNorm() / 2;
    for (int i = 0; i < 3; ++i) {
      const vec<3> e = elbow_velocity.col(i);
      energy += rod_energy<3>(p.upper_arm_mass, vec<3>::Zero(), e) + half_forearm * e.squaredNorm() / 2;
      energy += real(p.rotor_inertia[i]) * qd[i] * qd[i] / 2;
    }
    return energy;
  }
  real potential_energy(const vec<3>& x, const vec<3>& q) const {
    const real half_forearm = real(p.forearm_mass) / 2;
    vec<3> moment = (real(p.platform_mass) + 3 * half_forearm) * x;
    for (int i = 0; i < 3; ++i) {
      const vec<3> e = real_elbow(i, q[i]), base = real(p.base_radius) * radial(i);
      moment += real(p.upper_arm_mass) * (base + e) / 2 + half_forearm * e;
    }
    return -exact(p.gravity).dot(moment);
  }
};

// Both conditioning figures at x: of type 1 for each leg, and of type 2.
template <int N>
struct figures {
  vec<N> legs;
  real type_2;
};

template <class Oracle>
figures<Oracle::N> conditioning(const Oracle& truth, const vec<Oracle::N>& x, const vec<Oracle::N>& q) {
  constexpr int N = Oracle::N;
  figures<N> result;
  mat<N, N> unit;
  for (int i = 0; i < N; ++i) {
    const vec<N> r = x - truth.elbow(i, q[i]);
    const vec<N> tangent = derivative([&](const real& s) { return truth.elbow(i, q[i] + s); });
    result.legs[i] = abs(r.dot(tangent)) / (r.norm() * tangent.norm());
    unit.row(i) = r.transpose() / r.norm();
  }
  result.type_2 = abs(real(unit.determinant()));
  return result;
}

using ph::testing::random_source;

inline constexpr unsigned seed = 7;
inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double pi = std::numbers::pi;

using five_bar = ph::five_bar<double>;
using delta = ph::delta<double>;

struct lopsided_five_bar {
  using mechanism = ph::five_bar<double, 4>;
  static auto parameters() {
    ph::five_bar_parameters<double, 4> p;
    p.base_distance = 0.04, p.proximal_1 = 0.07, p.proximal_2 = 0.09, p.distal_1 = 0.12, p.distal_2 = 0.1;
    p.rotor_inertia = {1e-5, 2e-5, 3e-5, 4e-5}, p.gravity = {1, -9.81};
    return p;
  }
};
struct coaxial_five_bar {
  using mechanism = five_bar;
  static auto parameters() {
    ph::five_bar_parameters<double> p;
    p.base_distance = 0, p.distal_2 = 0.07, p.assembly = ph::five_bar_assembly::right;
    return p;
  }
};
// Arms so long that the forearms can come to lie in one plane.
struct long_armed_delta {
  using mechanism = delta;
  static auto parameters() {
    ph::delta_parameters<double> p;
    p.upper_arm = 0.12, p.forearm = 0.1, p.assembly = ph::delta_assembly::upper;
    p.rotor_inertia = {1e-5, 2e-5, 3e-5}, p.gravity = {1, 2, -9.81};
    return p;
  }
};

template <class Case>
class closed_chain : public ::testing::Test {
 protected:
  using mechanism = typename Case::mechanism;
  static constexpr int dof = mechanism::dof;
  using joints = ph::vector<double, dof>;
  const oracle<mechanism> truth{Case::parameters()};
  const mechanism chain{Case::parameters()};
  random_source random{seed};

  joints any_pose() { return random.between<double, dof>(joints::Constant(-pi), joints::Constant(pi)); }

  // A pose where the loop closes and both figures are at least `least`
  joints closed_pose(double least = 0.05) {
    for (;;) {
      const joints q = any_pose();
      const auto c = chain.conditioning(q);
      if (c.type_1 >= least && c.type_2 >= least) return q;
    }
  }

  // Handle of the chain's own assembly in 50 digits: the library's formula, which the constraints below
  // confirm
  vec<dof> handle(const vec<dof>& q) const { return chain.position(q); }

  double length() const { return double(truth.distal(0)); }
};

// Both mechanisms, either assembly, two brakes and four
using cases = ::testing::Types<lopsided_five_bar, coaxial_five_bar, long_armed_delta>;

}  // namespace closed_chains
