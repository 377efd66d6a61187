// slow
// A cycle calls no function of the namespace of a user's types: here one has functions by names of the
// library's own, and each of them ends the program.
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cstdlib>

namespace ph = passive_haptics;

namespace stranger {

struct arm : ph::tendon_two_link<double> {};
struct brakes : ph::switchable_brakes<arm> {};

struct room {
  using contacts_type = ph::contacts<2, 2>;
  static constexpr int dimension = 2;
  contacts_type now;
  const contacts_type& touched_at(const ph::point<2>&) const { return now; }
};

struct half {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    return T(0.5);
  }
};

struct constant_drag {
  static constexpr bool commands_torques = true;
  template <class M, class E, class B, int D, int N>
  ph::brake_vector<M> torque(const ph::brake_situation<M, E, B>& device,
                             const ph::contacts<D, N>&) const noexcept {
    return -0.1 * device.s;
  }
};

struct honey {
  using scalar = double;
  static constexpr int dimension = 2;
  ph::vector<double, 2> force(const ph::vector<double, 2>&, const ph::vector<double, 2>& v,
                              const ph::vector<double, 2>&) const {
    return -2 * v;
  }
};

// By names of the library, each a better match than the library's template: a call that is not qualified ends
// here
using V2 = ph::vector<double, 2>;
using M2 = ph::matrix<double, 2, 2>;
double jacobian(const arm&, const V2&) { std::abort(); }  // such as millimetres per degree, for plots
double brake_jacobian(const arm&, const V2&) { std::abort(); }
double transmission(const arm&, const V2&) { std::abort(); }
double force_map_of(const ph::mechanism_pose<arm>&, const M2&) { std::abort(); }
double torque_box_of(const V2&, const brakes&) { std::abort(); }
double torque_bounds_of(const brakes&, const V2&) { std::abort(); }
double within_limits(const V2&, const brakes&, ph::saturation) { std::abort(); }
double brakes_off(const V2&, const brakes&) { std::abort(); }
double check_brakes(const brakes&) { std::abort(); }
double check_parameters(const brakes&, const half&, const ph::step_options<double>&) { std::abort(); }

}  // namespace stranger

namespace {

// Random cycles with one wall and with two.
template <class Scene, class Law>
void run_cycles(const Scene& scene, const Law& law) {
  using stranger::arm;
  ph::testing::random_source random(20040627);
  ph::controller control(arm(), stranger::brakes(), scene, law);
  ph::step_memory<Law> memory;
  auto& touched = [&]() -> auto& {
    if constexpr (requires { control.scene().scene(); }) return control.scene().scene().now;
    else return control.scene().now;
  }();
  for (int k = 0; k < 50; ++k) {
    ph::device_state<arm> state;
    state.time = 1e-3 * k;
    state.q = random.between<double, 2>({0.3, 0.3}, {1.2, 1.2});
    state.qd = random.normal_vector<double, 2>();
    state.hand_force = random.normal_vector<double, 2>();
    touched.clear();
    for (int j = 0; j <= k % 2; ++j)
      touched.push_back({.normal = random.direction<double, 2>(),
                         .depth = 1e-4,
                         .stiffness = 1e4,
                         .sensed_at = arm().position(state.q)});
    EXPECT_EQ(control(state).outcome, ph::status::ok);
    EXPECT_EQ(ph::step(arm(), stranger::brakes(), touched, law, state, memory).outcome, ph::status::ok);
  }
}

TEST(functions_of_a_users_namespace, are_not_called_by_a_cycle) {
  run_cycles(stranger::room(), stranger::half());
  run_cycles(stranger::room(), stranger::constant_drag());
  run_cycles(ph::with_effects(stranger::room(), stranger::honey()), ph::direct_control());
}

}  // namespace
