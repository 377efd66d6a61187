// What is felt of the facets on which a proxy rests.
#include <passive_haptics/scene/proxy/proxy_contacts.hpp>

#include <gtest/gtest.h>

#include "tracked_handle.hpp"

#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

// A floor, and a ramp at 3 : 4 that is bent along its middle by twice 16 deg; all through the origin.
ph::mesh_parameters<3> obtuse_corner() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.6, 0, 0.8}, {0.224, 0.96, -0.168}, {-0.224, 0.96, 0.168}},
          {{0, 1, 2}, {0, 3, 4}, {0, 3, 5}}};
}
constexpr int surface_number = 5;
const ph::point<3> up(0, 0, 1), from_ramp(-0.8, 0, 0.6);

// By a handle at x whose proxy rests on these facets, of which those of the ramp are one smooth surface.
std::vector<tracked::touch<3>> felt(std::initializer_list<int> facets, const ph::point<3>& x) {
  ph::proxy_tracker<3> t;
  for (const int f : facets) t.facets[static_cast<std::size_t>(t.facet_count++)] = {surface_number, f};
  std::vector<tracked::touch<3>> all;
  const ph::mesh_surface<3> corner(
      {.surface = ph::triangle_mesh(obtuse_corner()), .crease_angle = ph::radians(40.0)});
  const ph::placed_surface<ph::mesh_surface<3>> here{&corner, ph::point<3>::Zero(), surface_number};
  ph::detail::proxy_contacts<ph::mesh_surface<3>>({&here, 1}, t, x)
      .add_to([&](const ph::point<3>& normal, double depth, int number) {
        EXPECT_EQ(number, surface_number);
        all.push_back({normal, depth});
      });
  return all;
}

// 2 deep behind the floor and 1.7 behind the ramp: the way to in front of both is 1.53125 up and 0.78125 from
// the ramp. The floor's depth is all of its own, the ramp's twice its share.
TEST(an_obtuse_corner, lets_a_surface_begin_with_depth_zero) {
  const auto touched = felt({0, 1, 2}, {0.625, 0, -2});
  ASSERT_EQ(touched.size(), 2u);
  EXPECT_TRUE(touched[0].normal.isApprox(up, 1e-15));
  EXPECT_NEAR(touched[0].depth, 2, 1e-14);
  EXPECT_TRUE(touched[1].normal.isApprox(from_ramp, 1e-14));
  EXPECT_NEAR(touched[1].depth, 1.5625, 1e-14);
}

TEST(a_smooth_surface, has_a_direction_wherever_it_is_touched) {
  for (const double depth : {1.0, 1e-100}) {
    const auto touched = felt({1, 2}, -depth * from_ramp);
    ASSERT_EQ(touched.size(), 1u) << depth;
    EXPECT_TRUE(touched[0].normal.isApprox(from_ramp, 1e-14));
    EXPECT_NEAR(touched[0].depth / depth, 1, 1e-14);
  }
  EXPECT_TRUE(felt({1, 2}, -1e-200 * from_ramp).empty()) << "where squares underflow there is none";
}

// 1e-3 thick in front of a segment 2 long, with a lip of 1e-6; another lip is for rounding.
TEST(a_slab, holds_what_rests_on_its_facet) {
  const ph::mesh_facet<2> segment{{{{1, 0}, {-1, 0}}}, {0, 1}};
  const ph::detail::facet_slab<2> slab{segment, 1e-3, 1e-6};
  for (const double height : {-1.9e-6, 0.0, 1e-3 + 0.9e-6}) EXPECT_TRUE(slab.holds({0.5, height})) << height;
  for (const double height : {-2.1e-6, 1e-3 + 1.1e-6}) EXPECT_FALSE(slab.holds({0.5, height})) << height;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(slab.holds({side * (1 + 1.9e-6), 0}));
    EXPECT_FALSE(slab.holds({side * (1 + 2.1e-6), 0}));
  }
}

// It falls under the skin by less than a lip while it is over the facet, then by more; or it does not fall.
TEST(a_slab, stops_what_falls_but_not_what_only_grazes_it) {
  const ph::mesh_facet<2> segment{{{{1, 0}, {-1, 0}}}, {0, 1}};
  const ph::detail::facet_slab<2> slab{segment, 1e-3, 1e-6};
  EXPECT_GT(slab.stop({0.9, 1e-3}, {1, -5e-6}), 1);
  EXPECT_NEAR(slab.stop({0.9, 1e-3}, {1, -5e-5}), 0, 1e-9);
  EXPECT_EQ(slab.stop({0.1, 5e-4}, {0, -1e-4}), 0);
  for (const ph::point<2>& step : {ph::point<2>(0, 1e-4), {1, 0}}) EXPECT_GT(slab.stop({0.1, 5e-4}, step), 1);
}

TEST(a_tracker, rests_on_nothing_where_the_handle_is_free) {
  const ph::mesh_parameters<2> plate{{{-1, 0}, {1, 0}}, {{1, 0}}};
  tracked::handle<2> h{ph::mesh_surface<2>(ph::mesh<2>(plate))};
  EXPECT_EQ(h.memory.nearest, 0) << "which every mesh has";
  EXPECT_EQ(h.memory.facet_count, 0);
  h.go({0.1, 0.01});
  h.go({0.1, -0.01});
  EXPECT_EQ(h.memory.facet_count, 1);
  h.go({0.1, 0.02});
  EXPECT_EQ(h.memory.facet_count, 0);
}

TEST(a_tracker, remembers_the_nearest_facet) {
  const ph::mesh_parameters<2> plate{{{-1, 0}, {0, 0}, {1, 0}}, {{1, 0}, {2, 1}}};
  tracked::handle<2> h{ph::mesh_surface<2>(ph::mesh<2>(plate))};
  for (const auto& [x, facet] : {std::pair(0.5, 1), {-0.5, 0}}) {
    h.go({x, 0.1});
    EXPECT_EQ(h.memory.nearest, facet) << x;
  }
}

}  // namespace
