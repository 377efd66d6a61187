// slow, no sanitizers
// Serial chains: as two_link, as the product of exponentials in 50 digits, as a table of Denavit and
// Hartenberg.
#include <passive_haptics/mechanism/chains/denavit_hartenberg.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include "../../property/chain_cases.hpp"
#include "../high_precision.hpp"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <limits>

namespace {

namespace ph = passive_haptics;
using namespace high_precision;
using ph::testing::random_source;

constexpr unsigned seed = 3;
constexpr double eps = std::numeric_limits<double>::epsilon();

template <class T>
ph::serial_chain_with_inertia<T, 2, 2> chain_like(const ph::two_link_parameters<T>& p) {
  const auto geometry = ph::planar_arm(std::array{p.length_1, p.length_2});
  ph::serial_chain_inertia<T, 2, 2> inertia;
  inertia.links = {ph::uniform_rod<T, 2>(p.mass_1, geometry.joints[0].point, geometry.joints[1].point),
                   ph::uniform_rod<T, 2>(p.mass_2, geometry.joints[1].point, geometry.handle)};
  inertia.rotor_inertia = {p.rotor_inertia_1, p.rotor_inertia_2};
  inertia.handle_mass = p.handle_mass;
  return {geometry, inertia};
}

TEST(serial_chain, with_two_planar_joints_equals_two_link) {
  random_source random(seed);
  for (int k = 0; k < 200; ++k) {
    ph::two_link_parameters<double> p;
    for (double* x : {&p.length_1, &p.length_2, &p.mass_1, &p.mass_2, &p.handle_mass, &p.rotor_inertia_1,
                      &p.rotor_inertia_2})
      *x = random.uniform(0.05, 0.5);
    const ph::two_link<double> arm(p);
    const auto chain = chain_like(p);
    const ph::vector<double, 2> q = 3 * random.normal_vector<double, 2>(),
                                qd = random.normal_vector<double, 2>();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", case " << k << ", q = " << q.transpose());
    ASSERT_LE((chain.position(q) - arm.position(q)).norm(), 16 * eps);
    ASSERT_LE((chain.jacobian(q) - arm.jacobian(q)).norm(), 16 * eps);
    ASSERT_LE((chain.mass_matrix(q) - arm.mass_matrix(q)).norm(), 16 * eps);
    ASSERT_LE((chain.bias_torque(q, qd) - arm.bias_torque(q, qd)).norm(), 16 * eps * qd.squaredNorm());
    ASSERT_LE((chain.bias_acceleration(q, qd) - arm.bias_acceleration(q, qd)).norm(),
              16 * eps * qd.squaredNorm());
  }
}

// The product of exponentials as it is written, in the base frame: the joints' motions from the last to the
// first.
template <class T, int N, int D>
struct oracle {
  ph::serial_chain_parameters<T, N, D> geometry;
  ph::serial_chain_inertia<T, N, D> inertia;

  static mat<D, D> turned(const vec<D>& axis, const real& angle) {
    if constexpr (D == 2) return Eigen::Rotation2D<real>(angle).toRotationMatrix();
    else return Eigen::AngleAxis<real>(angle, axis.normalized()).toRotationMatrix();
  }

  // Of a point of body `body`, given in the zero pose
  vec<D> moved(int body, vec<D> x, const vec<N>& q) const {
    for (int i = body; i >= 0; --i) {
      const auto& joint = geometry.joints[std::size_t(i)];
      const vec<D> axis = exact(joint.axis), point = exact(joint.point);
      if (joint.kind == ph::joint_kind::prismatic) x += q[i] * axis.normalized();
      else x = point + turned(axis, q[i]) * (x - point);
    }
    return x;
  }

