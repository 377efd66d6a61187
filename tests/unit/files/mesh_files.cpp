// Meshes from files of all formats: the solid, its unit, and that no bytes whatever do harm.
#include "mesh_files.hpp"

#include <passive_haptics/scene/mesh/mesh_solid.hpp>

#include <sys/resource.h>
#include <sys/stat.h>

namespace {

using namespace mesh_files;

struct mesh_of_a_file : in_a_folder {};

TEST_F(mesh_of_a_file, is_the_same_solid_in_each_format) {
  for (const auto& [name, read, text] : formats()) {
    const auto file = read(write(name, text));
    EXPECT_EQ(file.mesh.vertices.size(), 8u) << name;
    EXPECT_EQ(file.mesh.facets.size(), 12u) << name;
    EXPECT_EQ(file.slivers + file.not_triangles, 0) << name;
    const ph::mesh_solid<3> solid{ph::triangle_mesh(file.mesh)};
    EXPECT_DOUBLE_EQ(solid.surface().content(), 6) << name;
    EXPECT_DOUBLE_EQ(solid.distance({0.5, 1, 2.75}), -0.25) << name;
  }
}

TEST_F(mesh_of_a_file, keeps_every_bit_of_its_coordinates) {
  mesh m = cube();
  for (auto& v : m.vertices) v = v * (1 + 1e-9) + ph::point<3>(1.0 / 3, 100 + 1e-12, -2.0 / 7);
  for (const auto& [name, read_file, text] : {format{"a.stl", stl, ascii_stl(m)},
                                              {"a.obj", obj_file, obj(m)},
                                              {"a.ply", ply, ascii_ply(m)},
                                              {"b.ply", ply, binary_ply(m)}}) {
    const mesh read = read_file(write(name, text)).mesh;
    for (std::size_t f = 0; f < m.facets.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read.corners(f)[i], m.corners(f)[i]) << name;
  }
}

TEST_F(mesh_of_a_file, is_in_the_unit_that_is_said) {
  const ph::triangle_mesh m(ph::read_obj(write("cube.obj", obj(cube())), 1e-3).mesh);
  EXPECT_NEAR((m.bounds().upper - ph::point<3>(1e-3, 2e-3, 3e-3)).norm(), 0, 1e-18);
  for (const double scale : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(ph::read_obj(folder / "cube.obj", scale), std::invalid_argument);
}

TEST_F(mesh_of_a_file, has_polygons_cut_into_triangles_that_face_as_they_do) {
  // About a corner that turns in: of four fans two fit
  const std::string arrow = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n";
  for (const char* f : {"f 1 2 3 4", "f 2 3 4 1", "f 3 4 1 2", "f 4 1 2 3", "f -4 -3 -2 -1"}) {
    const mesh m = ph::read_obj(write("arrow.obj", arrow + f)).mesh;
    ASSERT_EQ(m.facets.size(), 2u);
    double area = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(ph::detail::normal_of(m.corners(i)), ph::point<3>::UnitZ());
      const auto c = m.corners(i);
      const ph::point<3> u = c[1] - c[0], v = c[2] - c[0];
      area += 0.5 * ph::cross(u, v).norm();
    }
    EXPECT_DOUBLE_EQ(area, 4) << f;
  }
}

TEST_F(mesh_of_a_file, is_made_of_all_parts_and_of_what_else_formats_have) {
  const auto two = ph::read_stl(write("two.stl", ascii_stl(cube()) + "\n" + ascii_stl(cube())));
  EXPECT_EQ(two.mesh.facets.size(), 24u);
  EXPECT_EQ(ph::read_stl(write("named.stl", binary_stl(cube(), "solid but binary"))).mesh.facets.size(), 12u);

  const auto parts =
      ph::read_obj(write("parts.obj",
                         "# parts\r\nmtllib a.mtl\no one\nv 0 0 0 # origin\nv 1 0 0 1\n\tv +1 1 0 "
                         "0.5 0.5 0.5\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl red\ns 1\nf 1/1/1 2//1 \\\n"
                         "  3/1 4\no two\nv 2 0 0\nv 2 1 0\nf 2 -2 -1 3\nl 1 2 3\np 1\n"));
  EXPECT_EQ(parts.mesh.facets.size(), 4u);
  EXPECT_EQ(parts.mesh.vertices.size(), 6u);
  EXPECT_EQ(parts.not_triangles, 2);

  const auto more = ph::read_ply(write(
      "more.ply",
      "ply\r\nformat ascii 1.0\r\nobj_info of a scanner\r\nelement face 2\r\nproperty uchar kind\r\n"
      "property list uint8 uint16 vertex_index\r\nproperty list uchar float texcoord\r\nelement vertex 3\r\n"
      "property float32 z\r\nproperty float32 nx\r\nproperty int x\r\nproperty list uchar int marks\r\n"
      "property float y\r\nelement edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\nend_header\r\n"
      "1 3 0 1 2 2 0.5 nan\r\n2 2 0 1 0\r\n0 nan 0 0 0\r\n0 9 4 2 8 9 0\r\n5 9 0 0 1\r\n0 1\r\n"));
  ASSERT_EQ(more.mesh.facets.size(), 1u);
  EXPECT_EQ(more.not_triangles, 2);
  EXPECT_EQ(more.mesh.corners(0)[1], ph::point<3>(4, 0, 0));
  EXPECT_EQ(more.mesh.corners(0)[2], ph::point<3>(0, 1, 5));
}

TEST_F(mesh_of_a_file, loses_triangles_without_area_and_says_how_many) {
  auto m = cube();
  m.facets.push_back({0, 1, 1});
  m.vertices.push_back({0.5, 0, 0});
  m.facets.push_back({0, 8, 1});
  for (const auto& [name, read, text] : {format{"a.stl", stl, ascii_stl(m)},
                                         {"b.stl", stl, binary_stl(m)},
                                         {"a.obj", obj_file, obj(m)},
                                         {"a.ply", ply, ascii_ply(m)}}) {
    const auto file = read(write(name, text));
    EXPECT_EQ(file.slivers, 2) << name;
    EXPECT_EQ(file.mesh.facets.size(), 12u) << name;
  }
}

// A scanner writes NaN where it saw nothing.
TEST_F(mesh_of_a_file, may_have_vertices_that_are_no_numbers_if_no_face_uses_them) {
  mesh with_hole = cube();
  with_hole.vertices.insert(with_hole.vertices.begin() + 3, ph::point<3>(0, std::nan(""), 1));
  with_hole.vertices.emplace_back(std::nan(""), 0, 0);
  for (auto& f : with_hole.facets)
    for (int& v : f) v += v >= 3;
  expect_cube(ph::read_obj(write("a.obj", obj(with_hole))), "obj");
  for (const char* nan : {"-1.#IND", "1.#QNAN00", "1.#INF"})
    expect_cube(ph::read_obj(write("a.obj", replaced(obj(with_hole), "nan", nan))), nan);
  expect_cube(ph::read_ply(write("a.ply", ascii_ply(with_hole))), "text");
  expect_cube(ph::read_ply(write("b.ply", binary_ply(with_hole))), "binary");

  with_hole.facets[2][1] = 3;
  const std::string wrong = "corner 2 = (0, nan, 1): expected finite coordinates; the file is damaged";
  EXPECT_EQ(obj_error(obj(with_hole)), "line 13: " + wrong);
  EXPECT_EQ(obj_error(replaced(obj(with_hole), "nan", "-1.#IND")), "line 13: " + wrong);
  EXPECT_NE(obj_error(replaced(obj(with_hole), "nan", "2.#IND")), "line 13: " + wrong);
  EXPECT_EQ(ply_error(ascii_ply(with_hole)), "line 24: " + wrong);
  EXPECT_EQ(stl_error(ascii_stl(with_hole)), "line 16: " + wrong);
  EXPECT_EQ(stl_error(binary_stl(with_hole)), "byte 184: " + wrong);
}

TEST_F(mesh_of_a_file, is_read_from_a_regular_file_only) {
  ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
  for (const reader& read : {stl, obj_file, ply}) {
    EXPECT_EQ(error_of(read, folder / "none"), "no such file");
    EXPECT_EQ(error_of(read, folder), "is a directory: expected a regular file");
    EXPECT_EQ(error_of(read, folder / "fifo"), "is a FIFO: expected a regular file");
    EXPECT_EQ(error_of(read, "/dev/zero"), "is a device: expected a regular file");
  }
}

// Each prefix of a good file ends, and quickly.
TEST_F(mesh_of_a_file, that_is_cut_off_anywhere_is_refused_or_is_a_mesh) {
  for (const auto& [name, read, text] : formats())
    for (std::size_t size = 0; size < text.size(); ++size) {
      const std::string error = error_of(read, write(name, text.substr(0, size)));
      const bool only_the_name_is_gone = size + std::strlen(" part of a thing\n") >= text.size();
      EXPECT_TRUE(error != "none" || only_the_name_is_gone || text.starts_with("v "))
          << name << " cut to " << size;
    }
}

// A header may announce anything: no memory is taken for what is not there.
TEST_F(mesh_of_a_file, that_announces_more_than_it_has_takes_no_memory) {
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  for (const char* count : {"2147483647", "1000000000", "99999999"}) {
    const std::string head = std::string("ply\nformat binary_little_endian 1.0\nelement vertex ") + count +
                             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                             count + "\nproperty list uint uint vertex_indices\nend_header\n";
    EXPECT_NE(error_of(ply, write("a.ply", head + std::string(100, '\0'))).find("rows of 24 bytes"),
              std::string::npos);
  }
  std::string bytes = ply_head("binary_little_endian", {cube().vertices, {{0, 1, 2}}});
  bytes.replace(bytes.find("list uchar"), 10, "list uint");
  bytes += std::string(8 * 25, '\0');
  append(bytes, std::uint32_t(0xffffffff));
  EXPECT_NE(error_of(ply, write("b.ply", bytes)).find("a list of 4294967295 values"), std::string::npos);
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 20'000) << "KiB";
}

// Whatever stands in a file, there is a mesh that is valid or an error that names it.
TEST_F(mesh_of_a_file, with_bytes_gone_wrong_is_valid_or_refused) {
  constexpr std::uint64_t seed = 20040627;
  ph::testing::random_source random(seed);
  for (const auto& [name, read, good] : formats()) {
    int valid = 0, refused = 0;
    for (int k = 0; k < 150; ++k) {
      std::string text = good;
      const auto somewhere = [&] {
        return static_cast<std::size_t>(random.uniform(0.0, double(text.size())));
      };
      for (int hits = k % 4; hits >= 0 && !text.empty(); --hits) {
        const std::size_t at = somewhere();
        const char any = static_cast<char>(random.uniform(0.0, 256.0) - 128);
        const char likely = "0123456789 -\n."[static_cast<std::size_t>(random.uniform(0.0, 14.0))];
        switch (static_cast<int>(random.uniform(0.0, 5.0))) {
          case 0: text[at] = any; break;
          case 1: text[at] = likely; break;
          case 2: text.erase(at, somewhere() / 8); break;
          case 3: text.insert(at, text.substr(somewhere(), 12)); break;
          default: text.resize(at);
        }
      }
      const auto path = write(name, text);
      const std::string error = error_of(
          [&, &read = read](const fs::path& p) {
            ASSERT_EQ(validate(read(p).mesh), "") << "seed " << seed << ", file " << k;
          },
          path);
      EXPECT_FALSE(error.starts_with("not so named")) << error;
      ++(error == "none" ? valid : refused);
    }
    EXPECT_GT(refused, 15) << name;
    EXPECT_GT(valid, 1) << name;
  }
}

}  // namespace
