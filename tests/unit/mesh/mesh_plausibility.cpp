// What looks odd about a mesh: its unit, its sides.
#include <passive_haptics/scene/mesh/mesh_plausibility.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"

#include <cmath>
#include <stdexcept>

namespace {

namespace ph = passive_haptics;

ph::mesh_parameters<3> cube_of(double size) { return sample_meshes::box<3>({0, 0, 0}, {size, size, size}); }
std::string remarks(const ph::mesh_parameters<3>& m, double reach = 0.4) {
  return plausibility(ph::triangle_mesh(m), reach);
}

TEST(plausibility_of_a_mesh, finds_another_unit) {
  for (const double size : {0.001, 0.1, 0.4, 3.9}) EXPECT_EQ(remarks(cube_of(size)), "") << size;
  EXPECT_EQ(
      remarks(cube_of(100)),
      "size of the mesh [m] = 100, usually up to 4: a file in millimetres, whose metres_per_unit is 1e-3?\n");
  EXPECT_EQ(
      remarks(cube_of(1e-4)),
      "size of the mesh [m] = 0.0001, usually over 0.0008: a file in metres, whose metres_per_unit is 1?\n");
  EXPECT_EQ(remarks(cube_of(100), 20), "");
  for (const double reach : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(remarks(cube_of(1), reach), std::invalid_argument) << reach;
}

TEST(plausibility_of_a_mesh, finds_what_is_inside_out) {
  EXPECT_EQ(
      remarks(sample_meshes::inside_out(cube_of(0.1))),
      "volume within the mesh [m^3] = -0.001, usually > 0: inside out? If the hand is outside, swap two "
      "corners of each facet\n");
  const ph::mesh<2> square(sample_meshes::inside_out(sample_meshes::box<2>({0, 0}, {0.1, 0.1})));
  EXPECT_EQ(plausibility(square, 0.4),
            "area within the mesh [m^2] = -0.01, usually > 0: inside out? If the hand is outside, swap two "
            "corners of each facet\n");
}

TEST(plausibility_of_a_mesh, finds_single_facets_that_are_inside_out) {
  auto m = cube_of(0.1);
  EXPECT_EQ(ph::triangle_mesh(m).turned_edges(), 0);
  std::swap(m.facets[4][0], m.facets[4][1]);
  EXPECT_EQ(ph::triangle_mesh(m).turned_edges(), 3);
  EXPECT_EQ(
      remarks(m),
      "edges whose facets face opposite sides = 3, usually 0: facets inside out? A handle that comes from "
      "their back goes through\n");
  m.facets.erase(m.facets.begin() + 5, m.facets.end());  // open, and turned all the same
  EXPECT_EQ(ph::triangle_mesh(m).turned_edges(), 1);
  m.facets.pop_back();
  EXPECT_EQ(remarks(m), "");
}

}  // namespace
