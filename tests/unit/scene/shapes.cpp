// slow, optimised
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../../property/user_shapes.hpp"
#include "closest_points.hpp"

#include <limits>

namespace ph = passive_haptics;
using ph::testing::random_source;

namespace {

constexpr unsigned seed = 1985;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
ph::point<D> anywhere(random_source& random, double size) {
  return random.between<double, D>(ph::point<D>::Constant(-size), ph::point<D>::Constant(size));
}

template <int D>
ph::matrix<double, D, D> any_frame(random_source& random) {
  return random.orthogonal_directions<D>();
}

// The error of a constructor.
template <class F>
std::string error_of(F&& make) {
  try {
    make();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "none";
}

static_assert(ph::Shape<ph::offset<ph::complement<ph::moving<custom::torus>>>>);
static_assert(ph::MovingShape<ph::offset<ph::complement<ph::moving<custom::torus>>>>);
static_assert(!ph::MovingShape<ph::offset<ph::complement<custom::torus>>>);
static_assert(!ph::MovingShape<ph::box<2>>);
static_assert(ph::PlaneFaced<ph::box<3>> && ph::PlaneFaced<ph::convex_polygon<4>>);
static_assert(!ph::PlaneFaced<ph::capsule<3>>);

}  // namespace

template <int D>
void capsule_against_search() {
  random_source random(seed);
  for (int k = 0; k < 500; ++k) {
    const auto a = anywhere<D>(random, 1), x = anywhere<D>(random, 2);
    const ph::point<D> b = k % 10 == 0 ? a : anywhere<D>(random, 1);
    const double radius = k % 7 == 0 ? 0 : random.uniform(0.0, 1.0);
    const ph::capsule<D> shape(a, b, radius);
    ASSERT_NEAR(shape.distance(x), static_cast<double>(closest_points::from_segment<D>(x, a, b) - radius),
                16 * eps)
        << "seed " << seed << ", x = " << x.transpose();
  }
}

TEST(capsule, has_the_distance_that_a_search_over_its_segment_finds) {
  capsule_against_search<2>();
  capsule_against_search<3>();
}

// On the medial axis and where squares leave the range of numbers.
TEST(a_shape, has_a_unit_gradient_where_it_has_none_to_choose) {
  const auto expect_unit = []<class S>(const S& shape, const ph::point<S::dimension>& x) {
    EXPECT_NEAR(shape.gradient(x).norm(), 1, 4 * eps) << typeid(S).name() << " at " << x.transpose();
  };
  const ph::point<3> from(0, 0, 0), to(1, 2, -2);
  EXPECT_NEAR(ph::capsule<3>(from, to, 0.1).gradient(0.5 * to).dot(to), 0, 8 * eps);
  expect_unit(ph::capsule<3>(from, to, 0.1), 0.5 * to);
  expect_unit(ph::capsule<3>(to, to, 0.5), to);
  for (int axis = 0; axis < 3; ++axis) {
    const ph::point<3> along = ph::point<3>::Unit(axis);
    const ph::point<3> across = ph::capsule<3>(from, -along, 0.1).gradient(-0.5 * along);
    EXPECT_EQ(across.norm(), 1);
    EXPECT_EQ(across.dot(along), 0);
  }
  const ph::capsule<2> lying({0, 0}, {1, 0}, 1);
  EXPECT_EQ(lying.gradient({0.5, 1e-170}), ph::point<2>(0, 1));
  EXPECT_EQ(lying.gradient({0.5, -5e-324}), ph::point<2>(0, -1));

  EXPECT_EQ(ph::box<3>({0, 0, 0}, {1, 2, 3}).gradient({0, 0, 0}), ph::point<3>(1, 0, 0))
      << "the nearest face";
  expect_unit(ph::box<2>({1, 1}, {0, 0}), {1, 1});
  const ph::convex_polygon square({{0, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}});  // three corners on a line
  EXPECT_EQ(square.distance({0.5, -1}), 1);
  for (const ph::point<2>& x : {ph::point<2>(1, 1), {1e300, 1e300}, {-1e300, 0.5}, {1e300, -1e200}})
    expect_unit(square, x);
}

template <int D>
void box_against_enumeration() {
  random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    ph::box_parameters<D> p{anywhere<D>(random, 1), anywhere<D>(random, 1).cwiseAbs(), any_frame<D>(random)};
    if (k % 5 == 0) p.half_extents[0] = 0;
    const ph::box<D> shape(p);
    std::vector<ph::half_space_parameters<D>> planes;
    for (int i = 0; i < D; ++i) {
      for (const double side : {1.0, -1.0}) {
        const ph::point<D> n = side * p.axes.col(i);
        planes.push_back({p.centre + p.half_extents[i] * n, n});
      }
    }
    for (int l = 0; l < 10; ++l) {
      const auto x = anywhere<D>(random, 2);
      const double expected = closest_points::from_polytope<D>(x, planes);
      ASSERT_NEAR(shape.distance(x), expected, 32 * eps) << "seed " << seed << ", x = " << x.transpose();
    }
  }
}

