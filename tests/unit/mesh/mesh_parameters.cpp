// What is said of meshes that are wrong.
#include <passive_haptics/scene/mesh/mesh_solid.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ph = passive_haptics;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

ph::mesh_parameters<3> cube() { return sample_meshes::box<3>({0, 0, 0}, {1, 1, 1}); }
ph::mesh_parameters<2> square() { return sample_meshes::box<2>({0, 0}, {1, 1}); }

template <int D>
std::string error_of_solid(const ph::mesh_parameters<D>& p) {
  return validate(ph::mesh_solid_parameters<D>{ph::mesh<D>(p)});
}

template <class Change, class Parameters>
std::string error_after(const Change& change, Parameters p) {
  change(p);
  return validate(p);
}

TEST(mesh_parameters, say_what_is_wrong) {
  EXPECT_EQ(validate(cube()), "");
  EXPECT_EQ(validate(square()), "");
  EXPECT_EQ(validate(ph::mesh_parameters<3>{}), "a mesh has no facets: expected one or more");
  for (const std::size_t i : {3u, 0u})
    EXPECT_EQ(error_after([i](auto& p) { p.vertices[i][1] = no_number; }, cube()),
              "vertices[" + std::to_string(i) + "][1] of a mesh [m] = nan: expected a finite number");
  for (const int i : {8, -1})
    EXPECT_EQ(error_after([i](auto& p) { p.facets[7][2] = i; }, cube()),
              "facet 7 of a mesh: index of a vertex = " + std::to_string(i) +
                  ": expected 0 or more and less than 8");
  const std::string sliver =
      " of a mesh: height by longest edge = 0: expected > 1e-10; remove the facet, without_slivers() does";
  EXPECT_EQ(error_after([](auto& p) { p.facets[7][2] = p.facets[7][0]; }, cube()), "facet 7" + sliver);
  auto s = square();
  s.vertices[1] = s.vertices[0];
  EXPECT_EQ(validate(s), "facet 0" + sliver);
  EXPECT_EQ(validate(without_slivers(s)), "");
  EXPECT_EQ(without_slivers(s).facets.size(), 3u);
  EXPECT_THROW(ph::triangle_mesh(ph::mesh_parameters<3>{}), std::invalid_argument);
}

TEST(a_facet, is_as_slender_as_it_is_high_for_its_length) {
  const ph::point<2> a(1, 2), b(1, 1e200);
  EXPECT_EQ(ph::detail::slenderness<2>({a, b}), 1);
  EXPECT_EQ(ph::detail::slenderness<2>({a, a}), 0);
  const ph::point<3> o(0, 0, 0), x(2, 0, 0), y(1, 1, 0);
  EXPECT_EQ(ph::detail::slenderness<3>({o, x, y}), 0.5);
  EXPECT_EQ(ph::detail::slenderness<3>({o, x, x}), 0);
  EXPECT_EQ(ph::detail::slenderness<3>({x, x, x}), 0);
}

// Whichever corner comes first, and wherever the needle lies.
TEST(mesh_parameters, measure_a_sliver_by_its_longest_edge) {
  for (const double height : {0.9e-10, 1.1e-10}) {
    for (const double away : {-10.0, 0.0, 10.0}) {
      for (std::size_t first = 0; first < 3; ++first) {
        ph::mesh_parameters<3> p{{}, {{0, 1, 2}}};
        const std::array<ph::point<3>, 3> corners{{{0, away, 0}, {1, away, 0}, {0.5, away, height}}};
        for (std::size_t k = 0; k < 3; ++k) p.vertices.push_back(corners[(first + k) % 3]);
        EXPECT_EQ(validate(p).empty(), height > 1e-10) << height << ' ' << away << ' ' << first;
        EXPECT_EQ(without_slivers(p).facets.size(), height > 1e-10 ? 1u : 0u);
      }
    }
  }
}

