// optimised
// A proxy on a mesh in space: what stops it, what it feels, and that it never gets to the other side. In the
// plane: property/meshes.cpp.
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"
#include "tracked_handle.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>

namespace ph = passive_haptics;
using ph::testing::random_source;
using tracked::handle;

namespace {

constexpr unsigned seed = 20040627;
constexpr double skin = 1e-7, lip = 1e-10;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

static_assert(ph::TrackedShape<ph::mesh_surface<2>> && ph::TrackedShape<ph::mesh_surface<3>>);
static_assert(!ph::TrackedShape<ph::mesh_solid<3>>);

ph::mesh_surface<3> surface_of(const ph::mesh_parameters<3>& p) {
  return ph::mesh_surface<3>(ph::mesh<3>(p));
}

ph::mesh_parameters<3> centred_cube(double r = 1) {
  return sample_meshes::box<3>(ph::point<3>::Constant(-r), ph::point<3>::Constant(r));
}

// A plate at height 0, free above; 2 wide.
ph::mesh_parameters<3> plate() {
  return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

// At height h over a point a little aside.
ph::point<3> at_height(double h, double aside = 0.1) {
  ph::point<3> x = ph::point<3>::Constant(aside);
  x[2] = h;
  return x;
}

TEST(a_mesh_surface, stops_what_comes_from_the_front) {
  handle<3> h(surface_of(plate()));
  EXPECT_NEAR(h.go(at_height(0.5)), 0.5, 1e-6);
  EXPECT_TRUE(h.felt.empty());
  EXPECT_EQ(h.go(at_height(-0.3, 0.2)), 0);
  ASSERT_EQ(h.felt.size(), 1u);
  EXPECT_EQ(h.felt[0].normal, ph::point<3>::Unit(2));
  EXPECT_EQ(h.felt[0].depth, 0.3);
  EXPECT_GT(h.go(at_height(0.01)), 0);
  EXPECT_TRUE(h.felt.empty());
  EXPECT_EQ(h.proxy(), at_height(0.01));
  EXPECT_EQ(h.go(at_height(2 * skin)), 0) << "next it may touch";
  EXPECT_TRUE(h.felt.empty());
}

TEST(a_mesh_surface, is_free_from_the_back_and_beside_its_rim) {
  handle<3> h(surface_of(plate()));
  h.go(at_height(-0.5));
  EXPECT_NEAR(h.go(at_height(-1e-3)), 1e-3, 1e-6);
  EXPECT_TRUE(h.felt.empty());
  h.go(at_height(0.5));
  EXPECT_TRUE(h.felt.empty());
  h.go(at_height(0.5, 1.01));
  h.go(at_height(-0.5, 1.01));
  EXPECT_TRUE(h.felt.empty());
  h.go(at_height(-0.5));  // under the plate now
  EXPECT_TRUE(h.felt.empty());
  h.go(at_height(0.1));
  EXPECT_TRUE(h.felt.empty());
  h.go(at_height(-0.1));
  EXPECT_EQ(h.felt.size(), 1u);
  EXPECT_GT(h.go(at_height(-0.1, 1.01)), 0) << "pushed off the rim";
  EXPECT_TRUE(h.felt.empty());
  EXPECT_FALSE(h.memory.held);
}

TEST(a_mesh_surface, leaves_a_handle_free_in_its_skin_and_at_its_proxy) {
  handle<3> h(surface_of(centred_cube()));
  h.go(at_height(1 + 0.5 * skin));
  EXPECT_FALSE(h.memory.held);
  EXPECT_TRUE(h.felt.empty());
  h.go(at_height(0.9));
  EXPECT_EQ(h.felt.size(), 1u);
  ASSERT_TRUE(h.memory.held);
  h.go(h.proxy());
  EXPECT_FALSE(h.memory.held);
  EXPECT_EQ(h.memory.facet_count, 0);
}

// A roof along the x axis, its ridge at the origin and its sides at this angle to the vertical.
ph::mesh_parameters<3> roof(double angle) {
  const double side = std::sin(angle), down = -std::cos(angle);
  return {{{0, -1, 0}, {0, 1, 0}, {side, -1, down}, {side, 1, down}, {-side, -1, down}, {-side, 1, down}},
          {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}}};
}

// From behind one side to behind the other: over the ridge and down, a skin in front. The handle is as far
// beyond the ridge as it is along the first side: where that is little, the proxy comes in low over the
// second.
TEST(a_mesh_surface, is_followed_over_a_ridge_in_one_cycle) {
  random_source random(seed);
  for (int k = 0; k < 300; ++k) {
    const double angle = random.uniform(50.0, 85.0) * std::numbers::pi / 180;
    handle<3> h(surface_of(roof(angle)));
    // Of a side of 1 or -1, as far down from the ridge and as deep
    const auto go = [&](double side, double down, double depth) {
      ph::point<3> x = ph::point<3>::Zero();
      x[0] = side * (down * std::sin(angle) - depth * std::cos(angle));
      x[2] = -down * std::cos(angle) - depth * std::sin(angle);
      h.go(x);
    };
    const double side = k % 2 == 0 ? 1 : -1, down = random.uniform(0.3, 0.6);
    go(side, down, -0.1);
    go(side, down, 1e-3);
    ASSERT_EQ(h.felt.size(), 1u);
    const double beyond = random.positive(1e-9, 0.02);
    const double depth = (-down * std::cos(2 * angle) - beyond) / std::sin(2 * angle);
    go(-side, down, depth);
    ASSERT_EQ(h.felt.size(), 1u) << "seed " << seed << ", trial " << k;
    EXPECT_LT(side * h.felt[0].normal[0], 0) << "seed " << seed << ", trial " << k;
    EXPECT_NEAR(h.felt[0].depth, depth, 1e-12);
    EXPECT_NEAR(h.distance_of_proxy(), skin, 0.11 * skin) << "seed " << seed << ", trial " << k;
    EXPECT_NEAR((h.proxy() - h.x).norm(), depth + skin, 0.11 * skin) << "seed " << seed << ", trial " << k;
  }
}

// Many sides, and the handle below the point where they meet, round and round.
TEST(a_funnel, is_never_left_however_many_sides_hold) {
  constexpr int sides = 40;
  ph::mesh_parameters<3> p;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    p.vertices.push_back({std::cos(angle), std::sin(angle), 1});
    p.facets.push_back({sides, k, (k + 1) % sides});
  }
  p.vertices.push_back({0, 0, 0});
  handle<3> h(surface_of(p));
  h.go({0, 0, 0.5});
  int most = 0;
  for (int k = 0; k < 300; ++k) {
    const double angle = 0.7 * k;
    h.go({0.4 * std::cos(angle), 0.4 * std::sin(angle), -0.5});
    ASSERT_FALSE(h.felt.empty()) << k;
    ASSERT_NEAR(h.proxy().norm(), skin, skin) << k;
    most = std::max(most, h.memory.facet_count);
  }
  EXPECT_EQ(most, ph::proxy_tracker<3>::max_facets);
}