TEST(box, has_the_distance_that_enumeration_finds) {
  box_against_enumeration<2>();
  box_against_enumeration<3>();
}

TEST(box, makes_printed_axes_orthonormal) {
  ph::box_parameters<2> p{{0, 0}, {1, 1}};
  p.axes << 0.866025, -0.5, 0.5, 0.866025;
  const ph::box<2> shape(p);
  for (const ph::point<2>& x : {ph::point<2>(3, 0.1), {0.2, 0.1}, {-5, 5}})
    EXPECT_NEAR(shape.gradient(x).norm(), 1, 4 * eps);
  p.axes << 1, 5e-6, 0, 1;  // skew
  EXPECT_NEAR(ph::box<2>(p).gradient({3, 0}).dot(ph::box<2>(p).gradient({0, 3})), 0, eps);
}

TEST(convex_polygon, has_the_distance_that_enumeration_finds) {
  random_source random(seed);
  for (int k = 0; k < 50; ++k) {
    constexpr std::size_t K = 7;
    ph::convex_polygon_parameters<K> p;
    std::array<double, K> angles;
    for (double& angle : angles) angle = random.uniform(0.0, 6.28);
    std::sort(angles.begin(), angles.end());
    if (k % 2 == 0) std::reverse(angles.begin(), angles.end());
    const double flat = random.uniform(0.1, 1.0);
    for (std::size_t i = 0; i < K; ++i) p.corners[i] = {std::cos(angles[i]), flat * std::sin(angles[i])};
    const ph::convex_polygon shape(p);
    std::vector<ph::half_space_parameters<2>> planes;
    for (std::size_t i = 0; i < K; ++i) {
      const ph::point<2> edge = (k % 2 == 0 ? -1 : 1) * (p.corners[(i + 1) % K] - p.corners[i]);
      planes.push_back({p.corners[i], {edge.y(), -edge.x()}});
    }
    for (int l = 0; l < 20; ++l) {
      const auto x = anywhere<2>(random, 1.5);
      const double expected = closest_points::from_polytope<2>(x, planes);
      ASSERT_NEAR(shape.distance(x), expected, 16 * eps) << "seed " << seed << ", x = " << x.transpose();
    }
  }
}

