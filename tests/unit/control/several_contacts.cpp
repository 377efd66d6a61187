// Several walls at once in a whole step: what the law wants of each, and what is reported of it.
#include "../support.hpp"

#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

constexpr unsigned seed = 20040627;
const ph::matrix<double, 2, 2> identity = ph::matrix<double, 2, 2>::Identity();

// (12) for each wall by its own relative velocity; a wall that asks for nothing wants nothing.
TEST(several_contacts, each_want_what_the_law_says_of_them) {
  using M = ph::tendon_two_link<double>;
  ph::testing::random_source random(seed);
  const M arm;
  int left = 0, pressed = 0, kept = 0;
  for (int k = 0; k < 300; ++k) {
    const auto state = state_of<M>({random.uniform(-3.0, 3.0), random.uniform(0.3, 2.8)},
                                   {random.wide(0.1, 3.0), random.wide(0.1, 3.0)},
                                   ph::vector<double, 2>(5 * random.direction<double, 2>()));
    ph::contact<2> walls[2];
    for (int j = 0; j < 2; ++j) {
      walls[j] = asking_for<2>(random.positive(1.0, 20.0) * random.direction<double, 2>());
      walls[j].wall_velocity = random.positive(0.1, 1.0) * random.direction<double, 2>();
      walls[j].wall_number = 3 + j;
    }
    if (k % 5 == 0) walls[k % 2].depth *= -1;
    const auto step = [&]<class L>(const L& law) {
      ph::contacts<2, 2> touched;
      for (const auto& wall : walls) touched.push_back(wall);
      ph::step_memory<L> memory;
      return ph::step(arm, ph::brakes_of<M>(), touched, law, state, memory);
    };
    const auto direct = step(ph::direct_control{}), plain = step(ph::no_direct_control{});
    ASSERT_EQ(direct.outcome, ph::status::ok);
    ASSERT_EQ(direct.contact_count, k % 5 == 0 ? 1 : 2);
    const ph::point<2> v = ph::jacobian(arm, state.q) * state.qd;
    const ph::point<2> hand = state.hand_force;
    for (int j = 0, at = 0; j < 2; ++j) {
      const double force = walls[j].stiffness * walls[j].depth, pressing = -walls[j].normal.dot(hand);
      const bool leaves = walls[j].normal.dot(v - walls[j].wall_velocity) > 0;
      if (force <= 0) continue;
      const double given = leaves ? std::clamp(pressing, 0.0, force) : force;
      const auto& report = direct.contacts[std::size_t(at)];
      const auto& other = plain.contacts[std::size_t(at++)];
      EXPECT_NEAR(report.wanted, given, 1e-5) << "seed " << seed << ", trial " << k;
      EXPECT_NEAR(other.wanted, force, 1e-5) << "seed " << seed << ", trial " << k;
      EXPECT_EQ(report.has_priority, leaves) << "seed " << seed << ", trial " << k;
      EXPECT_FALSE(other.has_priority) << "this law never gives way";
      EXPECT_EQ(report.wall_number, 3 + j);
      left += leaves;
      pressed += !leaves;
      kept += leaves && given > 0;
    }
  }
  EXPECT_GT(left, 90);
  EXPECT_GT(pressed, 90);
  EXPECT_GT(kept, 30);
}

// Half of what a wall asks for; may not be asked where that is nothing.
struct half_of_what_asks {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    return c.desired_magnitude > T(0) ? T(0.5) : std::numeric_limits<T>::quiet_NaN();
  }
};

