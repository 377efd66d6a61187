// slow
// velocity_direct_control at two walls commands redundant brakes independently of the units of their rates.
#include "polar_arm.hpp"

#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace {

ph::vector<double, 3> capacities(double per_metre, const ph::vector<double, 2>& q,
                                 const ph::vector<double, 2>& qd, const ph::vector<double, 2>& hand_force,
                                 const std::array<ph::point<2>, 2>& normals) {
  using M = polar_arm;
  const ph::vector<double, 3> unit(1, per_metre, per_metre), limit(0.5, 20, 5);
  ph::brakes_of<M> brakes;
  brakes.torque_limit = limit.cwiseQuotient(unit);
  brakes.rate_dead_band = 1e-3 * unit;
  ph::contacts<2, 2> touched;
  for (int j = 0; j < 2; ++j)
    touched.push_back({.normal = normals[std::size_t(j)],
                       .depth = 3e-3,
                       .stiffness = 1000,
                       .wall_number = j,
                       .sensed_at = {0, 0}});
  ph::step_memory<ph::velocity_direct_control> memory;
  const auto result = ph::step(M{per_metre}, brakes, touched, ph::velocity_direct_control(),
                               ph::device_state<M>{0, q, qd, hand_force}, memory);
  EXPECT_EQ(result.outcome, ph::status::ok);
  return result.capacity.cwiseProduct(unit);
}

TEST(torque_units_of_velocity_control, are_those_of_the_limits) {
  ph::testing::random_source random(1);
  int all_brake = 0;
  for (int k = 0; k < 200; ++k) {
    const ph::vector<double, 2> q(random.uniform(-3.0, 3.0), random.uniform(0.1, 0.3)),
        qd = k % 2 == 0 ? ph::vector<double, 2>(0, 0)
                        : ph::vector<double, 2>(random.normal<double>(), 0.2 * random.normal<double>()),
        hand_force = random.normal_vector<double, 2>();
    const std::array normals{ph::point<2>(random.direction<double, 2>()),
                             ph::point<2>(random.direction<double, 2>())};
    const auto t = capacities(1, q, qd, hand_force, normals),
               in_millimetres = capacities(1000, q, qd, hand_force, normals);
    ASSERT_LE((t - in_millimetres).norm(), 1e-6 * t.norm());
    all_brake += (t.array() > 1e-3).all() ? 1 : 0;
  }
  EXPECT_GT(all_brake, 8);
}

}  // namespace
