// Scenes of walls.
#include <precompiled.hpp>

#include "kind_of_scene.hpp"
#include "module.hpp"
#include "walls.hpp"

#include <passive_haptics_python/scenes.hpp>

#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/world/world.hpp>

namespace passive_haptics_python {
namespace {

// One wall, whose contacts are those of a static_scene.
template <int D, int Capacity>
class single_wall final : public any_scene<D, Capacity>::interface {
  using contacts = typename any_scene<D, Capacity>::contacts_type;

 public:
  explicit single_wall(const ph::wall<any_shape<D>>& wall) : scene_(wall) {}
  std::unique_ptr<typename any_scene<D, Capacity>::interface> copy() const override {
    return std::make_unique<single_wall>(*this);
  }
  const contacts& touched_at(const ph::point<D>& x, double) override {
    touched_.clear();
    for (const auto& contact : scene_.touched_at(x)) touched_.append_unchecked(contact);
    return touched_;
  }
  void set_margin(double margin) override { scene_.set_margin(margin); }
  void reset() override {}

 private:
  ph::static_scene<any_shape<D>> scene_;
  contacts touched_;
};

// Many walls.
template <int D>
class many_walls final : public any_scene<D>::interface {
 public:
  explicit many_walls(const ph::world<D>& world) : world_(world) {}
  std::unique_ptr<typename any_scene<D>::interface> copy() const override {
    return std::make_unique<many_walls>(*this);
  }
  const typename any_scene<D>::contacts_type& touched_at(const ph::point<D>& x, double) override {
    return world_.touched_at(x);
  }
  void set_margin(double margin) override { world_.set_margin(margin); }
  void reset() override { world_.reset(); }

 private:
  ph::world<D> world_;
};

// A scene of which the latest sample is held.
template <int D, int Capacity>
class held final : public any_scene<D, Capacity>::interface {
  using contacts = typename any_scene<D, Capacity>::contacts_type;
  // As held_scene takes it: without a time.
  struct sampled {
    static constexpr int dimension = D;
    using contacts_type = contacts;
    any_scene<D, Capacity> of;
    const contacts& touched_at(const ph::point<D>& x) { return of.touched_at(x, 0); }
    void set_margin(double margin) { of.set_margin(margin); }
  };

 public:
  held(any_scene<D, Capacity> of, double period) : scene_(sampled{std::move(of)}, period), period_(period) {}
  std::unique_ptr<typename any_scene<D, Capacity>::interface> copy() const override {
    return std::make_unique<held>(*this);
  }
  const contacts& touched_at(const ph::point<D>& x, double time) override {
    return scene_.touched_at(x, time);
  }
  void set_margin(double margin) override { scene_.set_margin(margin); }
  void reset() override {
    sampled of = std::move(scene_.scene());
    of.of.reset();
    scene_ = ph::held_scene<sampled>(std::move(of), period_);
  }

 private:
  ph::held_scene<sampled> scene_;
  double period_;
};

template <int D, int Capacity>
any_scene<D, Capacity> world_of(const scene& of) {
  if constexpr (Capacity == 1) {
    const bool is_one = of.walls.size() == 1;
    refuse_value((is_one ? "scene is a world" : "scene has " + std::to_string(of.walls.size()) + " walls") +
                 ", expected one wall with an inside, scene(wall(shape, stiffness)): a law that saturates "
                 "before scaling takes one wall at a time; take direct_control");
  } else {
    ph::world_walls<D> walls;
    for (std::size_t i = 0; i < of.walls.size(); ++i) walls.add(any_wall_of<D>(of.wall_at(i)));
    return any_scene<D>(std::make_unique<many_walls<D>>(ph::world<D>(walls)));
  }
}

struct scene_value final : kind_of_scene<scene_value> {
  explicit scene_value(const py::tuple& given) : kind_of_scene(given, "scene") {}
  bool is_one_wall() const override { return walls.size() == 1 && py::isinstance<shape>(wall_at(0).of); }
  template <int D, int Capacity>
  any_scene<D, Capacity> scene_in() const {
    if (!is_one_wall()) return world_of<D, Capacity>(*this);
    return any_scene<D, Capacity>(std::make_unique<single_wall<D, Capacity>>(*wall_at(0).solid<D>()));
  }
};

struct world_value final : kind_of_scene<world_value> {
  explicit world_value(const py::tuple& given) : kind_of_scene(given, "world") {}
  bool is_one_wall() const override { return false; }
  template <int D, int Capacity>
  any_scene<D, Capacity> scene_in() const {
    return world_of<D, Capacity>(*this);
  }

