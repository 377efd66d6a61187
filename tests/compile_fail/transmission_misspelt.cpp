// expect: passive_haptics: a member of the mechanism is spelt almost as `transmission`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm : ph::xy_table<double> {
  ph::matrix<double, 2, 2> transmision() const { return ph::matrix<double, 2, 2>::Identity(); }
};

int main() { ph::device_state<arm> state; }
