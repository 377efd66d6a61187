/// @file
/// Meshes from STL, OBJ and whatever else Assimp reads (https://assimp.org, Debian: libassimp-dev).
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/mesh/mesh_topology.hpp>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace passive_haptics {

/// What was found in a file of meshes.
struct mesh_file {
  mesh_parameters<3> mesh;  ///< All of its triangles as one mesh, vertices in the same place as one.
  int slivers =
      0;  ///< Triangles without area that were left out; a mesh may be open there, see without_slivers.
  int not_triangles = 0;  ///< Points and lines that were left out.
};

namespace detail {

/// Adds all facets of the meshes of a node and of those below it, moved by the node's transform.
inline void add_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4t<double>& parent,
                     double scale, mesh_file& file) {
  const auto& t = node.mTransformation;
  const aiMatrix4x4t<double> own(t.a1, t.a2, t.a3, t.a4, t.b1, t.b2, t.b3, t.b4, t.c1, t.c2, t.c3, t.c4, t.d1,
                                 t.d2, t.d3, t.d4);
  const auto placed = parent * own;
  const bool mirrored = placed.Determinant() < 0;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[node.mMeshes[m]];
    const int first = static_cast<int>(file.mesh.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const auto& x = part.mVertices[v];
      const auto y = placed * aiVector3t<double>(x.x, x.y, x.z);
      file.mesh.vertices.push_back(scale * point<3>(y.x, y.y, y.z));
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) {
        ++file.not_triangles;
        continue;
      }
      const auto corner = [&](unsigned i) { return first + static_cast<int>(face.mIndices[i]); };
      file.mesh.facets.push_back({corner(0), corner(mirrored ? 2 : 1), corner(mirrored ? 1 : 2)});
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) add_node(scene, *node.mChildren[c], placed, scale, file);
}

/// The same mesh with only the vertices that are used, each place once.
inline mesh_parameters<3> compact(const mesh_parameters<3>& m) {
  const std::vector<int> first = welded<3>(m.vertices);
  std::vector<int> number(m.vertices.size(), -1);
  mesh_parameters<3> small;
  small.facets = m.facets;
  for (auto& f : small.facets) {
    for (int& v : f) {
      const auto place = static_cast<std::size_t>(first[static_cast<std::size_t>(v)]);
      if (number[place] < 0) {
        number[place] = static_cast<int>(small.vertices.size());
        small.vertices.push_back(m.vertices[place]);
      }
      v = number[place];
    }
  }
  return small;
}

/// Why a mesh from a file cannot be used; empty if it can.
inline std::string check_mesh_file(const mesh_file& file) {
  for (std::size_t v = 0; v < file.mesh.vertices.size(); ++v) {
    if (!all_finite(file.mesh.vertices[v]))
      return indexed("vertex ", v, " is not finite, expected coordinates; the file is damaged");
  }
  return file.mesh.facets.empty() ? "no triangles, expected one or more; points and lines have no sides" : "";
}

}  // namespace detail

/// The mesh of a file whose unit is `metres_per_unit` (1e-3: millimetres). Polygons are cut into triangles;
/// parts are put where the file says. Assimp keeps coordinates in float, 24 bits.
///
/// Throws std::invalid_argument, its text names the file: no such file, no mesh in it, a scale that is not
/// positive, no triangles, coordinates that are not finite. For set-up, never for a control cycle.
inline mesh_file read_mesh_file(const std::filesystem::path& path, double metres_per_unit = 1) {
  const std::string name = path.string();
  const auto require = [&](const std::string& error) {
    if (!error.empty()) require_no_error(std::string("mesh file ").append(name).append(": ").append(error));
  };
  require(check_value("metres_per_unit", metres_per_unit, "", range::positive));
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) require("no such file");
  if (!std::filesystem::is_regular_file(path, ignored)) require("not a file");

  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(name, aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    require(std::string("no mesh that Assimp reads: ").append(importer.GetErrorString()));
    return {};
  }
  mesh_file file;
  detail::add_node(*scene, *scene->mRootNode, aiMatrix4x4t<double>(), metres_per_unit, file);
  require(detail::check_mesh_file(file));
  const auto all = file.mesh.facets.size();
  file.mesh = detail::compact(without_slivers(std::move(file.mesh)));
  file.slivers = static_cast<int>(all - file.mesh.facets.size());
  if (file.mesh.facets.empty()) require("no triangle has an area, expected one or more");
  return file;
}

/// The mesh alone.
inline mesh_parameters<3> read_mesh(const std::filesystem::path& path, double metres_per_unit = 1) {
  return read_mesh_file(path, metres_per_unit).mesh;
}

}  // namespace passive_haptics
