// A planar arm of four joints.
#include "arm_run.hpp"

namespace experiments {

void follow_with_4r(std::vector<arm_row>& rows, arm_extent extent) {
  const arm_kind four{"4R", planar_rods<4>({0.12, 0.12, 0.1, 0.08})};
  add_default_forces(rows, four, extent);
  add_other_forces(rows, four, ph::inertial(four.arm), "inertial", extent);
  add_other_forces(rows, four, ph::kinetostatic(four.arm), "kinetostatic", extent);
}

}  // namespace experiments
