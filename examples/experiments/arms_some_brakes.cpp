// Arms with brakes on some of their joints.
#include "arm_run.hpp"
#include "felt_forces.hpp"

namespace experiments {

namespace {
auto arm_with_two_brakes() { return with_brakes<0, 1>(planar_rods<3>({0.15, 0.15, 0.1})); }
}  // namespace

void follow_with_some_brakes(std::vector<arm_row>& rows) {
  add_rows(rows, arm_kind{"3R, brakes 1 and 2", arm_with_two_brakes()});
  if constexpr (built_extent == arm_extent::all) {
    add_rows(rows, arm_kind{"2R, brake 1", with_brakes<0>(planar_rods<2>({0.15, 0.15}))});
    add_rows(rows, arm_kind{"3R in space, brakes 1 and 2", with_brakes<0, 1>(spatial_rods<2>({0.2, 0.2}))});
  }
}

felt_row feel_two_brakes(std::size_t states) { return feel(arm_with_two_brakes(), states); }

}  // namespace experiments
