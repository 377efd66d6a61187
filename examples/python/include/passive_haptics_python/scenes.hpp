/// @file
/// Walls and scenes of walls in Python.
#pragma once

#include <passive_haptics_python/any_scene.hpp>
#include <passive_haptics_python/shapes.hpp>

#include <passive_haptics/scene/wall.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace passive_haptics_python {

/// A shape that resists.
struct wall {
  py::object of;           ///< A shape or a mesh_surface.
  double stiffness = 1e7;  ///< [N/m]
  int dimension = 0;       ///< d

  /// The names of the parameters.
  static std::vector<std::string> names() { return {"shape", "stiffness"}; }
  /// Of a dictionary; a ValueError if the stiffness is negative or not finite.
  static wall made(const py::dict& given, const std::string& name);
  /// Both parameters.
  py::dict parameters() const;
  /// Those that are not the defaults.
  py::dict changed() const;

  /// The wall in D dimensions; nothing where its shape is of another dimension, or a mesh_surface.
  template <int D>
  std::optional<ph::wall<any_shape<D>>> solid() const {
    if (!py::isinstance<shape>(of)) return std::nullopt;
    const auto* found = std::get_if<any_shape<D>>(&py::cast<const shape&>(of).geometry);
    if (found == nullptr) return std::nullopt;
    return ph::wall<any_shape<D>>(*found, stiffness);
  }
};

/// The base class of all scenes: walls, numbered from 0 in their order.
struct scene {
  py::tuple walls;  ///< Each a wall; all of one dimension.

  /// Of one wall or more of one dimension; else a TypeError or ValueError. name: of the scene's class.
  scene(const py::tuple& given, const std::string& name);
  /// As of a base class.
  virtual ~scene() = default;
  /// The scene of a controller in the plane.
  virtual any_scene<2> made(std::type_identity<any_scene<2>>) const = 0;
  /// The scene of a controller in the plane whose law takes one wall; a ValueError if there are more.
  virtual any_scene<2, 1> made(std::type_identity<any_scene<2, 1>>) const = 0;
  /// The scene of a controller in space.
  virtual any_scene<3> made(std::type_identity<any_scene<3>>) const = 0;
  /// The scene of a controller in space whose law takes one wall; a ValueError if there are more.
  virtual any_scene<3, 1> made(std::type_identity<any_scene<3, 1>>) const = 0;
  /// Whether the first cycle of a motion sees one wall alone, as of a static_scene.
  virtual bool is_one_wall() const = 0;

  /// The effects beside the walls.
  virtual py::tuple effects() const { return py::tuple(); }

  /// d
  int dimension() const { return wall_at(0).dimension; }
  /// Wall i.
  const wall& wall_at(std::size_t i) const { return py::cast<const wall&>(walls[i]); }
  /// The wall in D dimensions where is_one_wall(), else nothing.
  template <int D>
  std::optional<ph::wall<any_shape<D>>> only_wall() const {
    if (!is_one_wall()) return std::nullopt;
    return wall_at(0).solid<D>();
  }
};

}  // namespace passive_haptics_python