template <int D, int K>
void polytope_against_enumeration() {
  random_source random(seed);
  for (int k = 0; k < 40; ++k) {
    ph::convex_polytope_parameters<D, K> p;
    const auto centre = anywhere<D>(random, 1);
    for (auto& face : p.faces) {
      face.normal = random.positive(1e-3, 1e3) * random.direction<double, D>();
      face.surface_point = centre + random.uniform(0.2, 1.0) * face.normal.normalized();
    }
    if (k % 4 == 0) p.faces[K - 1] = p.faces[0];  // a face given twice
    const ph::convex_polytope<D, K> shape(p);
    const std::vector<ph::half_space_parameters<D>> planes(p.faces.begin(), p.faces.end());
    for (int l = 0; l < 10; ++l) {
      const ph::point<D> x = centre + anywhere<D>(random, 2);
      const double expected = closest_points::from_polytope<D>(x, planes);
      ASSERT_NEAR(shape.distance(x), expected, 1e-13) << "seed " << seed << ", x = " << x.transpose();
      ASSERT_NEAR(shape.gradient(x).norm(), 1, 16 * eps);
      for (const auto& face : shape.faces()) ASSERT_LE(face.distance(x), shape.distance(x));
    }
  }
}

TEST(convex_polytope, has_the_distance_that_enumeration_finds) {
  polytope_against_enumeration<2, 6>();
  polytope_against_enumeration<3, 8>();
}

TEST(convex_polytope, is_as_exact_as_the_sine_of_its_sharpest_angle_allows) {
  for (const double half_angle : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const double s = std::sin(half_angle), c = std::cos(half_angle);
    const ph::convex_polytope blade(ph::half_space<2>({0, 0}, {s, c}), ph::half_space<2>({0, 0}, {s, -c}));
    for (const ph::point<2>& x : {ph::point<2>(1, 0), {1, 0.5 * half_angle}, {0.1, 0.01 * half_angle}}) {
      EXPECT_NEAR(blade.distance(x), x.norm(), 4 * eps / s) << "half angle " << half_angle;
      EXPECT_NEAR(blade.gradient(x).norm(), 1, 4 * eps);
    }
  }
}

TEST(convex_polytope, takes_planes_for_parallel_only_within_1e_8_rad) {
  const auto error = [](double angle) {  // of two that nothing is behind unless far away
    const double s = std::sin(angle / 2), c = std::cos(angle / 2);
    return error_of(
        [&] { ph::convex_polytope(ph::half_space<2>({0, -1}, {s, c}), ph::half_space<2>({0, 1}, {s, -c})); });
  };
  EXPECT_EQ(error(5e-8), "none");
  EXPECT_NE(error(5e-9), "none");
}

TEST(convex_polytope, works_at_any_scale) {
  for (const double size : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
    const ph::convex_polytope corner(ph::half_space<2>({size, 0}, {1, 0}),
                                     ph::half_space<2>({0, size}, {0, 1}),
                                     ph::half_space<2>({-size, 0}, {-1, 0}));
    EXPECT_NEAR(corner.distance({4 * size, 5 * size}), 5 * size, 16 * eps * size);
    EXPECT_NEAR(corner.distance({size * (1 + 3e-12), size * (1 + 4e-12)}), 5e-12 * size, 8 * eps * size);
    EXPECT_EQ(corner.distance({0, 0}), -size);
  }
}

TEST(a_shape, has_a_nan_distance_for_a_nan) {
  const auto expect_nan = [](const auto& shape) {
    constexpr int D = std::remove_cvref_t<decltype(shape)>::dimension;
    for (int i = 0; i < D; ++i) {
      ph::point<D> x = ph::point<D>::Constant(0.25);
      x[i] = no_number;
      EXPECT_TRUE(std::isnan(shape.distance(x))) << "axis " << i << " of shape " << typeid(shape).name();
    }
    EXPECT_TRUE(std::isnan(shape.distance(ph::point<D>::Constant(no_number))));
  };
  const ph::convex_polygon polygon({{0, 0}, {1, 0}, {0, 1}});
  const ph::box<3> cube({0, 0, 0}, {1, 1, 1});
  const auto f = cube.faces();
  expect_nan(ph::capsule<3>({0, 0, 0}, {1, 0, 0}, 0.1));
  expect_nan(ph::capsule<3>({0, 0, 0}, {0, 0, 0}, 0.1));
  expect_nan(cube);
  expect_nan(polygon);
  expect_nan(ph::convex_polytope(f[0], f[1], f[2], f[3], f[4], f[5]));
  expect_nan(ph::offset(cube, 0.1));
  expect_nan(ph::complement(polygon));
  expect_nan(ph::moving(cube));
  ph::moving lost(cube);
  lost.set_motion({no_number, 0, 0}, {0, 0, 0});
  EXPECT_TRUE(std::isnan(lost.distance({0, 0, 0})));
}

