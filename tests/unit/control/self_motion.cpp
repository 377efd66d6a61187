// slow
// Arms with more joints than task dimensions keep their wall: random states at one.
#include "arm_of_rods.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace {

namespace ph = passive_haptics;
constexpr unsigned seed_of_self_motion = 20040627;

struct arm_at_a_wall {
  using M = arms::arm<3>;
  M mechanism = arms::of_rods<3>(1e-3);  // rotors of particle brakes of a few N m
  ph::device_state<M> state;
  ph::contacts<2, 1> touched;

  arm_at_a_wall(ph::testing::random_source& random, double depth, double stiffness) {
    state.time = 0;
    for (double& q : state.q) q = random.uniform(-std::numbers::pi, std::numbers::pi);
    state.qd = random.normal_vector<double, 3>();
    touched.push_back({.normal = random.direction<double, 2>(),
                       .depth = depth,
                       .stiffness = stiffness,
                       .sensed_at = mechanism.position(state.q)});
  }
  // The wall faces the motion; the hand pushes anywhere
  void move_in(ph::testing::random_source& random) {
    ph::contact<2> wall = touched[0];
    if (wall.normal.dot(ph::jacobian(mechanism, state.q) * state.qd) > 0) wall.normal *= -1;
    touched.clear();
    touched.push_back(wall);
    state.hand_force = random.normal_vector<double, 2>();
  }
  template <class L, class B = ph::brakes_of<M>>
  ph::step_result<M> step(const B& brakes = B(), const ph::step_options<double>& options = {}) const {
    ph::step_memory<L> memory;
    return ph::step(mechanism, brakes, touched, L(), state, memory, options);
  }
};

TEST(self_motion, that_settles_leaves_the_wall) {
  ph::testing::random_source random(seed_of_self_motion);
  int without = 0;
  for (int k = 0; k < 1000; ++k) {
    arm_at_a_wall arm(random, 1e-4, 1e7);
    arm.move_in(random);
    const auto result = arm.step<ph::direct_control>();
    EXPECT_EQ(result.outcome, ph::status::ok);
    if (!result.capacity.isZero(0)) continue;
    ++without;
    EXPECT_EQ(result.display, ph::display_class::none) << k << " has no wall: " << to_string(result.display);
  }
  EXPECT_LT(without, 50);
}

// A narrower angle leaves fewer states with a force; brakes cut one by one make more.
TEST(self_motion, obeys_the_options_under_velocity_direct_control) {
  ph::testing::random_source random(seed_of_self_motion);
  const ph::step_options<double> narrow(ph::approximation_parameters<double>{ph::radians(5.0)});
  const ph::step_options<double> each({}, ph::saturation::clamp_each);
  int cut_off = 0, displayed = 0, larger = 0;
  for (int k = 0; k < 200; ++k) {
    const arm_at_a_wall arm(random, 5e-3, 1000);
    const auto capacity = [&](const ph::step_options<double>& options) {
      return arm.step<ph::velocity_direct_control>({}, options).capacity;
    };
    const ph::vector<double, 3> usual = capacity({}), more = capacity(each);
    EXPECT_TRUE((more.array() >= usual.array()).all() && (more.array() <= 1).all()) << k;
    larger += more != usual;
    const bool is_displayed = !usual.isZero(0), is_near = !capacity(narrow).isZero(0);
    EXPECT_TRUE(is_displayed || !is_near) << k;
    cut_off += is_displayed && !is_near;
    displayed += is_near;
  }
  EXPECT_GT(cut_off, 20);
  EXPECT_GT(displayed, 20);
  EXPECT_GT(larger, 5);
}

// On-off control displays what no_direct_control does.
TEST(self_motion, is_left_alone_by_a_relay_too) {
  ph::testing::random_source random(seed_of_self_motion);
  int held = 0;
  for (int k = 0; k < 200; ++k) {
    const arm_at_a_wall arm(random, 1, 3);
    const ph::unlimited_brakes brakes;
    const ph::vector<double, 3> plain = arm.step<ph::no_direct_control>(brakes).torque,
                                relay = arm.step<ph::on_off_control>(brakes).torque;
    EXPECT_LE((relay - plain).norm(), 1e-12 * plain.norm()) << k;
    held += !plain.isZero(0);
  }
  EXPECT_GT(held, 140);
}

// A law whose torque is no number releases all brakes, also where no set of brakes displays anything.
struct broken_law {
  static constexpr bool commands_torques = true;
  template <class M, class E, int D, int N, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, E, B>&, const ph::contacts<D, N>&) const noexcept {
    return ph::brake_vector<M>::Constant(std::numeric_limits<double>::quiet_NaN());
  }
};

TEST(self_motion, of_a_law_without_numbers_is_a_fault) {
  ph::testing::random_source random(seed_of_self_motion);
  for (int k = 0; k < 100; ++k) {
    const auto result = arm_at_a_wall(random, 1, 3).step<broken_law>();
    ASSERT_EQ(result.outcome, ph::status::result_not_finite) << k;
    ASSERT_TRUE(result.capacity.isZero(0)) << k;
  }
}

}  // namespace
