// expect: passive_haptics: a wall needs a Shape: .*`point<dimension> gradient.x. const`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return q;
  }
};

struct blob {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const { return x.norm() - 1; }
};

int main() {
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(blob())), ph::direct_control());
}
