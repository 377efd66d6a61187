// slow
// Wrong parameters: the constructor of each kind of thing checks them, in the words of validate(). The text
// of each range and place: parameter_tables.cpp.
#include "../support.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <limits>
#include <string>

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
using table = ph::xy_table<double>;
using plane = ph::half_space<2>;

// validate() finds this error, and what is made of the parameters throws it.
template <class Parameters, class Make>
void expect_error(const Parameters& wrong, const std::string& error, Make&& make) {
  EXPECT_EQ(validate(wrong), error);
  EXPECT_EQ(thrown_by([&] { make(wrong); }), "passive_haptics: " + error);
}

// A change of the default parameters, and its error.
template <class Parameters>
struct wrong {
  void (*change)(Parameters&);
  const char* error;
};
template <class Parameters, class Make>
void expect_errors(std::initializer_list<wrong<Parameters>> all, Make&& make) {
  EXPECT_EQ(thrown_by([&] { make(Parameters()); }), "nothing");
  for (const auto& [change, error] : all) {
    Parameters p;
    change(p);
    expect_error(p, error, make);
  }
}

TEST(parameters, of_two_links_are_checked) {
  using P = ph::two_link_parameters<double>;
  expect_errors<P>(
      {{[](P& p) { p.length_1 = 0; }, "length_1 [m] = 0: expected a finite number > 0"},
       {[](P& p) { p.mass_1 = nan; }, "mass_1 [kg] = nan: expected a finite number > 0"},
       {[](P& p) { p.handle_mass = -1; }, "handle_mass [kg] = -1: expected a finite number >= 0"},
       {[](P& p) { p.rotor_inertia_1 = -1; }, "rotor_inertia_1 [kg m^2] = -1: expected a finite number >= 0"},
       {[](P& p) { p.rotor_inertia_2 = -1; },
        "rotor_inertia_2 [kg m^2] = -1: expected a finite number >= 0"}},
      [](const P& p) { ph::two_link<double>{p}; });
}

TEST(parameters, of_other_mechanisms_are_checked) {
  using P = ph::tendon_two_link_parameters<double>;
  expect_errors<P>({{[](P& p) { p.reduction_2 = 0; }, "reduction_2 [1] = 0: expected a finite number > 0"}},
                   [](const P& p) { ph::tendon_two_link<double>{p}; });
  using Q = ph::xy_table_parameters<double>;
  expect_errors<Q>({{[](Q& p) { p.mass_x = 0; }, "mass_x [kg] = 0: expected a finite number > 0"},
                    {[](Q& p) { p.mass_y = 0; }, "mass_y [kg] = 0: expected a finite number > 0"}},
                   [](const Q& p) { table{p}; });
}

TEST(parameters, of_a_mechanism_are_given_by_their_names) {
  EXPECT_EQ(ph::two_link<double>({.length_1 = 0.2}).parameters().length_1, 0.2);
  EXPECT_EQ(ph::tendon_two_link<double>({.length_1 = 0.2, .reduction_2 = 1}).parameters().length_1, 0.2);
  EXPECT_EQ(table({.mass_x = 3}).mass_matrix({0, 0}).diagonal()[0], 3);
  EXPECT_EQ(ph::five_bar<double>({.proximal_1 = 0.12}).parameters().proximal_1, 0.12);
  EXPECT_EQ(ph::delta<double>({.upper_arm = 0.12}).parameters().upper_arm, 0.12);
}

TEST(parameters, of_the_brakes_are_checked_one_by_one) {
  using P = ph::brakes_of<table>;
  const auto scene = ph::scene(ph::wall(plane({0, 0}, {0, 1})));
  const auto expect = [&](std::initializer_list<wrong<P>> all) {
    expect_errors<P>(all, [&](const P& p) { ph::controller(table(), p, scene, ph::no_direct_control{}); });
    expect_errors<P>(all, [](const P& p) { ph::simulated_device<table>(table(), p, 0, {0, 0}); });
  };
  expect(
      {{[](P& p) { p.torque_limit[0] = -1; }, "torque_limit[0] [N m] = -1: expected a finite number >= 0"},
       {[](P& p) { p.rate_dead_band[1] = -1; },
        "rate_dead_band[1] [rad/s] = -1: expected a finite number >= 0"},
       {[](P& p) { p.torque_dead_band[0] = -1; },
        "torque_dead_band[0] [N m] = -1: expected a finite number >= 0"},
       {[](P& p) { p.time_constant[1] = -1; }, "time_constant[1] [s] = -1: expected a finite number >= 0"}});
}

template <class T>
struct approximation_parameters : ::testing::Test {};
TYPED_TEST_SUITE(approximation_parameters, scalars);

