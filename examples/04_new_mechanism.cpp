// A custom mechanism: a planar arm of three links, defined by its position only. The Jacobian follows by
// automatic differentiation. Three joints for two dimensions have self-motion: a force counts as displayed if
// the hand feels it once the self-motion has settled.
#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

struct three_link {
  using scalar = double;
  static constexpr int dof = 3, task_dimension = 2, brake_count = 3;

  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 3>& q) const {
    using std::cos, std::sin;
    const S a = q[0], b = a + q[1], c = b + q[2];
    return {0.15 * cos(a) + 0.15 * cos(b) + 0.1 * cos(c), 0.15 * sin(a) + 0.15 * sin(b) + 0.1 * sin(c)};
  }
};
static_assert(ph::is_mechanism<three_link, ph::explain>());

template <class M>
void show(const M& arm) {
  const ph::joint_vector<M> q(1.2, -0.5, -0.4);
  const ph::point<2> x = arm.position(q);
  const ph::half_space<2> wall(x - ph::point<2>(0, 1e-4), {0, -1});  // the handle is 0.1 mm inside
  ph::controller control(arm, ph::brakes_of<M>(), ph::scene(ph::wall(wall)), ph::direct_control());
  std::cerr << ph::plausibility(arm, control.brakes(), control.scene(), q);  // degrees? millimetres?

  std::cout << "handle at " << x.transpose() << " m\nJacobian [m/rad]\n"
            << ph::jacobian(arm, q) << "\noptional members: " << to_text(ph::describe(arm)) << "\n";
  for (const auto& qd : {ph::vector<double, 3>(0.3, 0.1, 0.2), ph::vector<double, 3>(-0.5, 0.6, 0.3),
                         ph::vector<double, 3>(0.5, -0.3, 0.2)}) {
    const auto result = control(ph::device_state<M>{.time = 0, .q = q, .qd = qd, .hand_force = {0.5, 2}});
    std::cout << "rates " << qd.transpose() << " rad/s: " << display_text(result) << ", gamma "
              << ph::degrees(result.approximation_angle()) << " deg, brakes may hold "
              << result.capacity.transpose() << " N m\n";
  }
}

int main() { show(three_link()); }
