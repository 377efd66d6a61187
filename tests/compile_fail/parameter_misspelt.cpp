// expect: lenght_1
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() { ph::two_link<double> arm(ph::two_link_parameters<double>{.lenght_1 = 0.2}); }
