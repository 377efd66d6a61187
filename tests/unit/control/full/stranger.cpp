// A cycle calls no function of the namespace of a user's types, whatever its name: here one has a function by
// each name of the library's own, and each of them ends the program.
#include <library_functions.hpp>  // which CMake writes
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <type_traits>
#include <vector>

namespace ph = passive_haptics;

namespace friendly {
#include "stranger.inc"
}  // namespace friendly

namespace hostile {
#include "stranger.inc"

// A better match than a template of the library, also where template arguments are given
#define PASSIVE_HAPTICS_HOSTILE(name)                   \
  template <class... A>                                 \
  double name(A&&...) {                                 \
    std::abort();                                       \
  }                                                     \
  template <class X, class... A>                        \
  double name(A&&...) {                                 \
    std::abort();                                       \
  }                                                     \
  template <class... A>                                 \
  double name(const arm&, A&&...) {                     \
    std::abort();                                       \
  }                                                     \
  template <class... A>                                 \
  double name(const ph::mechanism_pose<arm>&, A&&...) { \
    std::abort();                                       \
  }
PASSIVE_HAPTICS_FUNCTIONS(PASSIVE_HAPTICS_HOSTILE)
#undef PASSIVE_HAPTICS_HOSTILE

// What a user may well have: millimetres per degree, for his plots
ph::matrix<double, 2, 2> jacobian(const arm&, const ph::vector<double, 2>&) { std::abort(); }
}  // namespace hostile

namespace {

// Capacities of random cycles, with one wall and with two.
template <class M, class B, class Scene, class Law>
std::vector<double> capacities(const M& mechanism, const B& brakes, const Scene& scene, const Law& law) {
  ph::testing::random_source random(20040627);
  ph::controller control(mechanism, brakes, scene, law);
  ph::step_memory<Law> memory;
  std::vector<double> all;
  for (int k = 0; k < 50; ++k) {
    ph::device_state<M> state;
    state.time = 1e-3 * k;
    state.q = random.between<double, M::dof>(ph::joint_vector<M>::Constant(0.3),
                                             ph::joint_vector<M>::Constant(1.2));
    state.qd = random.normal_vector<double, M::dof>();
    state.hand_force = random.normal_vector<double, 2>();
    auto touched = [&]() -> auto& {
      if constexpr (requires { control.scene().scene(); }) return control.scene().scene().now;
      else return control.scene().now;
    };
    touched().clear();
    for (int j = 0; j <= k % 2; ++j)
      touched().push_back({.normal = random.direction<double, 2>(),
                           .depth = 1e-4,
                           .stiffness = 1e4,
                           .sensed_at = mechanism.position(state.q)});
    for (const double c : control(state).capacity) all.push_back(c);
    state.time += 5e-4;
    for (const double c : control.command(state).capacity) all.push_back(c);
    for (const double c : ph::step(mechanism, brakes, touched(), law, state, memory).capacity)
      all.push_back(c);
  }
  return all;
}

#define OF_BOTH(of) EXPECT_EQ(of(friendly), of(hostile))
#define CAPACITIES(space, mechanism, scene, law) \
  capacities(space::mechanism(), space::brakes<space::mechanism>(), scene, law)

TEST(functions_of_a_users_namespace, are_those_of_the_library) {
#define PASSIVE_HAPTICS_NAME(name) " " #name " "
  const std::string all = PASSIVE_HAPTICS_FUNCTIONS(PASSIVE_HAPTICS_NAME);
#undef PASSIVE_HAPTICS_NAME
  for (const char* name :
       {" jacobian ", " brake_signs ", " force_map_of ", " approximate ", " cycle ", " times "})
    EXPECT_NE(all.find(name), std::string::npos) << name;
}

TEST(functions_of_a_users_namespace, change_no_cycle) {
#define OF(space) CAPACITIES(space, arm, space::room(), ph::direct_control())
  OF_BOTH(OF);
#undef OF
#define OF(space) CAPACITIES(space, arm, space::room(), space::half())
  OF_BOTH(OF);
#undef OF
#define OF(space) CAPACITIES(space, redundant_arm, space::room(), ph::direct_control())
  OF_BOTH(OF);
#undef OF
#define OF(space) CAPACITIES(space, heavy_arm, space::room(), ph::direct_control())
  OF_BOTH(OF);
#undef OF
}

TEST(functions_of_a_users_namespace, change_no_torque_law) {
#define OF(space) CAPACITIES(space, arm, space::room(), space::constant_drag())
  OF_BOTH(OF);
#undef OF
#define OF(space) CAPACITIES(space, arm, space::room(), ph::velocity_direct_control())
  OF_BOTH(OF);
#undef OF
#define OF(space) CAPACITIES(space, arm, space::room(), ph::on_off_control())
  OF_BOTH(OF);
#undef OF
#define OF(space) CAPACITIES(space, redundant_arm, space::room(), ph::on_off_control())
  OF_BOTH(OF);
#undef OF
}

TEST(functions_of_a_users_namespace, change_no_effect) {
#define OF(space) \
  CAPACITIES(space, arm, ph::with_effects(space::room(), space::honey()), ph::direct_control())
  OF_BOTH(OF);
#undef OF
}

}  // namespace
