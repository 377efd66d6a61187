// Batches of the paper's device: to the last bit what single cycles return, whatever stands in a state.
#include "batch_cases.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

using tendons = ph::tendon_two_link<double>;
using plane = ph::half_space<2>;

std::vector<ph::device_state<tendons>> states_about(double y, unsigned seed, std::size_t n) {
  const tendons mechanism;
  return batch_cases::any_states<tendons>(seed, n, [&](auto& random) {
    const double depth = random.coin() ? random.uniform(-1e-3, 3e-3) : 0.0;
    const auto elbow = random.coin() ? ph::elbow::left : ph::elbow::right;
    return mechanism.inverse({random.uniform(-0.25, 0.25), y + depth}, elbow).q;
  });
}

template <class L>
void expect_that_of_single_cycles(const L& law, ph::saturation limits, double stiffness) {
  ph::step_options<double> options;
  options.limits = limits;
  const auto scene = ph::scene(ph::wall(plane({0, 0.225}, {0, -1}), stiffness));
  const auto seen = batch_cases::expect_that_of_single_cycles(tendons(), ph::brakes_of<tendons>(), scene, law,
                                                              options, states_about(0.225, 1, 1003));
  for (const int count : seen) EXPECT_GT(count, 40);
}

TEST(batch, without_direct_control) {
  expect_that_of_single_cycles(ph::no_direct_control(), ph::saturation::keep_direction, 1e7);
}

TEST(batch, of_direct_control_with_a_dead_band) {
  expect_that_of_single_cycles(ph::direct_control{0.2}, ph::saturation::clamp_each, 1e3);
}

TEST(batch, of_saturated_direct_control) {
  expect_that_of_single_cycles(ph::saturated_direct_control(), ph::saturation::clamp_each, 1e7);
}

auto direct(double stiffness = 1e4) {
  return ph::controller(tendons(), ph::brakes_of<tendons>(),
                        ph::scene(ph::wall(plane({0, 0.225}, {0, -1}), stiffness)), ph::direct_control());
}