// A room whose skin is as thin as it may be, and handles beyond its walls, further than numbers are exact.
TEST(a_mesh_surface, holds_with_the_thinnest_skin_what_goes_the_furthest) {
  random_source random(seed);
  const ph::mesh<3> room(sample_meshes::inside_out(centred_cube()));
  handle<3> h(ph::mesh_surface<3>(ph::mesh_surface_parameters<3>{room, 1e-9}));
  for (int k = 0; k < 500; ++k) {
    if (k % 10 == 0) h.go(0.5 * random.direction<double, 3>());
    h.go(random.positive(1.0, 1e9) * 1e3 * random.direction<double, 3>());
    ASSERT_TRUE(h.memory.held) << "seed " << seed << ", handle " << k;
    ASSERT_NEAR(h.distance_of_proxy(), 1e-9, 0.01e-9) << "seed " << seed << ", handle " << k;
  }
}

// Two opposed faces 1 mm apart, and even none apart.
TEST(a_mesh_surface, that_is_thin_is_not_popped_through) {
  for (const double thickness : {1e-3, 0.0}) {
    auto under = sample_meshes::inside_out(plate());
    for (auto& v : under.vertices) v[2] -= thickness;
    handle<3> h(surface_of(sample_meshes::both(plate(), under)));
    for (const int side : {1, -1}) {
      const double face = side > 0 ? 0 : -thickness;
      h = handle<3>(h.shape);
      h.go(at_height(face + side * 1e-2));
      for (int k = 1; k <= 25; ++k) {
        h.go(at_height(face - side * 1e-3 * k, 0.01 * k));
        ASSERT_EQ(h.felt.size(), 1u) << thickness;
        EXPECT_EQ(h.felt[0].normal, side * ph::point<3>::Unit(2));
        EXPECT_NEAR(h.felt[0].depth, 1e-3 * k, 1e-15);
      }
      h.go(at_height(face + side * 1e-6));
      EXPECT_TRUE(h.felt.empty());
    }
  }
}

