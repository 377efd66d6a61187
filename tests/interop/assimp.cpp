// Meshes from files: what is right in them, and what is said of those that are wrong.
#include <passive_haptics/interop/assimp.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>

#include <gtest/gtest.h>

#include "../property/sample_meshes.hpp"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace ph = passive_haptics;
namespace fs = std::filesystem;

namespace {

// A folder of its own that goes with the test.
struct mesh_files : ::testing::Test {
  const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(::testing::TempDir()) / (std::string("passive_haptics_") + test.name());

  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  std::string error_text(const fs::path& path, double scale = 1) const {
    try {
      ph::read_mesh(path, scale);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "none";
  }
};

ph::mesh_parameters<3> cube() { return sample_meshes::box<3>({0, 0, 0}, {1, 2, 3}); }

std::string ascii_stl(const ph::mesh_parameters<3>& m) {
  std::ostringstream text;
  text << "solid part\n";
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const auto& c : m.corners(f)) text << "vertex " << c[0] << " " << c[1] << " " << c[2] << "\n";
    text << "endloop\nendfacet\n";
  }
  text << "endsolid part\n";
  return text.str();
}

// 80 bytes of a title, the number of triangles, and of each normal, corners and two bytes; little endian.
std::string binary_stl(const ph::mesh_parameters<3>& m) {
  std::string bytes(80, ' ');
  const auto put = [&](const auto& value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  put(static_cast<std::uint32_t>(m.facets.size()));
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) put(0.0f);
    for (const auto& c : m.corners(f)) {
      for (int i = 0; i < 3; ++i) put(static_cast<float>(c[i]));
    }
    put(std::uint16_t(0));
  }
  return bytes;
}

std::string obj(const ph::mesh_parameters<3>& m) {
  std::ostringstream text;
  for (const auto& v : m.vertices) text << "v " << v[0] << " " << v[1] << " " << v[2] << "\n";
  for (const auto& f : m.facets) text << "f " << f[0] + 1 << " " << f[1] + 1 << " " << f[2] + 1 << "\n";
  return text.str();
}

TEST_F(mesh_files, of_all_kinds_hold_the_same_solid) {
  for (const fs::path& path : {write("ascii.stl", ascii_stl(cube())), write("binary.stl", binary_stl(cube())),
                               write("cube.obj", obj(cube()))}) {
    const auto file = ph::read_mesh_file(path);
    EXPECT_EQ(file.mesh.vertices.size(), 8u) << path;
    EXPECT_EQ(file.mesh.facets.size(), 12u) << path;
    EXPECT_EQ(file.slivers + file.not_triangles, 0) << path;
    const ph::mesh_solid<3> solid{ph::triangle_mesh(file.mesh)};
    EXPECT_DOUBLE_EQ(solid.surface().content(), 6) << path;
    EXPECT_DOUBLE_EQ(solid.distance({0.5, 1, 4}), 1) << path;
    EXPECT_DOUBLE_EQ(solid.distance({0.5, 1, 2.75}), -0.25) << path;
  }
}

TEST_F(mesh_files, are_in_the_unit_that_is_said) {
  const ph::triangle_mesh m(ph::read_mesh(write("cube.obj", obj(cube())), 1e-3));
  EXPECT_NEAR((m.bounds().upper - ph::point<3>(1e-3, 2e-3, 3e-3)).norm(), 0, 1e-18);
}

TEST_F(mesh_files, have_polygons_and_parts_made_one_mesh_of_triangles) {
  const auto file = ph::read_mesh_file(write("parts.obj",
                                             "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
                                             "o one\nf 1 2 3 4\no two\nf 2 5 6 3\n"));
  EXPECT_EQ(file.mesh.facets.size(), 4u);
  EXPECT_EQ(file.mesh.vertices.size(), 6u);
  for (std::size_t f = 0; f < 4; ++f)
    EXPECT_EQ(ph::detail::normal_of(file.mesh.corners(f)), ph::point<3>::UnitZ());
}