TEST(a_shape, knows_the_box_about_it) {
  const auto expect_bounds = [](const auto& shape, const auto& lower, const auto& upper) {
    EXPECT_LE((shape.bounds().lower - lower).norm(), 4 * eps) << shape.bounds().lower.transpose();
    EXPECT_LE((shape.bounds().upper - upper).norm(), 4 * eps) << shape.bounds().upper.transpose();
  };
  using at2 = ph::point<2>;
  using at3 = ph::point<3>;
  const ph::ball<3> ball({1, 2, -3}, 0.5);
  expect_bounds(ball, at3(0.5, 1.5, -3.5), at3(1.5, 2.5, -2.5));
  expect_bounds(ph::offset(ball, 0.25), at3(0.25, 1.25, -3.75), at3(1.75, 2.75, -2.25));
  expect_bounds(ph::offset(ball, -0.25), at3(0.5, 1.5, -3.5), at3(1.5, 2.5, -2.5));
  const auto hollow = ph::ball<2>({1, 2}, 0.5, ph::filling::hollow).bounds();
  EXPECT_EQ(hollow.lower, at2(-infinity, -infinity));
  EXPECT_EQ(hollow.upper, at2(infinity, infinity));
  expect_bounds(ph::capsule<2>({1, 5}, {3, -1}, 0.25), at2(0.75, -1.25), at2(3.25, 5.25));
  ph::box_parameters<2> turned{{1, -2}, {3, 1}};
  turned.axes << 0.6, -0.8, 0.8, 0.6;
  expect_bounds(ph::box<2>(turned), at2(-1.6, -5), at2(3.6, 1));
  expect_bounds(ph::convex_polygon({{-0.9, -0.5}, {0.2, -0.8}, {0.9, 0.1}, {0.3, 0.7}}), at2(-0.9, -0.8),
                at2(0.9, 0.7));
}

TEST(a_complement, swaps_wall_and_free_space) {
  const ph::ball<2> solid({0.1, 0.2}, 0.5);
  const ph::complement outside(solid);
  for (const ph::point<2>& x : {ph::point<2>(0.3, 0.4), {-1, 2}}) {
    EXPECT_EQ(outside.distance(x), -solid.distance(x));
    EXPECT_EQ(outside.gradient(x), -solid.gradient(x));
    EXPECT_EQ(ph::complement(outside).distance(x), solid.distance(x));  // twice, not a copy
  }
}

TEST(a_moving_shape, is_displaced_and_adds_its_velocity_to_that_of_the_shape_within_it) {
  ph::moving inner(ph::disc({0, 0}, 0.5));
  EXPECT_EQ(inner.velocity({2, 0}), ph::point<2>(0, 0));
  inner.set_motion({1, 0}, {0.1, 0});
  EXPECT_EQ(inner.gradient({1, 2}), ph::point<2>(0, 1));
  ph::moving outer(inner);
  outer.set_motion({0, 1}, {0, 0.2});
  EXPECT_EQ(outer.distance({1, 3}), 1.5);
  EXPECT_EQ(outer.velocity({1, 3}), ph::point<2>(0.1, 0.2));
  const ph::complement hollow(ph::offset(outer, 0.25));
  EXPECT_EQ(hollow.distance({1, 3}), -1.25);
  EXPECT_EQ(hollow.velocity({1, 3}), ph::point<2>(0.1, 0.2));
}

