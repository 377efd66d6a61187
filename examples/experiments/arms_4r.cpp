// A planar arm of four joints.
#include "arm_run.hpp"

namespace experiments {

void follow_with_4r(std::vector<arm_row>& rows) {
  add_rows(rows, arm_kind{"4R", planar_rods<4>({0.12, 0.12, 0.1, 0.08})});
}

}  // namespace experiments
