#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

class scara : public ph::two_link<double> {
 public:
  scara() : two_link({.length_1 = 0.2, .length_2 = 0.1}) {}

  // The second motor axis turns with the sum of both joints, geared 3 : 1.
  ph::matrix<double, 2, 2> transmission() const { return ph::matrix<double, 2, 2>{{1, 0}, {3, 3}}; }
};

static_assert(ph::describe<scara>().has("transmission"));

int main() {
  const ph::vector<double, 2> w = ph::brake_rates(scara(), {0.3, 1.2}, {1, 2});
  return w[0] == 1 && w[1] == 9 ? 0 : 1;
}
