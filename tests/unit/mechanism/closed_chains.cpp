// slow, optimised, no sanitizers
#include "closed_chain_oracles.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/step.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace closed_chains;
using ph::testing::random_source;

constexpr unsigned seed = 7;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double pi = std::numbers::pi;

using five_bar = ph::five_bar<double>;
using delta = ph::delta<double>;

struct pantograph {
  using mechanism = five_bar;
  static ph::five_bar_parameters<double> parameters() { return {}; }
};
struct pantograph_behind {
  using mechanism = five_bar;
  static auto parameters() {
    ph::five_bar_parameters<double> p;
    p.assembly = ph::five_bar_assembly::right;
    return p;
  }
};
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
struct desktop_delta {
  using mechanism = delta;
  static ph::delta_parameters<double> parameters() { return {}; }
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

using chains = ::testing::Types<pantograph, pantograph_behind, lopsided_five_bar, coaxial_five_bar,
                                desktop_delta, long_armed_delta>;
TYPED_TEST_SUITE(closed_chain, chains);

TYPED_TEST(closed_chain, position_fulfils_the_constraints_on_its_own_side_or_is_not_a_number) {
  constexpr int N = TestFixture::dof;
  int closed = 0, open = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto q = this->any_pose();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const real slack = this->truth.slack(exact(q));
    if (abs(slack) < real(64 * eps)) continue;  // either answer
    const ph::vector<double, N> x = this->chain.position(q);
    if (slack < 0) {
      ++open;
      for (int i = 0; i < N; ++i) ASSERT_TRUE(std::isnan(x[i]));
      ASSERT_FALSE(ph::all_finite(this->chain.jacobian(q)));
      ASSERT_TRUE(std::isnan(this->chain.conditioning(q).type_1));
      ASSERT_TRUE(std::isnan(this->chain.conditioning(q).type_2));
      continue;
    }
    ++closed;
    const vec<N> exact_x = this->handle(exact(q));
    for (int i = 0; i < N; ++i) {
      const real residual = (exact_x - this->truth.elbow(i, exact(q)[i])).norm() - this->truth.distal(i);
      ASSERT_LE(abs(residual), real(1e-40)) << "leg " << i;
    }
    ASSERT_GT(this->truth.side() * this->truth.side_of(exact_x, exact(q)), 0);
    const real type_2 = conditioning(this->truth, exact_x, exact(q)).type_2;
    ASSERT_LE((exact(x) - exact_x).norm(), real(16 * eps) * this->length() / type_2);
  }
  EXPECT_GE(closed, 100);
  std::cout << closed << " poses closed, " << open << " open, seed " << seed << "\n";
}

TYPED_TEST(closed_chain, jacobian_and_its_inverse_are_the_derivatives) {
  constexpr int N = TestFixture::dof;
  for (int k = 0; k < 60; ++k) {
    const auto q = this->closed_pose(1e-3);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const mat<N, N> expected = gradient<N, N>([&](const vec<N>& at) { return this->handle(at); }, exact(q));
    const mat<N, N> inverse = expected.inverse();
    const auto c = this->chain.conditioning(q);
    // The error of x is eps / type_2, and A is made of x
    const double error = 16 * eps / (c.type_2 * c.type_2);
    ASSERT_LE((exact(this->chain.jacobian(q)) - expected).norm(), real(error) * expected.norm());
    const double inverse_error = 16 * eps / (c.type_1 * c.type_2);
    ASSERT_LE((exact(this->chain.inverse_jacobian(q)) - inverse).norm(),
              real(inverse_error) * inverse.norm());
  }
}

TYPED_TEST(closed_chain, conditioning_is_the_angle_between_links_and_the_volume_of_distal_links) {
  constexpr int N = TestFixture::dof;
  for (int k = 0; k < 100; ++k) {
    const auto q = this->closed_pose(1e-3);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const vec<N> x = this->handle(exact(q));
    const figures<N> expected = conditioning(this->truth, x, exact(q));
    const auto c = this->chain.conditioning(q);
    ASSERT_LE(abs(real(c.type_1) - expected.legs.minCoeff()), real(16 * eps / c.type_2));
    ASSERT_LE(abs(real(c.type_2) - expected.type_2), real(16 * eps / c.type_2));
    ASSERT_TRUE(c.type_1 <= 1 && c.type_2 <= 1);
  }
}

