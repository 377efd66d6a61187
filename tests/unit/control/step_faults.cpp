// slow
// A number that is none, wherever it stands, releases the brakes and is named: every input, every law.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <limits>
#include <string>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double bad_numbers[] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};

// All that a step reads, such that every law brakes.
template <class M, int Walls>
struct inputs {
  using T = typename M::scalar;
  ph::device_state<M> state = state_of<M>({T(0.2), T(0.4)}, {T(0.3), T(2)}, {T(0.1), T(1)});
  ph::contact<2> walls[2] = {
      {.normal = {0, -1}, .depth = 4e-3, .stiffness = 1e3, .wall_number = 0, .sensed_at = {0, 0}},
      {.normal = {0.6, -0.8}, .depth = 3e-3, .stiffness = 1e3, .wall_number = 1, .sensed_at = {0, 0}}};
  ph::brakes_of<M> brakes = {};
  ph::step_options<T> options = {};

  template <class L>
  ph::step_result<M> step() const {
    ph::contacts<2, Walls> touched;
    for (int j = 0; j < Walls; ++j) touched.push_back(walls[j]);
    ph::step_memory<L> memory;
    return ph::step(M(), brakes, touched, L{}, state, memory, options);
  }
};

// Puts each bad number into each place that change(inputs, i, value) knows, i < places.
template <class L, class M, int Walls, class Change>
void expect_fault(ph::status expected, const char* where, int places, const Change& change) {
  for (int i = 0; i < places; ++i) {
    for (const double bad : bad_numbers) {
      inputs<M, Walls> in;
      change(in, i, bad);
      const auto result = in.template step<L>();
      EXPECT_EQ(result.outcome, expected)
          << where << ", place " << i << " = " << bad << ": " << to_string(result.outcome);
      EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0))
          << where << ", place " << i << " = " << bad;
    }
  }
}

template <class L, class M, int Walls>
void expect_faults() {
  using T = typename M::scalar;
  const auto as = [](double x) { return static_cast<T>(x); };
  const auto good = inputs<M, Walls>().template step<L>();
  EXPECT_EQ(good.outcome, ph::status::ok);
  EXPECT_GT(good.capacity.norm(), T(0));

  const auto state = ph::status::state_not_finite;
  expect_fault<L, M, Walls>(state, "q", 2, [&](auto& in, int i, double x) { in.state.q[i] = as(x); });
  expect_fault<L, M, Walls>(state, "qd", 2, [&](auto& in, int i, double x) { in.state.qd[i] = as(x); });
  expect_fault<L, M, Walls>(state, "hand force", 2,
                            [&](auto& in, int i, double x) { in.state.hand_force[i] = as(x); });
  expect_fault<L, M, Walls>(state, "time", 1, [](auto& in, int, double x) { in.state.time = x; });

  const auto contact = ph::status::contact_invalid;
  for (int j = 0; j < Walls; ++j) {
    expect_fault<L, M, Walls>(contact, "normal", 2,
                              [j](auto& in, int i, double x) { in.walls[j].normal[i] = x; });
    expect_fault<L, M, Walls>(contact, "depth", 1, [j](auto& in, int, double x) { in.walls[j].depth = x; });
    expect_fault<L, M, Walls>(contact, "stiffness", 1,
                              [j](auto& in, int, double x) { in.walls[j].stiffness = x; });
    expect_fault<L, M, Walls>(contact, "velocity of a wall", 2,
                              [j](auto& in, int i, double x) { in.walls[j].wall_velocity[i] = x; });
    expect_fault<L, M, Walls>(contact, "velocity of a wall that asks for nothing", 2,
                              [](auto& in, int i, double x) {
                                for (auto& wall : in.walls) wall.stiffness = 0;
                                in.walls[0].wall_velocity[i] = x;
                              });
  }
}

// A law of each pipeline.
TEST(a_step, names_every_number_that_is_none_in_state_and_contacts) {
  expect_faults<ph::direct_control, ph::xy_table<double>, 1>();
  expect_faults<ph::direct_control, ph::tendon_two_link<double>, 2>();
  expect_faults<ph::on_off_control, ph::tendon_two_link<double>, 1>();
  expect_faults<ph::velocity_direct_control, ph::tendon_two_link<float>, 2>();
}

// A limit or dead band below zero is none either.
TEST(a_step, refuses_brakes_and_options_that_are_none) {
  using M = ph::tendon_two_link<double>;
  const auto expect_refused = [](double bad, const auto& change) {
    inputs<M, 1> in;
    change(in);
    const auto result = in.template step<ph::velocity_direct_control>();
    EXPECT_EQ(result.outcome, ph::status::parameters_invalid) << bad;
    EXPECT_TRUE(result.capacity.isZero(0)) << bad;
  };
  for (int i = 0; i < 2; ++i) {
    for (const double bad : {bad_numbers[0], bad_numbers[1], bad_numbers[2], -1e-9}) {
      expect_refused(bad, [&](auto& in) { in.brakes.torque_limit[i] = bad; });
      expect_refused(bad, [&](auto& in) { in.brakes.rate_dead_band[i] = bad; });
      expect_refused(bad, [&](auto& in) { in.brakes.torque_dead_band[i] = bad; });
    }
    for (const double bad : bad_numbers)
      expect_refused(bad, [&](auto& in) { in.brakes.time_constant[i] = bad; });
  }
  for (const double bad : bad_numbers) expect_refused(bad, [&](auto& in) { in.options.min_cosine = bad; });
}

