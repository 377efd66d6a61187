// expect: deleted
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  const ph::tendon_two_link<double> whole;
  const ph::two_link<double> part = whole;
}