TEST(a_user_shape, may_turn) {
  struct turntable : ph::disc {
    turntable() : ph::disc({0, 0}, 1) {}
    ph::point<2> velocity(const ph::point<2>& x) const { return {-3 * x.y(), 3 * x.x()}; }
  };
  const auto walls = ph::scene(ph::wall(turntable()));
  EXPECT_EQ(ph::sense(walls, {0.5, 0})[0].wall_velocity, ph::point<2>(0, 1.5));
  ph::moving carried{turntable()};
  carried.set_motion({1, 2}, {10, 20});
  EXPECT_EQ(carried.velocity({1.5, 2.25}), ph::point<2>(10 - 0.75, 20 + 1.5)) << "about where it is";
}

TEST(a_scene, fills_the_wall_velocity_of_shapes_that_have_one) {
  auto walls = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 100),
                         ph::wall(ph::moving(ph::disc({0, 0}, 1)), 200));
  walls.get<1>().shape.set_motion({0, 0.5}, {1, 2});
  const auto touched = ph::sense(walls, {0, -0.25});
  ASSERT_EQ(touched.size(), 2);
  EXPECT_EQ(touched[0].wall_velocity, ph::point<2>(0, 0));
  EXPECT_EQ(touched[1].wall_velocity, ph::point<2>(1, 2));
  EXPECT_EQ(touched[1].depth, 0.25);
  EXPECT_EQ(touched[1].normal, ph::point<2>(0, -1));
  EXPECT_EQ(touched[1].stiffness, 200);
  EXPECT_EQ(touched[1].wall_number, 1);
}

TEST(a_room, is_touched_at_all_faces_of_a_corner_at_once) {
  const auto walls = ph::walls_of(ph::box<3>({0, 0, 0}, {1, 2, 3}), 5e3);
  EXPECT_EQ(ph::sense(ph::walls_of(ph::box<2>({0, 0}, {1, 2})), {0, 3})[0].stiffness, 1e7)
      << "of section 5.1";
  EXPECT_TRUE(ph::sense(walls, {0.9, -1.9, 2.9}).empty());
  const auto touched = ph::sense(walls, {1.25, -2.5, 3.125});
  ASSERT_EQ(touched.size(), 3);
  const std::tuple<int, double, ph::point<3>> expected[] = {
      {0, 0.25, {-1, 0, 0}}, {3, 0.5, {0, 1, 0}}, {4, 0.125, {0, 0, -1}}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(std::tuple(touched[i].wall_number, touched[i].depth, touched[i].normal), expected[i]);
    EXPECT_EQ(touched[i].stiffness, 5e3);
  }
}

TEST(a_room, of_a_polygon_or_polytope_has_the_walls_of_its_faces) {
  random_source random(seed);
  const ph::convex_polygon polygon({{-0.9, -0.5}, {0.2, -0.8}, {0.9, 0.1}, {0.3, 0.9}, {-0.7, 0.6}});
  const auto f = polygon.faces();
  const auto one = ph::walls_of(polygon);
  const auto other = ph::walls_of(ph::convex_polytope(f[0], f[1], f[2], f[3], f[4]));
  for (int k = 0; k < 200; ++k) {
    const auto x = anywhere<2>(random, 1);
    const auto touched = ph::sense(one, x);
    ASSERT_EQ(touched.size(), ph::sense(other, x).size());
    ASSERT_EQ(touched.empty(), polygon.distance(x) <= 0);
    for (const auto& c : touched) ASSERT_EQ(c.depth, f[static_cast<std::size_t>(c.wall_number)].distance(x));
  }
}

