// slow
// What is said about wrong parameters.
#include "../support.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

// A field that has to be > 0, >= 0, or merely finite.
enum class rule { positive, not_negative, finite };

// For each value that breaks the rule, validate() names the parameter, the value and what is expected, and
// the constructor throws the same text. At the edge of the rule neither complains.
template <class Parameters, class Field, class Construct>
void expect_rule(const Parameters& good, Field&& field, const std::string& name, rule r,
                 Construct&& construct) {
  SCOPED_TRACE(name);
  Parameters p = good;
  using T = std::remove_reference_t<decltype(field(p))>;
  constexpr T infinity = std::numeric_limits<T>::infinity();
  std::vector<std::pair<T, std::string>> wrong{
      {std::numeric_limits<T>::quiet_NaN(), "nan"}, {infinity, "inf"}, {-infinity, "-inf"}};
  if (r != rule::finite) wrong.emplace_back(T(-0.5), "-0.5");
  if (r == rule::positive) wrong.emplace_back(T(0), "0");
  const std::string expected = r == rule::positive ? "a finite number > 0"
                               : r == rule::finite ? "a finite number"
                                                   : "a finite number >= 0";
  for (const auto& [value, text] : wrong) {
    field(p) = value;
    const std::string error = name + " = " + text + ", expected " + expected;
    EXPECT_EQ(validate(p), error);
    EXPECT_EQ(thrown_by([&] { construct(p); }), "passive_haptics: " + error);
  }
  for (const T fine :
       {r == rule::positive ? std::numeric_limits<T>::min() : T(0), T(3), r == rule::finite ? T(-3) : T(7)}) {
    field(p) = fine;
    EXPECT_EQ(validate(p), "") << fine;
    EXPECT_EQ(thrown_by([&] { construct(p); }), "nothing") << fine;
  }
}

template <class T>
struct parameters : ::testing::Test {};
TYPED_TEST_SUITE(parameters, scalars);

TYPED_TEST(parameters, of_two_links_are_checked) {
  using P = ph::two_link_parameters<TypeParam>;
  const auto construct = [](const P& p) { ph::two_link<TypeParam>{p}; };
  const auto expect = [&](auto&& field, const char* name, rule r) {
    expect_rule(P(), field, name, r, construct);
  };
  expect([](P& p) -> auto& { return p.length_1; }, "length_1 [m]", rule::positive);
  expect([](P& p) -> auto& { return p.length_2; }, "length_2 [m]", rule::positive);
  expect([](P& p) -> auto& { return p.mass_1; }, "mass_1 [kg]", rule::positive);
  expect([](P& p) -> auto& { return p.mass_2; }, "mass_2 [kg]", rule::positive);
  expect([](P& p) -> auto& { return p.handle_mass; }, "handle_mass [kg]", rule::not_negative);
  expect([](P& p) -> auto& { return p.rotor_inertia_1; }, "rotor_inertia_1 [kg m^2]", rule::not_negative);
  expect([](P& p) -> auto& { return p.rotor_inertia_2; }, "rotor_inertia_2 [kg m^2]", rule::not_negative);
}

TYPED_TEST(parameters, of_the_tendon_device_are_checked) {
  using P = ph::tendon_two_link_parameters<TypeParam>;
  const auto construct = [](const P& p) { ph::tendon_two_link<TypeParam>{p}; };
  expect_rule(P(), [](P& p) -> auto& { return p.reduction_2; }, "reduction_2 [1]", rule::positive, construct);
  expect_rule(P(), [](P& p) -> auto& { return p.length_2; }, "length_2 [m]", rule::positive, construct);
}

TEST(parameters_of_a_mechanism, are_given_by_their_names) {
  EXPECT_EQ(ph::two_link<double>({.length_1 = 0.2}).parameters().length_1, 0.2);
  EXPECT_EQ(ph::tendon_two_link<double>({.length_1 = 0.2, .reduction_2 = 1}).parameters().length_1, 0.2);
  EXPECT_EQ(ph::xy_table<double>({.mass_x = 3}).mass_matrix({0, 0}).diagonal()[0], 3);
  EXPECT_EQ(ph::five_bar<double>({.proximal_1 = 0.12}).parameters().proximal_1, 0.12);
  EXPECT_EQ(ph::delta<double>({.upper_arm = 0.12}).parameters().upper_arm, 0.12);
}