// Through the nearest facet; a metre is small so far out, but no less solid.
TEST(a_mesh_surface, takes_a_handle_within_it_for_come_through_a_facet_far_from_the_origin_too) {
  for (const double side : {1.0, -1.0}) {
    for (const double away : {0.0, 1e5}) {
      auto p = side < 0 ? sample_meshes::inside_out(centred_cube()) : centred_cube();
      const ph::point<3> far = ph::point<3>::Constant(away);
      for (auto& v : p.vertices) v += far;
      handle<3> h(ph::mesh_surface<3>({.surface = ph::mesh<3>(p), .skin = away > 0 ? 1e-3 : skin}));
      h.go(far + (1 - side * 0.2) * ph::point<3>::UnitX());
      ASSERT_EQ(h.felt.size(), 1u);
      EXPECT_EQ(h.felt[0].normal, side * ph::point<3>::UnitX());
      EXPECT_NEAR(h.felt[0].depth, 0.2, away > 0 ? 1e-10 : 1e-15);
    }
  }
}

TEST(a_mesh_surface, takes_any_handle_within_a_star_for_come_through_a_facet) {
  random_source random(seed);
  for (const int around : {5, 9, 24}) {
    const auto shape = surface_of(sample_meshes::star<3>(random, around));
    for (int k = 0; k < 500; ++k) {
      const ph::point<3> x = random.uniform(0.0, 1.0) * random.direction<double, 3>();
      const double distance = shape.surface().signed_distance(x, shape.surface().nearest(x));
      handle<3> h(shape);
      h.go(x);
      ASSERT_GT(h.distance_of_proxy(), -lip) << "seed " << seed << ", handle " << k;
      ASSERT_EQ(h.felt.empty(), distance >= 0) << "seed " << seed << ", handle " << k;
      if (distance < 0) {
        ASSERT_LE((h.proxy() - x).norm(), 1e-5 - distance) << "handle " << k;
      }
    }
  }
}

TEST(a_mesh_surface, lets_the_handle_come_round_a_convex_edge) {
  handle<3> h(surface_of(centred_cube()));
  h.go(1.5 * ph::point<3>::UnitX());
  for (int k = 0; k <= 200; ++k) {  // 10 mm deep, along one face and past its end
    ph::point<3> x = ph::point<3>::Zero();
    x[0] = 0.99;
    x[1] = 0.9 + 1e-3 * k;
    h.go(x);
    if (x[1] > 1) {
      EXPECT_TRUE(h.felt.empty()) << k;
      continue;
    }
    ASSERT_EQ(h.felt.size(), 1u) << k;
    EXPECT_EQ(h.felt[0].normal, ph::point<3>::UnitX());
  }
  h.go(0.99 * ph::point<3>::UnitX() + 0.98 * ph::point<3>::UnitY());  // back, now through the other face
  ASSERT_EQ(h.felt.size(), 1u);
  EXPECT_EQ(h.felt[0].normal, ph::point<3>::UnitY());
  EXPECT_NEAR(h.felt[0].depth, 0.02, 1e-15);
}