TEST(a_tube, is_free_within_its_radius) {
  const auto guide = ph::tube<3>({0, 0, 0}, {1, 0, 0}, 0.1);
  EXPECT_NEAR(guide.distance({0.5, 0, 0}), 0.1, eps);
  EXPECT_NEAR(guide.distance({0.5, 0.3, 0.4}), -0.4, eps);
  EXPECT_NEAR((guide.gradient({0.5, 0.3, 0.4}) - ph::point<3>(0, -0.6, -0.8)).norm(), 0, 2 * eps);
  EXPECT_NEAR(guide.distance({1.3, 0, 0}), -0.2, 2 * eps);
}

TEST(a_slot, is_free_between_its_walls) {
  const auto walls = ph::slot<3>({0, 0, 1}, {0, 0, 2}, 0.25, 1e3);
  for (const double z : {1.25, 0.75}) EXPECT_TRUE(ph::sense(walls, {5, 6, z}).empty());
  const auto above = ph::sense(walls, {5, 6, 1.5}), below = ph::sense(walls, {5, 6, 0});
  ASSERT_EQ(above.size(), 1);
  ASSERT_EQ(below.size(), 1);
  EXPECT_EQ(above[0].wall_number, 0);
  EXPECT_EQ(above[0].depth, 0.25);
  EXPECT_EQ(above[0].normal, ph::point<3>(0, 0, -1));
  EXPECT_EQ(above[0].stiffness, 1e3);
  EXPECT_EQ(ph::sense(ph::slot<2>({0, 0}, {0, 1}, 0.25), {0, 1})[0].stiffness, 1e7) << "of section 5.1";
  EXPECT_EQ(below[0].wall_number, 1);
  EXPECT_EQ(below[0].depth, 0.75);
  EXPECT_EQ(below[0].normal, ph::point<3>(0, 0, 1));
}

