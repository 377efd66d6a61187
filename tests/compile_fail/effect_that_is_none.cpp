// expect: passive_haptics: each effect must model Effect, WallEffect or JointEffect
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct breeze {
  using scalar = double;
  static constexpr int dimension = 2;
  ph::vector<double, 2> force() const { return {0, 1}; }
};

int main() { ph::with_effects(ph::no_walls<2>(), breeze()); }
