// expect: passive_haptics: the law must model ControlLaw
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct law {
  static constexpr bool needs_hand_force = false, needs_dynamics = false, needs_brake_lag = false;
};

int main() {
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(ph::wall(ph::disc({0, 0}, 1))), law{});
  control(ph::device_state<table>());
}
