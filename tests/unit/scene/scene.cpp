// Scenes: what is touched, how deep, in which order.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

const ph::half_space<2> floor_below({0, 0}, {0, 1});

TEST(a_half_space, has_a_unit_normal_whatever_length_is_given) {
  EXPECT_EQ(ph::half_space<2>({1, 1}, {3, 4}).distance({0.4, 0.2}), -1);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  for (const double length : {least, 3 * least, 1e-310, 1e-200, 1e154, 1e200, 1e308}) {
    const ph::point<2> n = ph::half_space<2>({0, 0}, {length, length}).gradient({0, 0});
    EXPECT_NEAR(n.norm(), 1, 1e-15) << length;
    EXPECT_EQ(n[0], n[1]) << length;
  }
}

TEST(a_ball, is_free_outside_or_if_hollow_inside) {
  const ph::ball<3> solid({1, 0, 0}, 2), hollow({1, 0, 0}, 2, ph::filling::hollow);
  EXPECT_EQ(solid.distance({4, 0, 0}), 1);
  EXPECT_EQ(hollow.distance({1, 0.5, 0}), 1.5);
  EXPECT_EQ(solid.gradient({4, 0, 0}), ph::point<3>(1, 0, 0));
  EXPECT_EQ(hollow.gradient({4, 0, 0}), ph::point<3>(-1, 0, 0));
  EXPECT_EQ(solid.gradient({1, 0, 0}), ph::point<3>(1, 0, 0)) << "some unit vector at the centre";
  EXPECT_TRUE(solid.hessian({1, 0, 0}).isZero(0));
}

TEST(sensing, nothing_is_touched_on_the_surface_itself) {
  const auto walls = ph::scene(ph::wall(floor_below));
  EXPECT_TRUE(sense(walls, {5, 0}).empty());
  EXPECT_TRUE(sense(walls, {5, 1e-300}).empty());
  const auto touched = sense(walls, {5, -1e-300});
  ASSERT_EQ(touched.size(), 1);
  EXPECT_EQ(touched[0].depth, 1e-300);
}

TEST(sensing, a_contact_says_all_about_its_wall) {
  const auto walls =
      ph::scene(ph::wall(floor_below, 1e4), ph::wall(ph::disc({0, 0}, 1, ph::filling::hollow), 2e4));
  static_assert(decltype(walls)::wall_count == 2 && decltype(walls)::dimension == 2);
  const auto touched = sense(walls, {-1.5, 0.5});
  ASSERT_EQ(touched.size(), 1);
  EXPECT_EQ(touched[0].wall_number, 1);
  EXPECT_EQ(touched[0].stiffness, 2e4);
  EXPECT_DOUBLE_EQ(touched[0].depth, std::sqrt(2.5) - 1);
  EXPECT_TRUE(touched[0].normal.isApprox(ph::point<2>(1.5, -0.5).normalized()));
  EXPECT_EQ(touched[0].wall_velocity, ph::point<2>(0, 0));
  EXPECT_EQ(touched[0].sensed_at, ph::point<2>(-1.5, 0.5));
  // Of a hollow: -(I - n n^T) / |x|
  const ph::matrix<double, 2, 2> flat = ph::matrix_of<2, 2>(0.25, 0.75, 0.75, 2.25) / 2.5;
  EXPECT_TRUE(touched[0].curvature.isApprox(flat / -std::sqrt(2.5), 1e-15));
  EXPECT_EQ(ph::wall(floor_below).stiffness(), 1e7) << "of section 5.1";
  for (const double bad : {-1.0, HUGE_VAL}) EXPECT_THROW(ph::wall(floor_below, bad), std::invalid_argument);
}

TEST(a_contact, is_of_nothing_by_default) {
  const ph::contact<2> c;
  EXPECT_EQ(c.normal, ph::point<2>(1, 0));
  EXPECT_EQ(c.depth, 0);
  EXPECT_EQ(c.stiffness, 0);
  EXPECT_EQ(c.wall_velocity, ph::point<2>(0, 0));
  EXPECT_EQ(c.wall_number, 0);
  EXPECT_TRUE(std::isnan(c.sensed_at[0]) && std::isnan(c.sensed_at[1]));
  EXPECT_TRUE(c.curvature.isZero(0));
}

