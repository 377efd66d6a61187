// A controller compiles with any device, law and number of walls, whatever else is included: its header
// includes all that it uses.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;

namespace {

// Joint i moves the handle along axis i modulo Dimension.
template <int Joints, int Dimension, int Brakes = Joints>
struct slides {
  using scalar = double;
  static constexpr int dof = Joints, task_dimension = Dimension, brake_count = Brakes;
  ph::matrix<double, Dimension, Joints> jacobian() const {
    return ph::matrix<double, Dimension, Joints>::NullaryExpr(
        [](auto i, auto j) { return j % Dimension == i ? 1.0 : 0.0; });
  }
  ph::vector<double, Dimension> position(const ph::vector<double, Joints>& q) const { return jacobian() * q; }
  ph::matrix<double, Brakes, Joints> transmission() const
    requires(Brakes != Joints)
  {
    return ph::matrix<double, Brakes, Joints>::Identity();
  }
};

struct hold_all {
  static constexpr bool commands_torques = true;
  template <class M, class EMatrix, int D, int N, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& now,
                             const ph::contacts<D, N>&) const noexcept {
    return -now.s;
  }
};

template <class M, class L>
auto cycle(const M& device, const L& law) {
  const ph::wall wall(ph::half_space<M::task_dimension>(
      ph::point<M::task_dimension>::Zero(), ph::point<M::task_dimension>::Unit(M::task_dimension - 1)));
  ph::controller one(device, ph::brakes_of<M>(), ph::scene(wall), law);
  ph::controller two(device, ph::brakes_of<M>(), ph::scene(wall, wall), law);
  return one(ph::device_state<M>()).capacity + two(ph::device_state<M>()).capacity;
}

template <class M>
auto cycles(const M& device) {
  return cycle(device, ph::direct_control()) + cycle(device, hold_all());
}

[[maybe_unused]] void devices() {
  cycles(slides<1, 1>());
  cycles(slides<2, 2>());
  cycles(slides<2, 2, 3>());
  cycles(slides<3, 2>());
  cycles(slides<3, 2, 2>());
  cycles(slides<3, 3>());
  cycles(slides<4, 3>());
}

}  // namespace
