// Shapes, meshes, walls, effects and scenes, for scenes.py and meshes.py of the package.
#include "scenes.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/mesh/mesh_plausibility.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/world/world.hpp>

#include <pybind11/stl.h>

#include <cmath>
#include <utility>

namespace passive_haptics_python {
namespace {

template <int D, class Variant>
const auto& in_dimension(const Variant& v) {
  return std::get<D - 2>(v.in);
}

template <int D>
shape_in<D> made_in(const named& n, const shape* of) {
  const auto& entry = *rt::find(example::catalogue().shapes<D>(), n.name);
  std::optional<rt::any_shape<D>> inner;
  if (of != nullptr) inner = in_dimension<D>(*of).solid;
  shape_in<D> made;
  if (entry.make) made.solid = entry.make(n.table, inner ? &*inner : nullptr);
  made.wall_of = [&entry, table = n.table, inner](double stiffness) {
    return entry.make_wall(table, inner ? &*inner : nullptr, stiffness);
  };
  return made;
}
shape made_shape(const named& n, const shape* of) {
  if (n.dimension == 2) return {made_in<2>(n, of)};
  return {made_in<3>(n, of)};
}

double distance_at(const shape& s, py::handle x) {
  return std::visit([&]<int D>(const shape_in<D>& of) { return of.solid->distance(vector_of<D>(x, "x")); },
                    s.in);
}
py::array gradient_at(const shape& s, py::handle x) {
  const auto in = [&]<int D>(const shape_in<D>& of) {
    return array_of(of.solid->gradient(vector_of<D>(x, "x")));
  };
  return std::visit(in, s.in);
}

// ---- meshes

struct mesh {
  std::variant<ph::mesh<2>, ph::mesh<3>> held;
};

template <int D>
mesh mesh_of(const numbers_array& vertices, const numbers_array& facets) {
  if (facets.shape(1) != D)
    refuse_value("shape of facets = " + std::string(py::str(facets.attr("shape"))) + ": expected (M, " +
                 std::to_string(D) + "), " +
                 (D == 2 ? "the two ends of each segment" : "the three corners of each triangle"));
  ph::mesh_parameters<D> p;
  for (const double* x = vertices.data(); std::ssize(p.vertices) < vertices.shape(0); x += D)
    p.vertices.emplace_back(x);
  p.facets.resize(static_cast<std::size_t>(facets.shape(0)));
  for (std::size_t i = 0; i < p.facets.size(); ++i) {
    for (int k = 0; k < D; ++k) {
      const double index = facets.at(py::ssize_t(i), k);
      if (!(index >= 0 && index < double(p.vertices.size()) && index == std::floor(index)))
        refuse_value("facet " + std::to_string(i) +
                     " of a mesh: index of a vertex = " + std::string(py::str(py::float_(index))) +
                     ": expected a whole number of 0 or more and less than " +
                     std::to_string(p.vertices.size()));
      p.facets[i][static_cast<std::size_t>(k)] = static_cast<int>(index);
    }
  }
  const py::gil_scoped_release unlocked;
  return {ph::mesh<D>(p)};
}
mesh mesh_from(py::handle vertices, py::handle facets) {
  const auto points = array_from(vertices, "vertices", {2}), corners = array_from(facets, "facets", {2});
  if (points.shape(1) == 2) return mesh_of<2>(points, corners);
  if (points.shape(1) == 3) return mesh_of<3>(points, corners);
  refuse_value("shape of vertices = " + std::string(py::str(points.attr("shape"))) +
               ": expected (N, 2) or (N, 3)");
}

// Rows of three numbers.
template <class Rows>
py::array as_array(const Rows& rows) {
  using T = typename Rows::value_type::value_type;
  return py::array_t<T>({std::ssize(rows), py::ssize_t(3)}, rows.empty() ? nullptr : rows.front().data());
}

// The vertices and facets of a file, and remarks on it.
py::tuple read_mesh(const std::string& format, const std::string& path, double metres_per_unit) {
  const auto read = format == "stl" ? &ph::read_stl : format == "ply" ? &ph::read_ply : &ph::read_obj;
  ph::mesh_file file;
  {
    const py::gil_scoped_release unlocked;
    file = read(path, metres_per_unit);
  }
  return py::make_tuple(as_array(file.mesh.vertices), as_array(file.mesh.facets), file.remarks);
}

shape solid_of(const mesh& m) {
  const auto made = []<int D>(const ph::mesh<D>& of) -> shape {
    const ph::mesh_solid<D> solid(of);
    return {shape_in<D>{rt::any_shape<D>(solid),
                        [solid](double stiffness) { return ph::any_wall<D>(ph::wall(solid, stiffness)); }}};
  };
  return std::visit(made, m.held);
}
shape surface_of(const mesh& m, double skin, double crease_angle) {
  const auto made = [&]<int D>(const ph::mesh<D>& of) -> shape {
    ph::mesh_surface_parameters<D> p{of};
    p.skin = skin;
    p.crease_angle = crease_angle;
    const ph::mesh_surface<D> surface(p);
    return {shape_in<D>{
        std::nullopt, [surface](double stiffness) { return ph::any_wall<D>(ph::wall(surface, stiffness)); }}};
  };
  return std::visit(made, m.held);
}
std::string plausibility_of(const mesh& m, double reach) {
  return std::visit([&](const auto& of) { return ph::plausibility(of, reach); }, m.held);
}

// ---- walls and scenes

wall made_wall(const shape& s, double stiffness) {
  return std::visit(
      [&]<int D>(const shape_in<D>& of) -> wall {
        if (!of.solid) return {wall_in<D>{of.wall_of(stiffness), std::nullopt}};
        return {wall_in<D>{of.wall_of(stiffness), ph::wall(*of.solid, stiffness)}};
      },
      s.in);
}

template <int D>
rt::any_scene<D> scene_in(const std::vector<wall>& walls, bool is_world) {
  if (const auto& first = in_dimension<D>(walls.front()); walls.size() == 1 && first.solid && !is_world)
    return rt::any_scene<D>(ph::scene(*first.solid));
  ph::world_walls<D> all;
  for (const wall& w : walls) all.add(in_dimension<D>(w).any);
  return rt::any_scene<D>(ph::world<D>(all));
}
scene made_scene(const std::vector<wall>& walls, bool is_world) {
  if (walls.front().in.index() == 0) return {scene_in<2>(walls, is_world)};
  return {scene_in<3>(walls, is_world)};
}

// As held_scene takes it: without a time.
template <int D>
struct sampled {
  static constexpr int dimension = D;
  using contacts_type = typename rt::any_scene<D>::contacts_type;
  rt::any_scene<D> of;
  const contacts_type& touched_at(const ph::point<D>& x) { return of.touched_at(x, 0); }
  void set_margin(double margin) { of.set_margin(margin); }
  void reset() { of.reset(); }
};
scene held(const scene& of, double period) {
  return of.without_effects([&]<int D>(const rt::any_scene<D>& walls) -> scene {
    return {rt::any_scene<D>(ph::held_scene<sampled<D>>({walls}, period))};
  });
}

effect made_effect(const named& n) {
  const auto in = [&]<int D>() -> std::optional<rt::any_effect<D>> {
    if (n.dimension == 5 - D) return {};
    return rt::find(example::catalogue().effects<D>(), n.name)->make(n.table);
  };
  return {{in.operator()<2>(), in.operator()<3>()}};
}

template <int D>
scene beside(const rt::any_scene<D>& walls, const std::vector<effect>& effects) {
  std::vector<rt::any_effect<D>> all;
  for (const effect& e : effects) {
    const auto& one = std::get<D - 2>(e.in);
    if (!one)
      refuse_value("effect " + std::to_string(all.size()) + " of the scene has vectors of " +
                   std::to_string(5 - D) + " numbers: expected " + std::to_string(D) + ", as its walls have");
    all.push_back(*one);
  }
  return {rt::any_scene_with_effects<D>(walls, all)};
}

}  // namespace

void bind_scenes(py::module_& module) {
  py::class_<shape>(module, "shape")
      .def(py::init([](const named& n) { return made_shape(n, nullptr); }))
      .def(py::init([](const named& n, const shape& of) { return made_shape(n, &of); }))
      .def("distance", &distance_at)
      .def("gradient", &gradient_at)
      .def("dimension", [](const shape& s) { return s.in.index() + 2; });
  py::class_<mesh>(module, "mesh")
      .def(py::init(&mesh_from))
      .def("plausibility", &plausibility_of)
      .def("dimension", [](const mesh& m) { return m.held.index() + 2; });
  module.def("read_mesh", &read_mesh);
  module.def("mesh_solid", &solid_of);
  module.def("mesh_surface", &surface_of);
  py::class_<wall>(module, "wall").def(py::init(&made_wall)).def("dimension", [](const wall& w) {
    return w.in.index() + 2;
  });
  py::class_<effect>(module, "effect").def(py::init(&made_effect));
  py::class_<scene>(module, "scene").def(py::init(&made_scene)).def("dimension", [](const scene& of) {
    return of.held.index() % 2 == 1 ? 2 : 3;
  });
  module.def("held_scene", &held);
  module.def("with_effects", [](const scene& of, const std::vector<effect>& effects) {
    return of.without_effects(
        [&]<int D>(const rt::any_scene<D>& walls) { return beside<D>(walls, effects); });
  });
}

}  // namespace passive_haptics_python
