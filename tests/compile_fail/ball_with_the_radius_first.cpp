// expect: passive_haptics: a ball is made of .centre, radius., in this order
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() { ph::disc b(0.01, {0, 1}); }
