// More brakes than joints, more joints than the task, and three dimensions.
#include "corner_rows.hpp"
#include "rods.hpp"

namespace experiments {

void add_other_devices(corner_tables& tables) {
  using five_bar = ph::five_bar<double, 4>;
  add_device<five_bar>(tables, {"five-bar, four brakes", five_bar(), {{1.5, 0}, {3.1, 1.6}, 0.015, 1, 25}});
  const auto arm = planar_rods<3>({0.15, 0.15, 0.1});
  add_device<decltype(planar_rods<3>({}))>(tables,
                                           {"3R", arm, {{-3.1, 0.5, 0.5}, {3.1, 2.6, 2.6}, 0.025, 1, 8}});
  using delta = ph::delta<double>;
  const corner_device<delta> robot{
      "delta, two planes", delta(), {{-0.2, -0.2, -0.2}, {1.1, 1.1, 1.1}, 0.015, 1, 25}};
  add_device(tables, robot);
  corner_device<delta> three = robot;
  three.name = "delta, three planes";
  add_device(tables, three, 3);
}

}  // namespace experiments