TEST(a_facet, tells_what_its_nearest_point_lies_on) {
  const auto expect_nearest = []<int D>(const ph::mesh_facet<D>& f, const ph::point<D>& x,
                                        const ph::point<D>& foot, ph::facet_part part, int index) {
    const auto nearest = ph::nearest_point(f, x);
    EXPECT_TRUE(nearest.position.isApprox(foot, 1e-15)) << nearest.position.transpose();
    EXPECT_DOUBLE_EQ(nearest.squared_distance, (x - foot).squaredNorm());
    EXPECT_EQ(nearest.part, part) << x.transpose();
    EXPECT_EQ(nearest.index, index) << x.transpose();
  };
  using enum ph::facet_part;
  using at2 = ph::point<2>;
  const ph::mesh_facet<2> segment{{{{1, 2}, {4, 2}}}, {0, -1}};
  EXPECT_EQ(segment.height({2, 7}), -5);
  EXPECT_EQ(segment.corner(3), at2(4, 2));
  expect_nearest(segment, at2(0, 3), at2(1, 2), corner, 0);
  expect_nearest(segment, at2(6, 3), at2(4, 2), corner, 1);
  expect_nearest(segment, at2(3, 5), at2(3, 2), interior, 0);
  EXPECT_EQ(ph::nearest_point(segment, at2(3, 5), 9.0).squared_distance, 9);
  EXPECT_TRUE(std::isinf(ph::nearest_point(segment, at2(3, 5), 8.9).squared_distance));
  using at3 = ph::point<3>;
  const ph::mesh_facet<3> triangle{{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}}, {0, 0, 1}};
  expect_nearest(triangle, at3(-1, -2, 2), at3(0, 0, 0), corner, 0);
  expect_nearest(triangle, at3(6, -1, 3), at3(4, 0, 0), corner, 1);
  expect_nearest(triangle, at3(-1, 5, 1), at3(0, 3, 0), corner, 2);
  expect_nearest(triangle, at3(1, -2, 1), at3(1, 0, 0), edge, 0);
  expect_nearest(triangle, at3(5, 5.5, 2), at3(2, 1.5, 0), edge, 1);
  expect_nearest(triangle, at3(-3, 1, 5), at3(0, 1, 0), edge, 2);
  expect_nearest(triangle, at3(1, 1, -2), at3(1, 1, 0), interior, 0);
  const ph::mesh_facet<3> obtuse{{{{0, 0, 0}, {4, 0, 0}, {-3, 1, 0}}}, {0, 0, 1}};
  expect_nearest(obtuse, at3(1, -0.5, 2), at3(1, 0, 0), edge, 0);  // and behind edge 2
}

TEST(mesh_solid, says_what_keeps_it_from_being_solid) {
  EXPECT_EQ(error_of_solid(cube()), "");
  EXPECT_EQ(error_of_solid(square()), "");

  auto p = cube();
  p.facets.pop_back();  // 3, 7, 5
  EXPECT_EQ(error_of_solid(p),
            "edge between vertices 3 and 5 of a mesh_solid belongs to facet 10 only: expected a closed "
            "surface; close the hole, or use mesh_surface");
  auto s = square();
  s.facets.pop_back();  // 2, 0
  EXPECT_EQ(error_of_solid(s),
            "vertex 0 of a mesh_solid belongs to facet 0 only: expected a closed surface; close the hole, or "
            "use mesh_surface");

  p = cube();
  std::swap(p.facets[1][0], p.facets[1][1]);
  EXPECT_EQ(error_of_solid(p),
            "edge between vertices 1 and 2 of a mesh_solid: facets 0 and 1 run the same way: expected "
            "opposite ways; "
            "swap two vertices of one of them");
  s = square();
  std::swap(s.facets[1][0], s.facets[1][1]);
  EXPECT_EQ(error_of_solid(s),
            "vertex 1 of a mesh_solid: facets 0 and 1 run the same way: expected opposite ways; swap two "
            "vertices of "
            "one of them");

  p = cube();
  p.vertices.push_back({0.5, 0.5, 0.5});
  p.facets.push_back({0, 1, 8});
  EXPECT_EQ(error_of_solid(p),
            "edge between vertices 0 and 1 of a mesh_solid belongs to 3 facets: expected as many that run "
            "one way as "
            "the other; remove what is within the solid");

  EXPECT_EQ(error_of_solid(sample_meshes::inside_out(cube())),
            "volume of a mesh_solid [m^3] = -1: expected > 0; swap two vertices of every facet, or use "
            "complement() for a room");
  EXPECT_EQ(error_of_solid(sample_meshes::inside_out(square())),
            "area of a mesh_solid [m^2] = -1: expected > 0; swap two vertices of every facet, or use "
            "complement() for a room");
  EXPECT_THROW(ph::mesh_solid<3>{ph::triangle_mesh(sample_meshes::inside_out(cube()))},
               std::invalid_argument);
}

