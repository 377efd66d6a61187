// Walls, and what all scenes have in common.
#include <precompiled.hpp>

#include "module.hpp"
#include "walls.hpp"

namespace passive_haptics_python {

wall wall::made(const py::dict& given, const std::string& name) {
  if (!given.contains("shape")) refuse_type("a wall needs a shape: wall(shape, stiffness)");
  wall w;
  w.of = given["shape"];
  if (py::isinstance<mesh_surface_value>(w.of))
    w.dimension = py::cast<const mesh_surface_value&>(w.of).dimension();
  else
    w.dimension =
        expect<shape>(w.of, "shape", "a shape such as half_space(...): a wall is made of (shape, stiffness)")
            .dimension();
  for (const auto& [key, value] : given) {
    const std::string called = py::str(key);
    if (called == "stiffness") w.stiffness = number_from(value, "stiffness");
    else if (called != "shape")
      refuse_type(name + " has no parameter '" + called + "', expected shape, stiffness");
  }
  // The library's own text where the stiffness is not valid
  if (w.dimension == 2) any_wall_of<2>(w);
  else any_wall_of<3>(w);
  return w;
}

py::dict wall::parameters() const {
  py::dict all;
  all["shape"] = of;
  all["stiffness"] = stiffness;
  return all;
}

py::dict wall::changed() const {
  py::dict all;
  all["shape"] = of;
  if (stiffness != wall().stiffness) all["stiffness"] = stiffness;
  return all;
}

scene::scene(const py::tuple& given, const std::string& name) : walls(given) {
  if (walls.empty())
    refuse_type("a " + name + " needs a wall: " + name +
                (name == "scene" ? "(wall(shape, stiffness), ...)" : "([wall(shape, stiffness), ...])"));
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const std::string number = "wall " + std::to_string(i) + " of a " + name;
    const int found =
        expect<wall>(walls[i], number.c_str(), "a wall: put each shape into one, wall(shape)").dimension;
    if (found != dimension())
      refuse_value(number + " has dimension " + std::to_string(found) + ", expected " +
                   std::to_string(dimension()) + ", as wall 0 has");
  }
}

void bind_walls(py::module_& module) {
  py::class_<wall> bound(
      module, "wall",
      "(shape: shape | mesh_surface, stiffness: float = ...)\n\nA shape that resists with stiffness [N/m] "
      "times depth; 1e7 where none is given.");
  add_value_protocol(bound, "wall");
}

}  // namespace passive_haptics_python
