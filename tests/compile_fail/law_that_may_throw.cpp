// expect: passive_haptics: the law must model ControlLaw: give it .* const noexcept`
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2>;

struct law {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const {
    return 1;
  }
};

int main() {
  ph::controller control(device(), ph::brakes_of<device>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))), law());
}
