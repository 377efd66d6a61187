// expect: passive_haptics: a member of the brakes is spelt almost as `torque_upper`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct brakes {
  ph::vector<double, 2> torque_limit{1, 1}, torque_lower{0, -1}, torque_uper{0, 1};
};

int main() {
  ph::controller control(table(), brakes(), ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))),
                         ph::direct_control());
}