// Three walls of which one asks for nothing are the other two, and its law is not asked.
TEST(several_contacts, are_those_that_ask_for_a_force) {
  using M = ph::tendon_two_link<double>;
  ph::testing::random_source random(seed);
  for (int k = 0; k < 300; ++k) {
    const auto state = state_of<M>({random.uniform(-3.0, 3.0), random.uniform(0.3, 2.8)},
                                   {random.wide(0.1, 3.0), random.wide(0.1, 3.0)});
    ph::contact<2> walls[3];
    for (auto& wall : walls) wall = asking_for<2>(random.positive(1.0, 20.0) * random.direction<double, 2>());
    walls[k % 3].depth *= k % 2 == 0 ? 0 : -1;
    const auto step = [&]<int N>(ph::contacts<2, N> touched, bool all) {
      for (int j = 0; j < 3; ++j)
        if (all || j != k % 3) touched.push_back(walls[j]);
      ph::step_memory<half_of_what_asks> memory;
      return ph::step(M(), ph::brakes_of<M>(), touched, half_of_what_asks(), state, memory);
    };
    const auto three = step(ph::contacts<2, 3>(), true);
    const auto two = step(ph::contacts<2, 2>(), false);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    ASSERT_EQ(three.outcome, ph::status::ok);
    expect_near(three.torque, two.torque, 1e3);
    expect_near(three.control_force, two.control_force, 1e3);
    EXPECT_EQ(three.display, two.display);
    ASSERT_EQ(three.contact_count, 2);
    for (std::size_t j = 0; j < 2; ++j) EXPECT_EQ(three.contacts[j].wanted, two.contacts[j].wanted);
  }
}

// More than the limits below.
struct strong_torques {
  static constexpr bool commands_torques = true;
  template <class Situation, class Contacts>
  auto torque(const Situation& now, const Contacts&) const noexcept {
    return (-200 * now.s).eval();
  }
};

// Each law in a corner of walls 3 and 4, which are touched, near or, without a margin, absent. The handle
// moves in, so that both brakes of the table slip: what they make is -s_i capacity_i.
template <class L>
void expect_reports(bool first_is_touched, bool second_is_touched, bool has_margin, double limit,
                    ph::saturation policy) {
  using M = ph::xy_table<double>;
  ph::contacts<2, 2> touched;
  std::vector<ph::contact<2>> expected;
  for (const bool is_first : {true, false}) {
    ph::contact<2> wall = asking_for<2>(is_first ? ph::point<2>(12, 5) : ph::point<2>(-6, 8));
    wall.sensed_at = {0, 0};
    wall.wall_number = is_first ? 3 : 4;
    if (is_first ? first_is_touched : second_is_touched) expected.push_back(wall);
    else wall.depth = -1e-4;
    if (has_margin || wall.depth > 0) touched.push_back(wall);
  }
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(limit);
  const auto state = state_of<M>({0, 0}, {-0.05, -0.1}, {-1, -2});
  ph::step_options<double> options;
  options.limits = policy;
  const auto check = [&](const auto& walls) {
    ph::step_memory<L> memory;
    const auto result = ph::step(M(), brakes, walls, L(), state, memory, options);
    ASSERT_EQ(result.outcome, ph::status::ok);
    ASSERT_EQ(result.contact_count, static_cast<int>(expected.size()));
    const ph::point<2> F = -result.signs.cwiseProduct(result.capacity);
    for (std::size_t j = 0; j < expected.size(); ++j) {
      const auto& report = result.contacts[j];
      const double wanted = ph::TorqueLaw<L> ? expected[j].normal.dot(result.control_force)
                                             : expected[j].stiffness * expected[j].depth;
      EXPECT_EQ(report.wall_number, expected[j].wall_number);
      EXPECT_NEAR(report.displayed, expected[j].normal.dot(F), 1e-12);
      EXPECT_NEAR(report.wanted, wanted, 1e-12);
      EXPECT_FALSE(report.has_priority) << "the handle moves in";
    }
  };
  check(touched);
  if constexpr (ph::ScalingLaw<L>)
    check(ph::with_effects(touched, ph::viscous_field<double, 2>({.viscosity = 3 * identity})));
}

TEST(corner, reports_each_touched_wall_under_every_law) {
  for (const double limit : {2.0, 100.0})
    for (int k = 0; k < 16; ++k) {
      const bool first = k & 1, second = k & 2, margin = k & 4;
      const auto policy = k & 8 ? ph::saturation::keep_direction : ph::saturation::clamp_each;
      SCOPED_TRACE(::testing::Message() << "limit " << limit << ", touched " << first << second << ", margin "
                                        << margin << ", policy " << int(policy));
      expect_reports<ph::direct_control>(first, second, margin, limit, policy);
      expect_reports<ph::velocity_direct_control>(first, second, margin, limit, policy);
      expect_reports<strong_torques>(first, second, margin, limit, policy);
    }
}