// As sensed there, to third order of the way; a plane, and a circle along it, to rounding.
TEST(a_contact, is_carried_to_where_the_handle_is) {
  const auto expect_as_sensed = [](const auto& shape, const auto& from, const auto& way, double tolerance) {
    const ph::wall w(shape);
    const std::remove_cvref_t<decltype(from)> to = from + way;
    const auto carried = ph::carried_to(to, ph::contact_of(w, from, shape.distance(from)));
    const auto sensed = ph::contact_of(w, to, shape.distance(to));
    EXPECT_NEAR(carried.depth, sensed.depth, tolerance);
    EXPECT_LT((carried.normal - sensed.normal).norm(), std::sqrt(tolerance));
    EXPECT_NEAR(carried.normal.norm(), 1, 1e-15);
    EXPECT_EQ(carried.sensed_at, to);
  };
  using P2 = ph::point<2>;
  using P3 = ph::point<3>;
  expect_as_sensed(ph::half_space<2>(P2(0, 0), P2(3, 4)), P2(1, -2), P2(0.3, 0.5), 1e-15);
  for (const auto filling : {ph::filling::solid, ph::filling::hollow})
    expect_as_sensed(ph::disc(P2(0, 0), 1, filling), P2(0, 1.1), P2(2, 0), 1e-15);
  const double h = 1e-3;
  expect_as_sensed(ph::ball<3>(P3(0, 0, 0), 0.5), P3(0.1, 0.2, 0.3), h * P3(1, -2, 1), 50 * h * h * h);
  expect_as_sensed(ph::capsule<3>(P3(0, 0, 0), P3(0, 0, 1), 0.5), P3(0.2, 0.3, 0.4), h * P3(1, -2, 1),
                   50 * h * h * h);
  expect_as_sensed(ph::offset(ph::box<2>(P2(0, 0), P2(1, 1)), 0.5), P2(1.2, 1.3), h * P2(2, -1),
                   50 * h * h * h);
}

// All subsets of walls, by points all over the place.
TEST(sensing, gives_exactly_the_touched_walls_in_the_order_of_construction) {
  const ph::half_space<3> ground({0, 0, 0}, {0, 0, 1}), side({0.5, 0, 0}, {-1, 0, 0});
  const ph::ball<3> stone({0, 0, 0.2}, 0.4), room({0, 0, 0}, 1, ph::filling::hollow);
  const auto walls = ph::scene(ph::wall(ground, 1), ph::wall(stone, 2), ph::wall(side, 3), ph::wall(room, 4));
  ph::testing::random_source random(8);
  unsigned seen = 0;
  for (int k = 0; k < 2000; ++k) {
    const ph::point<3> x = random.between<double, 3>({-1, -1, -1}, {1, 1, 1});
    const double distances[] = {ground.distance(x), stone.distance(x), side.distance(x), room.distance(x)};
    const auto touched = sense(walls, x);
    int next = 0;
    unsigned pattern = 0;
    for (int wall = 0; wall < 4; ++wall) {
      if (distances[wall] >= 0) continue;
      ASSERT_LT(next, touched.size()) << "seed 8, x = " << x.transpose();
      EXPECT_EQ(touched[next].wall_number, wall);
      EXPECT_EQ(touched[next].depth, -distances[wall]);
      EXPECT_EQ(touched[next].stiffness, wall + 1);
      pattern |= 1u << wall;
      ++next;
    }
    EXPECT_EQ(touched.size(), next);
    EXPECT_EQ(touched.end() - touched.begin(), next);
    EXPECT_EQ(touched.empty(), next == 0);
    seen |= 1u << pattern;
  }
  EXPECT_EQ(std::popcount(seen), 10) << "all combinations that this room allows";
}

TEST(sensing, begins_at_the_margin_with_a_depth_below_zero) {
  auto scene = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 5.0),
                         ph::wall(ph::half_space<2>({0, 1}, {0, -1}), 7.0));
  scene.set_margin(0.25);
  for (const double y : {0.2, 1e-9, -1e-9, -3.0}) {
    const auto touched = sense(scene, {0, y});
    ASSERT_EQ(touched.size(), 1) << y;
    EXPECT_EQ(touched[0].depth, -y);
    EXPECT_EQ(touched[0].stiffness, 5);
  }
  EXPECT_EQ(sense(scene, {0, 0.25}).size(), 0) << "not on the margin itself";
  EXPECT_EQ(sense(scene, {0, 0.8}).size(), 1);
  scene.set_margin(0.75);
  EXPECT_EQ(sense(scene, {0, 0.5}).size(), 2);
  scene.set_margin(0);
  EXPECT_EQ(sense(scene, {0, 1e-9}).size(), 0);
}