TEST(a_mesh_surface, hit_at_its_edges_and_corners_holds) {
  const auto shape = surface_of(centred_cube());
  // Straight down on every corner, the middle of every edge and of every face, and back out.
  for (int code = 0; code < 27; ++code) {
    ph::point<3> target;
    for (int i = 0, rest = code; i < 3; ++i, rest /= 3) target[i] = rest % 3 - 1;
    if (target.isZero()) continue;
    for (const ph::point<3>& from :
         {ph::point<3>(2 * target), ph::point<3>(target + 0.5 * target.cwiseAbs())}) {
      handle<3> h(shape);
      h.go(from);
      h.go(target);
      h.go(0.99 * target);
      EXPECT_GE(h.felt.size(), 1u) << "target " << target.transpose();
      EXPECT_GE(h.distance_of_proxy(), 0);
      h.go(-0.3 * target);
      EXPECT_GE(h.felt.size(), 1u) << "target " << target.transpose();
      EXPECT_GE(h.distance_of_proxy(), 0);
      h.go(2 * target);
      EXPECT_TRUE(h.felt.empty());
    }
  }
}

// A leap across several facets of it: the proxy gets there in the same cycle.
TEST(a_smooth_hollow, is_followed_over_many_facets_at_once) {
  random_source random(seed);
  const auto p = sample_meshes::globe(60, 30, [](const auto&) { return 1.0; });
  for (const bool hollow : {false, true}) {
    handle<3> h(surface_of(hollow ? sample_meshes::inside_out(p) : p));
    const double side = hollow ? -1 : 1;
    ph::point<3> u = ph::point<3>::UnitX();
    h.go((1 + side * 0.1) * u);
    for (int k = 0; k < 300; ++k) {
      u = (u + 0.3 * random.direction<double, 3>()).normalized();
      h.go((1 - side * 0.05) * u);
      ASSERT_EQ(h.felt.size(), 1u);
      EXPECT_LE((h.proxy() - u).norm(), 0.1) << "seed " << seed << ", leap " << k;
    }
  }
}

// Round and round a pencil: over each edge the proxy sinks towards the next face, and rises again.
TEST(a_mesh_surface, keeps_its_proxy_at_the_height_of_the_skin) {
  const auto p = sample_meshes::globe(7, 3, [](const auto&) { return 1.0; });
  handle<3> h(surface_of(p));
  h.go(2 * ph::point<3>::UnitX());
  for (int k = 0; k < 1000; ++k) {
    const double angle = 0.03 * k;
    h.go(0.7 * (std::cos(angle) * ph::point<3>::UnitX() + std::sin(angle) * ph::point<3>::UnitY()));
    ASSERT_EQ(h.felt.size(), 1u) << k;
    ASSERT_NEAR(h.distance_of_proxy(), skin, 0.11 * skin) << k;
  }
}

// Two rims that meet at 1e-6 rad, each a lip wider, would meet 0.1 mm further on.
TEST(a_needle, ends_at_its_tip) {
  handle<3> h(surface_of(ph::mesh_parameters<3>{{{0, 0, 0}, {1, 0, 0}, {0, 1e-6, 0}}, {{0, 1, 2}}}));
  for (const auto& [x, y, contacts] :
       {std::tuple(0.5, 0.2e-6, 1u), {1 - 1e-6, 1e-13, 1u}, {1 + 1e-6, 0.0, 0u}, {0.5, 0.7e-6, 0u}}) {
    h.go({x, y, 0.1});
    h.go({x, y, -0.1});
    EXPECT_EQ(h.felt.size(), contacts) << x;
    h.go({2, 0, 0.1});
  }
  h.go({1 - 1e-6, 1e-13, 0.1});
  h.go({1 - 1e-6, 1e-13, -1e-3});
  EXPECT_EQ(h.felt.size(), 1u);
  h.go({1 + 1e-6, 0, -1e-3});
  EXPECT_TRUE(h.felt.empty()) << "slid off the tip";
}

