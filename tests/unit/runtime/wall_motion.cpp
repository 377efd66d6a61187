// Walls that move by the time of a cycle: as a shape that a program moves before each cycle.
#include "../support.hpp"

#include <passive_haptics/runtime/any_scene.hpp>
#include <passive_haptics/runtime/wall_motion.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <numbers>

namespace {

namespace rt = ph::runtime;

// The contacts of one wall that moves, over two seconds: by the scene itself, and set before each cycle.
void expect_contacts_of_moving(double period) {
  const ph::wall still(ph::half_space<2>({0, 0.5}, {0.1, -1}), 1e3);
  const ph::ball<2> ball({0, 0}, 0.2);
  const rt::wall_motion<2> motion{{0.01, -0.02}, 0.7, {0.05, 0.03}};
  ph::held_scene own(ph::scene(still, ph::wall(ph::moving(ball), 2e3)), period);
  ph::world_walls<2> walls;
  walls.add(still);
  const int number = walls.add_moving(ph::wall(ball, 2e3));
  rt::any_scene<2> by_itself(
      rt::scene_in_motion(ph::held_scene(ph::world<2>(walls), period), {{number, motion}}));
  rt::any_scene<2> copy = by_itself;
  ph::testing::random_source random(3);
  int touched = 0;
  for (double t = 0; t < 2; t += 1e-3) {
    const ph::point<2> x = random.uniform(0.15, 0.25) * random.direction<double, 2>();
    const double angle = 2 * std::numbers::pi * 0.7 * t, rate = 2 * std::numbers::pi * 0.7;
    own.scene().get<1>().shape.set_motion(
        std::sin(angle) * ph::point<2>(0.01, -0.02),
        ph::point<2>(0.05, 0.03) + rate * std::cos(angle) * ph::point<2>(0.01, -0.02));
    const auto expected = own.touched_at(x, t);
    for (rt::any_scene<2>* any : {&by_itself, &copy}) {
      const auto& found = any->touched_at(x, t);
      ASSERT_EQ(found.size(), expected.size());
      for (int i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].wall_number, expected[i].wall_number);
        EXPECT_EQ(found[i].depth, expected[i].depth);
        EXPECT_EQ(found[i].normal, expected[i].normal);
        EXPECT_EQ(found[i].wall_velocity, expected[i].wall_velocity);
        EXPECT_EQ(found[i].sensed_at, expected[i].sensed_at);
        EXPECT_EQ(found[i].curvature, expected[i].curvature);
        ++touched;
      }
    }
  }
  EXPECT_GT(touched, 500);
}

TEST(scene_in_motion, has_the_contacts_of_walls_that_are_moved_from_outside) { expect_contacts_of_moving(0); }
TEST(scene_in_motion, is_held_between_two_samples) { expect_contacts_of_moving(0.05); }

}  // namespace
