// What a step tells before anything is known, and of brakes that are released.
#include "../support.hpp"

#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <cstring>
#include <limits>
#include <new>

namespace {

using M = ph::xy_table<double>;

TEST(step_result, is_of_free_space_at_first) {
  const ph::step_result_of_contacts<M, 2> fresh;
  EXPECT_EQ(fresh.outcome, ph::status::ok);
  EXPECT_EQ(fresh.wall_number, -1);
  EXPECT_EQ(fresh.power, ph::power_class::none);
  EXPECT_EQ(fresh.display, ph::display_class::exact);
  EXPECT_FALSE(fresh.saturated);
  EXPECT_EQ(fresh.alpha, 1);
  EXPECT_EQ(fresh.approximation_cosine, 1);
  for (const auto& x : {fresh.capacity, fresh.torque, fresh.cone_coefficients, fresh.signs})
    EXPECT_TRUE(x.isZero(0));
  EXPECT_TRUE(fresh.desired_force.isZero(0) && fresh.control_force.isZero(0));
  EXPECT_EQ(fresh.contact_count, 0);
  for (const auto& report : fresh.contacts) {
    EXPECT_EQ(report.wall_number, -1);
    EXPECT_EQ(report.wanted, 0);
    EXPECT_EQ(report.displayed, 0);
    EXPECT_FALSE(report.has_priority);
  }
}

// As a member of a driver's struct before the first cycle, where other bytes were before.
TEST(brake_command, is_of_released_brakes_at_first) {
  alignas(64) unsigned char storage[sizeof(ph::brake_command<M>)];
  std::memset(storage, 0x41, sizeof storage);
  const auto* fresh = ::new (storage) ph::brake_command<M>;
  EXPECT_TRUE(fresh->capacity.isZero(0));
  EXPECT_EQ(fresh->outcome, ph::status::ok);
}

TEST(step_result, of_a_fault_displays_nothing) {
  EXPECT_EQ(ph::released<ph::step_result<M>>(ph::status::state_not_finite).display, ph::display_class::none);
  EXPECT_EQ(ph::released<ph::step_result<M>>(ph::status::ok).display, ph::display_class::exact);
  EXPECT_TRUE(ph::released<ph::brake_command<M>>(ph::status::state_not_finite).capacity.isZero(0));
}

// 5 N m of each brake.
struct strong_law {
  static constexpr bool commands_torques = true;
  template <class Situation, class Contacts>
  auto torque(const Situation& now, const Contacts&) const noexcept {
    return (-5 * now.s).eval();
  }
};

TEST(step_result, is_saturated_where_there_is_a_limit) {
  const auto saturated = [&](const auto& brakes) {
    ph::contacts<2, 1> touched;
    touched.push_back(asking_for<2>({0, 5}));
    ph::step_memory<strong_law> memory;
    const auto result = ph::step(M(), brakes, touched, strong_law(), state_of<M>({0, 0}, {-1, -1}), memory);
    EXPECT_GT(result.capacity.minCoeff(), 0);
    return result.saturated;
  };
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(4);
  EXPECT_TRUE(saturated(brakes));
  EXPECT_FALSE(saturated(ph::unlimited_brakes()));
  ph::contacts<2, 1> touched;
  touched.push_back(asking_for<2>({0, 5}));
  ph::step_memory<ph::no_direct_control> memory;
  EXPECT_FALSE(ph::step(M(), ph::unlimited_brakes(), touched, ph::no_direct_control(),
                        state_of<M>({0, 0}, {-1, -1}), memory)
                   .saturated);
}

}  // namespace