  // A rigid link as point masses with its second moment int r r^T dm, so that no formula for
  // inertia is shared with the library
  real kinetic_energy(const vec<N>& q, const vec<N>& qd) const {
    real energy = 0;
    const auto add = [&](int body, const real& mass, const vec<D>& at) {
      const vec<D> v = derivative([&](const real& s) { return moved(body, at, vec<N>(q + s * qd)); });
      energy += mass * v.squaredNorm() / 2;
    };
    for (int i = 0; i < N; ++i) {
      const auto& link = inertia.links[std::size_t(i)];
      const real part = real(link.mass) / (2 * D);
      const mat<D, D> root = second_moment(exact(link.about_centre)).llt().matrixL();
      for (int k = 0; k < D; ++k) {
        const vec<D> r = root.col(k) / sqrt(real(2 * part));
        add(i, part, exact(link.centre) + r);
        add(i, part, exact(link.centre) - r);
      }
      energy += real(inertia.rotor_inertia[i]) * qd[i] * qd[i] / 2;
    }
    add(N - 1, inertia.handle_mass, exact(geometry.handle));
    return energy;
  }

  real potential_energy(const vec<N>& q) const {
    const vec<D> g = exact(inertia.gravity);
    real energy = -real(inertia.handle_mass) * g.dot(moved(N - 1, exact(geometry.handle), q));
    for (int i = 0; i < N; ++i) {
      const auto& link = inertia.links[std::size_t(i)];
      energy -= real(link.mass) * g.dot(moved(i, exact(link.centre), q));
    }
    return energy;
  }

  static mat<2, 2> second_moment(const mat<1, 1>& inertia) {
    return mat<2, 2>::Identity() * (inertia(0, 0) / 2);
  }
  static mat<3, 3> second_moment(const mat<3, 3>& inertia) {
    return mat<3, 3>::Identity() * (inertia.trace() / 2) - inertia;
  }
};

// With a slide in the plane and in space, with gravity
using sampled_chains =
    ::testing::Types<chains::irregular_chain<double, 5, 2>, chains::irregular_chain<double, 3, 3>,
                     chains::irregular_chain<double, 6, 3>>;

template <class Case>
class chain_oracle : public ::testing::Test {
 protected:
  using mechanism = typename Case::mechanism;
  static constexpr int dof = mechanism::dof, dimension = mechanism::task_dimension;
  const oracle<double, dof, dimension> truth{Case::geometry(), Case::inertia()};
  const mechanism chain = Case::make();
  random_source random{seed};

  ph::vector<double, dof> pose() { return random.between<double, dof>(Case::lower(), Case::upper()); }
};
TYPED_TEST_SUITE(chain_oracle, sampled_chains);

TYPED_TEST(chain_oracle, position_is_the_product_of_exponentials) {
  constexpr int N = TestFixture::dof, D = TestFixture::dimension;
  for (int k = 0; k < 40; ++k) {
    const ph::vector<double, N> q = this->pose();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const vec<D> expected = this->truth.moved(N - 1, exact(this->truth.geometry.handle), exact(q));
    // The axes are normalised in double
    ASSERT_LE((exact(this->chain.position(q)) - expected).norm(), real(8 * N * eps));
    ASSERT_LE((this->chain.position(exact(q)) - expected).norm(), real(8 * N * eps));
  }
}

TYPED_TEST(chain_oracle, mass_matrix_gives_the_kinetic_energy_of_the_links) {
  constexpr int N = TestFixture::dof;
  for (int k = 0; k < 20; ++k) {
    const ph::vector<double, N> q = this->pose(), qd = this->random.template normal_vector<double, N>();
    SCOPED_TRACE(::testing::Message()
                 << "seed " << seed << ", q = " << q.transpose() << ", qd = " << qd.transpose());
    const real expected = this->truth.kinetic_energy(exact(q), exact(qd));
    const ph::matrix<double, N, N> M = this->chain.mass_matrix(q);
    ASSERT_NEAR(qd.dot(M * qd) / 2, double(expected), 16 * N * eps * M.norm() * qd.squaredNorm());
  }
}

TYPED_TEST(chain_oracle, bias_torque_at_rest_is_the_gradient_of_the_potential_energy) {
  constexpr int N = TestFixture::dof;
  for (int k = 0; k < 20; ++k) {
    const ph::vector<double, N> q = this->pose();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
    const auto energy = [&](const vec<N>& at) { return vec<1>(this->truth.potential_energy(at)); };
    const mat<1, N> expected = gradient<1, N>(energy, exact(q));
    const ph::vector<double, N> c = this->chain.bias_torque(q, ph::vector<double, N>::Zero());
    ASSERT_LE((exact(c).transpose() - expected).norm(), real(32 * N * eps) * (1 + expected.norm()));
    ASSERT_EQ(c.isZero(0), !TypeParam::has_gravity);
  }
}

