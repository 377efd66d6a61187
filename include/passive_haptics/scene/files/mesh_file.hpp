/// @file
/// What a reader of mesh files returns: the mesh, and what of the file is not in it.
#pragma once

#include <passive_haptics/scene/mesh/mesh_parameters.hpp>

#include <cstddef>
#include <string>

namespace passive_haptics {

/// What was found in a file of meshes.
struct mesh_file {
  mesh_parameters<3> mesh;  ///< All of its triangles as one mesh, vertices in the same place as one.
  /// Triangles without area that were left out; a mesh may be open there, see without_slivers.
  int slivers = 0;
  int not_triangles = 0;  ///< Points and lines that were left out.
  /// Quads that cross themselves from whichever side they are seen. Each was cut along the diagonal that
  /// folds it less; how its surface runs between its edges is a guess.
  int twisted_quads = 0;
  int skipped_lines = 0;          ///< Lines of a text that begin with a keyword of another program.
  std::size_t skipped_bytes = 0;  ///< Bytes behind the end of the data.
  /// For a program to print: a line for each count that is not 0, with the place in the file of the first
  /// twisted quad and of the first line. Empty if the whole file is in the mesh.
  std::string remarks;
};

}  // namespace passive_haptics
