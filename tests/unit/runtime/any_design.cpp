// slow
// Functions of design, and the wall-following experiment, of a mechanism that is known at run time only.
#include "pairs.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/chains/serial_chain.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/runtime/any_design.hpp>

#include <cmath>

namespace {

using arm = ph::tendon_two_link<double>;

// Equal, or both NaN.
void expect_same(double a, double b) {
  EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << a << " and " << b;
}

TEST(any_design, has_the_numbers_of_the_functions_themselves) {
  const arm own;
  rt::design_list all;
  EXPECT_FALSE(all.make(rt::mechanism_model(own)));
  all.compile_for<arm>();
  const auto any = all.make(rt::mechanism_model(own));
  rt::design_brakes brakes{rt::brake_numbers(2), {0.1, 0.2}};
  brakes.brakes.torque_limit = {0.8, 1.2};
  const auto known = brakes.brakes.as<ph::switchable_brakes<arm>>();
  const ph::hybrid_brakes<arm> hybrid{known, {0.1, 0.2}};
  const ph::vector<double, 2> n(0.6, -0.8);
  std::vector<rt::path_place> path;
  const auto motion = random_motion(own, 50);
  for (const auto& s : motion) {
    const rt::path_place at{numbers(s.q), numbers(s.hand_force), numbers(n)};
    path.push_back(at);
    const auto found = any->displayable(at, brakes.brakes);
    const auto expected = ph::displayable(own, s.q, s.hand_force, n, known);
    EXPECT_EQ(found.display, expected.display);
    expect_same(found.angle, expected.angle);
    expect_same(found.max_force, expected.max_force);
    EXPECT_EQ(found.signs, rt::joint_numbers(expected.signs));
    expect_same(any->sink_slope(at, brakes, 2).slope,
                ph::sink_slope(own, s.q, s.hand_force, n, hybrid, 2).slope);
    expect_same(any->figures(at, brakes, 2).drag,
                ph::design_figures_at(own, ph::path_point<arm>{s.q, s.hand_force, n}, hybrid, 2).drag);
    EXPECT_EQ(any->brake_signs(at.q, numbers(s.qd), at.direction, brakes.brakes),
              rt::joint_numbers(ph::brake_signs(ph::brake_rates(own, s.q, s.qd),
                                                ph::brake_torque(ph::brake_jacobian(own, s.q), s.hand_force),
                                                brakes.brakes.as<ph::brakes_of<arm>>())));
    const auto references = ph::reference_forces(own, s.q);
    EXPECT_EQ(any->reference_forces(at.q).G[1], references.G(1, 0));
    const double signs[] = {1, -1};
    EXPECT_EQ(any->nearest_force(at.q, signs, at.direction),
              rt::task_numbers(
                  ph::nearest_force(ph::brake_jacobian(own, s.q), ph::brake_vector<arm>(signs), s.hand_force)
                      .force));
  }
  EXPECT_TRUE(any->has_reference_forces());
  expect_same(any->sink_depth(path, brakes, 2), ph::sink_depth(
                                                    own,
                                                    [&](double u) {
                                                      const auto& s =
                                                          motion[static_cast<std::size_t>(u * 50)];
                                                      return ph::path_point<arm>{s.q, s.hand_force, n};
                                                    },
                                                    hybrid, 2, 50));
  EXPECT_THROW(any->sink_slope({}, brakes, 2), std::invalid_argument);
}

TEST(any_design, follows_a_wall_as_the_simulated_device_itself) {
  const arm own;
  rt::design_list all;
  rt::catalogue plants;
  all.compile_for<arm>();
  plants.compile_for<arm>();
  const rt::mechanism_model any(own);
  const ph::joint_vector<arm> q(1.8, -1.2);
  const ph::point<2> x = own.position(q);
  const ph::half_space<2> plane(x, {0, -1});
  const ph::brakes_of<arm> brakes;
  const auto control = [&] {
    return ph::controller(own, brakes, ph::scene(ph::wall(plane, 1e4)), ph::direct_control());
  };
  const rt::hand_description hand{{1, 0}, {x[0], x[1]}, {}};
  const ph::wall_following_parameters parameters{.max_duration = 0.2};
  ph::simulated_device<arm> device(own, brakes, 0.5, q);
  const auto expected = ph::follow_wall(device, control(), plane, hand.hand<2>(), parameters);

  const auto plant =
      plants.make_plant(any, {2, rt::run_time_brake(ph::ideal_brakes(brakes)[0])}, 0.5, numbers(q));
  auto cycle = control();
  int steps = 0;
  const auto found = all.make(any)->follow_wall(
      *plant,
      [&](const rt::state_view& s) {
        return rt::cycle_record(cycle(ph::device_state<arm>{s.time, ph::joint_vector<arm>(s.q.data()),
                                                            ph::joint_vector<arm>(s.qd.data()),
                                                            ph::task_vector<arm>(s.hand_force.data())}));
      },
      rt::any_shape<2>(plane), hand, parameters, [&](const rt::following_record&) { ++steps; });
  EXPECT_EQ(steps, 2000);
  EXPECT_EQ(found.depth_mean, expected.depth_mean);
  EXPECT_EQ(found.brake_energy, expected.brake_energy);
  EXPECT_GT(found.max_depth, 0);
}

}  // namespace
