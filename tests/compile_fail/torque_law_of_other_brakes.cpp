// expect: passive_haptics: torque.. of this law takes brakes_of<M> alone
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct hold_all {
  static constexpr bool commands_torques = true;
  struct memory {};
  template <class M, class EMatrix, int D, int Capacity>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix>& now, const ph::contacts<D, Capacity>&,
                             memory&) const noexcept {
    return -now.s;
  }
};

int main() {
  ph::controller control(table(), ph::unlimited_brakes(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         hold_all());
  control(ph::sensorless_device_state<table>());
}
