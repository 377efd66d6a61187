/// @file
/// Meshes in Python, and walls of them.
#pragma once

#include <passive_haptics_python/shapes.hpp>

#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>

#include <type_traits>
#include <utility>
#include <variant>

namespace passive_haptics_python {

/// A mesh, and the vertices and facets that it was made of.
template <int D>
struct faceted {
  ph::mesh_parameters<D> given;  ///< As they were given.
  ph::mesh<D> surface;           ///< The mesh.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit faceted(ph::mesh_parameters<D> p) : given(std::move(p)), surface(given) {}
};

/// A surface of segments in the plane or of triangles in space.
struct mesh_value {
  std::variant<faceted<2>, faceted<3>> held;  ///< The mesh.

  /// d
  int dimension() const { return held.index() == 0 ? 2 : 3; }
  /// Calls f with the faceted<2> or faceted<3>.
  template <class F>
  auto visit(F&& f) const {
    return std::visit(std::forward<F>(f), held);
  }
};

/// A mesh, made without Python's lock; throws std::invalid_argument.
template <int D>
mesh_value mesh_of(ph::mesh_parameters<D> p) {
  const py::gil_scoped_release unlocked;
  return {faceted<D>(std::move(p))};
}

/// A mesh of these arrays or lists; a TypeError or ValueError if they are none.
mesh_value made_mesh(const py::object& vertices, const py::object& facets);

/// The solid within a closed mesh.
struct mesh_solid_value : shape {
  py::object surface;  ///< The mesh.

  /// The names of the parameters.
  static std::vector<std::string> names() { return {"surface"}; }
  /// Of a dictionary; a ValueError where the mesh is not closed, or inside out.
  static mesh_solid_value made(const py::dict& given, const std::string& name);
  /// The mesh.
  py::dict parameters() const;
  /// The mesh.
  py::dict changed() const { return parameters(); }
};

/// A mesh that stops what comes from its front.
struct mesh_surface_value {
  py::object surface;                                           ///< The mesh.
  double skin;                                                  ///< [m]
  double crease_angle;                                          ///< [rad]
  std::variant<ph::mesh_surface<2>, ph::mesh_surface<3>> held;  ///< The wall's shape.

  /// d
  int dimension() const { return held.index() == 0 ? 2 : 3; }
  /// The shape; of its dimension.
  template <int D>
  const ph::mesh_surface<D>& of_dimension() const {
    return std::get<ph::mesh_surface<D>>(held);
  }
  /// The names of the parameters.
  static std::vector<std::string> names() { return {"surface", "skin", "crease_angle"}; }
  /// Of a dictionary; a ValueError with the library's own text where a parameter is not valid.
  static mesh_surface_value made(const py::dict& given, const std::string& name);
  /// All parameters.
  py::dict parameters() const;
  /// Those that are not the defaults.
  py::dict changed() const;
};

}  // namespace passive_haptics_python
