// A controller compiles with a device of each kind, a law of each and one wall or two, whatever else is
// included: its header includes all that it uses.
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

template <class M>
auto wall_across(const M&) {
  return ph::wall(ph::half_space<M::task_dimension>(
      ph::point<M::task_dimension>::Zero(), ph::point<M::task_dimension>::Unit(M::task_dimension - 1)));
}

template <class L, class M>
void cycle(const M& device) {
  ph::controller two(device, ph::brakes_of<M>(), ph::scene(wall_across(device), wall_across(device)), L());
  two(ph::device_state<M>());
}

[[maybe_unused]] void devices() {
  using law = ph::direct_control;
  cycle<law>(slides<1, 1>());
  cycle<law>(slides<2, 2>());
  cycle<law>(slides<2, 2, 3>());
  cycle<law>(slides<3, 2>());
  cycle<law>(slides<3, 2, 2>());
  cycle<law>(slides<3, 3>());
  cycle<hold_all>(slides<2, 2>());
  const slides<2, 2> device;
  ph::controller one(device, ph::brakes_of<slides<2, 2>>(), ph::scene(wall_across(device)), law());
  one(ph::device_state<slides<2, 2>>());
}

}  // namespace
