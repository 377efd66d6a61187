// Shapes and scenes that are known at run time only.
#include "../support.hpp"

#include <passive_haptics/runtime/any_scene.hpp>
#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/testing/support/random.hpp>

namespace {

namespace rt = ph::runtime;

TEST(any_shape, has_all_that_the_shape_has) {
  ph::moving ball(ph::ball<3>({0.1, 0, 0}, 0.05));
  ball.set_motion({0.01, 0, 0}, {0, 0.2, 0});
  const rt::any_shape<3> any(ball);
  ph::testing::random_source random(1);
  for (int k = 0; k < 20; ++k) {
    const ph::point<3> x = 0.2 * random.direction<double, 3>();
    EXPECT_EQ(any.distance(x), ball.distance(x));
    EXPECT_EQ(any.gradient(x), ball.gradient(x));
    EXPECT_EQ(any.hessian(x), ball.hessian(x));
    EXPECT_EQ(any.velocity(x), ball.velocity(x));
  }
  EXPECT_EQ(any.thickness(), ball.thickness());
  const ph::ball<2> still({0.1, 0}, 0.05);
  EXPECT_EQ(rt::any_shape<2>(still).bounds().upper, still.bounds().upper);
}

TEST(any_shape, lacks_what_the_shape_lacks) {
  const rt::any_shape<2> any(ph::half_space<2>({0, 0}, {0, 1}));
  EXPECT_TRUE(any.hessian({0, 0}).isZero(0));
  EXPECT_TRUE(any.velocity({0, 0}).isZero(0));
  EXPECT_FALSE(ph::all_finite(any.bounds().upper));
}

// For a law that takes one wall.
TEST(strongest_contact_of, is_the_one_of_the_largest_force) {
  const rt::any_scene<2> scene(ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e3),
                                         ph::wall(ph::half_space<2>({0, 0}, {1, 0}), 1e4)));
  rt::strongest_contact_of<2> one(scene);
  const auto touched = one.touched_at({-0.001, -0.002}, 0);
  ASSERT_EQ(touched.size(), 1);
  EXPECT_EQ(touched[0].wall_number, 1);
  EXPECT_EQ(one.touched_at({-0.001, -0.02}, 0)[0].wall_number, 0);
  EXPECT_TRUE(one.touched_at({1, 1}, 0).empty());
  EXPECT_TRUE(std::isnan(one.touched_at({0.0 / 0.0, 1}, 0)[0].depth));
  one.set_margin(0.1);
  EXPECT_EQ(one.touched_at({1, 0.05}, 0).size(), 1);
}

}  // namespace
