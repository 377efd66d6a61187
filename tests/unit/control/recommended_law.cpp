// The law of a controller for which none was chosen, and the reason.
#include "../support.hpp"

#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <type_traits>

namespace {

namespace recommended_laws {

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

}  // namespace recommended_laws

}  // namespace
