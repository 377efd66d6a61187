// expect: passive_haptics: redundant brakes, fewer brakes than joints and inertial forces need
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;
using device = ph::five_bar<double, 4>;

int main() {
  ph::controller control(device(), ph::brakes_of<device>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))), ph::direct_control{});
  control(ph::device_state<device>());
}
