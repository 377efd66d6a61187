// Meshes, read from files, and the shapes that are made of them.
#include <precompiled.hpp>

#include "meshes.hpp"
#include "module.hpp"

#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>
#include <passive_haptics/scene/mesh/mesh_plausibility.hpp>

#include <filesystem>

namespace passive_haptics_python {
namespace {

template <class T, class Rows>
py::array array_of(const Rows& rows, int width) {
  py::array_t<T> all({py::ssize_t(rows.size()), py::ssize_t(width)});
  auto at = all.template mutable_unchecked<2>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int k = 0; k < width; ++k) at(py::ssize_t(i), k) = rows[i][std::size_t(k)];
  return all;
}
py::array vertices_of(const mesh_value& m) {
  return m.visit([&](const auto& of) { return array_of<double>(of.given.vertices, m.dimension()); });
}
py::array facets_of(const mesh_value& m) {
  return m.visit([&](const auto& of) { return array_of<int>(of.given.facets, m.dimension()); });
}
bool are_equal(const mesh_value& a, const mesh_value& b) {
  return std::visit(
      []<class A, class B>(const A& mine, const B& theirs) {
        if constexpr (!std::is_same_v<A, B>) return false;
        else return mine.given.vertices == theirs.given.vertices && mine.given.facets == theirs.given.facets;
      },
      a.held, b.held);
}

// The call that makes a small mesh; of a large one how large it is.
std::string repr_of(const mesh_value& m) {
  constexpr py::ssize_t max_shown = 20;  // vertices or facets
  const py::array vertices = vertices_of(m), facets = facets_of(m);
  if (vertices.shape(0) > max_shown || facets.shape(0) > max_shown)
    return "mesh(<" + std::to_string(vertices.shape(0)) + " vertices>, <" + std::to_string(facets.shape(0)) +
           " facets>)";
  return "mesh(" + std::string(py::repr(vertices.attr("tolist")())) + ", " +
         std::string(py::repr(facets.attr("tolist")())) + ")";
}

std::filesystem::path path_from(py::handle x) {
  py::object encoded;
  try {
    encoded = py::module_::import("os").attr("fsencode")(x);
  } catch (const py::error_already_set&) {
    refuse_type("path = " + shown(x) + ", expected the name of a file, a str or an os.PathLike");
  }
  const std::string name = py::reinterpret_borrow<py::bytes>(encoded);
  if (name.find('\0') != std::string::npos)
    refuse_value("path = " + shown(x) + ", expected the name of a file, which has no zero byte");
  return name;
}

template <ph::mesh_file (*Read)(const std::filesystem::path&, double)>
py::tuple read_mesh(py::handle path, py::handle metres_per_unit) {
  const std::filesystem::path name = path_from(path);
  const double unit = number_from(metres_per_unit, "metres_per_unit");
  ph::mesh_file file;
  {
    const py::gil_scoped_release unlocked;
    file = Read(name, unit);
  }
  return py::make_tuple(mesh_of<3>(std::move(file.mesh)), file.remarks);
}

template <ph::mesh_file (*Read)(const std::filesystem::path&, double)>
void bind_reader(py::module_& module, const std::string& name, const std::string& about) {
  const std::string text =
      name + "(path: Path, metres_per_unit: float = ...) -> tuple[mesh, str]\n\nThe mesh of " + about +
      ", and what of the file is not in it, in words; \"\" where all is. metres_per_unit: "
      "the unit of the file [m], 1e-3 for millimetres; 1 where none is given. A "
      "ValueError names the file, the line or byte, and what was expected there.";
  module.def(name.c_str(), &read_mesh<Read>, py::arg("path"), py::arg("metres_per_unit") = 1.0, text.c_str());
}

const mesh_value& surface_in(const py::dict& given, const std::string& name) {
  if (!given.contains("surface"))
    refuse_type(name + " needs a surface: " + name + "(mesh(vertices, facets))");
  return expect<mesh_value>(given["surface"], "surface", "a mesh: mesh(vertices, facets)");
}

void bind_mesh(py::module_& module) {
  py::class_<mesh_value>(
      module, "mesh",
      "(vertices: Rows, facets: Rows)\n\nA surface that never changes: triangles in space, or segments in "
      "the "
      "plane.\n\nvertices: N x d [m], of float64. facets: M x d indices of vertices, whole numbers. The "
      "corners "
      "of a triangle run counterclockwise seen from the free side; of a segment the free side is on its "
      "right. Both may be lists of rows. A ValueError names the first facet that is wrong.")
      .def(py::init(&made_mesh), py::arg("vertices"), py::arg("facets"))
      .def_property_readonly("vertices", &vertices_of, "Array: A copy of the vertices, N x d [m].")
      .def_property_readonly("facets", &facets_of, "Integers: A copy of the indices of vertices, M x d.")
      .def_property_readonly("dimension", &mesh_value::dimension, "int: 2 in the plane, 3 in space.")
      .def_property_readonly(
          "closed", [](const mesh_value& m) { return m.visit([](auto& of) { return of.surface.closed(); }); },
          "bool: Whether the facets enclose their wall or their free space without a hole.")
      .def_property_readonly(
          "hole", [](const mesh_value& m) { return m.visit([](auto& of) { return of.surface.hole(); }); },
          "str: Why it is not closed, by vertices and facets; \"\" if it is.")
      .def_property_readonly(
          "turned_edges",
          [](const mesh_value& m) { return m.visit([](auto& of) { return of.surface.turned_edges(); }); },
          "int: Edges (in the plane: vertices) of two facets of which one faces the wrong side.")
      .def_property_readonly(
          "content",
          [](const mesh_value& m) { return m.visit([](auto& of) { return of.surface.content(); }); },
          "float: The enclosed area [m^2] or volume [m^3] of a closed mesh; < 0 if the outside is solid.")
      .def(
          "plausibility",
          [](const mesh_value& m, py::handle reach) {
            const double size = number_from(reach, "reach");
            return m.visit([&](const auto& of) { return ph::plausibility(of.surface, size); });
          },
          py::arg("reach"),
          "plausibility(self, reach: float) -> str\n\nA line for each thing that looks odd beside a device "
          "of "
          "this reach [m]; \"\" if there is none.")
      .def(
          "__len__",
          [](const mesh_value& m) { return m.visit([](auto& of) { return of.given.facets.size(); }); },
          "__len__(self) -> int\n\nThe number of facets.")
      .def("__repr__", &repr_of)
      .def("__eq__",
           [](const mesh_value& m, const py::object& other) -> py::object {
             if (!py::isinstance<mesh_value>(other))
               return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(are_equal(m, py::cast<const mesh_value&>(other)));
           })
      .def(py::pickle([](const mesh_value& m) { return py::make_tuple(vertices_of(m), facets_of(m)); },
                      [](const py::tuple& state) { return made_mesh(state[0], state[1]); }))
      .attr("__hash__") = py::none();
}

}  // namespace

