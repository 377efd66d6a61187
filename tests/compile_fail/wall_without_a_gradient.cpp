// expect: passive_haptics: a wall needs a Shape: .*`point<dimension> gradient.x. const`
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2>;

struct blob {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const { return x.norm() - 1; }
};

int main() {
  ph::controller control(device(), ph::brakes_of<device>(), ph::scene(ph::wall(blob())),
                         ph::direct_control());
}
