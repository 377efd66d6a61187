// A controller that is known at run time only.
#include "pairs.hpp"

#include "../support.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/world/world.hpp>

namespace {

using tendon = ph::tendon_two_link<double>;
using held_tendon = rt::held_mechanism<tendon>;

template <class L>
rt::controller_parts parts_of(rt::scene_variant scene,
                              const rt::brake_numbers& brakes = rt::brake_numbers(2)) {
  return {brakes, std::move(scene), rt::any_parameters(rt::law_parameters<L>())};
}

std::unique_ptr<rt::any_controller> controller_in(const rt::any_scene<2>& scene) {
  using law = ph::direct_control;
  return std::make_unique<rt::controller_of<held_tendon, law>>(held_tendon(tendon()), scene,
                                                               parts_of<law>(scene));
}

TEST(any_controller, has_the_cycles_of_the_controller_itself) {
  const tendon arm;
  const auto motion = random_motion(arm, 200);
  ph::world_walls<2> walls;
  const ph::point<2> x = arm.position(motion[0].q);
  walls.add(ph::wall(ph::half_space<2>(x, {0, 1}), 1e3));
  walls.add(ph::wall(ph::ball<2>(x, 0.1), 1e3));
  const ph::held_scene<ph::world<2>> scene(ph::world<2>(walls), 0.003);
  ph::controller direct(arm, ph::switchable_brakes<tendon>(), scene, ph::direct_control());
  const auto any = controller_in(rt::any_scene<2>(scene));
  int two = 0;
  for (const auto& state : motion) {
    const rt::cycle_record expected(direct(state)), found = (*any)(view_of(state));
    ASSERT_TRUE(same(found, expected));
    ASSERT_EQ(found.contact_count, expected.contact_count);
    for (int i = 0; i < found.contact_count; ++i)
      ASSERT_TRUE(ph::nth(found.contacts, i) == ph::nth(expected.contacts, i));
    two += found.contact_count == 2;
  }
  EXPECT_GT(two, 10);
}

TEST(any_controller, releases_the_brakes_where_numbers_are_missing) {
  const tendon arm;
  const auto state = random_motion(arm, 1)[0];
  const auto any = controller_in(rt::any_scene<2>(scene_through(arm, {0.3, 0.3})));
  const double three[] = {0, 0, 0};
  rt::state_view few = view_of(state), many = few, numb = few;
  few.q = {};
  many.qd = three;
  numb.hand_force = {};
  for (const auto& wrong : {few, many, numb}) {
    const rt::cycle_record r = (*any)(wrong);
    EXPECT_EQ(r.outcome, ph::status::state_not_finite);
    EXPECT_EQ(r.capacity, rt::joint_numbers(ph::vector<double, 2>(0, 0)));
  }
}

TEST(any_controller, is_for_brakes_and_a_scene_of_its_mechanism) {
  using law = ph::saturated_direct_control;
  const auto error_of = [](const rt::controller_parts& parts) {
    return thrown_by([&] { rt::make_controller<law>(held_tendon(tendon()), parts); });
  };
  const auto scene = scene_through(tendon(), {0.3, 0.3});
  EXPECT_EQ(error_of(parts_of<law>(rt::any_scene<2>(scene), rt::brake_numbers(3))),
            "passive_haptics: number of brakes = 3: expected 2");
  const rt::any_scene<3> space(ph::scene(ph::wall(ph::half_space<3>({0, 0, 0}, {0, 0, 1}))));
  EXPECT_EQ(error_of(parts_of<law>(space)),
            "passive_haptics: dimension of the scene = 3: expected 2, the task dimension of the mechanism");
}

TEST(any_controller, takes_other_brakes_and_copies_with_a_memory_of_its_own) {
  const tendon arm;
  const auto motion = random_motion(arm, 100);
  const auto any = controller_in(rt::any_scene<2>(scene_through(arm, motion[0].q)));
  rt::brake_numbers off(2);
  off.torque_upper[0] = off.torque_lower[0] = 0;
  const auto copy = any->copy();
  copy->set_brakes(off);
  int differ = 0;
  for (const auto& state : motion) {
    const rt::cycle_record a = (*any)(view_of(state)), b = (*copy)(view_of(state));
    EXPECT_EQ(b.capacity[0], 0);
    differ += a.capacity[0] > 0;
  }
  EXPECT_GT(differ, 10);
}

}  // namespace