std::string error_of(const ph::batch_states<tendons>& in, const ph::batch_results<tendons>& out) {
  try {
    direct().batch(in, out);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

// Nothing beyond them: behind the arrays stands what stood there
TEST(batch, of_any_number_of_states) {
  const auto control = direct();
  for (std::size_t n = 0; n < 12; ++n) {
    const auto given = states_about(0.225, 2, 12);
    batch_cases::states<tendons> in(given);
    batch_cases::results<tendons> all(12), some(12);
    control.batch(in.spans(), all.spans());
    control.batch(part_of(in.spans(), 0, n), part_of(some.spans(), 0, n));
    for (std::size_t k = 0; k < 12; ++k) {
      const double first = some.capacity.of[0][k], second = some.signs.of[1][k];
      EXPECT_EQ(first, k < n ? all.capacity.of[0][k] : -7) << n << ", " << k;
      EXPECT_EQ(second, k < n ? all.signs.of[1][k] : -7) << n << ", " << k;
      EXPECT_TRUE(k >= n || some.display[k] == all.display[k]) << n << ", " << k;
    }
  }
}

// At one time, within one period: each state has a scene that has not seen the handle before
TEST(batch, at_a_held_scene_samples_it_for_each_state) {
  const auto scene = ph::scene(ph::wall(plane({0, 0.225}, {0, -1}), 1e4));
  const auto given = states_about(0.225, 5, 200);
  batch_cases::states<tendons> in(given);
  std::fill(in.time.begin(), in.time.end(), 0.0);
  batch_cases::results<tendons> held(given.size()), free(given.size());
  const auto run = [&](const auto& seen, auto& to) {
    ph::controller(tendons(), ph::brakes_of<tendons>(), seen, ph::direct_control())
        .batch(in.spans(), to.spans());
  };
  run(ph::held_scene(scene, 1.0), held);
  run(scene, free);
  EXPECT_EQ(held.capacity.of, free.capacity.of);
}

TEST(batch, of_states_without_hand_force_and_time) {
  const std::size_t n = 501;
  std::vector<ph::device_state<tendons>> given = states_about(0.225, 4, n);
  for (auto& s : given) {
    s.time = 0;
    s.hand_force.setZero();
  }
  batch_cases::states<tendons> in(given);
  auto without = in.spans();
  without.time = {};
  without.hand_force = {};
  batch_cases::results<tendons> got(n), expected(n);
  const ph::controller control(tendons(), ph::brakes_of<tendons>(),
                               ph::scene(ph::wall(plane({0, 0.225}, {0, -1}), 1e4)), ph::no_direct_control());
  control.batch(in.spans(), expected.spans());
  control.batch(without, got.spans());
  EXPECT_EQ(got.capacity.of, expected.capacity.of);
  EXPECT_EQ(got.outcome, expected.outcome);
  EXPECT_EQ(got.signs.of, expected.signs.of);
}

TEST(batch, refuses_arrays_of_other_lengths) {
  batch_cases::states<tendons> in(states_about(0.225, 5, 10));
  batch_cases::results<tendons> out(10);
  EXPECT_EQ(error_of(in.spans(), out.spans()), "");
  EXPECT_EQ(error_of({}, {}), "");
  const auto error_after = [&](const auto& change) {
    auto states = in.spans();
    auto results = out.spans();
    change(states, results);
    return error_of(states, results);
  };
  EXPECT_EQ(error_after([](auto& s, auto&) { s.qd[1] = s.qd[1].subspan(0, 9); }),
            "passive_haptics: length of qd[1] = 9: expected 10, one number for each state, as q[0] has");
  EXPECT_EQ(error_after([](auto& s, auto&) { s.hand_force[0] = {}; }),
            "passive_haptics: length of hand_force[0] = 0: expected 10, one number for each state, as q[0] "
            "has; or leave hand_force empty");
  EXPECT_EQ(error_after([](auto& s, auto&) { s.hand_force = {}; }),
            "passive_haptics: length of hand_force[0] = 0: expected 10, as the law needs a hand force; or "
            "use a law that needs none (no_direct_control)");
  EXPECT_EQ(error_after([](auto&, auto& r) { r.outcome = {}; }),
            "passive_haptics: length of outcome = 0: expected 10, one number for each state, as q[0] has");
  EXPECT_EQ(error_after([](auto&, auto& r) { r.alpha = r.alpha.subspan(0, 1); }),
            "passive_haptics: length of alpha = 1: expected 10, one number for each state, as q[0] has; or "
            "leave alpha empty");
}

template <class L, class S>
void expect_that_of_single_cycles(const L& law, const S& shape,
                                  const ph::step_options<double>& options = {}) {
  batch_cases::expect_that_of_single_cycles(tendons(), ph::brakes_of<tendons>(),
                                            ph::scene(ph::wall(shape, 1e4)), law, options,
                                            states_about(0.225, 7, 501));
}

TEST(batch, of_invalid_options_releases) {
  ph::step_options<double> options;
  options.min_cosine = std::numeric_limits<double>::quiet_NaN();
  expect_that_of_single_cycles(ph::direct_control(), plane({0, 0.225}, {0, -1}), options);
}

// A law of one's own: alpha out of [0, 1] and NaN for some hands
struct any_share {
  static constexpr bool needs_hand_force = true;
  double scale(const ph::contact_situation<double, 2>& c) const noexcept {
    return c.hand_force[0] / c.hand_force[1];
  }
};
struct wall_that_moves : plane {
  using plane::plane;
  ph::point<2> velocity(const ph::point<2>&) const { return {0.1, -0.1}; }
};

TEST(batch, of_a_custom_law_at_a_wall_that_moves) {
  expect_that_of_single_cycles(any_share(), plane({0, 0.225}, {0, -1}));
  expect_that_of_single_cycles(ph::direct_control(), wall_that_moves({0, 0.225}, {0, -1}));
}

}  // namespace
