// Shapes, and the walls and scenes that are made of them.
#include <precompiled.hpp>

#include "module.hpp"

#include <passive_haptics_python/derived_shapes.hpp>

#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <pybind11/eigen.h>

namespace passive_haptics_python {
namespace {

// A shape that exists in the plane and in space.
template <template <int> class S, template <int> class P>
void bind_shape(py::module_& module, const std::string& name, const std::string& about) {
  using X = shape_value<S, P>;
  const std::string text = "(" + stub_arguments<P<2>>() + ")\n\n" + about +
                           " Of vectors of 2 numbers in the plane, of 3 in space.\n\n" +
                           parameter_lines<P<2>>();
  py::class_<X, shape> bound(module, name.c_str(), text.c_str());
  add_value_protocol(bound, name);
}

template <class X>
void bind_derived(py::module_& module, const std::string& name, const char* text) {
  py::class_<X, shape> bound(module, name.c_str(), text);
  add_value_protocol(bound, name);
}

Eigen::VectorXd gradient_at(const shape& s, py::handle x) {
  return s.visit(
      [&]<int D>(const any_shape<D>& of) -> Eigen::VectorXd { return of.gradient(vector_from<D>(x, "x")); });
}
double distance_at(const shape& s, py::handle x) {
  return s.visit([&]<int D>(const any_shape<D>& of) { return of.distance(vector_from<D>(x, "x")); });
}

}  // namespace

void bind_shapes(py::module_& module) {
  py::class_<shape>(module, "shape", "A shape of a wall, as a signed distance.")
      .def_property_readonly("dimension", &shape::dimension, "int: 2 in the plane, 3 in space.")
      .def("distance", &distance_at, py::arg("x"),
           "distance(self, x: Numbers) -> float\n\nThe signed distance [m] at x [m], positive in free space.")
      .def("gradient", &gradient_at, py::arg("x"),
           "gradient(self, x: Numbers) -> Array\n\nThe unit vector at x [m] out of the wall.");
  bind_shape<ph::half_space, ph::half_space_parameters>(module, "half_space", "The wall behind a plane.");
  bind_shape<ph::ball, ph::ball_parameters>(module, "ball",
                                            "A round wall, touched from outside or, hollow, from inside.");
  bind_shape<ph::box, ph::box_parameters>(module, "box", "A rectangular wall.");
  bind_shape<ph::capsule, ph::capsule_parameters>(module, "capsule", "A rounded bar.");
  bind_derived<polygon_shape>(
      module, "convex_polygon",
      "(corners: Rows)\n\nA convex polygon in the plane, of 3 to 8 corners [m], either way round.");
  bind_derived<offset_shape>(
      module, "offset",
      "(shape: shape, growth: float = ...)\n\nA shape whose surface moves this far [m] to the free "
      "side; < 0 shrinks it.");
  bind_derived<complement_shape>(module, "complement",
                                 "(shape: shape)\n\nA shape with wall and free space swapped.");
  bind_meshes(module);
  bind_walls(module);
  bind_scenes(module);
  bind_effects(module);
  bind_with_effects(module);
}

}  // namespace passive_haptics_python