TYPED_TEST(closed_chain, mass_matrix_gives_the_kinetic_energy_of_the_links) {
  constexpr int N = TestFixture::dof;
  for (int k = 0; k < 60; ++k) {
    const auto q = this->closed_pose();
    const ph::vector<double, N> qd = this->random.template normal_vector<double, N>();
    SCOPED_TRACE(::testing::Message()
                 << "seed " << seed << ", q = " << q.transpose() << ", qd = " << qd.transpose());
    const vec<N> v = derivative([&](const real& s) { return this->handle(exact(q) + s * exact(qd)); });
    mat<N, N> elbows;
    for (int i = 0; i < N; ++i)
      elbows.col(i) =
          derivative([&](const real& s) { return this->truth.elbow(i, real(q[i]) + s * real(qd[i])); });
    const double expected = double(this->truth.kinetic_energy(exact(qd), v, elbows));
    const double type_2 = this->chain.conditioning(q).type_2;
    ASSERT_NEAR(qd.dot(this->chain.mass_matrix(q) * qd) / 2, expected,
                64 * eps * expected / (type_2 * type_2));
  }
}

TYPED_TEST(closed_chain, bias_torque_at_rest_is_the_gradient_of_the_potential_energy) {
  constexpr int N = TestFixture::dof;
  const bool weighs = !TypeParam::parameters().gravity.isZero(0);
  for (int k = 0; k < 60; ++k) {
    const auto q = this->closed_pose();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const auto energy = [&](const vec<N>& at) {
      return vec<1>(this->truth.potential_energy(this->handle(at), at));
    };
    const mat<1, N> expected = gradient<1, N>(energy, exact(q));
    const ph::vector<double, N> c = this->chain.bias_torque(q, ph::vector<double, N>::Zero());
    const double type_2 = this->chain.conditioning(q).type_2;
    ASSERT_LE((exact(c).transpose() - expected).norm(), real(32 * eps / (type_2 * type_2)) * expected.norm());
    ASSERT_EQ(c.isZero(0), !weighs);
  }
}

// The solution of the inverse kinematics with elbows that the bits of `choice` name.
ph::joint_solution<double, 2> solution(const auto& chain, const ph::vector<double, 2>& x, unsigned choice) {
  const auto side = [&](unsigned bit) { return (choice & bit) != 0 ? ph::elbow::left : ph::elbow::right; };
  return chain.inverse(x, side(1), side(2));
}
ph::joint_solution<double, 3> solution(const auto& chain, const ph::vector<double, 3>& x, unsigned choice) {
  const auto side = [&](unsigned bit) {
    return (choice & bit) != 0 ? ph::delta_elbow::outward : ph::delta_elbow::inward;
  };
  return chain.inverse(x, {side(1), side(2), side(4)});
}

auto other_assembly(ph::five_bar_assembly a) {
  return a == ph::five_bar_assembly::left ? ph::five_bar_assembly::right : ph::five_bar_assembly::left;
}
auto other_assembly(ph::delta_assembly a) {
  return a == ph::delta_assembly::lower ? ph::delta_assembly::upper : ph::delta_assembly::lower;
}

