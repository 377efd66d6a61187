// expect: passive_haptics: this law locks brakes: give the brakes a torque_limit
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  ph::contacts<2, 1> touched;
  const ph::velocity_ratio_control law;
  ph::step_memory<ph::velocity_ratio_control> memory;
  ph::step(table(), ph::unlimited_brakes(), touched, law, ph::device_state<table>(), memory);
}
