// expect: passive_haptics: all walls of a scene need the same dimension
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() { ph::scene(ph::wall(ph::disc({0, 0}, 1)), ph::wall(ph::ball<3>({0, 0, 0}, 1))); }
