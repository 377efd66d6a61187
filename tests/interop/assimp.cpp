// Meshes from files of any kind: which reader takes which, and what is believed of Assimp.
#include <passive_haptics/interop/assimp.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>

#include "../unit/files/mesh_files.hpp"

#include <sys/stat.h>

namespace {

using namespace mesh_files;

struct a_mesh_file : in_a_folder {
  std::string error_text(const fs::path& path, double scale = 1) const {
    return error_of([&](const fs::path& p) { ph::read_mesh(p, scale); }, path);
  }
};

// The same triangle turned, moved, and mirrored by nodes of a glTF file.
std::string gltf(const std::string& indices = "") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
    "nodes": [{"translation": [10, 0, 0], "children": [1]}, {"scale": [2, 2, 2], "mesh": 0},
              {"scale": [1, 1, -1], "translation": [0, 0, 5], "mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0})" +
         indices + R"(}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

std::string off(const std::string& face = "3 0 1 2") {
  return "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 3\n" + face + "\n";
}

TEST_F(a_mesh_file, is_read_by_what_its_name_ends_in) {
  mesh m = cube();
  m.vertices[7] *= 1 + 1e-9;  // over the 24 bits of Assimp
  for (const auto& [name, bytes] :
       {std::pair{"a.obj", obj(m)}, {"a.OBJ", obj(m)}, {"a.stl", ascii_stl(m)}, {"a.ply", binary_ply(m)}}) {
    const auto file = ph::read_mesh_file(write(name, bytes));
    EXPECT_EQ(file.mesh.facets.size(), 12u) << name;
    EXPECT_EQ(ph::triangle_mesh(file.mesh).bounds().upper, m.vertices[7]) << name;
  }
  EXPECT_EQ(ph::read_mesh(write("b.stl", binary_stl(cube()))).vertices.size(), 8u);
  EXPECT_EQ(ph::read_mesh(write("a.off", off())).facets.size(), 2u);
}

TEST_F(a_mesh_file, is_in_the_unit_that_is_said) {
  for (const auto& [name, bytes] : {std::pair{"a.obj", obj(cube())}, {"a.off", off()}}) {
    const auto path = write(name, bytes);
    const ph::triangle_mesh m(ph::read_mesh(path, 1e-3));
    EXPECT_NEAR(m.bounds().upper[0], 1e-3, 1e-18);
    for (const double scale : {0.0, -1.0, std::nan("")})
      EXPECT_TRUE(error_text(path, scale).starts_with("metres_per_unit = ")) << name;
  }
}

TEST_F(a_mesh_file, has_parts_where_their_nodes_say) {
  const auto m = ph::read_mesh(write("nodes.gltf", gltf()));
  ASSERT_EQ(m.facets.size(), 2u);
  EXPECT_EQ(m.corners(0)[1], ph::point<3>(12, 0, 0));
  EXPECT_EQ(ph::detail::normal_of(m.corners(0)), ph::point<3>(0, 0, 1));
  const auto mirrored = m.corners(1);
  EXPECT_NE(std::find(mirrored.begin(), mirrored.end(), ph::point<3>(0, 0, 5)), mirrored.end());
  EXPECT_EQ(ph::detail::normal_of(mirrored), ph::point<3>(0, 0, -1)) << "mirrored";
}

TEST_F(a_mesh_file, that_is_wrong_is_named_with_the_reason) {
  ASSERT_EQ(mkfifo((folder / "fifo.off").c_str(), 0600), 0);
  fs::create_directory(folder / "folder.off");
  EXPECT_EQ(error_text(folder / "none.off"), "no such file");
  EXPECT_EQ(error_text(folder / "fifo.off"), "is a FIFO: expected a regular file");
  EXPECT_EQ(error_text(folder / "folder.off"), "is a directory: expected a regular file");
  EXPECT_EQ(error_text("/dev/zero"), "is a device: expected a regular file");
  EXPECT_EQ(error_text(write("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n")),
            "line 3: '9': expected a vertex of the 2 above, from 1, or back from -1");
  for (const auto& [name, bytes] : {std::pair{"garbage.dae", std::string(3000, 'x')},
                                    {"empty.off", std::string()},
                                    {"text.txt", std::string("a text")}})
    EXPECT_TRUE(error_text(write(name, bytes)).starts_with("no mesh that Assimp reads: ")) << name;
}

// Its readers that trust a file are never asked, whatever the name.
TEST_F(a_mesh_file, of_ply_is_not_read_by_assimp_under_any_name) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n";
  for (const char* name : {"a.ply", "a.PLY", "ply_of_another.name", "ply"}) {
    EXPECT_NE(error_text(write(name, ply + "3 0 1 99999\n")), "none") << name;
    EXPECT_NE(error_text(write(name, ply + "3 0 1 -5\n")), "none") << name;
    EXPECT_NE(error_text(write(name, ply.substr(0, 60))), "none") << name << ": Assimp 5.2.5 never returns";
  }
}

// A scene as a reader of Assimp may leave it: a triangle of the mesh's three vertices.
struct scene_of_assimp {
  aiScene scene;
  scene_of_assimp() {
    scene.mMeshes = new aiMesh* [scene.mNumMeshes = 1] { new aiMesh };
    aiMesh& mesh = *scene.mMeshes[0];
    mesh.mVertices = new aiVector3D[mesh.mNumVertices = 3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.mFaces = new aiFace[mesh.mNumFaces = 1];
    mesh.mFaces[0].mIndices = new unsigned[mesh.mFaces[0].mNumIndices = 3]{0, 1, 2};
    scene.mRootNode = new aiNode;
    scene.mRootNode->mMeshes = new unsigned[scene.mRootNode->mNumMeshes = 1]{0};
  }
  aiMesh& mesh() { return *scene.mMeshes[0]; }
  std::string error() const {
    ph::detail::polygons to;
    return ph::detail::add_nodes(scene, to);
  }
};

TEST(a_scene_of_assimp, is_checked_before_it_is_used) {
  EXPECT_EQ(scene_of_assimp().error(), "");
  for (const unsigned index : {3u, 99999u, static_cast<unsigned>(-5)}) {
    scene_of_assimp s;
    s.mesh().mFaces[0].mIndices[2] = index;
    EXPECT_EQ(s.error(), "face 0: index of a vertex = " + std::to_string(index) +
                             ": expected less than 3; the file is damaged");
  }
  scene_of_assimp no_part, no_vertices;
  no_part.scene.mRootNode->mMeshes[0] = 7;
  EXPECT_EQ(no_part.error(), "index of a part = 7: expected less than 1; the file is damaged");
  delete[] no_vertices.mesh().mVertices;
  no_vertices.mesh().mVertices = nullptr;
  EXPECT_EQ(no_vertices.error(), "vertices without positions: expected one for each; the file is damaged");
}

TEST_F(a_mesh_file, of_assimp_with_bytes_gone_wrong_never_gives_a_mesh_that_is) {
  ph::testing::random_source random(20040627);
  int read = 0, refused = 0;
  for (int k = 0; k < 300; ++k) {
    std::string text = off();
    const auto somewhere = [&] { return static_cast<std::size_t>(random.uniform(0.0, double(text.size()))); };
    if (k % 4 == 0) text.resize(somewhere());
    for (int hits = 0; hits < 2 && !text.empty(); ++hits)
      text[somewhere()] = "0123456789 -.\n"[static_cast<std::size_t>(random.uniform(0.0, 14.0))];
    const std::string error = error_of(
        [&](const fs::path& p) { ASSERT_EQ(validate(ph::read_mesh(p)), "") << "seed 20040627, file " << k; },
        write("a.off", text));
    EXPECT_FALSE(error.starts_with("not so named")) << error;
    ++(error == "none" ? read : refused);
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 30);
}

}  // namespace
