/// @file
/// Walls as a world takes them.
#pragma once

#include "meshes.hpp"

#include <passive_haptics_python/scenes.hpp>

#include <passive_haptics/scene/world/any_wall.hpp>

namespace passive_haptics_python {

/// A wall of a world, of the mesh itself where it has one: its facets stop the handle's proxy.
template <int D>
ph::any_wall<D> any_wall_of(const wall& w) {
  if (py::isinstance<mesh_surface_value>(w.of))
    return ph::wall(py::cast<const mesh_surface_value&>(w.of).of_dimension<D>(), w.stiffness);
  const auto solid = w.solid<D>();
  if (const auto* mesh = solid->shape.template as<ph::mesh_solid<D>>()) return ph::wall(*mesh, w.stiffness);
  return *solid;
}

}  // namespace passive_haptics_python
