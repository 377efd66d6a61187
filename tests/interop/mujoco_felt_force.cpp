// A stiff hand feels settled forces of planar arms of three and four joints, in MuJoCo as in
// simulated_device.
#include <passive_haptics/interop/mujoco.hpp>

#include <experiments/felt_force.hpp>
#include <experiments/rods.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace {

namespace ph = passive_haptics;

constexpr std::size_t states = 150;

template <class M>
void expect_settled(const char* name, const M& arm) {
  const auto row = experiments::feel_with(
      arm, states, [&](const experiments::felt_state<M>& state, const ph::brake_vector<M>& capacity) {
        return experiments::feel_once<ph::mujoco_device<M>>(arm, state, capacity);
      });
  std::printf("%-30s displayed %3.0f %%, median %5.2f N, within 10 %%: %3.0f %%; others %zu, %zu, %zu\n",
              name, 100 * row.displayed_share(), row.median, 100 * row.within_share(), row.unknown_sign,
              row.not_at_rest, row.pose);
  EXPECT_NEAR(row.median, 1, 0.02);
  EXPECT_GE(row.within_share(), 0.85);
}

constexpr std::array three{0.15, 0.15, 0.1};
constexpr std::array four{0.12, 0.12, 0.1, 0.08};

TEST(mujoco_felt_force, three_joints) { expect_settled("3R", experiments::planar_rods(three)); }

TEST(mujoco_felt_force, three_joints_with_two_brakes) {
  expect_settled("3R, brakes 1 and 2", experiments::with_brakes<0, 1>(experiments::planar_rods(three)));
}

TEST(mujoco_felt_force, four_joints) { expect_settled("4R", experiments::planar_rods(four)); }

}  // namespace