// glTF, for it has nodes: the same triangle turned, moved, and mirrored.
TEST_F(mesh_files, have_parts_where_their_nodes_say) {
  const auto path =
      write("nodes.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
    "nodes": [{"translation": [10, 0, 0], "children": [1]}, {"scale": [2, 2, 2], "mesh": 0},
              {"scale": [1, 1, -1], "translation": [0, 0, 5], "mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const auto m = ph::read_mesh(path);
  ASSERT_EQ(m.facets.size(), 2u);
  EXPECT_EQ(m.corners(0)[1], ph::point<3>(12, 0, 0));
  EXPECT_EQ(ph::detail::normal_of(m.corners(0)), ph::point<3>(0, 0, 1));
  EXPECT_EQ(m.corners(1)[0], ph::point<3>(0, 0, 5));
  EXPECT_EQ(ph::detail::normal_of(m.corners(1)), ph::point<3>(0, 0, -1)) << "mirrored";
}

TEST_F(mesh_files, lose_triangles_without_area_and_say_how_many) {
  auto m = cube();
  m.facets.push_back({0, 1, 1});
  m.vertices.push_back({0.5, 0, 0});
  m.facets.push_back({0, 8, 1});
  const auto file = ph::read_mesh_file(write("slivers.stl", binary_stl(m)));
  EXPECT_EQ(file.slivers, 2);
  EXPECT_EQ(file.mesh.facets.size(), 12u);
  EXPECT_EQ(validate(file.mesh), "");
}

TEST_F(mesh_files, that_are_wrong_are_named_with_the_reason) {
  const auto says = [&](const fs::path& path, const std::string& reason, double scale = 1) {
    const std::string text = error_text(path, scale),
                      start = "passive_haptics: mesh file " + path.string() + ": ";
    EXPECT_EQ(text.substr(0, start.size()), start);
    EXPECT_NE(text.find(reason), std::string::npos) << text;
  };
  const auto good = write("good.stl", binary_stl(cube()));
  says(folder / "goood.stl", "no such file");
  says(folder, "not a file");
  for (const double scale : {0.0, -1.0, std::nan("")}) says(good, "metres_per_unit = ", scale);
  says(write("empty.stl", ""), "no mesh that Assimp reads: ");
  says(write("good.txt", binary_stl(cube())), "no mesh that Assimp reads: ");
  says(write("garbage.stl", std::string(3000, 'x')), "no mesh that Assimp reads: ");
  says(write("garbage.obj", std::string("\x01\x02\xff\xfe garbage\n", 13)), "no");
  const std::string whole = binary_stl(cube());
  says(write("cut.stl", whole.substr(0, whole.size() - 60)), "no mesh that Assimp reads: ");
  says(write("cut_title.stl", whole.substr(0, 50)), "no mesh that Assimp reads: ");
  says(write("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "no triangles, expected one or more");
  says(write("points.obj", "v 0 0 0\nv 1 0 0\n"), "no");
  says(write("lost_vertex.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"), "no mesh that Assimp reads: ");
  says(write("flat.stl", binary_stl({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}})),
       "no triangle has an area");
  auto bad = cube();
  bad.vertices[3][1] = std::nan("");
  says(write("nan.stl", binary_stl(bad)), "not finite");
  bad.vertices[3][1] = INFINITY;
  says(write("inf.stl", binary_stl(bad)), "not finite");
}

// Whatever stands in a file, there is a mesh that is valid or an error.
TEST_F(mesh_files, with_bytes_gone_wrong_never_give_a_mesh_that_is) {
  ph::testing::random_source random(20040627);
  const std::string texts[] = {binary_stl(cube()), ascii_stl(cube()), obj(cube())};
  const char* const names[] = {"a.stl", "b.stl", "c.obj"};
  int read = 0, refused = 0;
  for (int k = 0; k < 600; ++k) {
    const auto kind = static_cast<std::size_t>(k % 3);
    std::string text = texts[kind];
    const auto somewhere = [&] { return static_cast<std::size_t>(random.uniform(0.0, double(text.size()))); };
    if (k % 4 == 0) text.resize(somewhere());
    for (int hits = 0; hits < 3 && !text.empty(); ++hits)
      text[somewhere()] = static_cast<char>(random.uniform(0.0, 256.0) - 128);
    const auto path = write(names[kind], text);
    try {
      const auto m = ph::read_mesh(path);
      ASSERT_EQ(validate(m), "") << "seed 20040627, file " << k;
      ++read;
    } catch (const std::invalid_argument& e) {
      ASSERT_NE(std::string(e.what()).find(names[kind]), std::string::npos);
      ++refused;
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 50);
}

}  // namespace
