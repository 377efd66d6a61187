// A scene that another thread publishes: the latest, whole, not too old, with what the loop knew of the
// handle.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ph = passive_haptics;

namespace {

using M = ph::xy_table<double>;
const ph::point<2> up{0, 1};

// Free above the height y.
auto floor_at(double y) { return ph::scene(ph::wall(ph::half_space<2>({0, y}, up), 1e4)); }
using floor_scene = decltype(floor_at(0));

ph::device_state<M> falling(double y, double time) {
  return {.time = time, .q = {0, y}, .qd = {0, -0.1}, .hand_force = {0, -1}};
}

TEST(a_latest_scene, that_is_out_of_date_releases_the_brakes_and_says_so) {
  ph::scene_exchange<floor_scene> exchange(floor_at(0), 0.0);
  ph::controller control(M(), ph::brakes_of<M>(), ph::latest_scene(exchange, {.stale_after = 0.05}),
                         ph::direct_control());
  const auto braked = [&](double time) { return control(falling(-1e-3, time)); };
  EXPECT_GT(braked(0.0).capacity.norm(), 0);
  EXPECT_GT(braked(0.05).capacity.norm(), 0) << "as old as allowed";
  for (const double late : {0.051, 1.0, 1e9}) {
    EXPECT_EQ(braked(late).outcome, ph::status::scene_stale);
    EXPECT_EQ(braked(late).capacity.norm(), 0);
    EXPECT_EQ(control(falling(1.0, late)).outcome, ph::status::scene_stale) << "in free space, too";
  }
  exchange.publish(floor_at(0), 2.0);
  EXPECT_EQ(braked(2.01).outcome, ph::status::ok);
  EXPECT_GT(braked(2.01).capacity.norm(), 0);
  EXPECT_EQ(braked(1.99).outcome, ph::status::ok) << "published for a later cycle";
  EXPECT_EQ(braked(1.94).outcome, ph::status::scene_stale) << "too far in the future";
  exchange.publish(floor_at(0), 1.7e9);  // by the clock on the wall, not that of the states
  EXPECT_EQ(braked(2.02).outcome, ph::status::scene_stale);
  EXPECT_EQ(braked(2.02).capacity.norm(), 0);
  exchange.publish(floor_at(0), std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(braked(2.02).outcome, ph::status::scene_stale);
}

template <class Scene>
void expect_carried_on(const Scene& scene) {
  for (const bool asked : {false, true}) {
    ph::scene_exchange<Scene> exchange(scene, 1.0);
    ph::latest_scene latest(exchange, {.extrapolate = asked});
    for (const double time : {1.0, 1.04, 1.02}) {
      const double carried = asked ? 0.5 * (time - 1) : 0;
      const auto& touched = ph::sense(latest, ph::point<2>(0, 0.1), time);
      ASSERT_EQ(touched.size(), 1);
      EXPECT_NEAR(touched[0].depth, 0.1 + carried, 1e-15) << time;
      EXPECT_EQ(touched[0].wall_velocity, 0.5 * up);
    }
    EXPECT_NEAR(ph::sense(latest, ph::point<2>(0, 0.1), 9.0)[0].depth, asked ? 0.11 : 0.1, 1e-15)
        << "not further than its last cycle that was not too late";
  }
}

TEST(a_latest_scene, carries_moving_walls_on_only_if_asked) {
  auto inside = ph::scene(ph::wall(ph::offset(ph::moving(ph::moving(ph::half_space<2>({0, 0}, up))), 0.0)));
  inside.get<0>().shape.shape().shape().set_motion(0.2 * up, 0.5 * up);
  expect_carried_on(inside);

  ph::world_walls<2> walls;
  const int lid = walls.add_moving(ph::wall(ph::half_space<2>({0, 0}, up)));
  ph::world<2> world(walls);
  world.set_motion(lid, 0.2 * up, 0.5 * up);
  expect_carried_on(world);
}

TEST(a_latest_scene, gives_its_margin_to_each_scene_that_comes) {
  ph::scene_exchange<floor_scene> exchange(floor_at(0), 0.0);
  ph::latest_scene latest(exchange);
  latest.set_margin(3e-3);
  for (int k = 0; k < 5; ++k) {
    exchange.publish(floor_at(k), k);
    EXPECT_EQ(ph::sense(latest, ph::point<2>(0, k + 2e-3), k).size(), 1)
        << "2 mm before the touch, scene " << k;
  }
}

// Knows no more than its number and which scene it took over from.
struct numbered_scene {
  int number;
  int remembered = -1;
  void remember(const numbered_scene& other) { remembered = other.number; }
};

TEST(a_scene_exchange, leaves_the_scene_that_is_read_alone_until_it_is_updated) {
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  ph::scene_exchange<numbered_scene> exchange({0}, 0);
  int read = 0, before = -1, latest = 0;
  const auto check = [&] {
    ASSERT_EQ(exchange.scene().number, read) << "seed " << seed;
    ASSERT_EQ(exchange.scene().remembered, before) << "seed " << seed;
    ASSERT_EQ(exchange.time(), read) << "seed " << seed;
  };
  for (int k = 0; k < 1000; ++k) {
    if (k < 2 || random.coin()) {
      ++latest;
      exchange.publish({latest}, latest);
    } else {
      exchange.update();
      if (latest != read) before = read;
      read = latest;
    }
    check();
  }
}

// A scene that nothing can be asked but what it touches.
struct bare {
  static constexpr int dimension = 2;
  using contacts_type = ph::contacts<2, 1>;
  double depth = 0;
  contacts_type touched_at(const ph::point<2>&) const {
    contacts_type touched;
    touched.push_back({.depth = depth});
    return touched;
  }
};

TEST(a_latest_scene, may_be_one_that_can_only_be_sensed) {
  ph::scene_exchange<bare> exchange(bare{1}, 0.0);
  ph::latest_scene latest(exchange);
  EXPECT_EQ(scene_status(latest), ph::status::ok) << "before anything is sensed";
  EXPECT_EQ(ph::sense(latest, {0, 0}, 0.01)[0].depth, 1);
  exchange.publish(bare{2}, 0.02);
  EXPECT_EQ(ph::sense(latest, {0, 0}, 0.02)[0].depth, 2);
}

struct stale_itself : bare {
  friend ph::status scene_status(const stale_itself&) { return ph::status::scene_stale; }
};

TEST(a_latest_scene, is_stale_if_its_scene_is) {
  ph::scene_exchange<stale_itself> exchange(stale_itself(), 0.0);
  EXPECT_EQ(scene_status(ph::latest_scene(exchange)), ph::status::scene_stale);
  EXPECT_EQ(scene_status(ph::held_scene(stale_itself(), 0.05)), ph::status::scene_stale);
}

TEST(a_latest_scene, refuses_parameters_that_it_cannot_follow) {
  ph::scene_exchange<floor_scene> exchange(floor_at(0), 0.0);
  for (const double bad : {0.0, -1.0, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(ph::latest_scene(exchange, {.stale_after = bad}), std::invalid_argument);
  ph::scene_exchange<bare> plain(bare{}, 0.0);
  EXPECT_NO_THROW(ph::latest_scene{plain});
  EXPECT_THROW(ph::latest_scene(plain, {.extrapolate = true}), std::invalid_argument);
}

// A sheet that the handle has been pushed through must hold it when the scene is exchanged, also where it
// begins to move or ceases to. Another mesh has nothing to remember.
TEST(a_latest_scene, keeps_the_handle_on_its_side_of_a_thin_wall) {
  const ph::mesh_parameters<2> line{.vertices = {{-1, 0}, {1, 0}}, .facets = {{1, 0}}};
  const ph::any_wall<2> sheet = ph::wall(ph::mesh_surface<2>(ph::mesh<2>(line)));
  ph::world_walls<2> still, moving, other;
  still.add(sheet);
  moving.add_moving(sheet);
  other.add_moving(ph::wall(ph::mesh_surface<2>(ph::mesh<2>(line))));
  const ph::point<2> front(0.1, 0.01), back(0.1, -0.01);
  for (const bool moves_first : {false, true}) {
    ph::scene_exchange<ph::world<2>> exchange(ph::world<2>(moves_first ? moving : still), 0.0);
    ph::latest_scene latest(exchange);
    EXPECT_TRUE(ph::sense(latest, front, 0.0).empty());
    for (int k = 1; k < 20; ++k) {
      const double time = 1e-3 * k;
      if (k % 7 == 0) {
        const bool moves = (k % 2 == 0) == moves_first;
        ph::world<2> next(moves ? moving : still);
        next.set_motion(0, {time, 0}, {1, 0});
        exchange.publish(next, time);
      }
      ASSERT_EQ(ph::sense(latest, back, time).size(), 1) << "cycle " << k;
      EXPECT_NEAR(ph::sense(latest, back, time)[0].depth, 0.01, 1e-9);
    }
    exchange.publish(ph::world<2>(other), 0.02);
    EXPECT_TRUE(ph::sense(latest, back, 0.02).empty());
  }
}

// As many walls that remember as there are of either kind.
TEST(a_world, remembers_nothing_of_a_world_of_nothing) {
  const ph::mesh_parameters<2> line{.vertices = {{-1, 0}, {1, 0}}, .facets = {{1, 0}}};
  ph::world_walls<2> walls;
  walls.add_moving(ph::wall(ph::mesh_surface<2>(ph::mesh<2>(line))));
  ph::world<2> sheet(walls), empty{ph::world_walls<2>()};
  ph::sense(sheet, {0.1, 0.01});
  EXPECT_EQ(ph::sense(sheet, {0.1, -0.01}).size(), 1);
  empty.remember(sheet);
  EXPECT_TRUE(ph::sense(empty, {0.1, -0.01}).empty());
  sheet.remember(empty);
  EXPECT_EQ(ph::sense(sheet, {0.1, -0.01}).size(), 1);
}

}  // namespace
