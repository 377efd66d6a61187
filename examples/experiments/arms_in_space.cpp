// A spatial arm of four joints: yaw, shoulder, elbow and wrist.
#include "arm_run.hpp"

namespace experiments {

void follow_with_4r_in_space(std::vector<arm_row>& rows) {
  add_rows(rows, arm_kind{"4R in space", spatial_rods<3>({0.2, 0.15, 0.1})});
}

}  // namespace experiments
