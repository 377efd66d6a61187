// slow, no sanitizers
// A control cycle allocates nothing, on any device and by any law.
#include "allocations.hpp"

#include "../property/custom_mechanisms.hpp"
#include "ways.hpp"

#include <passive_haptics/runtime/catalogue.hpp>
#include <passive_haptics/runtime/wall_motion.hpp>

#include <span>

namespace {

TEST(no_allocation, in_a_step_of_the_table) { run_all(ph::xy_table<float>(), 0.3); }
TEST(no_allocation, in_a_step_with_automatic_derivatives_and_self_motion) {
  run_all(custom::planar_arm<double>(), 0.6);
}
TEST(no_allocation, in_a_step_in_space) { run_all(custom::spatial_arm<double>(), 0.4); }
TEST(no_allocation, in_a_step_with_a_transmission_that_depends_on_the_pose) {
  run_all(custom::coupled_arm<double>(), 1.5);
}

// A law that commands torques.
template <class M>
void run_torque_law(const M& mechanism, double size) {
  constexpr int d = M::task_dimension;
  const auto walls =
      ph::scene(ph::wall(ph::half_space<d>(ph::point<d>::UnitX() * (size / 3), ph::point<d>::UnitX()), 1e3),
                ph::wall(ph::ball<d>(ph::point<d>::Zero(), size, ph::filling::hollow), 2e3));
  ways seen;
  using walls_type = decltype(walls);
  using felt = ph::device_state<M>;
  run<M, ph::on_off_control, walls_type, felt>(mechanism, walls, {}, seen);
  EXPECT_TRUE(seen.fault && seen.exact);
}

TEST(no_allocation, in_a_law_that_commands_torques) {
  run_torque_law(ph::xy_table<float>(), 0.3);
  run_torque_law(custom::spatial_arm<double>(), 0.4);
}

// With effects of every kind beside the same walls.
template <class M>
void run_with_effects(const M& mechanism, double size) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension, n = M::dof;
  ph::point<d> low = ph::point<d>::Zero(), up = ph::point<d>::UnitX();
  low[0] = size / 3;
  const auto walls = ph::scene(ph::wall(ph::half_space<d>(low, up), 1e3),
                               ph::wall(ph::ball<d>(low, size, ph::filling::hollow), 2e3));
  const auto scene =
      ph::with_effects(walls, ph::viscous_field<T, d>({.viscosity = ph::matrix<T, d, d>::Identity()}),
                       ph::detents<T, d>({.spacing = T(0.02), .strength = T(3)}),
                       ph::guide<T, d>({.stiffness = T(100)}), ph::rough_walls<T, d>({.coefficient = T(0.4)}),
                       ph::end_stops<T, n>({.upper = ph::vector<T, n>::Constant(T(0.5)),
                                            .stiffness = ph::vector<T, n>::Ones()}));
  ways seen;
  run<M, ph::direct_control, decltype(scene), ph::device_state<M>>(mechanism, scene, {}, seen);
  EXPECT_TRUE(seen.free && seen.fault && seen.exact && seen.approximate && seen.saturated);
}

TEST(no_allocation, in_a_cycle_with_effects) {
  run_with_effects(ph::xy_table<float>(), 0.3);
  run_with_effects(custom::spatial_arm<double>(), 0.4);
}

TEST(no_allocation, in_what_can_be_displayed) {
  const ph::five_bar<double> pantograph;
  const ph::five_bar<double, 4> redundant;
  const ph::vector<double, 2> q(2.2, 0.9), v(0.3, -0.4), n(0, 1), limit(1, 2);
  EXPECT_EQ(allocations_in([&] { return ph::displayable(pantograph, q, v, n, limit); }), 0);
  EXPECT_EQ(allocations_in([&] { return ph::displayable(redundant, q, v, n); }), 0);
  EXPECT_EQ(allocations_in([&] { return ph::sink_slope(pantograph, q, v, n, limit, 1); }), 0);
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
    touched |= result.wall_number >= 0;
    probed |= control.probing() == decltype(control)::probe_phase::probing;
  }
  EXPECT_TRUE(touched && probed);
}

// Chosen at run time, in a world with an effect and a wall that moves.
TEST(no_allocation, in_a_cycle_of_an_any_controller) {
  namespace rt = ph::runtime;
  using M = ph::tendon_two_link<double>;
  constexpr rt::named_law<ph::direct_control> law{"direct_control"};
  rt::catalogue all;
  all.add_laws(law);
  all.compile_for<M>(law);
  ph::world_walls<2> walls;
  const int number = walls.add_moving(ph::wall(ph::half_space<2>({0, 0.2}, {0, -1})));
  const rt::any_scene_with_effects<2> scene(
      rt::any_scene<2>(rt::scene_in_motion(ph::world<2>(walls), {{number, {{0, 0.01}, 1}}})),
      {rt::any_effect<2>(ph::viscous_field<double, 2>({.viscosity = ph::matrix<double, 2, 2>::Identity()}))});
  const auto control = all.make_controller(rt::mechanism_model<M>(M()), all.laws()[0],
                                           {rt::brake_numbers(2), scene, all.laws()[0].defaults});
  bool touched = false, faulty = false;
  for (int k = 0; k < 1000; ++k) {
    ph::vector<double, 2> q(1.0, 1.0), qd(std::sin(0.1 * k), 0.3);
    q[0] += 0.5 * std::sin(0.01 * k);
    const std::span<const double> all_of_q(q.data(), k % 100 == 99 ? 1 : 2), rates(qd.data(), 2);
    rt::cycle_record result;
    ASSERT_EQ(allocations_in([&] { result = (*control)({k * 1e-3, all_of_q, rates, rates}); }), 0)
        << "cycle " << k;
    touched |= result.wall_number >= 0;
    faulty |= result.outcome != ph::status::ok;
  }
  EXPECT_TRUE(touched && faulty);
}

}  // namespace
