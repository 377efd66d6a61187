// expect: passive_haptics: simulated_device needs #include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

using arm = ph::two_link<double>;

int main() { ph::simulated_device<arm> device(arm(), {}, 0.5, {0.1, 1}); }
