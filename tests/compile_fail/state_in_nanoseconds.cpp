// expect: passive_haptics: the state needs a member time, in seconds and of a floating-point type
#include <passive_haptics/passive_haptics.hpp>

#include <cstdint>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

struct state {
  std::int64_t time = 0;
  ph::vector<double, 2> q, qd, hand_force;
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))),
                         ph::direct_control());
  control(state());
}
