// One control cycle of the paper's device under LAW on a microcontroller: what it takes of flash, and how
// many instructions.
#include "output.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <cstdint>

namespace ph = passive_haptics;

#if !defined(SCALAR)
#define SCALAR double
#endif
#if !defined(LAW)
#define LAW direct_control
#endif

namespace {

using device = ph::tendon_two_link<SCALAR>;

// SysTick counts the core's clock, 25 MHz, down; under QEMU's -icount shift=0 an instruction takes a
// nanosecond.
struct clock {
  volatile std::uint32_t ctrl, load, val;
};
clock& systick() { return *reinterpret_cast<clock*>(0xE000'E010); }
constexpr std::uint32_t longest = 0xFFFFFF;
constexpr int instructions_per_tick = 40, rounds = 64;

// So that nothing is computed by the compiler
volatile SCALAR sensors[] = {SCALAR(0.6), SCALAR(0.9), SCALAR(-0.3), SCALAR(-0.4), SCALAR(0.8), SCALAR(1.5)};
volatile SCALAR currents[2];
volatile double times[rounds];  // [s]

}  // namespace

int main(int, char**) {
  const ph::half_space<2> plane({0, 0.225}, {0, -1});
  ph::controller control(device(), ph::brakes_of<device>(), ph::scene(ph::wall(plane)), ph::LAW());
  for (int k = 0; k < rounds; ++k) times[k] = 1e-3 * k;
  systick().load = longest;
  systick().val = 0;
  systick().ctrl = 5;
  const std::uint32_t before = systick().val;
  for (int k = 0; k < rounds; ++k) {
    ph::device_state<device> state;
    state.time = times[k];
    state.q = {sensors[0], sensors[1]};
    state.qd = {sensors[2], sensors[3]};
    state.hand_force = {sensors[4], sensors[5]};
    const auto command = control.command(state);
    currents[0] = command.capacity[0];
    currents[1] = command.capacity[1];
  }
  const auto ticks = static_cast<int>((before - systick().val) & longest);
  output::line("instructions a cycle:") << ticks * instructions_per_tick / rounds;
  output::line("capacities:") << SCALAR(currents[0]) << SCALAR(currents[1]);
}
