/// The result of reading a mesh file.
#pragma once

#include <passive_haptics/scene/mesh/mesh_parameters.hpp>

#include <cstddef>
#include <string>

namespace passive_haptics {

/// A mesh and counts of the items of the file that are not in it.
struct mesh_file {
  mesh_parameters<3> mesh;  ///< All triangles as one mesh; vertices in the same place are merged.
  int slivers = 0;  ///< Triangles without area, left out. The mesh may be open there, see without_slivers.
  int not_triangles = 0;  ///< Points and lines, left out.
  /// Quads that cross themselves in every projection, cut along the diagonal that folds them less, a guess.
  int twisted_quads = 0;
  int skipped_lines = 0;          ///< Skipped text lines with unknown keywords.
  std::size_t skipped_bytes = 0;  ///< Skipped bytes after the data.
  /// Text for the user: one line for each count that is not 0, with the place of the first twisted quad and
  /// the first skipped line. Empty if the whole file is in the mesh.
  std::string remarks;
};

}  // namespace passive_haptics