TEST(sensing, a_position_that_is_not_finite_touches_with_a_depth_that_is_not) {
  const auto walls = ph::scene(ph::wall(floor_below), ph::wall(ph::disc({0, 0}, 1)));
  const auto touched = sense(walls, {0.0, std::numeric_limits<double>::quiet_NaN()});
  ASSERT_EQ(touched.size(), 2);
  for (const auto& c : touched) EXPECT_TRUE(std::isnan(c.depth));
}

TEST(contact_list, holds_up_to_its_capacity_and_says_when_it_is_full) {
  ph::contacts<2, 2> list;
  EXPECT_TRUE(list.empty());
  EXPECT_TRUE(list.push_back({.depth = 1}));
  EXPECT_TRUE(list.push_back({.depth = 2}));
  EXPECT_FALSE(list.push_back({.depth = 3}));
  ASSERT_EQ(list.size(), 2);
  EXPECT_EQ(list[0].depth, 1);
  EXPECT_EQ(list[1].depth, 2);
  EXPECT_EQ(list.end() - list.begin(), 2);
  EXPECT_EQ(&ph::as_single(list)[0], &list[0]);
#ifndef NDEBUG
  EXPECT_DEATH(list[2], "");
  EXPECT_DEATH(list[-1], "");
#endif
  list.clear();
  EXPECT_EQ(list.size(), 0);
}

template <int Capacity>
void expect_copies_of_all() {
  ph::contacts<2, Capacity> touched, other;
  EXPECT_TRUE(touched.empty());
  for (int k = 0; k < Capacity; ++k)
    touched.push_back({.normal = {0, 1}, .depth = 1.0 + k, .wall_number = k, .sensed_at = {2.0, double(k)}});
  const auto copy = touched;
  other.push_back({.depth = 9});
  other = touched;
  touched.clear();
  EXPECT_TRUE(touched.empty() && touched.begin() == touched.end());
  for (const auto& same : {copy, other}) {
    ASSERT_EQ(same.size(), Capacity);
    for (int k = 0; k < Capacity; ++k) {
      EXPECT_EQ(same[k].depth, 1.0 + k);
      EXPECT_EQ(same[k].wall_number, k);
      EXPECT_EQ(same[k].sensed_at, ph::point<2>(2, k));
    }
  }
  touched.push_back({.depth = 5});
  EXPECT_EQ(touched[0].depth, 5) << "a slot that was used before";
  EXPECT_EQ(touched[0].normal, ph::point<2>(1, 0));
}
TEST(contacts, are_copied_whole) {
  expect_copies_of_all<1>();
  expect_copies_of_all<3>();
}

struct resting_law : ph::no_direct_control {
  ph::velocity_direct_control_parameters parameters() const { return {}; }
};

// Under a law that rests the hand at 2 mm.
TEST(a_controller, rejects_a_wall_through_which_its_law_presses) {
  using M = ph::xy_table<double>;
  const ph::velocity_direct_control law;
  const ph::rectangle plate({0, 0}, {0.1, 0.0025}), block({0, 0}, {0.1, 0.003});
  const std::string text =
      "thickness of wall 1 of a scene [m] = 0.005: expected >= 0.006, three times the rest_depth of the law; "
      "use a world for a thinner wall";
  const auto scene_with = [](const auto& shape) { return ph::scene(ph::wall(floor_below), ph::wall(shape)); };
  const auto rejection_of = [&](const auto& scene) {
    return thrown_by([&] { ph::detail::require_thick_walls(scene, law); });
  };
  EXPECT_NE(thrown_by([&] {
              ph::controller(M(), ph::brakes_of<M>(), scene_with(plate), resting_law());
            }).find(text),
            std::string::npos);
  EXPECT_NE(rejection_of(ph::held_scene(scene_with(ph::moving(plate)), 0.05)).find(text), std::string::npos);
  EXPECT_NE(rejection_of(scene_with(ph::capsule<2>({0, 0}, {1, 1}, 0.0025))).find(text), std::string::npos);
  EXPECT_NE(rejection_of(scene_with(ph::offset(block, -0.0005))).find(text), std::string::npos);
  EXPECT_EQ(rejection_of(scene_with(ph::offset(plate, 0.001))), "nothing");
  EXPECT_EQ(rejection_of(scene_with(block)), "nothing");
  EXPECT_EQ(rejection_of(scene_with(ph::complement(plate))), "nothing");
  EXPECT_EQ(rejection_of(scene_with(ph::disc({0, 0}, 0.001, ph::filling::hollow))), "nothing");
}

}  // namespace