TYPED_TEST(closed_chain, forward_undoes_inverse_with_every_choice_of_elbows) {
  constexpr int N = TestFixture::dof;
  auto mirrored = TypeParam::parameters();
  mirrored.assembly = other_assembly(mirrored.assembly);
  const typename TypeParam::mechanism mirror(mirrored);
  int other_sides = 0;
  for (int k = 0; k < 300; ++k) {
    const auto q = this->closed_pose();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const ph::vector<double, N> x = this->chain.position(q);
    int found = 0;
    for (unsigned choice = 0; choice < (1u << N); ++choice) {
      const auto s = solution(this->chain, x, choice);
      ASSERT_LE(s.q.cwiseAbs().maxCoeff(), pi);
      const bool mine = s.outcome == ph::status::ok;
      // Whichever side it is, exactly one assembly owns up to it
      ASSERT_NE(mine, solution(mirror, x, choice).outcome == ph::status::ok) << "choice " << choice;
      const auto& owner = mine ? this->chain : mirror;
      const auto c = owner.conditioning(s.q);
      ASSERT_LE((owner.position(s.q) - x).norm(), 32 * eps * this->length() / c.type_2)
          << "choice " << choice;
      const double error =
          64 * eps / (this->chain.conditioning(q).type_1 * this->chain.conditioning(q).type_2);
      found += mine && (s.q - q).norm() <= error;
      other_sides += !mine;
    }
    ASSERT_EQ(found, 1) << "the pose itself is one of the solutions";
  }
  EXPECT_GT(other_sides, 0);
}

TYPED_TEST(closed_chain, inverse_says_what_is_out_of_reach_or_not_finite) {
  constexpr int N = TestFixture::dof;
  using point = ph::vector<double, N>;
  for (int k = 0; k < 100; ++k) {
    const point far = this->random.template direction<double, N>();
    const auto s = this->chain.inverse(far);
    EXPECT_EQ(s.outcome, ph::status::out_of_reach);
    EXPECT_TRUE(ph::all_finite(s.q));
  }
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int i = 0; i < N; ++i) {
      point x = point::Constant(0.01);
      x[i] = bad;
      EXPECT_EQ(this->chain.inverse(x).outcome, ph::status::state_not_finite);
    }
}

// The root of f between a (f > 0) and b (f < 0), to 45 digits.
template <class F>
real root(F&& f, real a, real b) {
  for (int k = 0; k < 160; ++k) {
    const real middle = (a + b) / 2;
    (f(middle) > 0 ? a : b) = middle;
  }
  return (a + b) / 2;
}

TYPED_TEST(closed_chain, near_type_1_conditioning_falls_linearly_and_only_the_inverse_is_unbounded) {
  constexpr int N = TestFixture::dof;
  int found = 0;
  for (int k = 0; k < 20000 && found < 5; ++k) {
    // Two poses between which leg 1 passes the singularity, all else well away from one
    ph::vector<double, N> q = this->closed_pose(0.2), end = q;
    const auto drive = [&](const real& q0) {
      vec<N> at = exact(q);
      at[0] = q0;
      const vec<N> tangent = derivative([&](const real& s) { return this->truth.elbow(0, q0 + s); });
      return real((this->handle(at) - this->truth.elbow(0, q0)).dot(tangent));
    };
    end[0] += this->random.coin() ? 1.0 : -1.0;
    if (!(this->chain.conditioning(end).type_2 > 0.2)) continue;
    const real from = drive(q[0]), to = drive(end[0]);
    if (!(from * to < 0)) continue;
    const real singular =
        root([&](const real& s) { return real(drive(s) * (from > 0 ? 1 : -1)); }, q[0], end[0]);
    vec<N> at = exact(q);
    at[0] = singular;
    const figures<N> there = conditioning(this->truth, this->handle(at), at);
    if (!(there.type_2 > 0.2) || !(there.legs.template tail<N - 1>().minCoeff() > 0.1)) continue;
    ++found;
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", singular at q = " << at.transpose());

    at[0] = singular + real(1e-20);
    const double slope = double(conditioning(this->truth, this->handle(at), at).legs[0] / real(1e-20));
    for (const double side : {-1.0, 1.0}) {
      for (double away = 1e-3; away > 0.5e-12; away /= 10) {
        q[0] = double(singular + real(side * away));
        const double really = double(abs(real(q[0]) - singular));
        const auto c = this->chain.conditioning(q);
        ASSERT_NEAR(c.type_1, slope * really, 100 * really * really + 64 * eps) << "away " << side * away;
        ASSERT_GT(c.type_2, 0.15);
        // J loses column 1; row 1 of its inverse has length 1 / (type_1 lever)
        const double lever = double((this->truth.elbow(0, 0) - this->truth.elbow(0, real(pi))).norm()) / 2;
        const auto J = this->chain.jacobian(q);
        ASSERT_LE(J.col(0).norm(), 10 * lever * c.type_1);
        ASSERT_LE(J.norm(), 20 * lever);
        ASSERT_NEAR(this->chain.inverse_jacobian(q).row(0).norm() * c.type_1 * lever, 1, 1e-12);
      }
    }
  }
  EXPECT_EQ(found, 5);
}

