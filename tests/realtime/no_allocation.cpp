// A control cycle allocates nothing, whichever way it takes.
#include "allocations.hpp"

#include "../property/custom_mechanisms.hpp"

#include <passive_haptics/passive_haptics.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace {

namespace ph = passive_haptics;

TEST(no_allocation, is_noticed_where_there_is_one) {
  std::unique_ptr<int> kept;
  EXPECT_EQ(allocations_in([&] { kept = std::make_unique<int>(3); }), 1);
  std::string text;
  EXPECT_GE(allocations_in([&] { text.assign(1000, 'x'); }), 1);
  EXPECT_EQ(allocations_in([] {}), 0);
  EXPECT_DEATH(allocations_in([] { Eigen::VectorXd::Ones(7).eval(); }), "malloc");
}

// The ways a cycle can take, by their diagnostics.
struct ways {
  bool free = false, fault = false, exact = false, approximate = false, none = false, saturated = false,
       held = false;
};

template <class M, class Law, class Scene, class State>
void run(const M& mechanism, Scene scene, Law law, ways& seen) {
  using T = typename M::scalar;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(T(0.5));
  ph::controller control(mechanism, brakes, std::move(scene), law);
  State state;
  for (int k = 0; k < 3000; ++k) {
    state.time = k * 1e-3;
    for (int i = 0; i < M::dof; ++i) {
      state.q[i] = static_cast<T>(std::sin(0.01 * k * (i + 1)));
      state.qd[i] = k % 7 == 0 ? T(0) : static_cast<T>(std::cos(0.37 * k + i));
    }
    if constexpr (requires { state.hand_force; })
      state.hand_force.setConstant(static_cast<T>(std::sin(0.11 * k)));
    if (k % 100 == 99) state.q[0] = std::numeric_limits<T>::quiet_NaN();
    ph::step_result<M> result;
    ASSERT_EQ(allocations_in([&] { result = control(state); }), 0) << "cycle " << k;
    const bool touches = result.outcome == ph::status::ok && result.wall >= 0;
    seen.fault |= result.outcome != ph::status::ok;
    seen.free |= result.outcome == ph::status::ok && result.wall < 0;
    seen.exact |= touches && result.display == ph::display_class::exact;
    seen.approximate |= touches && result.display == ph::display_class::approximate;
    seen.none |= touches && result.display == ph::display_class::none;
    seen.saturated |= result.saturated;
  }
}

// Between a plane and a round room of this size [m].
template <class M>
void run_all(const M& mechanism, double size) {
  constexpr int d = M::task_dimension;
  ph::point<d> low = ph::point<d>::Zero(), up = ph::point<d>::UnitX();
  low[0] = size / 3;
  const ph::scene walls{ph::wall(ph::half_space<d>(low, up), 1e3),
                        ph::wall(ph::ball<d>(low, size, ph::filling::hollow), 2e3)};
  const ph::held_scene held(walls, 0.01);
  ways seen;
  run<M, ph::direct_control, decltype(walls), ph::device_state<M>>(mechanism, walls, {}, seen);
  run<M, ph::direct_control, decltype(held), ph::device_state<M>>(mechanism, held, {}, seen);
  run<M, ph::no_direct_control, decltype(walls), ph::sensorless_device_state<M>>(mechanism, walls, {}, seen);
  EXPECT_TRUE(seen.free && seen.fault && seen.saturated);
  EXPECT_TRUE(seen.exact && seen.approximate && seen.none);
}

TEST(no_allocation, in_a_step_of_two_links) { run_all(ph::two_link<float>(), 0.3); }
TEST(no_allocation, in_a_step_of_the_tendon_device) { run_all(ph::tendon_two_link<double>(), 0.3); }
TEST(no_allocation, in_a_step_of_the_table) { run_all(ph::xy_table<double>(), 0.3); }
TEST(no_allocation, in_a_step_with_automatic_derivatives_and_self_motion) {
  run_all(custom::planar_arm<double>(), 0.6);
}
TEST(no_allocation, in_a_step_in_space) { run_all(custom::spatial_arm<double>(), 0.4); }
TEST(no_allocation, in_a_step_with_a_transmission_that_depends_on_the_pose) {
  run_all(custom::coupled_arm<double>(), 1.5);
}

// The laws that command torques, and the cycle without a force sensor.
template <class M>
void run_torque_laws(const M& mechanism, double size) {
  constexpr int d = M::task_dimension;
  const ph::scene walls{
      ph::wall(ph::half_space<d>(ph::point<d>::UnitX() * (size / 3), ph::point<d>::UnitX()), 1e3),
      ph::wall(ph::ball<d>(ph::point<d>::Zero(), size, ph::filling::hollow), 2e3)};
  ways seen;
  using walls_type = decltype(walls);
  using felt = ph::device_state<M>;
  run<M, ph::coercive_force_approximation, walls_type, felt>(mechanism, walls, {}, seen);
  run<M, ph::single_degree_of_freedom_control, walls_type, felt>(mechanism, walls, {}, seen);
  run<M, ph::velocity_ratio_control, walls_type, felt>(mechanism, walls, {}, seen);
  run<M, ph::on_off_control, walls_type, felt>(mechanism, walls, {}, seen);
  EXPECT_TRUE(seen.free && seen.fault && seen.exact);
}

TEST(no_allocation, in_laws_that_command_torques) {
  run_torque_laws(ph::tendon_two_link<double>(), 0.3);
  run_torque_laws(ph::xy_table<float>(), 0.3);
  run_torque_laws(custom::spatial_arm<double>(), 0.4);
}

TEST(no_allocation, in_a_cycle_without_a_force_sensor) {
  using M = ph::tendon_two_link<double>;
  ph::sensorless_controller control(M(), ph::brakes_of<M>(),
                                    ph::scene(ph::wall(ph::half_space<2>({0, 0.2}, {0, -1}))),
                                    ph::velocity_direct_control());
  bool probed = false, touched = false;
  for (int k = 0; k < 2000; ++k) {
    ph::sensorless_device_state<M> state{k * 1e-3, {1.0, 1.0}, {k < 1000 ? std::sin(0.1 * k) : 0.0, 0.0}};
    if (k % 500 == 99) state.q[0] = std::numeric_limits<double>::quiet_NaN();
    ph::step_result<M> result;
    ASSERT_EQ(allocations_in([&] { result = control(state); }), 0) << "cycle " << k;
    touched |= result.wall >= 0;
    probed |= control.probing() == decltype(control)::probe_phase::probing;
  }
  EXPECT_TRUE(touched && probed);
}

}  // namespace
