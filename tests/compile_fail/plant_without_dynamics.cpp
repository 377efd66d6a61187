// expect: passive_haptics: a simulated device needs a mechanism that models Dynamics
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2>;

int main() { ph::simulated_device<device> device(device(), ph::brakes_of<device>(), 0, {0, 0}); }
