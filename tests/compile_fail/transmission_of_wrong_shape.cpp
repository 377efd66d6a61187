// expect: passive_haptics: transmission must be const.*matrix<scalar, brake_count, dof> exactly
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct arm : ph::two_link<double> {
  ph::matrix<double, 2, 3> transmission() const { return {}; }
};

int main() { ph::jacobian(arm(), ph::vector<double, 2>(0, 0)); }