TEST(a_mesh, gives_no_number_for_no_number) {
  const ph::mesh_solid<3> solid{ph::triangle_mesh(cube())};
  for (int i = 0; i < 3; ++i) {
    ph::point<3> x(0.5, 0.5, 0.5);
    x[i] = no_number;
    EXPECT_TRUE(std::isnan(solid.distance(x)));
  }
}

TEST(a_mesh, may_touch_itself_along_an_edge_or_at_a_corner) {
  const auto stair = sample_meshes::both(cube(), sample_meshes::box<3>({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(error_of_solid(stair), "");
  const ph::mesh_solid<3> solid{ph::triangle_mesh(stair)};
  EXPECT_NEAR(solid.distance({0.9, 1.1, 0.5}), 0.1, 1e-15);
  EXPECT_NEAR(solid.distance({0.9, 0.8, 0.5}), -0.1, 1e-15);
  EXPECT_NEAR(solid.distance({1.1, 1.1, 0.5}), -0.1, 1e-15);
  EXPECT_EQ(error_of_solid(sample_meshes::both(cube(), sample_meshes::box<3>({1, 1, 1}, {2, 2, 2}))), "");
  EXPECT_EQ(error_of_solid(sample_meshes::both(square(), sample_meshes::box<2>({1, 1}, {2, 2}))), "");
}

// A leaf of two sides: beyond its corners, either side will do.
TEST(a_mesh, has_a_unit_normal_everywhere) {
  const ph::triangle_mesh leaf({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  for (const ph::point<3>& x : {ph::point<3>(-1, -1, 0), {2, 0, 0}, {0, 2, 0}, {0.5, -1, 0}, {0.2, 0.2, 1}})
    EXPECT_EQ(leaf.normal_at(leaf.nearest(x)).norm(), 1) << x.transpose();
  const ph::triangle_mesh box(sample_meshes::box<3>({-1, -1, -1}, {1, 1, 1}));
  for (const ph::point<3>& x : {ph::point<3>(2, 2, 2), {2, 2, 0}, {-2, 0.1, 0.2}})
    EXPECT_NEAR(box.normal_at(box.nearest(x)).norm(), 1, 1e-15) << x.transpose();
  for (const ph::point<3>& corner : {ph::point<3>(1, 1, 1), {-1, 1, -1}, {-1, -1, -1}})  // weighted by angles
    EXPECT_TRUE(box.normal_at(box.nearest(2 * corner)).isApprox(corner.normalized(), 1e-15));
}

// However near it is: the way to it would be rounding.
TEST(a_mesh, has_the_gradient_of_the_facet_in_front_of_it) {
  const auto globe = sample_meshes::globe(24, 12, [](const auto&) { return 1.0; });
  const ph::triangle_mesh surface(globe);
  const ph::mesh_solid<3> solid{surface};
  for (std::size_t f = 0; f < globe.facets.size(); ++f) {
    const auto c = globe.corners(f);
    const ph::point<3>& n = surface[static_cast<int>(f)].normal;
    const ph::point<3> middle = (c[0] + c[1] + c[2]) / 3;
    for (const double height : {1e-9, 1e-3})
      EXPECT_EQ(solid.gradient(middle + height * n), n) << "facet " << f;
    // On an edge what is left to the nearest point has no direction
    const ph::point<3> on_edge = c[0] + 0.3 * (c[1] - c[0]);
    EXPECT_GT(solid.gradient(on_edge).dot(on_edge.normalized()), 0.9) << "facet " << f;
  }
}

TEST(a_mesh, keeps_to_the_facet_that_was_guessed_where_others_are_as_near) {
  const ph::polyline wedge({{{-1, -1}, {0, 0}, {1, -1}}, {{0, 1}, {1, 2}}});
  EXPECT_EQ(wedge.nearest({0, 1}).facet, 0);
  for (const int guess : {0, 1}) EXPECT_EQ(wedge.nearest({0, 1}, guess).facet, guess);
}

}  // namespace
