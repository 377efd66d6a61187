// expect: passive_haptics: a wall is made of .shape, stiffness., in this order
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() { ph::wall w(1e5, ph::half_space<2>({0, 1}, {0, -1})); }
