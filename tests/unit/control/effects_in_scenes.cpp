// slow
// with_effects goes around every kind of scene.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>
#include <passive_haptics/scene/world/world.hpp>

namespace {

ph::viscous_field<double, 2> honey(double viscosity) {
  return ph::viscous_field<double, 2>({.viscosity = viscosity * ph::matrix<double, 2, 2>::Identity()});
}

const ph::wall the_floor(ph::half_space<2>({0, 0}, {0, 1}), 5e3);

TEST(with_effects, goes_around_every_scene) {
  using M = ph::xy_table<double>;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(50);
  const auto field = honey(10);
  const ph::device_state<M> inside{0, {0, -1e-3}, {0.1, -0.1}, {0, -1}},
      outside{0, {0, 1}, {0.1, -0.1}, {0, 0}};
  const auto expect_both = [&](auto scene) {
    ph::controller control(M(), brakes, ph::with_effects(scene, field), ph::direct_control());
    const auto felt = control(inside);
    EXPECT_EQ(felt.outcome, ph::status::ok);
    EXPECT_EQ(felt.wall_number, 0);
    expect_near(felt.torque, ph::vector<double, 2>(-1, 5), 5);
    EXPECT_EQ(control.command(inside).capacity, felt.capacity);
    control.reset();
    auto later = outside;
    later.time = 1;
    expect_near(control(later).torque, ph::vector<double, 2>(-1, 1), 1);
    EXPECT_EQ(control(later).wall_number, -1);
  };
  ph::world_walls<2> walls;
  walls.add(the_floor);
  ph::scene_exchange<ph::world<2>> exchange(ph::world<2>(walls), 0.0);
  expect_both(ph::scene(the_floor));
  expect_both(ph::scene(the_floor, ph::wall(ph::half_space<2>({0, 9}, {0, -1}))));
  expect_both(ph::held_scene(ph::scene(the_floor), 0.01));
  expect_both(ph::world<2>(walls));
  expect_both(ph::latest_scene(exchange, {.stale_after = 2}));
}

TEST(with_effects, says_what_its_scene_says) {
  using M = ph::xy_table<double>;
  ph::scene_exchange exchange(ph::scene(the_floor), 0.0);
  ph::controller control(M(), ph::brakes_of<M>(),
                         ph::with_effects(ph::latest_scene(exchange, {.stale_after = 0.1}), honey(1)),
                         ph::direct_control());
  EXPECT_EQ(control(ph::device_state<M>{0.05, {0, 1}, {1, 1}, {0, 0}}).outcome, ph::status::ok);
  EXPECT_EQ(control(ph::device_state<M>{0.2, {0, 1}, {1, 1}, {0, 0}}).outcome, ph::status::scene_stale);
}

}  // namespace