TYPED_TEST(parameters, of_the_xy_table_are_checked) {
  using P = ph::xy_table_parameters<TypeParam>;
  const auto construct = [](const P& p) { ph::xy_table<TypeParam>{p}; };
  expect_rule(P(), [](P& p) -> auto& { return p.mass_x; }, "mass_x [kg]", rule::positive, construct);
  expect_rule(P(), [](P& p) -> auto& { return p.mass_y; }, "mass_y [kg]", rule::positive, construct);
}

TYPED_TEST(parameters, of_the_brakes_are_checked_one_by_one) {
  using M = ph::xy_table<TypeParam>;
  using P = ph::brakes_of<M>;
  const auto controller = [](const P& p) {
    ph::controller(M(), p, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))), ph::no_direct_control{});
  };
  const auto device = [](const P& p) { ph::simulated_device<M>(M(), p, TypeParam(0), {0, 0}); };
  for (int i = 0; i < 2; ++i) {
    const std::string n = "[" + std::to_string(i) + "]";
    const auto expect = [&](auto&& field, const std::string& name) {
      expect_rule(P(), field, name, rule::not_negative, controller);
      expect_rule(P(), field, name, rule::not_negative, device);
    };
    expect([i](P& p) -> auto& { return p.torque_limit[i]; }, "torque_limit" + n + " [N m]");
    expect([i](P& p) -> auto& { return p.rate_dead_band[i]; }, "rate_dead_band" + n + " [rad/s]");
    expect([i](P& p) -> auto& { return p.torque_dead_band[i]; }, "torque_dead_band" + n + " [N m]");
    expect([i](P& p) -> auto& { return p.time_constant[i]; }, "time_constant" + n + " [s]");
  }
}

TYPED_TEST(parameters, of_the_approximation_are_checked) {
  using T = TypeParam;
  for (const T angle : {T(0), T(-1), T(1.5708), T(2), std::numeric_limits<T>::quiet_NaN(),
                        std::numeric_limits<T>::infinity()}) {
    const ph::approximation_parameters<T> p{angle};
    const std::string text = validate(p);
    EXPECT_TRUE(text.starts_with("max_approximation_angle [rad] = ")) << text;
    EXPECT_TRUE(text.ends_with(", expected an angle > 0 and <= pi/2")) << text;
    EXPECT_EQ(thrown_by([&] { ph::step_options<T>{p}; }), "passive_haptics: " + text);
  }
  for (const T angle : {T(0.01), T(1.57), ph::radians(T(90))})
    EXPECT_EQ(validate(ph::approximation_parameters<T>{angle}), "");
  EXPECT_EQ(validate(ph::approximation_parameters<T>()), "");
  const T none = ph::step_options<T>(ph::approximation_parameters<T>{ph::radians(T(90))}).min_cosine;
  EXPECT_TRUE(0 <= none && none < std::numeric_limits<T>::epsilon());
}

TYPED_TEST(parameters, of_the_hand_are_checked) {
  using P = ph::following_hand_parameters<TypeParam>;
  const auto construct = [](const P& p) { ph::following_hand<TypeParam, 2>({1, 0}, {0, 0}, p); };
  const auto expect = [&](auto&& field, const char* name, rule r) {
    expect_rule(P(), field, name, r, construct);
  };
  expect([](P& p) -> auto& { return p.speed; }, "speed [m/s]", rule::finite);
  expect([](P& p) -> auto& { return p.stiffness; }, "stiffness [N/m]", rule::not_negative);
  expect([](P& p) -> auto& { return p.damping; }, "damping [N s/m]", rule::not_negative);
  expect([](P& p) -> auto& { return p.push; }, "push [N]", rule::finite);
  expect([](P& p) -> auto& { return p.normal_damping; }, "normal_damping [N s/m]", rule::not_negative);
  expect([](P& p) -> auto& { return p.mass; }, "mass [kg]", rule::not_negative);
}

TYPED_TEST(parameters, a_simulated_hand_may_not_weigh_less_than_nothing) {
  using T = TypeParam;
  const auto device = [](T mass) {
    return thrown_by([&] { ph::simulated_device<ph::xy_table<T>>(ph::xy_table<T>(), {}, mass, {0, 0}); });
  };
  EXPECT_EQ(device(T(-0.5)), "passive_haptics: hand_mass [kg] = -0.5, expected a finite number >= 0");
  EXPECT_NE(device(std::numeric_limits<T>::quiet_NaN()), "nothing");
  EXPECT_EQ(device(T(0)), "nothing");
}

