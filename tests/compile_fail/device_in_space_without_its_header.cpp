// expect: passive_haptics: forces in space, and of three or more brakes in the plane, need
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;

struct gantry {
  using scalar = double;
  static constexpr int dof = 3, task_dimension = 3, brake_count = 3;
  ph::vector<double, 3> position(const ph::vector<double, 3>& q) const { return q; }
  ph::matrix<double, 3, 3> jacobian(const ph::vector<double, 3>&) const {
    return ph::matrix<double, 3, 3>::Identity();
  }
};

int main() {
  ph::controller control(gantry(), ph::brakes_of<gantry>(),
                         ph::scene(ph::wall(ph::half_space<3>({0, 0, 0}, {0, 0, 1}))), ph::direct_control{});
  control(ph::device_state<gantry>());
}
