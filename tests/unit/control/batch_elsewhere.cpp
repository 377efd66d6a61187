// slow
// Batches of other mechanisms and scenes than batch.cpp has, to the last bit what single cycles return.
#include "batch_cases.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;

namespace {

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
void expect_same(const M& mechanism, const Scene& scene, const L& law, std::size_t n) {
  ph::step_options<typename M::scalar> options;
  options.limits = n % 2 == 0 ? ph::saturation::clamp_each : ph::saturation::keep_direction;
  ph::brakes_of<M> brakes;
  brakes.torque_limit *= typename M::scalar(0.1);
  const auto seen = batch_cases::expect_that_of_single_cycles(
      mechanism, brakes, scene, law, options, batch_cases::any_states<M>(0, n, anywhere(mechanism)));
  for (int i = 0; i < 3; ++i) EXPECT_GT(seen[std::size_t(i)], int(n / 100)) << i;
}

template <class M>
auto one_plane(const M& mechanism, double stiffness) {
  constexpr int d = M::task_dimension;
  return ph::scene(
      ph::wall(ph::half_space<d>(middle_of(mechanism), -ph::point<d>(ph::point<d>::Ones())), stiffness));
}

TEST(batch, in_space) {
  const ph::delta<double> device;
  expect_same(device, one_plane(device, 1e2), ph::direct_control{0.1}, 2001);
}
TEST(batch, in_float) {
  const ph::xy_table<float> device;
  expect_same(device, one_plane(device, 1e7), ph::saturated_direct_control(), 2002);
}
// Its memory is new in each state
TEST(batch, of_the_recommended_law) {
  const ph::tendon_two_link<double> arm;
  expect_same(arm, one_plane(arm, 1e3),
              ph::recommended_law(arm, ph::brakes_of<ph::tendon_two_link<double>>()), 2001);
}
TEST(batch, at_several_walls_without_torque_limits) {
  const ph::tendon_two_link<double> arm;
  const auto scene = ph::scene(ph::wall(ph::half_space<2>({0.1, 0}, {-1, 0}), 1e3),
                               ph::wall(ph::half_space<2>({0, 0.1}, {0, -1}), 1e4));
  batch_cases::expect_that_of_single_cycles(
      arm, ph::unlimited_brake_parameters<double, 2>(), scene, ph::direct_control(),
      ph::step_options<double>(),
      batch_cases::any_states<ph::tendon_two_link<double>>(5, 2001, anywhere(arm)));
}

}  // namespace