// Of a law that has parameters: each in turn, of itself or of its member `parameters`.
template <class P, class Step>
void expect_each_parameter_is_checked(P& parameters, const Step& step) {
  ph::for_each_member(parameters, [&]<class V>(const ph::member_description& about, V& value) {
    if constexpr (std::is_floating_point_v<V>) {
      const V good = value;
      for (const double bad : bad_numbers) {
        if (about.hard.contains(bad)) continue;
        value = static_cast<V>(bad);
        const auto result = step();
        EXPECT_EQ(result.outcome, ph::status::parameters_invalid) << about.name << " = " << bad;
        EXPECT_TRUE(result.capacity.isZero(0));
      }
      value = good;
    }
  });
  EXPECT_EQ(step().outcome, ph::status::ok);
}

template <class L, class Parameters>
void expect_parameters_are_checked(L& law, Parameters& parameters) {
  using M = ph::tendon_two_link<double>;
  const inputs<M, 1> in;
  ph::contacts<2, 1> touched;
  touched.push_back(in.walls[0]);
  expect_each_parameter_is_checked(parameters, [&] {
    ph::step_memory<L> memory;
    return ph::step(M(), in.brakes, touched, law, in.state, memory, in.options);
  });
}

TEST(a_step, refuses_a_law_whose_parameters_are_none) {
  ph::direct_control scaling;
  expect_parameters_are_checked(scaling, scaling);
  ph::on_off_control relay;
  expect_parameters_are_checked(relay, relay.parameters);
}

// A controller in contact: the same of the state, with and without a force sensor.
template <class State>
void expect_faults_of(State good) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  const ph::point<2> x = arm.position(good.q);
  const ph::half_space<2> wall(x + ph::point<2>(0, -4e-3), {0, -1});
  ph::controller control(arm, ph::brakes_of<M>(), ph::scene(ph::wall(wall, 1e3)), ph::no_direct_control{});
  const auto expect_fault = [&](auto change) {
    for (const double bad : bad_numbers) {
      State state = good;
      change(state, bad);
      const auto result = control(state);
      EXPECT_EQ(result.outcome, ph::status::state_not_finite);
      EXPECT_EQ(control.command(state).outcome, ph::status::state_not_finite);
      EXPECT_TRUE(result.capacity.isZero(0) && control.command(state).capacity.isZero(0));
    }
  };
  EXPECT_EQ(control(good).outcome, ph::status::ok);
  for (int i = 0; i < 2; ++i) {
    expect_fault([i](auto& s, double bad) { s.q[i] = bad; });
    expect_fault([i](auto& s, double bad) { s.qd[i] = bad; });
    if constexpr (requires { good.hand_force; })
      expect_fault([i](auto& s, double bad) { s.hand_force[i] = bad; });
  }
  expect_fault([](auto& s, double bad) { s.time = bad; });
}

TEST(a_controller, names_every_number_that_is_none_in_a_state_with_a_hand_force_or_without) {
  using M = ph::tendon_two_link<double>;
  expect_faults_of(state_of<M>({0.2, 0.4}, {-1, 2}, {0.1, -1}));
  expect_faults_of(ph::sensorless_device_state<M>{0.0, {0.2, 0.4}, {-1, 2}});
}

// x = 1e308 q overflows though q and J are finite.
struct long_slides {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return 1e308 * q; }
  ph::diagonal_matrix<double, 2> jacobian() const { return {1e308, 1e308}; }
};

// A scene that remembers what it was shown, as held_scene and world do.
struct remembering_scene {
  static constexpr int dimension = 2;
  using contacts_type = ph::contacts<2, 1>;
  contacts_type touched_at(const ph::point<2>& x) {
    last = x;
    return {};
  }
  ph::point<2> last = ph::point<2>::Zero();
};

TEST(a_position_that_is_not_finite, is_a_fault_where_a_wall_is_touched) {
  ph::contacts<2, 1> touched;
  const auto outcome = [&] {
    ph::step_memory<ph::no_direct_control> memory;
    return ph::step(long_slides{}, ph::brakes_of<long_slides>{}, touched, ph::no_direct_control(),
                    state_of<long_slides>({2, 0}, {0, 0}), memory)
        .outcome;
  };
  EXPECT_EQ(outcome(), ph::status::ok) << "free";
  touched.push_back({.normal = {0, 1}, .depth = 0, .stiffness = 1});
  EXPECT_EQ(outcome(), ph::status::pose_undefined);
}

TEST(a_position_that_is_not_finite, reaches_no_scene_that_remembers) {
  ph::controller control(long_slides{}, ph::brakes_of<long_slides>{}, remembering_scene{},
                         ph::no_direct_control());
  EXPECT_EQ(control(state_of<long_slides>({0.5, 0.5}, {0, 0})).outcome, ph::status::ok);
  EXPECT_EQ(control.scene().last, ph::point<2>(0.5e308, 0.5e308));
  EXPECT_EQ(control(state_of<long_slides>({2, 0}, {0, 0})).outcome, ph::status::pose_undefined);
  EXPECT_EQ(control.command(state_of<long_slides>({2, 0}, {0, 0})).outcome, ph::status::pose_undefined);
  EXPECT_EQ(control.scene().last, ph::point<2>(0.5e308, 0.5e308));
  static_assert(ph::RemembersHandle<ph::held_scene<ph::static_scene<ph::half_space<2>>>, 2>);
  static_assert(!ph::RemembersHandle<ph::static_scene<ph::half_space<2>>, 2>);
  static_assert(!ph::RemembersHandle<ph::contacts<2, 1>, 2>);
}

}  // namespace
