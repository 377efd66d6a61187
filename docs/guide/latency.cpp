#include <passive_haptics/testing/latency_of.hpp>

#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main(int argc, char** argv) {
  const device arm;
  const ph::half_space<2> top({0, 0.225}, {0, -1});
  const ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(top)), ph::direct_control());

  std::vector<ph::device_state<device>> states;  // those of your loop: here a glide along the wall
  for (int k = 0; k < 64; ++k) {
    auto& state = states.emplace_back();
    state.time = 1e-3 * k;
    state.q = arm.inverse({0.06 + 0.001 * k, 0.2251}, ph::elbow::left).q;
    state.qd = {0.2, -0.1 + 0.01 * k};
    state.hand_force = {0.8, 1.5};
  }
  ph::testing::latency_of("glide along the wall", control, states);

  benchmark::Initialize(&argc, argv);
  return benchmark::RunSpecifiedBenchmarks() == 3 ? 0 : 1;  // rows hot, chain and cold
}
