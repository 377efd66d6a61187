// expect: passive_haptics: forces in space, and of three or more brakes in the plane, need
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/adaptors/with_self_motion.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;

struct gantry_with_two_slides_along_x {
  using scalar = double;
  static constexpr int dof = 3, task_dimension = 2, brake_count = 3;
  ph::vector<double, 2> position(const ph::vector<double, 3>& q) const { return {q[0] + q[1], q[2]}; }
  ph::matrix<double, 2, 3> jacobian(const ph::vector<double, 3>&) const {
    return ph::matrix<double, 2, 3>{{1, 1, 0}, {0, 0, 1}};
  }
};

int main() {
  ph::controller control(ph::kinetostatic(gantry_with_two_slides_along_x()),
                         ph::brakes_of<gantry_with_two_slides_along_x>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))), ph::direct_control{});
  control(ph::device_state<gantry_with_two_slides_along_x>());
}