TEST(a_shape, says_what_is_wrong_with_its_parameters) {
  EXPECT_EQ(validate(ph::capsule_parameters<2>{{0, 0}, {1, 0}, 0.1}), "");
  EXPECT_EQ(validate(ph::capsule_parameters<2>{{no_number, 0}, {1, 0}, 0.1}),
            "from[0] of a capsule [m] = nan: expected a finite number");
  EXPECT_EQ(validate(ph::capsule_parameters<2>{{0, 0}, {infinity, 0}, 0.1}),
            "to[0] of a capsule [m] = inf: expected a finite number");
  EXPECT_EQ(validate(ph::capsule_parameters<2>{{-1e308, 0}, {1e308, 0}, 0.1}),
            "length of a capsule [m] = inf: expected a finite number");
  EXPECT_EQ(validate(ph::capsule_parameters<2>{{0, 0}, {1, 0}, -1}),
            "radius of a capsule [m] = -1: expected a finite number >= 0");

  EXPECT_EQ(validate(ph::ball_parameters<2>()), "radius of a ball [m] = 0: expected a finite number > 0");
  EXPECT_EQ(validate(ph::box_parameters<2>{{0, 0}, {1, 0}}), "");
  EXPECT_EQ(validate(ph::box_parameters<2>{{0, no_number}, {1, 0}}),
            "centre[1] of a box [m] = nan: expected a finite number");
  EXPECT_EQ(validate(ph::box_parameters<2>{{0, 0}, {1, -2}}),
            "half_extents[1] of a box [m] = -2: expected a finite number >= 0");
  ph::box_parameters<2> skew{{0, 0}, {1, 1}};
  skew.axes << 1, 0.25, 0, 1;
  EXPECT_EQ(validate(skew), "|axes^T axes - I| of a box = 0.25: expected orthonormal columns");
  for (const double bend : {9e-6, 1.1e-5}) {
    skew.axes << 1, bend, 0, 1;
    EXPECT_EQ(validate(skew).empty(), bend < 1e-5) << "six digits";
  }
  skew.axes(0, 0) = no_number;
  EXPECT_EQ(validate(skew), "axes(0, 0) of a box [1] = nan: expected a finite number");

  using triangle = ph::convex_polygon_parameters<3>;
  EXPECT_EQ(validate(triangle{{{{0, 0}, {1, 0}, {0, 1}}}}), "");
  EXPECT_EQ(validate(triangle{{{{0, 0}, {no_number, 0}, {0, 1}}}}),
            "corners[1][0] of a convex_polygon [m] = nan: expected a finite number");
  EXPECT_EQ(validate(triangle{{{{0, 0}, {1, 0}, {0, 0}}}}),
            "corner 2 of a convex_polygon equals the next one: expected distinct corners");
  EXPECT_EQ(validate(triangle{{{{0, 0}, {1, 0}, {2, 0}}}}),
            "area of a convex_polygon [m^2] = 0: expected > 0");
  using quadrilateral = ph::convex_polygon_parameters<4>;
  EXPECT_EQ(validate(quadrilateral{{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}}),
            "corner 3 of a convex_polygon lies outside the edge after corner 1: expected a convex polygon");
  EXPECT_EQ(validate(quadrilateral{{{{4, 0}, {1, 1}, {0, 4}, {0, 0}}}}),
            "corner 2 of a convex_polygon lies outside the edge after corner 0: expected a convex polygon");
  EXPECT_EQ(validate(quadrilateral{{{{0, 4}, {0, 0}, {4, 0}, {1, 1}}}}),
            "corner 0 of a convex_polygon lies outside the edge after corner 2: expected a convex polygon");
  EXPECT_EQ(validate(quadrilateral{{{{0, 0}, {0, 0}, {1, 0}, {0, 1}}}}),
            "corner 0 of a convex_polygon equals the next one: expected distinct corners");
  EXPECT_EQ(validate(quadrilateral{{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}}),
            "area of a convex_polygon [m^2] = 0: expected > 0")
      << "one loop each way round";
  for (const auto& corner : quadrilateral().corners) EXPECT_EQ(corner, ph::point<2>(0, 0));
  ph::convex_polygon_parameters<5> star;
  for (std::size_t i = 0; i < 5; ++i) {
    const double angle = ph::radians(144.0 * static_cast<double>(i));
    star.corners[i] = {std::cos(angle), std::sin(angle)};
  }
  EXPECT_NE(validate(star).find("expected a convex polygon"), std::string::npos);

  using slab = ph::convex_polytope_parameters<2, 2>;
  EXPECT_EQ(validate(slab{{{{{1, 0}, {1, 0}}, {{0, 0}, {-1, 0}}}}}), "");
  EXPECT_EQ(validate(slab{{{{{1, 0}, {1, 0}}, {{0, 0}, {0, 0}}}}}),
            "|faces[1].normal| of a half_space = 0: expected a direction");
  EXPECT_EQ(validate(slab{{{{{1, 0}, {-1, 0}}, {{0, 0}, {1, 0}}}}}),
            "faces of a convex_polytope have no common inside: expected normals that point out of it");
  EXPECT_EQ(error_of([] {
              ph::convex_polytope(ph::half_space<3>({0, 0, 5}, {1, 2, 3}),
                                  ph::half_space<3>({0, 0, 6}, {-1, -2, -3}));
            }),
            "passive_haptics: faces of a convex_polytope have no common inside: expected normals that point "
            "out of it");

  EXPECT_EQ(error_of([] { ph::offset(ph::disc({0, 0}, 1), no_number); }),
            "passive_haptics: growth of an offset [m] = nan: expected a finite number");
  EXPECT_EQ(error_of([] { ph::slot<2>({0, 0}, {1, 0}, -1); }),
            "passive_haptics: half_width of a slot [m] = -1: expected a finite number >= 0");
  EXPECT_EQ(error_of([] { ph::slot<2>({0, 0}, {0, 0}, 1); }),
            "passive_haptics: |normal| of a half_space = 0: expected a direction");
  EXPECT_EQ(error_of([] { ph::tube<2>({0, 0}, {1, 0}, -1); }),
            "passive_haptics: radius of a capsule [m] = -1: expected a finite number >= 0");
}
