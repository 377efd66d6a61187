// slow, optimised, no sanitizers
// Positions, derivatives, energies and inverse kinematics of closed chains, from their constraints.
#include "closed_chain_oracles.hpp"

#include <cmath>

namespace {

using namespace closed_chains;

TYPED_TEST_SUITE(closed_chain, cases);

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

}  // namespace