TYPED_TEST(closed_chain, near_type_2_the_inverse_jacobian_stays_finite_and_beyond_it_there_is_no_pose) {
  constexpr int N = TestFixture::dof;
  int found = 0;
  for (int k = 0; k < 20000 && found < 5; ++k) {
    ph::vector<double, N> q = this->closed_pose(0.1), end = q;
    const auto slack = [&](const real& q0) {
      vec<N> at = exact(q);
      at[0] = q0;
      return this->truth.slack(at);
    };
    end[0] += this->random.coin() ? 0.5 : -0.5;
    if (!(slack(end[0]) < 0)) continue;
    const real edge = root(slack, q[0], end[0]);
    const double inside = end[0] > q[0] ? -1 : 1;
    vec<N> at = exact(q);
    at[0] = edge + real(inside) * real(1e-24);
    const figures<N> there = conditioning(this->truth, this->handle(at), at);
    if (!(there.legs.minCoeff() > 0.05)) continue;
    ++found;
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", edge at q = " << at.transpose());

    // The figure is |sin| of an angle that grows as the root of the way: its square is linear in q
    const double slope = double(there.type_2 * there.type_2 / real(1e-24));
    for (double away = 1e-4; away > 0.5e-12; away /= 10) {
      q[0] = double(edge + real(inside * away));
      const double really = double(abs(real(q[0]) - edge));
      const auto c = this->chain.conditioning(q);
      ASSERT_NEAR(c.type_2 * c.type_2, slope * really, slope * (50 * really * std::sqrt(really) + 64 * eps))
          << "away " << away;
      const auto inverse = this->chain.inverse_jacobian(q);
      ASSERT_TRUE(ph::all_finite(inverse));
      ASSERT_LE(inverse.norm(), 16 / (this->length() * c.type_1));
      // J grows as 1 / type_2
      const double growth = this->chain.jacobian(q).norm() * c.type_2;
      ASSERT_TRUE(growth > 1e-4 && growth < 1) << growth;

      q[0] = double(edge - real(inside * away));
      ASSERT_TRUE(std::isnan(this->chain.position(q)[0]));
      ASSERT_FALSE(ph::all_finite(this->chain.jacobian(q)));
      ASSERT_TRUE(std::isnan(this->chain.conditioning(q).type_2));
    }
  }
  EXPECT_EQ(found, 5);
}

TEST(five_bar, near_coinciding_elbows_type_2_falls_linearly_from_both_sides) {
  const ph::five_bar_parameters<double> p;
  const five_bar chain(p);
  const oracle<five_bar> truth{p};
  const real meet = acos(real(p.base_distance) / 2 / real(p.proximal_1));
  // The elbows part along x, by 2 l sin(q) a radian
  const double slope = double(2 * real(p.proximal_1) * sin(meet) / real(p.distal_1));
  for (const double side : {-1.0, 1.0}) {
    for (double away = 1e-3; away > 0.5e-12; away /= 10) {
      const ph::vector<double, 2> q(double(meet + real(side * away)), pi - double(meet + real(side * away)));
      const double really =
          double((truth.elbow(1, q[1]) - truth.elbow(0, q[0])).norm() / (2 * real(p.proximal_1) * sin(meet)));
      const auto c = chain.conditioning(q);
      SCOPED_TRACE(::testing::Message() << "away " << side * away);
      ASSERT_NEAR(c.type_2, slope * really, 10 * really * really + 8 * eps);
      ASSERT_TRUE(ph::all_finite(chain.inverse_jacobian(q)));
      ASSERT_LE(chain.inverse_jacobian(q).norm(), 100 / p.proximal_1);
      // The side stays, so the handle has jumped over the elbows; along one direction J is unbounded
      ASSERT_GT(chain.jacobian(q).norm() * c.type_2, 1e-3);
    }
  }
  const ph::vector<double, 2> same = ph::vector<double, 2>::Constant(1.2);
  ph::five_bar_parameters<double> coaxial;
  coaxial.base_distance = 0;
  EXPECT_EQ(
      five_bar(coaxial).inverse(ph::vector<double, 2>(0.05, 0.05), ph::elbow::left, ph::elbow::left).q[0],
      five_bar(coaxial).inverse(ph::vector<double, 2>(0.05, 0.05), ph::elbow::left, ph::elbow::left).q[1]);
  EXPECT_TRUE(std::isnan(five_bar(coaxial).position(same)[0])) << "any direction would do";
}

