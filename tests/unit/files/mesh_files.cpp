// Meshes from STL, OBJ and PLY: what is right in them, what is said of those that are wrong, and that no
// bytes whatever do harm.
#include "mesh_files.hpp"

#include <passive_haptics/scene/mesh/mesh_solid.hpp>

#include <sys/resource.h>
#include <sys/stat.h>

#include <functional>

namespace {

using namespace mesh_files;

using reader = std::function<ph::mesh_file(const fs::path&)>;
const reader stl = [](const fs::path& p) { return ph::read_stl(p); },
             obj_file = [](const fs::path& p) { return ph::read_obj(p); },
             ply = [](const fs::path& p) { return ph::read_ply(p); };

struct format {
  const char* name;
  reader read;
  std::string cube;
};
std::vector<format> formats() {
  return {{"ascii.stl", stl, ascii_stl(cube())},   {"binary.stl", stl, binary_stl(cube())},
          {"cube.obj", obj_file, obj(cube())},     {"ascii.ply", ply, ascii_ply(cube())},
          {"little.ply", ply, binary_ply(cube())}, {"big.ply", ply, binary_ply(cube(), std::endian::big)}};
}

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
  for (const auto& [name, as_text] : {std::pair{"a.stl", ascii_stl(m)},
                                      {"a.obj", obj(m)},
                                      {"a.ply", ascii_ply(m)},
                                      {"b.ply", binary_ply(m)}}) {
    const auto path = write(name, as_text);
    const mesh read = (path.extension() == ".stl"   ? stl
                       : path.extension() == ".obj" ? obj_file
                                                    : ply)(path)
                          .mesh;
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
  for (const auto& [name, text] : {std::pair{"a.stl", ascii_stl(m)},
                                   {"b.stl", binary_stl(m)},
                                   {"a.obj", obj(m)},
                                   {"a.ply", ascii_ply(m)}}) {
    const auto path = write(name, text);
    const auto file = (path.extension() == ".stl" ? stl : path.extension() == ".obj" ? obj_file : ply)(path);
    EXPECT_EQ(file.slivers, 2) << name;
    EXPECT_EQ(file.mesh.facets.size(), 12u) << name;
  }
}

TEST_F(mesh_of_a_file, is_read_from_a_regular_file_only) {
  ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
  for (const reader& read : {stl, obj_file, ply}) {
    EXPECT_EQ(error_of(read, folder / "none"), "no such file");
    EXPECT_EQ(error_of(read, folder), "is a directory, expected a regular file");
    EXPECT_EQ(error_of(read, folder / "fifo"), "is a FIFO, expected a regular file");
    EXPECT_EQ(error_of(read, "/dev/zero"), "is a device, expected a regular file");
  }
}

TEST_F(mesh_of_a_file, that_is_wrong_is_named_with_place_and_expectation) {
  const std::string v3 = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const auto& [text, error] : {
           std::pair{std::string(""), "no triangles, expected one or more; points and lines have no sides"},
           {"v 0 0 0\nv 1 0 0\nl 1 2\n",
            "no triangles, expected one or more; points and lines have no sides"},
           {v3 + "f 1 2 4\n", "line 4: '4', expected a vertex of the 3 above, from 1, or back from -1"},
           {v3 + "f 1 2 0\n", "line 4: '0', expected a vertex of the 3 above, from 1, or back from -1"},
           {v3 + "f 1 2 -4\n", "line 4: '-4', expected a vertex of the 3 above, from 1, or back from -1"},
           {v3 + "f 1 2 99999999999999999999\n",
            "line 4: '99999999999999999999', expected the number of a vertex"},
           {v3 + "f 1 2 /3\n", "line 4: '/3', expected the number of a vertex"},
           {v3 + "f 1 2\n", "line 4: the line ends, expected three corners or more"},
           {"v 0 0\nv 1 0 0\n", "line 1: the line ends, expected a coordinate"},
           {"v 0 0 0x10\n", "line 1: '0x10', expected a coordinate"},
           {"v 0 0 1e999\n", "line 1: '1e999', expected a coordinate"},
           {v3 + "v 0 0 nan\nf 1 2 4\n",
            "line 5: corner 3 = (0, 0, nan), expected finite coordinates; the file is damaged"},
           {v3 + "f 1 2 2\n", "no triangle has an area, expected one or more"},
           {std::string("v 0 0 1\0\x1b[2J\n", 13),
            "line 1: a zero byte or Ctrl-Z, expected text; lines may be lost here: if none is, remove such "
            "bytes"},
           {"v 0,00 0,00 0,00\n",
            "line 1: '0,00', expected a coordinate; write a decimal point instead of the comma"},
           {"v 0 0 1.5e", "line 1: '1.5e', expected a coordinate; the file was cut off"},
           {v3 + "curv 0 1 1 2\n",
            "line 4: 'curv', expected v, f or another keyword of a mesh; curves and free-form surfaces are "
            "not "
            "read"},
           {std::string(100, 'x'),
            "line 1: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...', expected a keyword of a mesh; the file "
            "has "
            "no triangles"},
       }) {
    EXPECT_EQ(error_of(obj_file, write("a.obj", text)), error) << text;
  }

