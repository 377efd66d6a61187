#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <cstdio>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;  // the paper's device: two links of 0.15 m, both brakes at the base
  const ph::brakes_of<device> brakes;
  const ph::half_space<2> plane({0, 0.225}, {0, -1});  // a point of the surface [m], the way out of the wall
  ph::controller control(arm, brakes, ph::scene(ph::wall(plane)), ph::recommended_law(arm, brakes));

  const ph::vector<double, 2> start(0.05, 0.224);           // 1 mm before the wall [m]
  const ph::following_hand<double, 2> hand({1, 0}, start);  // moves with 5 cm/s and presses with 2 N
  ph::simulated_device plant(arm, brakes, hand.parameters().mass, arm.inverse(start, ph::elbow::left).q);

  for (int k = 0; k <= 2000; ++k) {  // a control loop of 1 kHz
    const ph::device_state<device> state{1e-3 * k, plant.q(), plant.qd(), plant.sensed_force()};
    const auto result = control(state);  // what the brakes may hold: result.capacity
    const double depth = -plane.distance(plant.position());
    const auto push = hand.force(state.time, plant.position(), plant.velocity(), {0, -1}, depth);
    plant.advance(1e-3, result.capacity, push);
    if (k % 400 == 0)
      std::printf("%.1f s: %2.0f mm along the wall, %5.2f mm deep, feels %.2f N\n", state.time,
                  1e3 * (plant.position() - start)[0], 1e3 * depth, state.hand_force[1]);
  }
}