// Elbows at one place: the handle may be anywhere about it, and what rounding makes of it is no pose.
template <class M>
void expect_no_pose(const M& chain, const ph::joint_vector<M>& q) {
  SCOPED_TRACE(::testing::Message() << "q = " << q.transpose());
  EXPECT_FALSE(ph::all_finite(chain.position(q)));
  EXPECT_FALSE(ph::all_finite(chain.jacobian(q)));
  ph::device_state<M> state;
  state.time = 0;
  state.q = q;
  state.qd = ph::joint_vector<M>::Constant(typename M::scalar(0.1));
  ph::contacts<M::task_dimension, 1> touched;
  touched.push_back({.normal = ph::point<M::task_dimension>::UnitX(), .depth = 1e-3, .stiffness = 1e3});
  ph::step_memory<ph::direct_control> memory;
  const auto result = ph::step(chain, ph::brakes_of<M>(), touched, ph::direct_control(), state, memory);
  EXPECT_EQ(result.outcome, ph::status::pose_undefined);
  EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
}

template <class T>
struct coinciding_elbows : ::testing::Test {};
using scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(coinciding_elbows, scalars);

TYPED_TEST(coinciding_elbows, of_a_five_bar_leave_no_pose) {
  using T = TypeParam;
  const ph::five_bar<T> chain({.base_distance = T(0.2),
                               .proximal_1 = T(0.1),
                               .proximal_2 = T(0.1),
                               .distal_1 = T(0.1),
                               .distal_2 = T(0.1)});
  expect_no_pose(chain, {T(0), std::numbers::pi_v<T>});
  const ph::five_bar<T> usual;
  const T meet = std::acos(usual.parameters().base_distance / 2 / usual.parameters().proximal_1);
  expect_no_pose(usual, {meet, std::numbers::pi_v<T> - meet});
}

TYPED_TEST(coinciding_elbows, of_a_delta_leave_no_pose) {
  using T = TypeParam;
  ph::delta_parameters<T> p;
  p.base_radius = T(0.1);
  p.platform_radius = T(0.05);
  p.upper_arm = T(0.2);
  p.forearm = T(0.3);
  const T q = std::acos(T(-0.25));  // on the axis
  const ph::delta<T> chain(p);
  expect_no_pose(chain, {q, q, T(0.3)});
  expect_no_pose(chain, {T(0.3), q, q});
  expect_no_pose(chain, {q, q, q});
}

// Where the determinant of the distal links is nothing but rounding, so would be J.
TYPED_TEST(coinciding_elbows, nearly_of_a_delta_leave_no_jacobian) {
  using T = TypeParam;
  ph::delta_parameters<T> p;
  p.base_radius = p.platform_radius;
  const T q = std::numbers::pi_v<T> / 2, little = std::sqrt(std::numeric_limits<T>::epsilon()) / 16;
  const ph::delta<T> chain(p);
  EXPECT_FALSE(ph::all_finite(chain.jacobian({q - little, q, q + little})));
}

