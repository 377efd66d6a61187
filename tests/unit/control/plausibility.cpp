// What looks odd about a device and its walls is said, and nothing about one on a desk.
#include "../../property/custom_mechanisms.hpp"

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/design/plausibility.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

namespace ph = passive_haptics;
using device = ph::two_link<double>;

TEST(plausibility, has_nothing_to_say_of_a_device_on_a_desk) {
  EXPECT_EQ(ph::plausibility(device(), ph::brakes_of<device>(),
                             ph::scene(ph::wall(ph::half_space<2>({0, 0.2}, {0, -1}))), {0.3, 1.2}),
            "");
}

TEST(plausibility, names_each_part_and_value) {
  const device arm({.length_1 = 150});
  const auto walls = ph::scene(ph::wall(ph::half_space<2>({0, 0.2}, {0, -1})),
                               ph::wall(ph::half_space<2>({0, 0.2}, {0, -1}), 1));
  EXPECT_EQ(
      ph::plausibility(arm, ph::brakes_of<device>(), walls, {90, 0.1}),
      "mechanism: length_1 [m] = 150, usually within 5 m: millimetres?\n"
      "wall 1: stiffness of a wall [N/m] = 1, usually 100 to 1e9: N/mm?\n"
      "q[0] [rad or m] = 90, usually within two turns: degrees?\n"
      "mechanism: distance of the end effector from the base [m] = 150.149, usually within 5 m: "
      "millimetres?\n"
      "wall 0: distance of the end effector [m] = -134.026, usually outside at the start: a normal that "
      "points into the wall?\n"
      "wall 1: distance of the end effector [m] = -134.026, usually outside at the start: a normal that "
      "points into the wall?\n");
}

// 4 pi = 12.566
TEST(plausibility, asks_beyond_two_turns_and_five_metres) {
  using arm = custom::planar_arm<double>;
  EXPECT_EQ(ph::plausibility(arm(), ph::unlimited_brakes(), 0, {12.56, -12.56, 0}), "");
  EXPECT_EQ(ph::plausibility(arm(), ph::unlimited_brakes(), 0, {0, -12.57, 0}),
            "q[1] [rad or m] = -12.57, usually within two turns: degrees?\n");
  const ph::xy_table<double> table;
  EXPECT_EQ(ph::plausibility(table, ph::unlimited_brakes(), 0, {3, -3.99}), "");
  EXPECT_EQ(ph::plausibility(table, ph::unlimited_brakes(), 0, {3, -4.01}),
            "mechanism: distance of the end effector from the base [m] = 5.008, usually within 5 m: "
            "millimetres?\n");
}

TEST(plausibility, asks_no_table_of_a_mechanism) {
  using arm = custom::planar_arm<double>;
  EXPECT_EQ(ph::plausibility(arm(), ph::unlimited_brakes(), 0, {0, 45, 0}),
            "q[1] [rad or m] = 45, usually within two turns: degrees?\n");
}
