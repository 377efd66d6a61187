// Polygons that are cut into triangles: exactly, or with their line.
#include "mesh_files.hpp"

#include <passive_haptics/scene/mesh/mesh_solid.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace mesh_files;

// The polygon of these corners in the plane z = a x + b y, as OBJ.
std::string polygon(const std::vector<ph::point<2>>& corners, double a = 0, double b = 0) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& c : corners) text << "v " << c[0] << " " << c[1] << " " << a * c[0] + b * c[1] << "\n";
  text << "f";
  for (std::size_t i = 1; i <= corners.size(); ++i) text << " " << i;
  text << "\n";
  return text.str();
}

// Twice the area of a polygon in the plane.
double twice_area(const std::vector<ph::point<2>>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto &c = p[i], &d = p[(i + 1) % p.size()];
    sum += c[0] * d[1] - c[1] * d[0];
  }
  return sum;
}

struct a_polygon : in_a_folder {
  ph::mesh_file read(const std::string& text) const { return ph::read_obj(write("a.obj", text)); }
  std::string refusal(const std::string& text) const {
    return error_of([](const fs::path& p) { ph::read_obj(p); }, write("a.obj", text));
  }
  // No triangle is turned over, and together they have the area: nothing is missing, nothing twice.
  void expect_filled(const std::vector<ph::point<2>>& corners, double a = 0, double b = 0) const {
    const auto file = read(polygon(corners, a, b));
    double sum = 0;
    for (std::size_t f = 0; f < file.mesh.facets.size(); ++f) {
      const auto c = file.mesh.corners(f);
      const double area =
          (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
      EXPECT_GT(area, 0);
      sum += area;
    }
    EXPECT_NEAR(sum, twice_area(corners), 1e-12 * std::abs(sum));
    EXPECT_EQ(file.mesh.facets.size() + static_cast<std::size_t>(file.slivers), corners.size() - 2);
    EXPECT_EQ(file.twisted_quads, 0);
  }
};

TEST_F(a_polygon, that_is_concave_is_filled_exactly) {
  const std::vector<ph::point<2>> u{{0, 0},       {0.1, 0},     {0.1, 0.1},  {0.08, 0.1},
                                    {0.08, 0.02}, {0.02, 0.02}, {0.02, 0.1}, {0, 0.1}};
  std::vector<ph::point<2>> star, comb, spiral;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.3, angle = 0.2 * std::numbers::pi * i;
    star.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  for (int i = 0; i < 100; ++i) comb.emplace_back(0.01 * i, i % 2 == 0 ? -1 : -0.1);
  comb.insert(comb.end(), {{0.99, 0}, {0, 0}});
  for (const double r : {1.0, 0.9})
    for (int i = 0; i <= 60; ++i) {
      const int k = r == 1 ? i : 60 - i;
      spiral.emplace_back(r * (1 + 0.02 * k) * std::cos(0.2 * k), r * (1 + 0.02 * k) * std::sin(0.2 * k));
    }
  for (auto corners : {u, star, comb, spiral})
    for (std::size_t turned = 0; turned < corners.size(); turned += 7) {
      std::rotate(corners.begin(), corners.begin() + 7 % static_cast<long>(corners.size()), corners.end());
      expect_filled(corners);
      expect_filled(corners, 0.3, -2);
    }
}

TEST_F(a_polygon, that_surrounds_a_hole_by_a_seam_is_filled_exactly) {
  expect_filled({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

// A neighbour has the corner within the edge, too: without area, a triangle there would open the mesh.
TEST_F(a_polygon, with_corners_in_its_edges_has_no_triangle_without_area) {
  const std::vector<ph::point<2>> square{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}};
  auto corners = square;
  for (std::size_t turned = 0; turned < corners.size(); ++turned) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    expect_filled(corners);
    EXPECT_EQ(read(polygon(corners)).slivers, 0);
  }
  EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 3 4\n").slivers, 1);
  EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 3 0 0\nf 1 2 4 2\nf 1 2 3\n").slivers, 2);
}

// Corners within edges that a float rounds to either side of them, anywhere in space.
TEST_F(a_polygon, with_corners_in_its_edges_is_filled_whatever_a_float_makes_of_them) {
  constexpr std::uint64_t seed = 20040627;
  ph::testing::random_source random(seed);
  const auto direction = [&] {
    return ph::point<3>(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  };
  for (int k = 0; k < 1000; ++k) {
    const int n = 4 + k % 8;
    std::vector<ph::point<2>> corners, all;
    for (int i = 0; i < n; ++i) {
      const double r = random.uniform(0.2, 1.2),
                   angle = (i + random.uniform(0.0, 0.8)) * 2 * std::numbers::pi / n;
      corners.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ph::point<2> along = corners[(i + 1) % corners.size()] - corners[i];
      const int parts = static_cast<int>(random.uniform(1.0, 5.0));
      for (int part = 0; part < parts; ++part) all.push_back(corners[i] + along * part / parts);
    }
    const ph::point<3> x = direction().normalized(), z = ph::cross(x, direction()).normalized(),
                       y = ph::cross(z, x);
    const ph::point<3> origin = std::pow(30, k % 3 - 1) * direction();
    std::vector<ph::point<3>> vertices;
    std::vector<int> polygon;
    for (const auto& c : all) {
      ph::point<3> in_space = origin + c[0] * x + c[1] * y;
      for (double& coordinate : in_space) coordinate = static_cast<float>(coordinate);
      polygon.push_back(static_cast<int>(vertices.size()));
      vertices.push_back(in_space);
    }
    std::vector<std::array<int, 3>> triangles;
    ASSERT_EQ(ph::detail::cut_polygon(vertices, polygon, triangles), ph::detail::polygon_cut::exact)
        << "seed " << seed << ", polygon " << k;
    ph::point<3> area = ph::point<3>::Zero();
    for (const auto& f : triangles) {
      const auto at = [&](std::size_t i) { return vertices[static_cast<std::size_t>(f[i])]; };
      EXPECT_GT(ph::detail::slenderness<3>({at(0), at(1), at(2)}), ph::min_slenderness);
      area += ph::cross<double>(at(1) - at(0), at(2) - at(0));
    }
    EXPECT_EQ(triangles.size(), all.size() - 2);
    EXPECT_NEAR(area.dot(z), twice_area(all), 1e-3);
  }
}

TEST_F(a_polygon, that_is_convex_is_cut_from_its_first_corner) {
  const auto file = read(polygon({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}}));
  const std::vector<std::array<int, 3>> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(file.mesh.facets, fan);
}

// A thin strip that turns by more than a right angle, as modellers leave them: its edges keep the mesh
// closed.
TEST_F(a_polygon, of_four_corners_that_is_twisted_is_cut_and_counted) {
  const std::string strip = "v 0.3 0 0.08\nv 0.294 -0.002 0.086\nv 0.3065 0.006 0.004\nv 0.3 -0.010 -0.002\n";
  for (const char* quad : {"f 1 2 3 4\n", "f 2 3 4 1\n"}) {
    const auto file = read(strip + quad + quad);
    EXPECT_EQ(file.mesh.facets.size(), 4u);
    EXPECT_EQ(file.twisted_quads, 2);
    const auto normal = [&](std::size_t i) { return ph::detail::normal_of(file.mesh.corners(i)); };
    EXPECT_GT(normal(0).dot(normal(1)), -0.7) << "along the diagonal that folds it less: -0.62, not -0.75";
    EXPECT_NE(file.remarks.find("twisted quads, cut along a diagonal: 2, the first at line 5;"),
              std::string::npos);
  }
  // So does one that nearly lies on itself
  EXPECT_EQ(read("v 6.020 230.393 60.566\nv 4.936 230.517 61.220\nv 4.669 230.439 61.034\nv 6.121 230.403 "
                 "60.586\nf 1 2 3 4\n")
                .twisted_quads,
            1);
  // With its back it encloses nothing, without a hole
  const ph::triangle_mesh both(read(strip + "f 1 2 3 4\nf 4 3 2 1\n").mesh);
  EXPECT_TRUE(both.closed()) << both.hole();
}

TEST_F(a_polygon, that_crosses_itself_is_refused_with_its_line) {
  const auto refused = [](const char* corners) {
    return std::string("a polygon of ") + corners +
           " corners crosses itself: expected its corners in their order around it; cut it into triangles "
           "where "
           "the file is made";
  };
  EXPECT_EQ(refusal(polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), "line 5: " + refused("4"));
  EXPECT_EQ(refusal(polygon({{0, 0}, {2, 2}, {1, 0}, {0, 1}})), "line 5: " + refused("4"));
  std::vector<ph::point<2>> pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.emplace_back(std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i));
  EXPECT_EQ(refusal(polygon(pentagram)), "line 6: " + refused("5"));

  const auto error_of_ply = [&](const std::string& format, const std::string& data) {
    return error_of(
        [](const fs::path& p) { ph::read_ply(p); },
        write("a.ply", "ply\nformat " + format +
                           " 1.0\nelement vertex 4\nproperty char x\nproperty char y\nproperty char "
                           "z\nelement face 1\nproperty list uchar uchar vertex_indices\n"
                           "end_header\n" +
                           data));
  };
  EXPECT_EQ(error_of_ply("ascii", "0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n"), "line 14: " + refused("4"));
  const std::string data("\0\0\0\1\1\0\1\0\0\0\1\0\4\0\1\2\3", 17);
  const std::string error = error_of_ply("binary_little_endian", data);
  EXPECT_TRUE(error.starts_with("byte ") && error.ends_with(": " + refused("4"))) << error;
}

}  // namespace
