// A hand at rest in a corner of two or three walls, which its brakes could hold by themselves.
#include "chain_cases.hpp"
#include "closed_chain_cases.hpp"
#include "device_cases.hpp"

#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/step.hpp>

#include <cmath>

namespace {

namespace ph = passive_haptics;
using law = ph::velocity_direct_control;
constexpr unsigned seed = 59;

// The least torques within the limits whose T^T t comes nearest to -J^T F.
template <class M>
ph::brake_vector<M> torques_that_hold(const ph::pose_dynamics<M>& device, const ph::task_vector<M>& F,
                                      const ph::brake_vector<M>& limits) {
  const ph::joint_vector<M> wanted = -ph::transposed_times(device.J, F);
  using square = ph::matrix<double, M::brake_count, M::brake_count>;
  return ph::least_squares_by_priority(ph::brake_vector<M>(-limits), limits,
                                       ph::least_squares_level{device.Tt, wanted},
                                       ph::least_squares_level{square(square::Identity())});
}

// True if brakes of these capacities hold a hand that does F.
template <class M>
bool can_hold(const ph::pose_dynamics<M>& device, const ph::task_vector<M>& F,
              const ph::brake_vector<M>& capacity) {
  const ph::joint_vector<M> hand = ph::transposed_times(device.J, F);
  return (hand + device.Tt * torques_that_hold<M>(device, F, capacity)).norm() <= 1e-9 * hand.norm();
}

// Walls at equal angles to an axis that leaves all of them, the corner at x.
template <int D>
ph::contacts<D, D> random_corner(const ph::point<D>& x, int walls, ph::testing::random_source& random,
                                 ph::point<D>& axis) {
  const auto e = random.orthogonal_directions<D>();
  axis = e.col(0);
  const double between = ph::radians(random.uniform(30.0, 170.0));  // of two opposite walls
  ph::contacts<D, D> corner;
  for (int j = 0; j < walls; ++j) {
    const double around = ph::radians(360.0 / walls * j);
    ph::point<D> spoke = std::cos(around) * e.col(1);
    if constexpr (D == 3) spoke += std::sin(around) * e.col(2);
    corner.push_back({.normal = std::sin(between / 2) * axis + std::cos(between / 2) * spoke,
                      .depth = random.coin() ? 1e-6 : random.uniform(1e-4, 4e-3),
                      .stiffness = 1e7,
                      .wall_number = j,
                      .sensed_at = x});
  }
  return corner;
}

template <class Case>
struct corners : ::testing::Test {};
using devices = tested_types<device_case<ph::tendon_two_link<double>>, closed_chains::level_five_bar<4>,
                             closed_chains::desktop_delta<double>, chains::irregular_chain<double, 3, 2>>;
TYPED_TEST_SUITE(corners, devices);

// At rest, or sinking within the dead bands.
template <class M>
ph::joint_vector<M> random_creep(const ph::pose_dynamics<M>& still, const ph::task_vector<M>& F,
                                 const ph::brakes_of<M>& brakes, ph::testing::random_source& random) {
  if (random.coin()) return ph::joint_vector<M>::Zero();
  const ph::joint_vector<M> qdd = still.mass.solve(ph::joint_vector<M>(ph::transposed_times(still.J, F)));
  const ph::brake_vector<M> wd = ph::transposed_times(still.Tt, qdd);
  return random.uniform(0.0, 0.5) / wd.cwiseAbs().cwiseQuotient(brakes.rate_dead_band).maxCoeff() * qdd;
}

// The sensor is off by up to a fifth. Pulled out along the axis, the hand is not held, unless the device
// gives way into a wall under that pull, or a wall pushes its handle up to the depth of rest.
TYPED_TEST(corners, hold_what_their_brakes_can_hold_and_let_the_hand_out) {
  using M = typename TypeParam::mechanism;
  constexpr int d = M::task_dimension;
  ph::testing::random_source random(seed);
  const M device = TypeParam::make();
  const ph::brakes_of<M> brakes;
  int pulls = 0;
  for (int k = 0; k < 150; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    const ph::joint_vector<M> q = random.between<double, M::dof>(TypeParam::lower(), TypeParam::upper());
    const ph::mechanism_pose<M> pose(device, q);
    const ph::pose_dynamics<M> still(pose, ph::joint_vector<M>::Zero(), law().parameters().hand_mass);
    ph::point<d> out;
    const auto corner = random_corner<d>(pose.position(), d == 3 && random.coin() ? 3 : 2, random, out);
    ph::task_vector<M> F = ph::task_vector<M>::Zero();
    for (const auto& wall : corner) F -= random.uniform(0.0, 1.0) * wall.normal;
    const ph::brake_vector<M> unlimited = ph::brake_vector<M>::Constant(1e9);
    const ph::brake_vector<M> holding = torques_that_hold<M>(still, F, unlimited);
    F *= random.uniform(0.02, 0.99) / holding.cwiseAbs().cwiseQuotient(brakes.torque_limit).maxCoeff();

    ph::step_memory<law> memory;
    const auto step = [&](double time, const ph::joint_vector<M>& qd, const ph::task_vector<M>& measured) {
      const auto result =
          ph::step(device, brakes, corner, law(), ph::device_state<M>{time, q, qd, measured}, memory);
      EXPECT_EQ(result.outcome, ph::status::ok);
      EXPECT_TRUE((result.capacity.array() >= 0).all());
      EXPECT_TRUE((result.capacity.array() <= brakes.torque_limit.array()).all());
      EXPECT_TRUE((result.signs.array() * result.torque.array() <= 0).all()) << "a brake drives";
      return result.capacity;
    };
    const auto in = step(0, random_creep<M>(still, F, brakes, random), random.uniform(0.8, 1.2) * F);
    ASSERT_TRUE(can_hold<M>(still, F, in)) << in.transpose();

    const ph::task_vector<M> pull = F.norm() * out;
    const auto back = step(0.1, ph::joint_vector<M>::Zero(), pull);
    bool leaves = true;
    for (const auto& wall : corner)
      leaves = leaves && wall.depth <= law().parameters().rest_depth &&
               ph::response_along(wall.normal, still, pull).free > 0;
    ASSERT_FALSE(leaves && can_hold<M>(still, pull, back)) << back.transpose();
    pulls += leaves;
  }
  EXPECT_GT(pulls, 30);
}

}  // namespace
