// expect: passive_haptics: a brake model needs `scalar torque_limit_at.scalar rate. const noexcept`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

struct brake {
  using scalar = double;
  struct state {};
  ph::brake_resistance<double> advance(double, double, double, state&) const noexcept { return {}; }
};

int main() { return ph::is_brake_model<brake, ph::explain>() ? 0 : 1; }