TEST(parameters_of_walls, balls_need_a_finite_centre_and_a_positive_radius) {
  using P = ph::ball_parameters<2>;
  const auto construct = [](const P& p) { ph::disc{p}; };
  expect_rule(
      P{.centre = {0, 0}, .radius = 1}, [](P& p) -> auto& { return p.radius; }, "radius of a ball [m]",
      rule::positive, construct);
  for (int i = 0; i < 2; ++i) {
    P p{.centre = {0, 0}, .radius = 1};
    p.centre[i] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(validate(p), "centre[" + std::to_string(i) + "] of a ball [m] = inf, expected a finite number");
    EXPECT_EQ(thrown_by([&] { construct(p); }), "passive_haptics: " + validate(p));
  }
}

TEST(parameters_of_walls, planes_need_a_finite_point_and_a_direction) {
  using P = ph::half_space_parameters<3>;
  const auto construct = [](const P& p) { ph::half_space<3>{p}; };
  const auto expect = [&](const P& p, const std::string& text) {
    EXPECT_EQ(validate(p), text);
    EXPECT_EQ(thrown_by([&] { construct(p); }), "passive_haptics: " + text);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect({{0, nan, 0}, {0, 0, 1}}, "surface_point[1] of a half_space [m] = nan, expected a finite number");
  expect({{0, 0, 0}, {0, 0, 0}}, "|normal| of a half_space = 0, expected a direction");
  expect({{0, 0, 0}, {0, nan, 1}}, "|normal| of a half_space = nan, expected a direction");
  // Any length will do
  for (const double length : {1e-300, 1e-3, 1.0, 1e300}) {
    EXPECT_EQ(ph::half_space<3>({0, 0, 0}, {0, 0, length}).gradient({0, 0, 0}), ph::point<3>(0, 0, 1))
        << length;
  }
}

TEST(parameters_of_walls, stiffness_and_period_are_not_negative) {
  const ph::half_space<2> plane({0, 0}, {0, 1});
  EXPECT_EQ(thrown_by([&] { ph::wall(plane, -1.0); }),
            "passive_haptics: stiffness of a wall [N/m] = -1, expected a finite number >= 0");
  EXPECT_EQ(thrown_by([&] { ph::wall(plane, 0.0); }), "nothing");
  EXPECT_EQ(ph::wall(plane).stiffness(), 1e7);
  const auto hold = [&](double period) {
    return thrown_by([&] { ph::held_scene(ph::scene(ph::wall(plane)), period); });
  };
  EXPECT_EQ(hold(-1), "passive_haptics: period of a held_scene [s] = -1, expected a finite number >= 0");
  EXPECT_EQ(hold(std::numeric_limits<double>::infinity()),
            "passive_haptics: period of a held_scene [s] = inf, expected a finite number >= 0");
  EXPECT_EQ(hold(0), "nothing");
}

TEST(parameters_of_experiments, are_checked) {
  using P = ph::wall_following_parameters;
  P slow;
  slow.control_period = 10;
  const auto expect = [&](auto&& field, const char* name, rule r) {
    expect_rule(slow, field, name, r, [](const P& p) { ph::require_valid(p); });
  };
  expect([](P& p) -> auto& { return p.time_step; }, "time_step [s]", rule::positive);
  expect([](P& p) -> auto& { return p.sensor_corner; }, "sensor_corner [Hz]", rule::not_negative);
  expect([](P& p) -> auto& { return p.sensor_noise; }, "sensor_noise [N]", rule::not_negative);
  expect([](P& p) -> auto& { return p.encoder_resolution; }, "encoder_resolution [rad or m]",
         rule::not_negative);
  expect([](P& p) -> auto& { return p.rate_corner; }, "rate_corner [Hz]", rule::not_negative);
  expect([](P& p) -> auto& { return p.path_end; }, "path_end [m]", rule::finite);
  expect([](P& p) -> auto& { return p.max_duration; }, "max_duration [s]", rule::positive);

  P fast;
  fast.control_period = fast.time_step / 2;
  EXPECT_EQ(validate(fast), "control_period [s] is shorter than time_step, expected a multiple of it");
  fast.control_period = 0;
  EXPECT_EQ(validate(fast), "control_period [s] = 0, expected a finite number > 0");
  using M = ph::xy_table<double>;
  ph::simulated_device<M> device(M(), {}, 0, {1, 0});
  const auto idle = [](const ph::device_state<M>&) { return ph::step_result<M>(); };
  const ph::following_hand<double, 2> hand({1, 0}, {1, 0});
  EXPECT_EQ(thrown_by([&] { ph::follow_wall(device, idle, ph::half_space<2>({0, 0}, {0, 1}), hand, fast); }),
            "passive_haptics: " + validate(fast));
}

}  // namespace
