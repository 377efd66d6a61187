// slow, no sanitizers
// A control loop against a thread that owns its scene: every snapshot is whole, the loop allocates nothing
// and never waits. Built with ThreadSanitizer, where the compiler has it.
#include "allocations.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>
#include <passive_haptics/scene/world/world.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

namespace {

namespace ph = passive_haptics;
using M = ph::xy_table<double>;
constexpr int loop_steps = 2'000'000;

// Number `generation` of a scene: both floors are as deep as that number, so that a half-exchanged scene
// would show.
ph::world<2> scene_of(long generation) {
  const double height = 1e-3 * static_cast<double>(generation % 97 + 1);
  ph::world_walls<2> walls;
  for (int i = 0; i < 40; ++i) walls.add(ph::wall(ph::ball<2>({1 + 0.1 * i, 0.5}, 0.01)));
  walls.add(ph::wall(ph::half_space<2>({0, height}, {0, 1}), 1e4));
  const int lid = walls.add_moving(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e4));
  ph::world<2> world(walls);
  world.set_motion(lid, {0, height}, {0, height});
  return world;
}

TEST(a_loop_and_a_scene_thread, share_whole_scenes_without_waiting) {
  ph::scene_exchange<ph::world<2>> exchange(scene_of(0), 0.0);
  std::atomic<bool> done = false;
  std::atomic<double> now = 0;
  long published = 0;
  std::thread owner([&] {
    while (!done) {
      exchange.publish(scene_of(++published), now);
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  });
  ph::controller control(M(), ph::brakes_of<M>(),
                         ph::latest_scene(exchange, {.stale_after = 1e9, .extrapolate = false}),
                         ph::direct_control());
  ph::latest_scene direct(exchange, {.stale_after = 1e9});

  long torn = 0, unbraked = 0, seen = 0;
  double last = 0;
  ph::device_state<M> state{.time = 0, .q = {0, -1e-3}, .qd = {0.1, -0.1}, .hand_force = {0, -1}};
  const long allocated = allocations_in([&] {
    for (int k = 0; k < loop_steps; ++k) {
      state.time = 1e-3 * k;
      if (k % 1000 == 0) now = state.time;
      if (k % 10 == 0) {
        if (!(control(state).capacity.norm() > 0)) ++unbraked;
        continue;
      }
      if (k % 10 != 5) {
        if (!ph::sense(direct, ph::point<2>(0, 0.2 + 1e-9 * k), state.time).empty()) ++torn;
        continue;
      }
      const auto& touched = ph::sense(direct, ph::point<2>(0, -1e-3), state.time);
      const bool whole = touched.size() == 2 && touched[0].depth == touched[1].depth &&
                         std::abs(touched[1].wall_velocity.y() + 1e-3 - touched[1].depth) < 1e-12;
      if (!whole) ++torn;
      if (whole && touched[0].depth != last) ++seen;
      last = touched.empty() ? 0 : touched[0].depth;
    }
  });
  done = true;
  owner.join();
  std::printf("%d steps, %ld scenes published, %ld changes seen\n", loop_steps, published, seen);
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(unbraked, 0);
  EXPECT_EQ(allocated, 0) << "allocations and frees of the loop's thread";
  EXPECT_GT(seen, 100);
}

}  // namespace