// Steps of any size on a star with deep valleys: the proxy stays outside, whatever the handle
// does.
void slide(const ph::mesh_parameters<3>& p, int steps, double max_step) {
  random_source random(seed);
  handle<3> h(surface_of(p));
  ph::point<3> x = 2 * ph::point<3>::UnitX();
  int touched = 0;
  for (int k = 0; k < steps; ++k) {
    const ph::point<3> step = random.positive(1e-9, max_step) * random.direction<double, 3>();
    x = k % 1000 == 0 ? ph::point<3>(1.5 * random.direction<double, 3>()) : ph::point<3>(0.999 * (x + step));
    if (k % 1009 == 0) x = p.vertices[static_cast<std::size_t>(k) % p.vertices.size()];
    h.go(x);
    touched += !h.felt.empty();
    ASSERT_LE(h.felt.size(), static_cast<std::size_t>(3));
    ASSERT_GT(h.distance_of_proxy(), -lip) << "seed " << seed << ", step " << k;
    for (const auto& c : h.felt) {
      ASSERT_NEAR(c.normal.norm(), 1, 1e-12);
      ASSERT_GT(c.depth, 0);
      ASSERT_GT(c.normal.dot(h.proxy() - x), -lip) << "seed " << seed << ", step " << k;
      ASSERT_LE(c.depth, (h.proxy() - x).norm() + skin);
    }
  }
  EXPECT_GT(touched, steps / 20);
  EXPECT_LT(touched, steps);
}

