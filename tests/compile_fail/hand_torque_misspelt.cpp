// expect: passive_haptics: a member of the state is spelt almost as `hand_torque`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

struct state {
  double time = 0;
  ph::vector<double, 2> q, qd, hand_force, hand_toque;
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))),
                         ph::no_direct_control());
  control(state());
}
