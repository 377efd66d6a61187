// expect: passive_haptics: a mechanism with a pose\(q\) needs position\(pose\) and jacobian\(pose\)
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm : ph::two_link<double> {
  struct angles {};
  angles pose(const ph::vector<double, 2>&) const { return {}; }
};

int main() { ph::jacobian(arm(), ph::vector<double, 2>(0, 0)); }
