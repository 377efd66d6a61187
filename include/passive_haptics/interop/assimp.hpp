/// Meshes from STL, OBJ, PLY and the formats of Assimp (https://assimp.org, Debian: libassimp-dev).
#pragma once

#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>

#include <assimp/BaseImporter.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace passive_haptics {
namespace detail {

/// Adds the facets of one transformed mesh. Returns an error text, empty if there is none.
inline std::string add_part(const aiMesh& part, const aiMatrix4x4t<double>& placed, polygons& to) {
  const bool mirrored = placed.Determinant() < 0;
  const std::size_t first = to.vertices.size();
  if (part.mNumVertices > polygons::max_count - first) return "more than 2^31 - 1 vertices: expected fewer";
  if (part.mVertices == nullptr && part.mNumVertices > 0)
    return "vertices without positions: expected one for each; the file is damaged";
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const auto& x = part.mVertices[v];
    const auto y = placed * aiVector3t<double>(x.x, x.y, x.z);
    to.vertices.push_back(point<3>(y.x, y.y, y.z));
  }
  std::vector<int> corners;
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    corners.clear();
    for (unsigned i = 0; i < face.mNumIndices && i < 4; ++i) {  // Assimp made triangles of it
      const unsigned index = face.mIndices[i];
      if (index >= part.mNumVertices)
        return error_text(indexed("face ", f, ": index of a vertex"), index,
                          indexed("less than ", part.mNumVertices, "; the file is damaged"));
      corners.push_back(static_cast<int>(first + index));
    }
    if (mirrored) std::reverse(corners.begin(), corners.end());
    to.add(corners, to.ends.size());
  }
  return {};
}

inline std::string add_nodes(const aiScene& scene, polygons& to) {
  struct placed_node {
    const aiNode* node;
    aiMatrix4x4t<double> parent;
  };
  std::vector<placed_node> open{{scene.mRootNode, {}}};  // no recursion: files may be nested deeply
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const auto& t = node->mTransformation;
    const auto placed = parent * aiMatrix4x4t<double>(t.a1, t.a2, t.a3, t.a4, t.b1, t.b2, t.b3, t.b4, t.c1,
                                                      t.c2, t.c3, t.c4, t.d1, t.d2, t.d3, t.d4);
    for (unsigned m = 0; m < node->mNumMeshes; ++m) {
      if (node->mMeshes[m] >= scene.mNumMeshes)
        return error_text("index of a part", node->mMeshes[m],
                          indexed("less than ", scene.mNumMeshes, "; the file is damaged"));
      if (std::string error = add_part(*scene.mMeshes[node->mMeshes[m]], placed, to); !error.empty())
        return error;
    }
    for (unsigned c = node->mNumChildren; c > 0; --c) open.push_back({node->mChildren[c - 1], placed});
  }
  return {};
}

/// Formats read without Assimp; its own readers are removed, so that it does not detect them by content.
inline constexpr const char* own_formats[] = {"stl", "obj", "ply"};

inline void read_by_assimp(const std::filesystem::path& path, polygons& to) {
  if (const std::string error = check_regular_file(path); !error.empty()) fail_mesh_file(path, error);
  Assimp::Importer importer;
  for (const char* const format : own_formats) {
    Assimp::BaseImporter* const reader = importer.GetImporter(format);
    if (reader != nullptr && importer.UnregisterLoader(reader) == AI_SUCCESS) delete reader;
  }
  // Validated before triangulation, which trusts all indices
  const aiScene* const scene =
      importer.ReadFile(path.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr)
    fail_mesh_file(path, std::string("no mesh that Assimp reads: ").append(importer.GetErrorString()));
  if (const std::string error = add_nodes(*scene, to); !error.empty()) fail_mesh_file(path, error);
}

}  // namespace detail

/// Reads a mesh file with the unit `metres_per_unit` (1e-3: millimetres). `.stl`, `.obj` and `.ply` are read
/// by read_stl, read_obj and read_ply, other formats by Assimp, which stores coordinates in float and may
/// hang or leak for damaged files. Throws std::invalid_argument with the name of the file: not a regular
/// file, no mesh in it, a scale <= 0, no triangles, coordinates that are not finite. For set-up.
inline mesh_file read_mesh_file(const std::filesystem::path& path, double metres_per_unit = 1) {
  std::string end = path.extension().string();
  for (char& c : end) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (end == ".stl") return read_stl(path, metres_per_unit);
  if (end == ".obj") return read_obj(path, metres_per_unit);
  if (end == ".ply") return read_ply(path, metres_per_unit);
  return detail::read_mesh_file(path, metres_per_unit, detail::read_by_assimp);
}

/// Returns the mesh of read_mesh_file.
inline mesh_parameters<3> read_mesh(const std::filesystem::path& path, double metres_per_unit = 1) {
  return read_mesh_file(path, metres_per_unit).mesh;
}

}  // namespace passive_haptics
