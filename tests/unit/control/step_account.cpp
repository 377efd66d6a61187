// A law that asks for it is told of each cycle that commands nothing: free space, a wall without force, a
// fault.
#include "../support.hpp"

#include <passive_haptics/control/pipelines/torque_law.hpp>

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <limits>

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double never = -1;

// Holds every brake; notes when it was last released, for all who can see.
struct noting_law {
  static constexpr bool commands_torques = true;
  struct memory {};
  double* latest = nullptr;
  template <class Situation, class Contacts>
  auto torque(const Situation& now, const Contacts&, memory&) const noexcept {
    return (-now.s).eval();
  }
  void released(memory&, double time) const noexcept { *latest = time; }
};

using M = ph::xy_table<double>;

ph::device_state<M> at(double time, double y, double vy = -1) {
  auto state = state_of<M>({0, y}, {0, vy});
  state.time = time;
  return state;
}

// One wall, or room for several.
template <int Walls>
void expect_told_by_a_step() {
  double latest = never;
  const noting_law law{&latest};
  ph::step_memory<noting_law> memory;
  const auto step = [&](double time, const auto&... walls) {
    ph::contacts<2, Walls> touched;
    (touched.push_back(walls), ...);
    latest = never;
    ph::step(M(), ph::brakes_of<M>(), touched, law, at(time, 0), memory);
    return latest;
  };
  auto floor = asking_for<2>({0, 1});
  EXPECT_EQ(step(1, floor), never);
  EXPECT_EQ(step(2), 2) << "free";
  floor.depth = -1e-3;
  EXPECT_EQ(step(3, floor), 3) << "touched, but it asks for nothing";
  floor.depth = nan;
  EXPECT_EQ(step(4, floor), 4) << "a fault";
  floor = asking_for<2>({0, 1});
  floor.normal[0] = nan;
  EXPECT_EQ(step(5, floor), 5) << "a fault";
}
TEST(a_law, is_told_by_a_step_that_it_commands_nothing) {
  expect_told_by_a_step<1>();
  expect_told_by_a_step<2>();
}

TEST(a_law, is_told_by_a_controller_that_it_commands_nothing) {
  double latest = never;
  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e3));
  ph::controller control(M(), ph::brakes_of<M>(), floor, noting_law{&latest});
  const auto cycle = [&](const ph::device_state<M>& state) {
    latest = never;
    control(state);
    const double full = latest;
    latest = never;
    control.command(state);
    EXPECT_EQ(latest, full);
    return full;
  };
  EXPECT_EQ(cycle(at(1, -1e-3)), never);
  EXPECT_EQ(cycle(at(2, 1e-3)), 2) << "free";
  EXPECT_EQ(cycle(at(3, -1e-3)), never);
  EXPECT_EQ(cycle(at(4, -1e-3, nan)), 4) << "a fault";
  EXPECT_EQ(cycle(at(5, nan)), 5) << "a fault";
  ph::controller soft(M(), ph::brakes_of<M>(), ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 0.0)),
                      noting_law{&latest});
  latest = never;
  soft(at(6, -1e-3));
  EXPECT_EQ(latest, 6) << "touched, but it asks for nothing";
}

// Whatever the form of E.
template <class Mechanism>
struct the_nearest_force : ::testing::Test {};
using mechanisms = tested_types<ph::xy_table<double>, ph::tendon_two_link<double>, ph::delta<double>>;
TYPED_TEST_SUITE(the_nearest_force, mechanisms);

// Before law and limits: its part along Fd is Fd, and gamma is the angle between the two.
TYPED_TEST(the_nearest_force, is_told_before_law_and_limits) {
  constexpr unsigned seed = 20040627;
  constexpr int D = TypeParam::task_dimension;
  using joints = ph::joint_vector<TypeParam>;
  ph::testing::random_source random(seed);
  int approximate = 0;
  for (int k = 0; k < 500; ++k) {
    const joints q = joints::NullaryExpr([&] { return random.uniform(0.3, 0.9); });
    const auto state = state_of<TypeParam>(q, joints::NullaryExpr([&] { return random.wide(0.1, 3.0); }),
                                           random.direction<double, D>());
    const ph::point<D> Fd = 7 * random.direction<double, D>();
    const auto result = step_once<ph::direct_control>(TypeParam(), {}, state, asking_for<D>(Fd));
    ASSERT_EQ(result.outcome, ph::status::ok);
    EXPECT_LE((result.desired_force - Fd).norm(), 1e-12);
    if (result.display == ph::display_class::none) continue;
    const auto& Fc = result.control_force;
    EXPECT_NEAR(Fc.dot(Fd.normalized()), 7, 1e-9) << "seed " << seed;
    EXPECT_NEAR(result.approximation_cosine, Fc.dot(Fd) / (Fc.norm() * Fd.norm()), 1e-12) << "seed " << seed;
    const ph::matrix<double, D, D> E(ph::brake_jacobian(TypeParam(), q));
    EXPECT_LE((result.cone_coefficients - E.transpose() * Fc).norm(), 1e-9 * Fc.norm()) << "seed " << seed;
    approximate += result.display == ph::display_class::approximate;
  }
  EXPECT_GT(approximate, 100);
}

// Displayed up to the largest angle, not beyond it.
TYPED_TEST(the_nearest_force, is_displayed_up_to_the_largest_angle) {
  constexpr unsigned seed = 20040627;
  constexpr int D = TypeParam::task_dimension;
  using joints = ph::joint_vector<TypeParam>;
  ph::testing::random_source random(seed);
  int approximate = 0;
  for (int k = 0; k < 500; ++k) {
    const joints q = joints::NullaryExpr([&] { return random.uniform(0.3, 0.9); });
    const auto state = state_of<TypeParam>(q, joints::NullaryExpr([&] { return random.wide(0.1, 3.0); }));
    ph::contacts<D, 1> touched;
    touched.push_back(asking_for<D>(5 * random.direction<double, D>()));
    const auto step = [&](double min_cosine) {
      ph::step_memory<ph::no_direct_control> memory;
      ph::step_options<double> options;
      options.min_cosine = min_cosine;
      return ph::step(TypeParam(), ph::brakes_of<TypeParam>(), touched, ph::no_direct_control{}, state,
                      memory, options);
    };
    const auto any = step(1e-3);
    if (any.display != ph::display_class::approximate) continue;
    const double cosine = any.approximation_cosine;
    EXPECT_EQ(step(cosine * (1 - 1e-9)).display, ph::display_class::approximate) << "seed " << seed;
    EXPECT_EQ(step(cosine * (1 + 1e-9)).display, ph::display_class::none) << "seed " << seed;
    EXPECT_TRUE(step(cosine * (1 + 1e-9)).capacity.isZero(0)) << "seed " << seed;
    ++approximate;
  }
  EXPECT_GT(approximate, 100);
}

TEST(step_options, cut_forces_off_beyond_an_angle_of_89_degrees_unless_told_another) {
  EXPECT_NEAR(ph::step_options<double>().min_cosine, std::cos(ph::radians(89.0)), 1e-16);
  const ph::approximation_parameters<double> narrow{ph::radians(60.0)};
  EXPECT_NEAR(ph::step_options<double>(narrow).min_cosine, 0.5, 1e-15);
}

}  // namespace