TEST(a_mesh_surface, is_never_passed_by_its_proxy) {
  random_source random(seed);
  for (const int around : {5, 9, 24}) {
    slide(sample_meshes::star<3>(random, around), 5'000, 0.3);
    slide(sample_meshes::star<3>(random, around), 5'000, 1e-3);
  }
}

// Needles of any width on a flat lid, which the handle slides over and presses on.
TEST(a_lid_of_needles, holds) {
  random_source random(seed);
  ph::mesh_parameters<3> lid;  // strips between y = -1 and y = 1, each of two needles
  double edge = -1;
  for (int k = 0; edge < 1; ++k) {
    lid.vertices.push_back({edge, -1, 0});
    lid.vertices.push_back({edge, 1, 0});
    if (k > 0) {
      const int i = 2 * k;
      lid.facets.push_back({i - 2, i, i + 1});
      lid.facets.push_back({i - 2, i + 1, i - 1});
    }
    edge += random.positive(1e-8, 1e-1);
  }
  handle<3> h(surface_of(lid));
  h.go({0, 0, 0.1});
  for (int k = 0; k < 5000; ++k) {
    const ph::point<3> x(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), random.uniform(-0.1, -0.001));
    h.go(k % 2 == 0 ? x : ph::point<3>(h.x + random.positive(1e-9, 1e-3) * ph::point<3>(1, 1, 0)));
    ASSERT_EQ(h.felt.size(), 1u) << "seed " << seed << ", step " << k;
    ASSERT_NEAR(h.felt[0].normal[2], 1, 1e-12);
    ASSERT_NEAR(h.felt[0].depth, -h.x[2], 1e-9);
    ASSERT_NEAR(h.proxy()[2], skin, 2 * lip);
  }
}

TEST(a_room_of_triangles, is_never_left_through_its_corners) {
  random_source random(seed);
  handle<3> h(surface_of(sample_meshes::inside_out(centred_cube())));
  h.go({0, 0, 0});
  int corners = 0;
  for (int k = 0; k < 5000; ++k) {
    const ph::point<3> x =
        random.between<double, 3>(ph::point<3>::Constant(-1.5), ph::point<3>::Constant(1.5));
    h.go(x);
    int behind = 0;
    for (int i = 0; i < 3; ++i) behind += std::abs(x[i]) > 1;
    ASSERT_EQ(h.felt.size(), static_cast<std::size_t>(behind)) << "seed " << seed << ", step " << k;
    corners += behind == 3;
    for (const auto& c : h.felt) {
      int axis = 0;
      ASSERT_EQ(c.normal.cwiseAbs().maxCoeff(&axis), 1);
      ASSERT_NEAR(c.depth, std::abs(x[axis]) - 1, 1e-15);
      ASSERT_LT(c.normal[axis] * x[axis], 0);
    }
  }
  EXPECT_GT(corners, 100);
}

TEST(a_mesh_surface, gives_no_number_for_no_number_and_remembers_what_it_knew) {
  handle<3> h(surface_of(centred_cube()));
  h.go(1.5 * ph::point<3>::UnitX());
  h.go(0.5 * ph::point<3>::UnitX());
  const auto before = h.memory;
  for (const double bad : {not_a_number, infinity, -infinity}) {
    ph::point<3> x = h.x;
    x[2] = bad;
    EXPECT_EQ(h.shape.follow(h.x, x, h.memory, h.adder()), 0);
    ASSERT_EQ(h.felt.size(), 1u);
    EXPECT_TRUE(std::isnan(h.felt[0].depth));
    EXPECT_EQ(h.memory.position, before.position);
    EXPECT_EQ(h.memory.facet_count, before.facet_count);
  }
  h.go(0.4 * ph::point<3>::UnitX());
  ASSERT_EQ(h.felt.size(), 1u);
  EXPECT_NEAR(h.felt[0].depth, 0.6, 1e-15);
}

TEST(a_mesh_surface, says_how_far_the_handle_may_go) {
  random_source random(seed);
  const auto p = sample_meshes::star<3>(random, 12);
  handle<3> often(surface_of(p)), seldom(often.shape);
  ph::point<3> x = 1.1 * ph::point<3>::UnitX(), asked = x;
  double may_go = 0;
  int calls = 0, touched = 0;
  for (int k = 0; k < 5000; ++k) {
    const ph::point<3> before = x;
    x += 2e-3 * random.direction<double, 3>() - 5e-4 * x;
    often.go(x);
    if (!((x - asked).norm() < may_go)) {
      seldom.x = before;
      may_go = seldom.go(x);
      asked = x;
      ++calls;
    } else {
      seldom.felt.clear();
    }
    touched += !often.felt.empty();
    ASSERT_EQ(seldom.felt.size(), often.felt.size()) << "seed " << seed << ", cycle " << k;
    for (std::size_t i = 0; i < often.felt.size(); ++i) ASSERT_EQ(seldom.felt[i].depth, often.felt[i].depth);
  }
  EXPECT_GT(touched, 100);
  EXPECT_LT(calls - touched, 1000);
}

// Passes through a random point of a random facet, up to 60 degrees oblique: from the first cycle behind the
// facet on, each has a contact.
int stopped_passes(const ph::mesh_parameters<3>& m, double margin, double step, int passes) {
  random_source random(seed);
  ph::world_walls<3> walls;
  walls.add(ph::wall(surface_of(m)));
  const ph::world<3> unseen(walls);
  int stopped = 0;
  for (int k = 0; k < passes; ++k) {
    const auto corners = m.corners(static_cast<std::size_t>(random.uniform(0.0, double(m.facets.size()))));
    const ph::point<3> normal = ph::detail::normal_of(corners);
    ph::vector<double, 3> weights = random.direction<double, 3>().cwiseAbs2();
    weights = (weights.array() + 0.1).matrix() / (1.3);  // beside no rim
    ph::point<3> place = ph::point<3>::Zero(), way;
    for (int i = 0; i < 3; ++i) place += weights[i] * corners[static_cast<std::size_t>(i)];
    do way = random.direction<double, 3>();
    while (-way.dot(normal) < 0.5);
    ph::world<3> w = unseen;
    w.set_margin(margin);
    const double before = random.uniform(4.0, 5.0);  // steps
    bool stops = true;
    for (int cycle = 0; cycle < 15; ++cycle) {
      const bool touched = !ph::sense(w, ph::point<3>(place + step * (cycle - before) * way)).empty();
      if (cycle >= 5) stops &= touched;
    }
    stopped += stops;
  }
  return stopped;
}

TEST(a_mesh_surface, stops_each_pass_in_a_world_whatever_its_margin) {
  constexpr int passes = 50;
  const auto ball = sample_meshes::globe(24, 12, [](const auto&) { return 0.1; });
  for (const double margin : {0.0, 1e-5, 1e-4, 1e-3, 0.011}) {
    for (const double step : {1e-6, 1e-5, 1e-4, 1e-3}) {
      int shape = 0;
      for (const auto& m : {plate(), ball, sample_meshes::inside_out(ball)})
        EXPECT_EQ(stopped_passes(m, margin, step, passes), passes)
            << "seed " << seed << ", shape " << shape++ << ", margin " << margin << " m, step " << step
            << " m";
    }
  }
}

// Two planes that face each other, and nothing between them: each gets what it can.
TEST(shares_of_displacement, of_planes_that_contradict_are_their_depths) {
  ph::matrix<double, 2, 4> N = ph::matrix<double, 2, 4>::Zero();
  N.col(0) = ph::point<2>::UnitX();
  N.col(1) = -ph::point<2>::UnitX();
  const ph::vector<double, 4> feasible(0.3, -0.3, 0, 0), contradicting(0.3, -0.2, 0, 0);
  EXPECT_NEAR(ph::detail::shares_of_displacement(N, feasible)[0], 0.3, 1e-12);
  EXPECT_EQ(ph::detail::shares_of_displacement(N, contradicting), contradicting.cwiseMax(0));
}

TEST(mesh_surface, says_what_is_wrong_with_its_parameters) {
  const ph::triangle_mesh m(centred_cube(2));
  EXPECT_EQ(validate(ph::mesh_surface_parameters<3>{m}), "");
  const std::string skin_text =
      ": expected a finite number > 0 and at least 2e-9, 1e-9 of the largest coordinate";
  EXPECT_EQ(validate(ph::mesh_surface_parameters<3>{m, 1e-9}),
            "skin of a mesh_surface [m] = 1e-9" + skin_text);
  EXPECT_EQ(validate(ph::mesh_surface_parameters<3>{m, not_a_number}),
            "skin of a mesh_surface [m] = nan" + skin_text);
  EXPECT_EQ(validate(ph::mesh_surface_parameters<3>{m, infinity}),
            "skin of a mesh_surface [m] = inf" + skin_text);
  EXPECT_EQ(validate(ph::mesh_surface_parameters<3>{m, 1e-7, -0.1}),
            "crease_angle of a mesh_surface [rad] = -0.1: expected 0 or more and less than pi");
  EXPECT_EQ(validate(ph::mesh_surface_parameters<3>{m, 1e-7, 0}), "");
  EXPECT_TRUE(
      validate(ph::mesh_surface_parameters<3>{m, 1e-7, std::numbers::pi}).starts_with("crease_angle"));
  EXPECT_EQ(ph::mesh_surface_parameters<3>{m}.crease_angle, std::numbers::pi / 6);
  EXPECT_THROW(ph::mesh_surface<3>(ph::mesh_surface_parameters<3>{m, 0}), std::invalid_argument);
}

}  // namespace