TEST(five_bar, with_four_brakes_measures_both_rates_their_difference_and_their_sum) {
  const ph::five_bar<double, 4> chain;
  const ph::vector<double, 4> w = ph::brake_rates(chain, {2, 1}, {0.5, 0.2});
  EXPECT_TRUE(w.isApprox(ph::vector<double, 4>(0.5, 0.2, 0.3, 0.7), 1e-15));
  static_assert(ph::Dynamics<ph::five_bar<float, 4>> && ph::ClosedChain<ph::five_bar<float, 4>>);
  static_assert(!ph::detail::names_transmission<five_bar>, "two brakes sit on the joints");
}

TEST(delta, at_equal_angles_is_symmetric_about_its_axis) {
  const delta chain;
  const auto& p = chain.parameters();
  for (const double q : {-0.4, 0.0, 0.7, 1.2}) {
    const ph::vector<double, 3> all = ph::vector<double, 3>::Constant(q), x = chain.position(all);
    const double out = p.base_radius - p.platform_radius + p.upper_arm * std::cos(q);
    EXPECT_NEAR(std::hypot(x[0], x[1]), 0, 1e-16);
    EXPECT_NEAR(x[2], -p.upper_arm * std::sin(q) - std::sqrt(p.forearm * p.forearm - out * out), 1e-16);
    // Together the arms move it along the axis alone
    const ph::vector<double, 3> v = chain.jacobian(all) * ph::vector<double, 3>::Ones();
    EXPECT_NEAR(std::hypot(v[0], v[1]), 0, 1e-15);
    EXPECT_LT(v[2], 0);
  }
}

TEST(delta, reaches_its_workspace_far_from_singularities) {
  const delta chain;
  random_source random(seed);
  for (int k = 0; k < 2000; ++k) {
    const ph::vector<double, 3> x =
        ph::vector<double, 3>(0, 0, -0.14) +
        0.05 * std::cbrt(random.uniform(0.0, 1.0)) * random.direction<double, 3>();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", x = " << x.transpose());
    const auto s = chain.inverse(x);
    ASSERT_EQ(s.outcome, ph::status::ok);
    ASSERT_GT(chain.conditioning(s.q).type_1, 0.29);
    ASSERT_GT(chain.conditioning(s.q).type_2, 0.29);
  }
}

TEST(closed_chain_parameters, say_which_is_wrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ph::five_bar_parameters<double, 4> f;
  EXPECT_EQ(validate(f), "");
  f.base_distance = 0;
  EXPECT_EQ(validate(f), "");
  f.base_distance = -1;
  EXPECT_EQ(validate(f), "base_distance [m] = -1, expected a finite number >= 0");
  f = {}, f.distal_2 = 0;
  EXPECT_EQ(validate(f), "distal_2 [m] = 0, expected a finite number > 0");
  f = {}, f.base_distance = 1;
  EXPECT_EQ(validate(f), "longest length [m] = 1, expected less than all others together");
  f = {}, f.proximal_2 = 1;
  EXPECT_EQ(validate(f), "longest length [m] = 1, expected less than all others together");
  f = {}, f.rotor_inertia[3] = nan;
  EXPECT_EQ(validate(f), "rotor_inertia[3] [kg m^2] = nan, expected a finite number >= 0");
  f = {}, f.gravity[1] = nan;
  EXPECT_EQ(validate(f), "gravity[1] [m/s^2] = nan, expected a finite number");
  EXPECT_THROW((ph::five_bar<double, 4>(f)), std::invalid_argument);

  ph::delta_parameters<double> d;
  EXPECT_EQ(validate(d), "");
  d.forearm = -0.1;
  EXPECT_EQ(validate(d), "forearm [m] = -0.1, expected a finite number > 0");
  d = {}, d.base_radius = 1;
  EXPECT_EQ(validate(d),
            "base_radius - platform_radius [m] = 0.98, expected less than upper_arm + forearm in magnitude");
  d = {}, d.platform_mass = -2;
  EXPECT_EQ(validate(d), "platform_mass [kg] = -2, expected a finite number >= 0");
  d = {}, d.gravity[2] = nan;
  EXPECT_EQ(validate(d), "gravity[2] [m/s^2] = nan, expected a finite number");
  EXPECT_THROW((ph::delta<double>(d)), std::invalid_argument);
}

}  // namespace
