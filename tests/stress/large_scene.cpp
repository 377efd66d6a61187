// 100 000 shapes for 20 s at 1 kHz, and hands that jump: the contacts of a look at everything, by a few looks
// a cycle.
#include "effort.hpp"

#include "../unit/scene/many_shapes.hpp"

#include <gtest/gtest.h>

namespace {

namespace ph = passive_haptics;
using many_shapes::scan;

struct large_scene : ::testing::Test {
  unsigned seed = static_cast<unsigned>(stress::first_seed());
  ph::testing::random_source random{seed};
  many_shapes::shapes<3> all{100'000, random};
  ph::world<3> world{all.walls()};
  int touched = 0;

  void look(const ph::point<3>& x) {
    const auto& found = ph::sense(world, x);
    ASSERT_TRUE(many_shapes::same(found, scan<4>(all, x))) << "seed " << seed << ", at " << x.transpose();
    touched += found.size();
  }
};

TEST_F(large_scene, is_touched_as_a_scan_says_for_20_seconds) {
  many_shapes::wandering_hand<3> hand(2e-4, random);
  for (int k = 0; k < 20'000; ++k) look(hand.next());
  EXPECT_GT(touched, 100);
}

TEST_F(large_scene, is_touched_as_a_scan_says_wherever_the_hand_jumps) {
  ph::point<3> x = ph::point<3>::Constant(0.5);
  const auto jumps = stress::effort(5'000, 100'000);
  for (std::uint64_t k = 0; k < jumps; ++k) {
    const double size = random.positive(1e-7, 1.0);
    x = k % 5 == 0 ? random.between<double, 3>(ph::point<3>::Constant(-0.1), ph::point<3>::Constant(1.1))
                   : ph::point<3>(x + size * random.direction<double, 3>());
    look(x);
  }
  EXPECT_GT(touched, 100);
}

}  // namespace
