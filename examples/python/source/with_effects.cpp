// A scene with effects beside its walls.
#include <precompiled.hpp>

#include "kind_of_scene.hpp"
#include "module.hpp"

#include <passive_haptics_python/effects.hpp>

namespace passive_haptics_python {
namespace {

struct with_effects_value final : kind_of_scene<with_effects_value> {
  py::object of;           // The scene.
  py::tuple beside_walls;  // Each an effect.

  with_effects_value(const py::object& scene_itself, const py::tuple& all)
      : kind_of_scene(py::cast<const scene&>(scene_itself).walls, "scene"),
        of(scene_itself),
        beside_walls(all) {}
  bool is_one_wall() const override { return false; }
  py::tuple effects() const override { return beside_walls; }
  template <int D, int Capacity>
  any_scene<D, Capacity> scene_in() const {
    return py::cast<const scene&>(of).made(std::type_identity<any_scene<D, Capacity>>());
  }

  static with_effects_value made(const py::args& given) {
    if (given.empty()) refuse_type("with_effects needs a scene: with_effects(scene, effect, ...)");
    const py::object of = given[0];
    if (!expect<scene>(of, "scene", "a scene: with_effects(scene(wall(shape, stiffness)), effect, ...)")
             .effects()
             .empty())
      refuse_type("scene of with_effects has effects itself, expected all effects in one with_effects");
    if (given.size() == 1) refuse_type("with_effects needs an effect: with_effects(scene, effect, ...)");
    const py::tuple all = given[py::slice(1, py::ssize_t(given.size()), 1)];
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string number = "effect " + std::to_string(i) + " of a scene";
      expect<effect>(all[i], number.c_str(), "an effect such as viscous_field(viscosity)");
    }
    return with_effects_value(of, all);
  }
  using kind_of_scene::made;
  py::tuple arguments() const { return py::make_tuple(of) + beside_walls; }
};

}  // namespace

void bind_with_effects(py::module_& module) {
  py::class_<with_effects_value, scene>(
      module, "with_effects",
      "(scene: scene, *effects: effect)\n\nA scene with effects beside its walls. Walls come first: what a "
      "cycle displays of them does not depend on the effects, but for the drag along them. Effects get what "
      "the brakes can do besides. For direct_control, and mechanisms with as many joints and brakes as task "
      "dimensions.")
      .def(py::init([](const py::args& given) { return with_effects_value::made(given); }))
      .def_readonly("effects", &with_effects_value::beside_walls, "tuple[effect, ...]: The effects.")
      .def("__repr__",
           [](const with_effects_value& s) {
             std::string text;
             for (const auto& part : s.arguments())
               text += (text.empty() ? "" : ", ") + std::string(py::repr(part));
             return "with_effects(" + text + ")";
           })
      .def("__eq__",
           [](const with_effects_value& s, const py::object& other) -> py::object {
             if (!py::isinstance<with_effects_value>(other))
               return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(s.arguments().equal(py::cast<const with_effects_value&>(other).arguments()));
           })
      .def(py::pickle([](const with_effects_value& s) { return s.arguments(); },
                      [](const py::tuple& state) {
                        return with_effects_value::made(py::reinterpret_borrow<py::args>(state));
                      }))
      .attr("__hash__") = py::none();
}

}  // namespace passive_haptics_python
