// The law for who has not chosen one: which it is, why, and that a hand glides under it.
#include "wall_experiment.hpp"

#include <passive_haptics/control/laws/recommended_law.hpp>

#include <type_traits>

namespace {

using arm = ph::tendon_two_link<double>;

// The same arm without inertia.
struct light_arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return arm().position(q); }
  ph::matrix<double, 2, 2> jacobian(const ph::vector<double, 2>& q) const { return arm().jacobian(q); }
  ph::matrix<double, 2, 2> transmission() const { return arm().transmission(); }
};
static_assert(ph::Mechanism<light_arm> && !ph::Dynamics<light_arm>);

template <class M, class State = ph::device_state<M>, class B = ph::brakes_of<M>>
using recommended = decltype(ph::recommended_law<State>(M(), B()));
using best = ph::velocity_direct_control;
using next_best = ph::on_off_control;
static_assert(std::is_same_v<recommended<arm>, best>);
static_assert(std::is_same_v<recommended<light_arm>, next_best>, "no inertia");
static_assert(std::is_same_v<recommended<arm, ph::sensorless_device_state<arm>>, next_best>, "no sensor");
static_assert(std::is_same_v<recommended<arm, ph::device_state<arm>, ph::unlimited_brakes>, next_best>);
static_assert(std::is_same_v<decltype(ph::recommended_law(arm(), ph::brakes_of<arm>())), best>);

TEST(recommended_law, says_what_a_better_one_lacks) {
  const ph::brakes_of<arm> brakes;
  EXPECT_TRUE(ph::reason_for_law(arm(), brakes).starts_with("velocity_direct_control: "));
  EXPECT_NE(ph::reason_for_law(light_arm(), ph::brakes_of<light_arm>()).find("inertia (mass_matrix"),
            std::string_view::npos);
  EXPECT_NE(ph::reason_for_law<ph::sensorless_device_state<arm>>(arm(), brakes).find("force sensor"),
            std::string_view::npos);
  EXPECT_NE(ph::reason_for_law(arm(), ph::unlimited_brakes()).find("time_constant"), std::string_view::npos);
}

TEST(recommended_law, leads_by_the_lag_of_the_slowest_brake) {
  ph::brakes_of<light_arm> brakes;
  brakes.time_constant = {0.01, 0.03};
  EXPECT_EQ(ph::recommended_law(light_arm(), brakes).parameters.lead, 0.03);
}

// The tendon device with its default brakes, a hand along the wall, the environment at 1 kHz.
template <class M, class State>
ph::contact_metrics along_the_wall() {
  auto e = tendon_device<double>(0.02);
  ph::brakes_of<M> brakes;
  const auto law = ph::recommended_law<State>(M(), brakes);
  ph::controller control(M(), brakes, ph::held_scene(ph::scene(ph::wall(wall)), 1e-3), law);
  const auto controller = [&](const ph::device_state<arm>& s) {
    State state;
    state.time = s.time;
    state.q = s.q;
    state.qd = s.qd;
    if constexpr (requires { state.hand_force; }) state.hand_force = s.hand_force;
    const auto result = control(state);
    ph::step_result<arm> same;
    same.capacity = result.capacity;
    same.wall_number = result.wall_number;
    return same;
  };
  return ph::follow_wall(e.device, controller, wall, e.hand, {});
}

TEST(recommended_law, lets_the_hand_glide_whatever_the_device_has) {
  for (const ph::contact_metrics& figures : {along_the_wall<arm, ph::device_state<arm>>(),
                                             along_the_wall<light_arm, ph::device_state<light_arm>>(),
                                             along_the_wall<arm, ph::sensorless_device_state<arm>>()}) {
    EXPECT_EQ(figures.separations, 0);
    EXPECT_TRUE(figures.arrived) << "the hand goes the whole way";
    EXPECT_GT(figures.depth_mean, 0.5e-3) << "it is in contact";
    EXPECT_LT(figures.max_depth, 3e-3) << "and held";
  }
}

}  // namespace
