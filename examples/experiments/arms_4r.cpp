// A planar arm of four joints.
#include "arm_run.hpp"
#include "felt_forces.hpp"

namespace experiments {

namespace {
auto arm_4r() { return planar_rods<4>({0.12, 0.12, 0.1, 0.08}); }
}  // namespace

void follow_with_4r([[maybe_unused]] std::vector<arm_row>& rows) {
  if constexpr (built_extent == arm_extent::all) add_rows(rows, arm_kind{"4R", arm_4r()});
}

felt_row feel_4r(std::size_t states) { return feel(arm_4r(), states); }

}  // namespace experiments
