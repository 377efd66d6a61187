// Shapes, walls and scenes.
#include <precompiled.hpp>

#include "module.hpp"

#include <passive_haptics_python/derived_shapes.hpp>
#include <passive_haptics_python/scenes.hpp>

#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/world.hpp>

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

// One wall, whose contacts are those of a static_scene.
template <int D>
class only_wall final : public any_scene<D>::interface {
 public:
  explicit only_wall(const ph::wall<any_shape<D>>& wall) : scene_(wall) {}
  std::unique_ptr<typename any_scene<D>::interface> copy() const override {
    return std::make_unique<only_wall>(*this);
  }
  const typename any_scene<D>::contacts_type& touched_at(const ph::point<D>& x) override {
    touched_.clear();
    for (const auto& contact : scene_.touched_at(x)) touched_.append_unchecked(contact);
    return touched_;
  }
  void set_margin(double margin) override { scene_.set_margin(margin); }
  void reset() override {}

 private:
  ph::static_scene<any_shape<D>> scene_;
  typename any_scene<D>::contacts_type touched_;
};

// Many walls.
template <int D>
class many_walls final : public any_scene<D>::interface {
 public:
  explicit many_walls(const ph::world<D>& world) : world_(world) {}
  std::unique_ptr<typename any_scene<D>::interface> copy() const override {
    return std::make_unique<many_walls>(*this);
  }
  const typename any_scene<D>::contacts_type& touched_at(const ph::point<D>& x) override {
    return world_.touched_at(x);
  }
  void set_margin(double margin) override { world_.set_margin(margin); }
  void reset() override { world_.reset(); }

 private:
  ph::world<D> world_;
};

struct scene_value final : scene {
  using scene::scene;
  any_scene<2> in_plane() const override { return in<2>(); }
  any_scene<3> in_space() const override { return in<3>(); }

 private:
  template <int D>
  any_scene<D> in() const {
    const auto all = geometry<D>();
    if (all.size() == 1) return any_scene<D>(std::make_unique<only_wall<D>>(all[0]));
    ph::world_walls<D> of_world;
    for (const auto& w : all) of_world.add(ph::any_wall<D>(w));
    return any_scene<D>(std::make_unique<many_walls<D>>(ph::world<D>(of_world)));
  }
};

std::unique_ptr<scene> made_scene(const py::tuple& walls) { return std::make_unique<scene_value>(walls); }

void bind_scene(py::module_& module) {
  py::class_<scene>(module, "scene", "(*walls: wall)\n\nWalls, numbered from 0 in their order.")
      .def(py::init([](const py::args& walls) { return made_scene(walls); }))
      .def_readonly("walls", &scene::walls, "tuple[wall, ...]: The walls.")
      .def_property_readonly("dimension", &scene::dimension, "int: 2 in the plane, 3 in space.")
      .def("__repr__",
           [](const scene& s) {
             std::string text;
             for (const auto& w : s.walls) text += (text.empty() ? "" : ", ") + std::string(py::repr(w));
             return "scene(" + text + ")";
           })
      .def("__eq__",
           [](const scene& s, const py::object& other) -> py::object {
             if (!py::isinstance<scene>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(s.walls.equal(py::cast<const scene&>(other).walls));
           })
      .def(py::pickle([](const scene& s) { return s.walls; },
                      [](const py::tuple& walls) { return made_scene(walls); }))
      .attr("__hash__") = py::none();
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
  py::class_<wall> bound(
      module, "wall",
      "(shape: shape, stiffness: float = ...)\n\nA shape that resists with stiffness [N/m] times "
      "depth; 1e7 where none is given.");
  add_value_protocol(bound, "wall");
  bind_scene(module);
}

}  // namespace passive_haptics_python
