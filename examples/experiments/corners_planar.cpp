// Planar devices with two brakes.
#include "corner_rows.hpp"

namespace experiments {

void add_planar_devices(corner_tables& tables) {
  using tendon = ph::tendon_two_link<double>;
  const corner_device<tendon> arm{"tendon", tendon(), {{-3.1, -2.9}, {3.1, -0.4}, 0.025, 1, 25}};
  add_device(tables, arm);
  using five_bar = ph::five_bar<double, 2>;
  add_device<five_bar>(tables, {"five-bar", five_bar(), {{1.5, 0}, {3.1, 1.6}, 0.015, 1, 25}});
  using xy_table = ph::xy_table<double>;
  corner_device<xy_table> table{"XY table", xy_table(), {{-0.1, -0.1}, {0.1, 0.1}, 0.025}};
  table.brakes.torque_limit.setConstant(10);      // [N]
  table.brakes.rate_dead_band.setConstant(2e-3);  // [m/s]
  table.count *= 0.1;                             // 0.1 m per radian
  add_device(tables, table);
}

}  // namespace experiments
