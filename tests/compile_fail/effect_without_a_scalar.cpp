// expect: passive_haptics: each effect needs `using scalar = double;`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

struct spring {
  static constexpr int dimension = 2;
  ph::vector<double, 2> force(const ph::vector<double, 2>& x, const ph::vector<double, 2>&,
                              const ph::vector<double, 2>&) const {
    return -x;
  }
};

int main() {
  ph::controller c(arm(), ph::brakes_of<arm>(),
                   ph::with_effects(ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))), spring()),
                   ph::direct_control());
}
