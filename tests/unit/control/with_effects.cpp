// What goes into a controller with_effects: end stops, faults, rest.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <algorithm>
#include <limits>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ph::viscous_field<double, 2> honey(double viscosity) {
  return ph::viscous_field<double, 2>({.viscosity = viscosity * ph::matrix<double, 2, 2>::Identity()});
}

// ---- End stops

TEST(end_stops_in_a_cycle, have_their_torques_where_the_brakes_can) {
  using M = ph::tendon_two_link<double>;
  const ph::end_stops<double, 2> stops({.upper = {0.5, 1.5}, .stiffness = {10, 20}});
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(100);
  brakes.rate_dead_band.setConstant(1e-9);
  ph::controller control(M(), brakes, ph::with_effects(ph::no_walls<2>(), stops), ph::direct_control());
  ph::device_state<M> state{0, {0.6, 1.0}, {1, 0}, {0, 0}};
  const auto joint_torque = [&](const auto& result) {
    return ph::vector<double, 2>(M().transmission().transpose() * result.torque);
  };
  EXPECT_EQ(control(state).effect_torque, (stops.torque(state.q, state.qd)));
  EXPECT_NEAR(joint_torque(control(state))[0], -1, 1e-12);
  state.qd = {-1, 0};  // the way back is free
  EXPECT_TRUE(control(state).capacity.isZero(0));
  state = {0, {0.6, 1.6}, {1, 3}, {0, 0}};
  expect_near(joint_torque(control(state)), ph::vector<double, 2>(-1, -2), 4);
  state.q = {0.4, 1.4};
  EXPECT_TRUE(control(state).capacity.isZero(0));
}

const ph::wall the_floor(ph::half_space<2>({0, 0}, {0, 1}), 5e3);

TEST(with_effects, lets_an_effect_be_changed_between_cycles) {
  using M = ph::xy_table<double>;
  ph::controller control(M(), ph::unlimited_brakes(), ph::with_effects(ph::no_walls<2>(), honey(1)),
                         ph::direct_control());
  const ph::device_state<M> state{0, {0, 0}, {1, 0}, {0, 0}};
  EXPECT_EQ(control(state).torque[0], -1);
  EXPECT_EQ(control(state).effect_force, ph::point<2>(-1, 0));
  control.scene().effect<0>() = honey(3);
  EXPECT_EQ(control(state).torque[0], -3);
}

// ---- What goes wrong

// An effect that fails at x > 0.
struct failing {
  using scalar = double;
  static constexpr int dimension = 2;
  ph::vector<double, 2> force(const ph::vector<double, 2>& x, const ph::vector<double, 2>&,
                              const ph::vector<double, 2>&) const {
    return ph::vector<double, 2>::Constant(x[0] > 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0);
  }
};

TEST(with_effects, releases_the_brakes_where_an_effect_is_no_number) {
  using M = ph::xy_table<double>;
  for (const double y : {-1e-3, 1.0}) {  // beside a wall and without
    ph::controller control(M(), ph::brakes_of<M>(), ph::with_effects(ph::scene(the_floor), failing()),
                           ph::direct_control());
    EXPECT_EQ(control(ph::device_state<M>{0, {-1, y}, {1, -1}, {0, 0}}).outcome, ph::status::ok);
    const auto result = control(ph::device_state<M>{0, {1, y}, {1, -1}, {0, 0}});
    EXPECT_EQ(result.outcome, ph::status::result_not_finite);
    EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
    EXPECT_EQ(control.command(ph::device_state<M>{0, {1, y}, {1, -1}, {0, 0}}).outcome,
              ph::status::result_not_finite);
  }
}

// ---- At rest

TEST(effects_at_rest, hold_against_a_push_up_to_their_strength) {
  using M = ph::xy_table<double>;
  const ph::detents<double, 2> knob({.spacing = 0.08, .strength = 3});
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(50);
  ph::controller control(M(), brakes, ph::with_effects(ph::no_walls<2>(), knob), ph::direct_control());
  for (const double push : {2.0, 7.0}) {
    const auto result = control(ph::device_state<M>{0, {0.02, 0}, {0, 0}, {push, 0}});
    EXPECT_NEAR(result.torque[0], -std::min(push, 3.0), 1e-12);
    EXPECT_EQ(result.torque[1], 0);
  }
}

}  // namespace
