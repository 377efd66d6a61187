// expect: passive_haptics: a TorqueLaw needs
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct hold_all {
  static constexpr bool commands_torques = true;
  template <class M, class EMatrix, int D, int N, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& now,
                             const ph::contacts<D, N>&) const noexcept {
    return -now.s;
  }
};

int main() {
  ph::controller control(table(), ph::brakes_of<table>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))), hold_all());
  control(ph::device_state<table>());
}
