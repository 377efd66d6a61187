// Batches of every shipped mechanism: to the last bit what single cycles return.
// Before it `rounds` is defined: how often this many states are drawn.
#pragma once

#include "batch_cases.hpp"

#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

namespace {

constexpr std::size_t count = 4001;

// q anywhere: half of the walls pass through the handle, within a rounding or some millimetres
template <class M>
auto anywhere(const M&) {
  return [](auto& random) {
    ph::joint_vector<M> q;
    for (int i = 0; i < M::dof; ++i) q[i] = random.uniform(typename M::scalar(-3), typename M::scalar(3));
    return q;
  };
}

// Of walls through where the handle is in the middle pose
template <class M>
ph::point<M::task_dimension> middle_of(const M& mechanism) {
  using T = typename M::scalar;
  ph::testing::random_source random(7);
  for (;;) {
    ph::joint_vector<M> q;
    for (int i = 0; i < M::dof; ++i) q[i] = random.uniform(T(0.3), T(1.5));
    const auto x = ph::as<double>(mechanism.position(q));
    if (ph::all_finite(x)) return x;
  }
}

template <class M, class Scene, class L>
void expect_same(const M& mechanism, const Scene& scene, const L& law, std::size_t n = count) {
  ph::step_options<typename M::scalar> options;
  options.limits = n % 2 == 0 ? ph::saturation::clamp_each : ph::saturation::keep_direction;
  ph::brakes_of<M> brakes;
  brakes.torque_limit *= typename M::scalar(0.1);
  for (unsigned seed = 0; seed < rounds && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    const auto seen = batch_cases::expect_that_of_single_cycles(
        mechanism, brakes, scene, law, options, batch_cases::any_states<M>(seed, n, anywhere(mechanism)));
    for (int i = 0; i < 3; ++i) EXPECT_GT(seen[std::size_t(i)], int(n / 100)) << i;
  }
}

template <class M>
auto one_plane(const M& mechanism, double stiffness) {
  constexpr int d = M::task_dimension;
  return ph::scene(
      ph::wall(ph::half_space<d>(middle_of(mechanism), -ph::point<d>(ph::point<d>::Ones())), stiffness));
}

template <class M>
void expect_same_under_the_papers_laws(const M& mechanism, std::size_t n = count) {
  expect_same(mechanism, one_plane(mechanism, 1e3), ph::no_direct_control(), n);
  expect_same(mechanism, one_plane(mechanism, 1e2), ph::direct_control{0.1}, n + 1);
  expect_same(mechanism, one_plane(mechanism, 1e7), ph::saturated_direct_control(), n + 2);
}

TEST(batches, of_a_two_link) { expect_same_under_the_papers_laws(ph::two_link<double>()); }
TEST(batches, of_the_tendon_device) { expect_same_under_the_papers_laws(ph::tendon_two_link<double>()); }
TEST(batches, of_an_xy_table) { expect_same_under_the_papers_laws(ph::xy_table<double>()); }
TEST(batches, of_a_five_bar) { expect_same_under_the_papers_laws(ph::five_bar<double>()); }
TEST(batches, of_a_five_bar_with_four_brakes) {
  expect_same_under_the_papers_laws(ph::five_bar<double, 4>(), 3001);
}
TEST(batches, of_a_delta) { expect_same_under_the_papers_laws(ph::delta<double>(), 3001); }
TEST(batches, in_float) { expect_same_under_the_papers_laws(ph::tendon_two_link<float>()); }

TEST(batches, at_a_disc) {
  const ph::tendon_two_link<double> arm;
  // Not about the base: there brake 1 has no torque but rounding, which decides a sign under -mfma
  for (const auto filling : {ph::filling::solid, ph::filling::hollow})
    expect_same(arm, ph::scene(ph::wall(ph::disc({0.02, 0.01}, 0.2, filling), 1e3)), ph::direct_control());
}
TEST(batches, at_a_disc_about_the_handle) {
  const ph::xy_table<double> table;
  const auto scene = ph::scene(ph::wall(ph::disc({0, 0}, 0.5), 1e3));
  std::vector<ph::device_state<ph::xy_table<double>>> states(5);
  for (auto& s : states) s.time = 0;
  states[1].q = {1e-320, 0};
  states[2].qd = {1, -1};
  states[3].hand_force = {1, 2};
  batch_cases::expect_that_of_single_cycles(table, ph::brakes_of<ph::xy_table<double>>(), scene,
                                            ph::direct_control(), ph::step_options<double>(), states);
}

TEST(batches, at_several_walls) {
  const ph::tendon_two_link<double> arm;
  const auto scene = ph::scene(ph::wall(ph::half_space<2>({0.1, 0}, {-1, 0}), 1e3),
                               ph::wall(ph::half_space<2>({0, 0.1}, {0, -1}), 1e4));
  expect_same(arm, scene, ph::direct_control(), 5001);
}

TEST(batches, of_brakes_without_limits_and_dead_bands) {
  const ph::tendon_two_link<double> arm;
  const auto states = batch_cases::any_states<ph::tendon_two_link<double>>(5, count, anywhere(arm));
  const auto scene = one_plane(arm, 1e3);
  batch_cases::expect_that_of_single_cycles(arm, ph::unlimited_brakes(), scene, ph::direct_control(),
                                            ph::step_options<double>(), states);
  batch_cases::expect_that_of_single_cycles(arm, ph::unlimited_brake_parameters<double, 2>(), scene,
                                            ph::direct_control(), ph::step_options<double>(), states);
}

TEST(batches, of_the_recommended_law) {
  const ph::tendon_two_link<double> arm;
  const ph::brakes_of<ph::tendon_two_link<double>> brakes;
  expect_same(arm, one_plane(arm, 1e3), ph::recommended_law(arm, brakes), 3001);
}

}  // namespace
