// expect: passive_haptics: the arguments of a controller are .mechanism, brakes, scene, law., in this order:
// the third one
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

int main() {
  ph::controller c(arm(), ph::brakes_of<arm>(), ph::direct_control(),
                   ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))));
}