TEST(serial_chain, follows_its_denavit_hartenberg_table) {
  random_source random(seed);
  for (int k = 0; k < 50; ++k) {
    std::array<ph::dh_joint<double>, 5> table;
    for (auto& row : table)
      row = {random.coin() ? ph::joint_kind::revolute : ph::joint_kind::prismatic, random.uniform(-0.3, 0.3),
             random.uniform(-3.0, 3.0), random.uniform(-0.3, 0.3), random.uniform(-3.0, 3.0)};
    const ph::vector<double, 3> tool = 0.1 * random.normal_vector<double, 3>();
    const ph::serial_chain<double, 5, 3> chain(ph::from_denavit_hartenberg(table, tool));
    const ph::vector<double, 5> q = random.normal_vector<double, 5>();
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", case " << k << ", q = " << q.transpose());

    using transform = Eigen::Transform<real, 3, Eigen::Isometry>;
    using turn = Eigen::AngleAxis<real>;
    transform frame = transform::Identity();
    for (int i = 0; i < 5; ++i) {
      const auto& row = table[std::size_t(i)];
      const bool turns = row.kind == ph::joint_kind::revolute;
      frame.rotate(turn(real(row.angle) + (turns ? real(q[i]) : real(0)), vec<3>::UnitZ()));
      frame.translate(vec<3>(0, 0, real(row.offset) + (turns ? real(0) : real(q[i]))));
      frame.translate(vec<3>(real(row.length), 0, 0));
      frame.rotate(turn(real(row.twist), vec<3>::UnitX()));
    }
    ASSERT_LE((exact(chain.position(q)) - frame * exact(tool)).norm(), real(64 * eps));
  }
}

TEST(serial_chain, says_which_parameter_is_wrong) {
  const auto good = chains::irregular_chain<double, 3, 3>::geometry();
  EXPECT_EQ(validate(good), "");
  auto p = good;
  p.joints[2].axis.setZero();
  EXPECT_EQ(validate(p), "joints[2].|axis| = 0: expected a direction");
  p = good;
  p.joints[0].point[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(validate(p), "joints[0].point[1] [m] = inf: expected a finite number");
  p = good;
  p.handle = ph::serial_chain_parameters<double, 3, 3>().handle;
  EXPECT_EQ(validate(p), "handle[0] [m] = nan: expected a finite number");
  EXPECT_THROW((ph::serial_chain<double, 3, 3>(p)), std::invalid_argument);
}

TEST(serial_chain, says_which_inertia_is_wrong) {
  using inertia = ph::serial_chain_inertia<double, 3, 3>;
  const inertia good = chains::irregular_chain<double, 3, 3>::inertia();
  EXPECT_EQ(validate(good), "");
  EXPECT_EQ(validate(inertia()), "links[0].mass [kg] = 0: expected a finite number > 0");
  inertia p = good;
  p.links[1].about_centre(0, 1) += 1;
  EXPECT_EQ(validate(p), "links[1].about_centre [kg m^2]: |I - I^T| = 1: expected 0, a symmetric matrix");
  const auto error_of = [&](double last) {
    p.links[1].about_centre = ph::vector<double, 3>(1, 1, last).asDiagonal();
    return validate(p);
  };
  EXPECT_EQ(error_of(2), "") << "a disc";
  p.links[1].about_centre.setZero();
  EXPECT_EQ(validate(p), "") << "a point mass";
  for (const double last : {2.001, -1.0})
    EXPECT_EQ(error_of(last),
              "links[1].about_centre [kg m^2] has a principal moment over the sum of the other two: "
              "expected that of a rigid body");
}

static_assert(ph::Mechanism<ph::serial_chain<float, 2, 2>> && ph::Mechanism<ph::serial_chain<double, 7, 3>>);
static_assert(!ph::Dynamics<ph::serial_chain<double, 3, 3>>, "no inertia given, none claimed");
static_assert(ph::Dynamics<ph::serial_chain_with_inertia<double, 3, 3>>);

}  // namespace
