// An XY table: two orthogonal slides, a brake on each (Figs. 4 and 5).
#include "planar_arm.hpp"

#include <passive_haptics/mechanism/models/xy_table.hpp>

namespace explorer {
namespace {

struct description : described {
  using mechanism = ph::xy_table<double>;
  using parameters = ph::xy_table_parameters<double>;
  using joints = ph::vector<double, 2>;
  static constexpr const char *id = "xy_table", *label = "XY table";
  static constexpr bool slides = true;
  static constexpr const char* scene = "plane:0,0.05,0.5,-0.8660254037844386";  // slanted by 30 deg, Fig. 5
  static constexpr double half = 0.15;  // of each rail, as it is drawn [m]

  static mechanism make(const parameters& p) { return mechanism(p); }
  static joints start() { return {0.02, 0.055}; }
  static ph::joint_solution<double, 2> inverse(const mechanism& model, const joints& x, const joints&) {
    return model.inverse(x);
  }
  static void draw(const mechanism&, const joints& q, drawing& to) {
    const double size = brake_share * half;
    const drawing::place along_x(1, 0, 0), along_y(0, 1, 0);
    const drawing::place x_left(-half, -half, 0), x_right(half, -half, 0), carriage(q[0], -half, 0);
    const drawing::place handle(q[0], q[1], 0);
    for (const auto& end : {x_left, x_right}) to.add(item_kind::ground, -1, end, end, size);
    to.add(item_kind::slide, 0, x_left, x_right);
    to.add(item_kind::slide, 1, carriage, drawing::place(q[0], half, 0));
    to.add_turning(item_kind::carriage, 0, carriage, along_x, size);
    to.add_turning(item_kind::carriage, 1, handle, along_y, size);
    to.add_turning(item_kind::brake, 0, carriage, along_x, size, q[0]);
    to.add_turning(item_kind::brake, 1, handle, along_y, size, q[1]);
    to.add(item_kind::handle, -1, handle, handle);
  }
  static double reach(const mechanism&) { return half; }
};

}  // namespace

mechanism_entry xy_table_entry() { return entry_of<description>(); }

}  // namespace explorer