// Both limits hold, and that one is reached is reported.
TEST(several_contacts, stay_within_the_limits) {
  using M = ph::xy_table<double>;
  ph::brakes_of<M> brakes;
  brakes.torque_limit = {5, 5};
  const auto step = [&](double x, double y) {
    return step_once<ph::no_direct_control>(M(), brakes, state_of<M>({0, 0}, {-1, -1}), asking_for<2>({x, 0}),
                                            asking_for<2>({0, y}));
  };
  EXPECT_FALSE(step(4, 3).saturated);
  expect_near(step(4, 3).capacity, ph::vector<double, 2>(4, 3), 5);
  for (const auto& result : {step(7, 3), step(3, 7), step(7, 7)}) {
    EXPECT_TRUE(result.saturated);
    EXPECT_TRUE((result.capacity.array() <= brakes.torque_limit.array()).all());
  }
}

// Brakes only push against their motion: out of both walls, out of one, out of none.
TEST(several_contacts, say_whether_each_gets_what_it_asks_for) {
  using M = ph::xy_table<double>;
  const auto display = [](const ph::vector<double, 2>& v) {
    return step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 0}, v), asking_for<2>({4, 0}),
                                            asking_for<2>({0, 3}))
        .display;
  };
  EXPECT_EQ(display({-1, -1}), ph::display_class::exact);
  EXPECT_EQ(display({-1, 1}), ph::display_class::approximate);
  EXPECT_EQ(display({1, 1}), ph::display_class::none);
}

// The angle to the wall that demands most, also where the elbow is all but straight and rounding decides what
// brakes can do, and of opposed walls, where its cosine may round over 1.
TEST(several_contacts, tell_the_angle_of_the_force_that_they_tell) {
  using M = ph::tendon_two_link<double>;
  ph::testing::random_source random(seed);
  int displayed = 0;
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    const auto state = state_of<M>({random.uniform(-3.0, 3.0), k % 4 == 0 ? 1.0 : random.wide(1e-17, 1e-3)},
                                   {random.wide(0.1, 3.0), random.wide(0.1, 3.0)});
    const ph::point<2> n = random.direction<double, 2>();
    const ph::point<2> other = k % 4 == 0 ? ph::point<2>(-n) : random.direction<double, 2>();
    const auto result =
        step_once<ph::no_direct_control>(M(), {}, state, asking_for<2>(random.positive(10.0, 20.0) * n),
                                         asking_for<2>(random.positive(1.0, 9.0) * other));
    if (result.outcome != ph::status::ok || !ph::is_displayed(result.display)) continue;
    ++displayed;
    ASSERT_FALSE(std::isnan(result.approximation_angle()));
    const double cosine = result.control_force.dot(n) / result.control_force.stableNorm();
    ASSERT_NEAR(result.approximation_cosine, std::max(cosine, 0.0),
                1e3 * std::numeric_limits<double>::epsilon());
  }
  EXPECT_GT(displayed, 250);
}

// A pose without a Jacobian, and a rate that overflows on its way to the brakes: by the law of torques, too.
TEST(several_contacts, release_the_brakes_where_pose_or_rates_are_undefined) {
  using arm = ph::tendon_two_link<double>;
  const double most = std::numeric_limits<double>::max();  // w2 = qd1 + qd2 / 0.4
  const auto expect_none = [](const auto& result) {
    EXPECT_EQ(result.outcome, ph::status::pose_undefined);
    EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
  };
  const auto a = asking_for<2>({1, 0}), b = asking_for<2>({0, 2});
  const auto nowhere = state_of<hyperbola<double>>({0, 1}, {1, 1});
  const auto too_fast = state_of<arm>({2, -1}, {0, most});
  expect_none(step_once<ph::no_direct_control>(hyperbola<double>(), {}, nowhere, a, b));
  expect_none(step_once<strong_torques>(hyperbola<double>(), {}, nowhere, a));
  expect_none(step_once<strong_torques>(hyperbola<double>(), {}, nowhere, a, b));
  expect_none(step_once<ph::no_direct_control>(arm(), {}, too_fast, a));
  expect_none(step_once<ph::no_direct_control>(arm(), {}, too_fast, a, b));
  expect_none(step_once<strong_torques>(arm(), {}, too_fast, b));
}

}  // namespace
