// A law that commands torques itself: its memory, its account, and the torques that are left of its own.
#include "../support.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using M = ph::xy_table<double>;
using pair = ph::vector<double, 2>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double never = -1;

// Opposes with one N m more each time, and notes when it was last released. It fails before time 0.
struct counting_law {
  static constexpr bool commands_torques = true;
  struct memory {
    int calls = 0;
  };
  double* latest = nullptr;
  template <class Situation, class Contacts>
  ph::brake_vector<M> torque(const Situation& now, const Contacts&, memory& m) const noexcept {
    ++m.calls;
    return -now.s * (now.time < 0 ? nan : m.calls);
  }
  void released(memory&, double time) const noexcept { *latest = time; }
};

const ph::brakes_of<M> far_limits = [] {
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(100);
  return brakes;
}();

ph::device_state<M> at(double time, double y) {
  auto state = state_of<M>({0, y}, {0, -1});
  state.time = time;
  return state;
}

// One wall, or room for several.
template <int Walls>
void expect_remembered_and_released_by_a_step() {
  double latest = never;
  ph::step_memory<counting_law> memory;
  const auto step = [&](double time, const auto&... walls) {
    ph::contacts<2, Walls> touched;
    (touched.push_back(walls), ...);
    latest = never;
    return ph::step(M(), far_limits, touched, counting_law{&latest}, at(time, 0), memory);
  };
  const auto floor = asking_for<2>({0, 1});
  EXPECT_EQ(step(1, floor).capacity[1], 1);
  EXPECT_EQ(step(2, floor).capacity[1], 2) << "a memory goes from cycle to cycle";
  EXPECT_EQ(latest, never);
  EXPECT_EQ(step(3).outcome, ph::status::ok);
  EXPECT_EQ(latest, 3) << "free";
  auto other = floor;
  other.depth = -1e-3;
  step(4, other);
  EXPECT_EQ(latest, 4) << "touched, but it demands nothing";
  other.depth = nan;
  EXPECT_EQ(step(5, other).outcome, ph::status::contact_invalid);
  EXPECT_EQ(latest, 5);
  EXPECT_EQ(step(-7, floor).outcome, ph::status::result_not_finite);
  EXPECT_EQ(latest, -7);
  EXPECT_EQ(memory.law.calls, 2) << "it is kept only by a cycle that ends well";
  EXPECT_EQ(step(8, floor).capacity[1], 3);
}

TEST(torque_law, remembers_and_is_told_by_a_step_that_it_commands_nothing) {
  expect_remembered_and_released_by_a_step<1>();
  expect_remembered_and_released_by_a_step<2>();
}

TEST(torque_law, is_told_by_a_controller_that_it_commands_nothing_and_keeps_its_memory_until_reset) {
  double latest = never;
  ph::controller control(M(), far_limits, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e3)),
                         counting_law{&latest});
  EXPECT_EQ(control(at(1, -1e-3)).capacity[1], 1);
  EXPECT_EQ(control.command(at(2, -1e-3)).capacity[1], 2);
  EXPECT_EQ(latest, never);
  control(at(3, 1e-3));
  EXPECT_EQ(latest, 3) << "free";
  control.command(at(4, nan));
  EXPECT_EQ(latest, 4) << "a fault";
  EXPECT_EQ(control(at(6, -1e-3)).capacity[1], 3);
  control.reset();
  EXPECT_EQ(control(at(7, -1e-3)).capacity[1], 1);
}

// A law that commands the torques it was made with, at one wall.
struct given_torque {
  static constexpr bool commands_torques = true;
  pair wanted = {0, 0};
  template <class Situation, class Contacts>
  pair torque(const Situation&, const Contacts&) const noexcept {
    return wanted;
  }
};

template <class B>
ph::step_result<M> step_with(const pair& torque, const B& brakes, const pair& v, const ph::point<2>& Fd) {
  ph::contacts<2, 1> touched;
  touched.push_back(asking_for<2>(Fd));
  ph::step_memory<given_torque> memory;
  return ph::step(M(), brakes, touched, given_torque{torque}, state_of<M>({0, 0}, v), memory);
}