mesh_solid_value mesh_solid_value::made(const py::dict& given, const std::string& name) {
  const mesh_value& surface = surface_in(given, name);
  if (given.size() > 1) refuse_type(name + " has one parameter, surface");
  return surface.visit([&]<int D>(const faceted<D>& of) -> mesh_solid_value {
    return {shape_geometry(any_shape<D>(ph::mesh_solid<D>(of.surface))), given["surface"]};
  });
}

py::dict mesh_solid_value::parameters() const {
  py::dict all;
  all["surface"] = surface;
  return all;
}

mesh_surface_value mesh_surface_value::made(const py::dict& given, const std::string& name) {
  const mesh_value& surface = surface_in(given, name);
  const py::dict others = given.attr("copy")();
  others.attr("pop")("surface");
  return surface.visit([&]<int D>(const faceted<D>& of) -> mesh_surface_value {
    ph::mesh_surface_parameters<D> p{of.surface};
    assign_members(p, others, name);
    return {given["surface"], p.skin, p.crease_angle, ph::mesh_surface<D>(p)};
  });
}

py::dict mesh_surface_value::parameters() const {
  py::dict all;
  all["surface"] = surface;
  all["skin"] = skin;
  all["crease_angle"] = crease_angle;
  return all;
}

py::dict mesh_surface_value::changed() const {
  py::dict all = parameters();
  std::visit(
      [&]<int D>(const ph::mesh_surface<D>& of) {
        const ph::mesh_surface_parameters<D> usual{of.surface()};
        if (skin == usual.skin) all.attr("pop")("skin");
        if (crease_angle == usual.crease_angle) all.attr("pop")("crease_angle");
      },
      held);
  return all;
}

void bind_meshes(py::module_& module) {
  bind_mesh(module);
  bind_reader<&ph::read_stl>(module, "read_stl", "an STL file, in text or binary");
  bind_reader<&ph::read_obj>(module, "read_obj", "an OBJ file: all objects and groups as one");
  bind_reader<&ph::read_ply>(module, "read_ply", "a PLY file, in text or binary");
  py::class_<mesh_solid_value, shape> solid(
      module, "mesh_solid",
      "(surface: mesh)\n\nThe solid within a closed mesh whose normals point outward. In a scene of one wall "
      "it "
      "has one contact; what is pushed more than half through a thin wall comes out at the other side.");
  add_value_protocol(solid, "mesh_solid");
  py::class_<mesh_surface_value> thin(
      module, "mesh_surface",
      "(surface: mesh, skin: float = ..., crease_angle: float = ...)\n\nA closed or an open mesh that stops "
      "what "
      "comes from its front, at any depth. A scene that has one is a world.\n\nParameters:\n    skin [m]: "
      "from "
      "the surface to the point that stands for the handle on it; default 1e-07\n    crease_angle [rad]: "
      "facets "
      "whose normals differ by less are one smooth surface; default 0.5235987755982988\n");
  add_value_protocol(thin, "mesh_surface");
}

}  // namespace passive_haptics_python
