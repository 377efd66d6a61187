// Which optional members a type has, as the library sees it.
#include <passive_haptics/passive_haptics.hpp>

#include <gtest/gtest.h>

namespace ph = passive_haptics;

namespace {

static_assert(ph::describe<ph::tendon_two_link<double>>().has("transmission"));
static_assert(ph::describe<ph::tendon_two_link<double>>().has("pose"));
static_assert(ph::describe<ph::tendon_two_link<double>>().has("mass_matrix"));
static_assert(ph::describe<ph::direct_control>().has("needs_hand_force"));
static_assert(!ph::describe<ph::direct_control>().has("memory"));
static_assert(ph::describe<ph::velocity_direct_control>().has("memory"));

struct position_alone {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return q;
  }
};
struct not_const : position_alone {
  ph::matrix<double, 2, 2> mass_matrix(const ph::vector<double, 2>&);
};

struct state_of_a_sensor {
  double time;
  ph::vector<double, 2> q, qd, hand_forc;
};
static_assert(ph::describe<ph::device_state<position_alone>>().has("hand_force"));
static_assert(!ph::describe<state_of_a_sensor>().has("hand_force"), "a name that is misspelt");

TEST(a_description, lists_what_was_found_and_what_was_not) {
  EXPECT_EQ(to_text(ph::describe(ph::tendon_two_link<double>())),
            "jacobian, transmission, pose, mass_matrix, bias_torque, bias_acceleration, "
            "inverse_transposed_jacobian; not found: brake_bias_acceleration, inverse_jacobian");
  EXPECT_EQ(to_text(ph::describe(position_alone())),
            "none; not found: jacobian, transmission, pose, mass_matrix, bias_torque, bias_acceleration, "
            "brake_bias_acceleration, inverse_jacobian, inverse_transposed_jacobian");
  EXPECT_FALSE(ph::describe<not_const>().has("mass_matrix")) << "a function that is not const";
  EXPECT_EQ(to_text(ph::describe(ph::brakes_of<position_alone>())),
            "torque_limit, rate_dead_band, torque_dead_band, time_constant; not found: torque_lower, "
            "torque_upper");
  EXPECT_TRUE(ph::describe<ph::switchable_brakes<position_alone>>().has("torque_lower"));
  EXPECT_EQ(to_text(ph::describe(ph::unlimited_brakes())),
            "none; not found: torque_limit, torque_lower, torque_upper, rate_dead_band, torque_dead_band, "
            "time_constant");
  EXPECT_EQ(to_text(ph::describe(ph::direct_control())),
            "needs_hand_force, nulls_normal_force; not found: needs_dynamics, needs_brake_lag, "
            "needs_sensed_at, needs_rising_time, saturates_before_scaling, max_contacts, memory");
  EXPECT_EQ(to_text(ph::describe(ph::device_state<position_alone>())), "hand_force; not found: hand_torque");
  EXPECT_EQ(to_text(ph::describe(ph::device_state_at_rest<position_alone>())), "hand_force, hand_torque");
}

TEST(a_description, refuses_a_name_that_no_member_has) {
  EXPECT_THROW(ph::describe<position_alone>().has("transmision"), std::invalid_argument);
}

}  // namespace
