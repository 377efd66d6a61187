// expect: passive_haptics: braked_joints<M, i, j, ...> needs at least one number of a brake
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;

int main() { [[maybe_unused]] const ph::braked_joints<arm<3>, 0, 3> two((arm<3>())); }