TYPED_TEST(approximation_parameters, are_checked) {
  using T = TypeParam;
  using P = ph::approximation_parameters<T>;
  for (const T angle : {T(0), T(-1), T(1.5708), std::numeric_limits<T>::quiet_NaN()}) {
    const std::string text = validate(P{angle});
    EXPECT_TRUE(text.starts_with("max_approximation_angle [rad] = ")) << text;
    EXPECT_TRUE(text.ends_with(": expected an angle > 0 and <= pi/2")) << text;
    EXPECT_EQ(thrown_by([&] { ph::step_options<T>{P{angle}}; }), "passive_haptics: " + text);
  }
  for (const T angle : {T(0.01), P().max_approximation_angle, ph::radians(T(90))})
    EXPECT_EQ(validate(P{angle}), "");
  const T none = ph::step_options<T>(P{ph::radians(T(90))}).min_cosine;
  EXPECT_TRUE(0 <= none && none < std::numeric_limits<T>::epsilon());
}

TEST(parameters, of_the_hand_are_checked) {
  using P = ph::following_hand_parameters<double>;
  expect_errors<P>(
      {{[](P& p) { p.speed = nan; }, "speed [m/s] = nan: expected a finite number"},
       {[](P& p) { p.stiffness = -1; }, "stiffness [N/m] = -1: expected a finite number >= 0"},
       {[](P& p) { p.damping = -1; }, "damping [N s/m] = -1: expected a finite number >= 0"},
       {[](P& p) { p.push = infinity; }, "push [N] = inf: expected a finite number"},
       {[](P& p) { p.normal_damping = -1; }, "normal_damping [N s/m] = -1: expected a finite number >= 0"},
       {[](P& p) { p.mass = -1; }, "mass [kg] = -1: expected a finite number >= 0"}},
      [](const P& p) { ph::following_hand<double, 2>({1, 0}, {0, 0}, p); });
  EXPECT_EQ(thrown_by([] { ph::simulated_device<table>(table(), {}, -0.5, {0, 0}); }),
            "passive_haptics: hand_mass [kg] = -0.5: expected a finite number >= 0");
}

TEST(parameters, of_balls_and_planes_are_checked) {
  using ball = ph::ball_parameters<2>;
  const auto disc = [](const ball& p) { ph::disc{p}; };
  expect_error(ball{{0, 0}, 0}, "radius of a ball [m] = 0: expected a finite number > 0", disc);
  expect_error(ball{{0, infinity}, 1}, "centre[1] of a ball [m] = inf: expected a finite number", disc);

  using P = ph::half_space_parameters<3>;
  const auto half_space = [](const P& p) { ph::half_space<3>{p}; };
  expect_error(P{{0, nan, 0}, {0, 0, 1}},
               "surface_point[1] of a half_space [m] = nan: expected a finite number", half_space);
  expect_error(P{{0, 0, 0}, {0, 0, 0}}, "|normal| of a half_space = 0: expected a direction", half_space);
  expect_error(P{{0, 0, 0}, {0, nan, 1}}, "|normal| of a half_space = nan: expected a direction", half_space);
  for (const double length : {1e-300, 1.0, 1e300})  // any will do
    EXPECT_EQ(ph::half_space<3>({0, 0, 0}, {0, 0, length}).gradient({0, 0, 0}), ph::point<3>(0, 0, 1));
}

TEST(parameters, of_walls_are_checked) {
  const plane flat({0, 0}, {0, 1});
  EXPECT_EQ(thrown_by([&] { ph::wall(flat, -1.0); }),
            "passive_haptics: stiffness of a wall [N/m] = -1: expected a finite number >= 0");
  EXPECT_EQ(thrown_by([&] { ph::wall(flat, 0.0); }), "nothing");
  EXPECT_EQ(ph::wall(flat).stiffness(), 1e7);
  const auto hold = [&](double period) {
    return thrown_by([&] { ph::held_scene(ph::scene(ph::wall(flat)), period); });
  };
  EXPECT_EQ(hold(-1), "passive_haptics: period of a held_scene [s] = -1: expected a finite number >= 0");
  EXPECT_EQ(hold(infinity),
            "passive_haptics: period of a held_scene [s] = inf: expected a finite number >= 0");
  EXPECT_EQ(hold(0), "nothing");
}

TEST(parameters, of_experiments_are_checked) {
  using P = ph::wall_following_parameters;
  const auto follow = [](const P& p) {
    ph::simulated_device<table> device(table(), {}, 0, {1, 0});
    const auto idle = [](const ph::device_state<table>&) { return ph::step_result<table>(); };
    const ph::following_hand<double, 2> hand({1, 0}, {1, 0});
    ph::follow_wall(device, idle, plane({0, 0}, {0, 1}), hand, p);
  };
  P p;
  p.control_period = p.time_step / 2;
  expect_error(p, "control_period [s] = 5e-5: expected at least time_step, 0.0001", follow);
  p = {}, p.control_period = 0;
  expect_error(p, "control_period [s] = 0: expected a finite number > 0", follow);
  p = {}, p.time_step = 0;
  expect_error(p, "time_step [s] = 0: expected a finite number > 0", follow);
  p = {}, p.encoder_resolution = -1;
  expect_error(p, "encoder_resolution [rad or m] = -1: expected a finite number >= 0", follow);
  p = {}, p.path_end = nan;
  expect_error(p, "path_end [m] = nan: expected a finite number", follow);
}

}  // namespace