  const std::string whole = binary_stl(cube()), ascii = ascii_stl(cube());
  for (
      const auto& [text, error] : {
          std::pair{std::string(""), "line 1: the file ends, expected 'solid'; it was cut off, or is no STL"},
          {whole.substr(0, 83), "line 1: the file ends, expected 'solid'; it was cut off, or is no STL"},
          {whole.substr(0, 84),
           "byte 84: the file ends, expected 684 bytes, those of 12 triangles; it was cut off, or is no STL"},
          {std::string(80, ' ') + "\xff\xff\xff\xff",
           "line 1: '\xff\xff\xff\xff', expected 'solid'; it was cut off, or is no STL"},
          {ascii.substr(0, ascii.find("endloop")), "line 7: the file ends, expected 'endloop'"},
          {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero", "line 4: 'zero', expected a number"},
          {"solid a\nendsolid a\nfacet", "line 3: 'facet', expected 'solid', or the end of the file"},
          {"solid a\n", "line 2: the file ends, expected 'facet' or 'endsolid'"},
          {"solid a\nendsolid", "no triangles, expected one or more; points and lines have no sides"},
      })
    EXPECT_EQ(error_of(stl, write("a.stl", text)).substr(0, 200), error) << text.substr(0, 100);
}

TEST_F(mesh_of_a_file, of_ply_that_is_wrong_is_named_with_place_and_expectation) {
  const auto head = [](const std::string& counts, const std::string& format = "ascii") {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
           "property float z\nelement face " +
           counts + "\nproperty list uchar int vertex_indices\nend_header\n";
  };
  const std::string v3 = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string no_mesh = "the header is not that of a mesh, expected ";
  for (const auto& [text, error] : {
           std::pair{
               head("1") + v3 + "3 0 1 99999\n",
               std::string(
                   "line 13: 'vertex 99999', expected 0 or more and less than 3, as many as there are")},
           {head("1") + v3 + "3 0 1 -5\n",
            "line 13: 'vertex -5', expected 0 or more and less than 3, as many as there are"},
           {head("1") + v3 + "3 0 1 2.5\n", "line 13: '2.5', expected a whole number"},
           {head("1") + v3 + "3 0 1\n", "line 14: the file ends, expected a whole number"},
           {head("1") + v3 + "-1 0 1 2\n",
            "line 13: 'a list of -1 values', expected 0 or more, and no more than the file has"},
           {head("1") + v3 + "200 0 1 2\n",
            "line 13: 'a list of 200 values', expected 0 or more, and no more than the file has"},
           {head("1") + v3 + "3 0 1 2\n3 0 1 2\n",
            "line 14: '3', expected the end of the file, as the header says"},
           {head("99999999999") + v3 + "3 0 1 2\n",
            "element face has 99999999999 rows of 2 bytes or more, expected no more than the 26 bytes that "
            "follow the "
            "header"},
           {head("99999999999999999999") + v3,
            "line 7: '99999999999999999999', expected how many rows there are"},
           {head("-1") + v3, "line 7: '-1', expected how many rows there are"},
           {head("1", "binary") + v3,
            "line 2: 'binary', expected ascii, binary_little_endian or binary_big_endian"},
           {"", "line 1: the file ends, expected 'ply'"},
           {"plyx", "line 1: 'plyx', expected 'ply'"},
           {"ply", "line 1: the file ends, expected 'end_header' and the data; the file was cut off"},
           {std::string("ply\n\0", 5),
            "line 2: the file ends, expected 'end_header' and the data; the file was cut off"},
           {"ply\nformat ascii 2.0\n", "line 2: '2.0', expected version 1.0"},
           {"ply\nformat ascii 1.0\nproperty float x\n",
            "line 3: 'property', expected element, property, comment, obj_info or end_header"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nproperty real x\n",
            "line 4: 'real', expected a type: char, uchar, short, ushort, int, uint, float or double"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nproperty list float int x\n",
            "line 4: 'float', expected a type of whole numbers"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nelement vertex 3\n",
            "line 4: 'vertex', expected an element of another name"},
           {"ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int x\n",
            "line 5: 'x', expected a property of another name"},
           {"ply\nformat ascii 1.0\nend_header\n", no_mesh + "'element vertex' and how many there are"},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n0 0\n",
            no_mesh + "properties x, y and z of the vertices"},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int "
            "z\nend_header\n0 0 0\n",
            no_mesh + "'element face' and how many there are"},
           {"ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int "
            "z\nelement face 1\n"
            "property list uchar float vertex_indices\nend_header\n0 0 0\n3 0 0 0\n",
            no_mesh + "'property list uchar int vertex_indices' of the faces"},
       }) {
    EXPECT_EQ(error_of(ply, write("a.ply", text)), error) << text;
  }

  const std::string whole = binary_ply(cube());
  auto bad = cube();
  bad.facets[3][1] = 8;
  constexpr std::size_t row = 1 + 3 * 4;  // of a face
  EXPECT_EQ(error_of(ply, write("b.ply", binary_ply(bad))),
            "byte " + std::to_string(whole.size() - 9 * row + 1 + 2 * 4) +
                ": before it vertex 8, expected 0 or more and less than 8, as many as there are");
  EXPECT_NE(error_of(ply, write("c.ply", whole.substr(0, whole.size() - 5))).find("a list of 3 values"),
            std::string::npos);
  EXPECT_EQ(error_of(ply, write("d.ply", whole + "xy")),
            "byte " + std::to_string(whole.size()) +
                ": 2 bytes more, expected the end of the file, as the "
                "header says");
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
    for (int k = 0; k < 500; ++k) {
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
    EXPECT_GT(refused, 50) << name;
    EXPECT_GT(valid, 5) << name;
  }
}

}  // namespace