// Of the force that these torques make before the limits, on the floor that demands 10 N.
TEST(torque_law, has_an_account_of_the_force_that_its_torques_make) {
  const auto run = [&](const pair& torque, const pair& v) {
    return step_with(torque, far_limits, v, {0, 10});
  };
  const auto exact = run({0, 10}, {-1, -1});
  EXPECT_EQ(exact.display, ph::display_class::exact);
  EXPECT_EQ(exact.power, ph::power_class::passive_1);
  EXPECT_NEAR(exact.approximation_cosine, 1, 1e-6);
  const auto slanted = run({3, 4}, {-1, -1});
  EXPECT_EQ(slanted.display, ph::display_class::approximate);
  EXPECT_EQ(slanted.power, ph::power_class::passive_1) << "Fd itself could be displayed";
  EXPECT_NEAR(slanted.approximation_cosine, 0.8, 1e-6);
  EXPECT_EQ(slanted.control_force, pair(3, 4));
  EXPECT_EQ(slanted.cone_coefficients, pair(3, 4));
  expect_near(slanted.desired_force, pair(0, 10), 10);
  const auto along = run({3, 0}, {-1, -1});
  EXPECT_EQ(along.display, ph::display_class::none);
  EXPECT_EQ(along.approximation_cosine, 0);
  EXPECT_EQ(along.capacity, pair(3, 0));
  const auto driving = run({3, 10}, {-1, 1});
  EXPECT_EQ(driving.power, ph::power_class::active);
  EXPECT_EQ(driving.display, ph::display_class::none);
  EXPECT_EQ(driving.capacity, pair(3, 0)) << "y would have to drive";
  const auto beyond = run({150, 40}, {-1, -1});
  EXPECT_TRUE(beyond.saturated);
  EXPECT_EQ(beyond.torque, pair(100, 40)) << "each within its limit";
  EXPECT_EQ(beyond.control_force, pair(150, 40)) << "before the limits";
  EXPECT_FALSE(step_with({150, 40}, ph::unlimited_brakes(), {-1, -1}, {0, 10}).saturated);
}

TEST(torque_law, has_no_part_in_its_account_for_a_brake_that_is_off) {
  ph::switchable_brakes<M> brakes;
  brakes.torque_limit.setConstant(100);
  brakes.switch_off(0);
  const auto result = step_with({3, 10}, brakes, {-1, -1}, {0, 10});
  EXPECT_EQ(result.capacity, pair(0, 10));
  EXPECT_EQ(result.control_force, pair(0, 10));
  EXPECT_EQ(result.display, ph::display_class::exact);
  EXPECT_FALSE(result.saturated);
}

TEST(torque_law, never_drives_a_brake_and_stays_within_its_limits) {
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  ph::brakes_of<M> brakes;
  brakes.torque_limit = {2, 0.5};
  int driving = 0, saturated = 0;
  for (int k = 0; k < 200; ++k) {
    const pair wanted(random.wide(0.1, 4.0), random.wide(0.1, 4.0));
    const pair v(random.wide(0.1, 1.0), random.wide(0.1, 1.0));
    const auto result = step_with(wanted, brakes, v, {0.6, 0.8});
    ASSERT_EQ(result.outcome, ph::status::ok);
    bool over = false;
    for (int i = 0; i < 2; ++i) {
      const double limit = brakes.torque_limit[i];
      const bool drives = wanted[i] * v[i] > 0;
      EXPECT_EQ(result.capacity[i], drives ? 0 : std::min(std::abs(wanted[i]), limit)) << "seed " << seed;
      EXPECT_EQ(result.torque[i], drives ? 0 : std::clamp(wanted[i], -limit, limit)) << "seed " << seed;
      over = over || (!drives && std::abs(wanted[i]) > limit);  // a brake that is released is at no limit
      driving += drives;
    }
    EXPECT_EQ(result.saturated, over);
    saturated += over;
  }
  EXPECT_GT(driving, 40);
  EXPECT_GT(saturated, 40);
}

TEST(torque_law, that_commands_no_number_releases_the_brakes) {
  for (const double bad : {nan, HUGE_VAL, -HUGE_VAL}) {
    for (const pair& wanted : {pair(bad, 0.1), pair(0.1, bad)}) {
      const auto result = step_with(wanted, ph::brakes_of<M>(), {1, 1}, {0.6, 0.8});
      EXPECT_EQ(result.outcome, ph::status::result_not_finite);
      EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
    }
  }
}

}  // namespace
