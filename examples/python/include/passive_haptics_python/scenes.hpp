/// @file
/// Walls and scenes of walls in Python.
#pragma once

#include <passive_haptics_python/any_scene.hpp>
#include <passive_haptics_python/shapes.hpp>

#include <passive_haptics/scene/scene.hpp>

#include <vector>

namespace passive_haptics_python {

/// A shape that resists.
struct wall {
  py::object of;           ///< The shape.
  double stiffness = 1e7;  ///< [N/m]

  /// The names of the parameters.
  static std::vector<std::string> names() { return {"shape", "stiffness"}; }
  /// Of a dictionary; a ValueError if the stiffness is negative or not finite.
  static wall made(const py::dict& given, const std::string& name) {
    if (!given.contains("shape")) refuse_type("a wall needs a shape: wall(shape, stiffness)");
    expect<shape>(given["shape"], "shape",
                  "a shape such as half_space(...): a wall is made of (shape, stiffness)");
    wall w;
    for (const auto& [key, value] : given) {
      const std::string called = py::str(key);
      if (called == "shape") w.of = py::reinterpret_borrow<py::object>(value);
      else if (called == "stiffness") w.stiffness = number_from(value, "stiffness");
      else refuse_type(name + " has no parameter '" + called + "', expected shape, stiffness");
    }
    w.geometry<2>();
    w.geometry<3>();
    return w;
  }
  /// Both parameters.
  py::dict parameters() const {
    py::dict all;
    all["shape"] = of;
    all["stiffness"] = stiffness;
    return all;
  }
  /// Those that are not the defaults.
  py::dict changed() const {
    py::dict all;
    all["shape"] = of;
    if (stiffness != wall().stiffness) all["stiffness"] = stiffness;
    return all;
  }

  /// The shape.
  const shape& made_of() const { return py::cast<const shape&>(of); }
  /// The wall of a controller in D dimensions: one, or none where the shape is of another dimension.
  template <int D>
  std::vector<ph::wall<any_shape<D>>> geometry() const {
    std::vector<ph::wall<any_shape<D>>> walls;
    if (const auto* found = std::get_if<any_shape<D>>(&made_of().geometry))
      walls.emplace_back(*found, stiffness);
    return walls;
  }
};

/// Walls, numbered from 0 in their order.
struct scene {
  py::tuple walls;  ///< The walls.

  /// Of one wall or more of one dimension; else a TypeError or ValueError.
  explicit scene(const py::tuple& given) : walls(given) {
    if (walls.empty()) refuse_type("a scene needs a wall: scene(wall(shape, stiffness), ...)");
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const std::string name = "wall " + std::to_string(i) + " of a scene";
      const int found = expect<wall>(walls[i], name.c_str(), "a wall: put each shape into one, wall(shape)")
                            .made_of()
                            .dimension();
      if (found != dimension())
        refuse_value(name + " has dimension " + std::to_string(found) + ", expected " +
                     std::to_string(dimension()) + ", as wall 0 has");
    }
  }
  /// As of a base class.
  virtual ~scene() = default;
  /// The scene of a controller in the plane.
  virtual any_scene<2> in_plane() const = 0;
  /// The scene of a controller in space.
  virtual any_scene<3> in_space() const = 0;

  /// d
  int dimension() const { return py::cast<const wall&>(walls[0]).made_of().dimension(); }
  /// The walls of a controller in D dimensions.
  template <int D>
  std::vector<ph::wall<any_shape<D>>> geometry() const {
    std::vector<ph::wall<any_shape<D>>> all;
    for (const auto& w : walls)
      for (const auto& one : py::cast<const wall&>(w).template geometry<D>()) all.push_back(one);
    return all;
  }
};

/// The scene of a controller in D dimensions, those of its walls.
template <int D>
any_scene<D> scene_of(const scene& walls) {
  if constexpr (D == 2) return walls.in_plane();
  else return walls.in_space();
}

}  // namespace passive_haptics_python
