// expect: passive_haptics: brake_lag_model is for at most 12 brakes.
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>

namespace ph = passive_haptics;

int main() {
  ph::brake_lag_model brakes;
  brakes.advance(0, ph::vector<double, 13>());
}
