// A planar arm of three joints, along planes and discs.
#include "arm_run.hpp"
#include "felt_forces.hpp"

namespace experiments {

void follow_with_3r(std::vector<arm_row>& rows) {
  arm_kind three{"3R", planar_rods<3>({0.15, 0.15, 0.1})};
  const auto add = [&](const char* name, arm_wall wall) {
    three.name = name;
    three.wall = wall;
    add_rows(rows, three);
  };
  add("3R", arm_wall::plane);
  add("3R, outside of a disc of 0.1 m", arm_wall::outside_of_disc);
  add("3R, inside of a disc of 0.3 m", arm_wall::inside_of_disc);
}

felt_row feel_3r(std::size_t states) { return feel(planar_rods<3>({0.15, 0.15, 0.1}), states); }

}  // namespace experiments
