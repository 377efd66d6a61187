// expect: passive_haptics: a brake model needs a default-constructible `struct state`
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

namespace ph = passive_haptics;

struct brake {
  using scalar = double;
  ph::brake_resistance<double> advance(double, double, double) const noexcept { return {}; }
  double torque_limit_at(double) const noexcept { return 1; }
};

int main() {
  using table = ph::xy_table<double>;
  ph::simulated_device device(table(), ph::brake_models_of<table, brake>{}, 0.5, {0, 0});
}
