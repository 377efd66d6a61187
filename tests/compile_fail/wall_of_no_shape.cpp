// expect: passive_haptics: a wall needs a Shape
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct rock {
  static constexpr int dimension = 2;
  float distance(const ph::point<2>&) const { return 0; }
  ph::point<2> gradient(const ph::point<2>& x) const { return x; }
};

int main() { ph::wall wall(rock{}); }
