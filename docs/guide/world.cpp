#include <passive_haptics/passive_haptics.hpp>

#include <chrono>
#include <cmath>
#include <iostream>
#include <thread>

namespace ph = passive_haptics;
using device = ph::delta<double>;

ph::device_state<device> measured(double time);

int main() {
  ph::world_walls<3> walls;  // as many as you like, of any shapes
  for (int i = 0; i < 1000; ++i)
    walls.add(ph::wall(ph::ball<3>({0.01 * (i % 10), 0.01 * (i / 10 % 10), -0.3 - 0.01 * (i / 100)}, 0.003)));
  const int lid = walls.add_moving(ph::wall(ph::half_space<3>({0, 0, -0.4}, {0, 0, 1}), 1e5));
  const ph::world<3> world(walls);

  ph::controller single(device(), ph::brakes_of<device>(), world, ph::direct_control());
  std::cout << "capacities " << single(measured(0)).capacity.transpose() << " N m\n";

  // A slow thread that owns the scene, and a loop that never waits for it
  ph::scene_exchange<ph::world<3>> exchange(world, 0);
  ph::controller loop(device(), ph::brakes_of<device>(),
                      ph::latest_scene(exchange, {.stale_after = 0.1, .extrapolate = true}),
                      ph::direct_control());
  std::thread owner([&, next = world]() mutable {
    for (int frame = 1; frame <= 5; ++frame) {
      const double time = 0.02 * frame;
      next.set_motion(lid, {0, 0, 0.01 * std::sin(time)}, {0, 0, 0.01 * std::cos(time)});
      exchange.publish(next, time);  // on the clock of the loop's states
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  for (int cycle = 0; cycle < 100; ++cycle) loop(measured(1e-3 * cycle));
  owner.join();
  const auto late = loop(measured(1.0));
  std::cout << "a second later: " << to_string(late.outcome) << ", capacities " << late.capacity.transpose()
            << " N m\n";
  return late.outcome == ph::status::scene_stale ? 0 : 1;
}

ph::device_state<device> measured(double time) {
  return {.time = time, .q = {0.5, 0.5, 0.5}, .qd = {0.1, 0.1, 0.1}, .hand_force = {0, 0, -2}};
}