  static std::vector<std::string> names() { return {"walls"}; }
  static world_value made(const py::dict& given, const std::string& name) {
    if (!given.contains("walls")) refuse_type("a world needs walls: world([wall(shape, stiffness), ...])");
    if (given.size() > 1) refuse_type(name + " has one parameter, walls");
    const py::object list = given["walls"];
    if (!PyList_Check(list.ptr()) && !PyTuple_Check(list.ptr()))
      refuse_type("walls = " + shown(list) + ", expected a list of walls");
    return world_value(py::tuple(list));
  }
  using kind_of_scene::made;
  py::dict parameters() const {
    py::dict all;
    all["walls"] = py::list(walls);
    return all;
  }
  py::dict changed() const { return parameters(); }
};

struct held_scene_value final : kind_of_scene<held_scene_value> {
  py::object of;  // The scene.
  ph::hold_parameters table;

  held_scene_value(const py::object& held_one, const ph::hold_parameters& p)
      : kind_of_scene(py::cast<const scene&>(held_one).walls, "held_scene"), of(held_one), table(p) {}
  const scene& held_one() const { return py::cast<const scene&>(of); }
  bool is_one_wall() const override { return held_one().is_one_wall(); }
  template <int D, int Capacity>
  any_scene<D, Capacity> scene_in() const {
    auto inner = held_one().made(std::type_identity<any_scene<D, Capacity>>());
    return any_scene<D, Capacity>(std::make_unique<held<D, Capacity>>(std::move(inner), table.period));
  }

  static std::vector<std::string> names() { return {"scene", "period"}; }
  static held_scene_value made(const py::dict& given, const std::string& name) {
    if (!given.contains("scene")) refuse_type("a held_scene needs a scene: held_scene(scene, period)");
    const py::object of = given["scene"];
    expect<scene>(of, "scene", "a scene: held_scene(scene(wall(shape, stiffness)), period)");
    if (py::isinstance<held_scene_value>(of))
      refuse_type("scene of a held_scene is a held_scene itself, expected one that is not held");
    if (!py::cast<const scene&>(of).effects().empty())
      refuse_type("scene of a held_scene has effects, expected with_effects(held_scene(...), ...)");
    if (!given.contains("period")) refuse_type("a held_scene needs a period [s]: held_scene(scene, period)");
    const py::dict others = given.attr("copy")();
    others.attr("pop")("scene");
    ph::hold_parameters p;
    assign_members(p, others, name);
    ph::require_no_error(ph::validate(p));
    return held_scene_value(of, p);
  }
  using kind_of_scene::made;
  py::dict parameters() const {
    py::dict all;
    all["scene"] = of;
    all["period"] = table.period;
    return all;
  }
  py::dict changed() const { return parameters(); }
};

std::unique_ptr<scene> made_scene(const py::tuple& walls) { return std::make_unique<scene_value>(walls); }

void bind_scene(py::module_& module) {
  py::class_<scene>(module, "scene",
                    "(*walls: wall)\n\nWalls, numbered from 0 in their order. Several walls, or a "
                    "mesh_surface, are a world.")
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
             const auto* theirs = py::isinstance<scene>(other) ? &py::cast<const scene&>(other) : nullptr;
             if (dynamic_cast<const scene_value*>(theirs) == nullptr)
               return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(s.walls.equal(theirs->walls));
           })
      .def(py::pickle([](const scene& s) { return s.walls; },
                      [](const py::tuple& walls) { return made_scene(walls); }))
      .attr("__hash__") = py::none();
}

}  // namespace

void bind_scenes(py::module_& module) {
  bind_scene(module);
  py::class_<world_value, scene> world(
      module, "world",
      "(walls: Sequence[wall])\n\nMany walls, numbered from 0 in their order, of which a cycle looks at "
      "those "
      "that the handle can have reached since it last looked. At most d + 1 contacts, those of the largest "
      "forces. With a mesh among them all walls are felt as one surface. For a law that takes several "
      "walls.");
  add_value_protocol(world, "world");
  py::class_<held_scene_value, scene> held_one(
      module, "held_scene",
      "(scene: scene, period: float)\n\nA scene that is sampled once a period [s] and held between: a "
      "virtual environment that is slower than the loop of the brakes. 0 samples every time.");
  add_value_protocol(held_one, "held_scene");
}

}  // namespace passive_haptics_python
