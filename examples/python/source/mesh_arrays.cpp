// Meshes of arrays.
#include <precompiled.hpp>

#include "meshes.hpp"

#include <cstdint>

namespace passive_haptics_python {
namespace {

std::string shape_of(const py::array& x) { return py::str(x.attr("shape")); }

// A table of numbers: an array of two axes, or lists of rows.
py::array table_from(py::handle x, const char* name, const char* rows) {
  py::object table = py::reinterpret_borrow<py::object>(x);
  if (PyList_Check(x.ptr()) || PyTuple_Check(x.ptr())) {
    try {
      table = py::module_::import("numpy").attr("array")(x);
    } catch (const py::error_already_set&) {
      refuse_value(std::string(name) + " = " + shown(x) + ", expected " + rows);
    }
  }
  if (!py::isinstance<py::array>(table))
    refuse_type(std::string(name) + " = " + shown(x) + ", expected a numpy.ndarray, " + rows);
  const py::array array = plain_array(table, name);
  if (array.ndim() != 2)
    refuse_value("shape of " + std::string(name) + " = " + shape_of(array) + ", expected " + rows);
  return array;
}

template <int D>
std::vector<ph::point<D>> vertices_from(const py::array& x, bool is_list) {
  const bool is_whole = is_list && x.dtype().kind() == 'i';
  if (!is_whole && py::cast<std::string>(x.dtype().attr("str")) != "<f8")
    refuse_type("vertices has dtype " + dtype_of(x) + ", expected float64 [m]: vertices.astype(float)");
  const py::array_t<double, py::array::forcecast> numbers(x);
  const auto at = numbers.template unchecked<2>();
  std::vector<ph::point<D>> all(std::size_t(x.shape(0)));
  for (py::ssize_t i = 0; i < x.shape(0); ++i)
    for (int k = 0; k < D; ++k) all[std::size_t(i)][k] = at(i, k);
  return all;
}

// Index: std::int64_t or std::uint64_t.
template <int D, class Index>
auto facets_from(const py::array& x, std::size_t vertices) {
  const py::array_t<Index, py::array::forcecast> numbers(x);
  const auto at = numbers.template unchecked<2>();
  std::vector<std::array<int, std::size_t(D)>> all(std::size_t(x.shape(0)));
  for (py::ssize_t i = 0; i < x.shape(0); ++i) {
    for (int k = 0; k < D; ++k) {
      const Index index = at(i, k);
      if (!std::in_range<int>(index))
        refuse_value("facet " + std::to_string(i) +
                     " of a mesh: index of a vertex = " + std::to_string(index) +
                     ", expected 0 or more and less than " + std::to_string(vertices));
      all[std::size_t(i)][std::size_t(k)] = int(index);
    }
  }
  return all;
}

template <int D>
mesh_value mesh_from(const py::array& vertices, bool is_list, const py::array& facets) {
  const char kind = facets.dtype().kind();
  if (kind != 'i' && kind != 'u')
    refuse_type("facets has dtype " + dtype_of(facets) + ", expected whole numbers: facets.astype(int)");
  if (facets.shape(1) != D)
    refuse_value("shape of facets = " + shape_of(facets) + ", expected (M, " + std::to_string(D) +
                 (D == 2 ? "), the two ends of each segment" : "), the three corners of each triangle"));
  ph::mesh_parameters<D> p;
  p.vertices = vertices_from<D>(vertices, is_list);
  p.facets = kind == 'i' ? facets_from<D, std::int64_t>(facets, p.vertices.size())
                         : facets_from<D, std::uint64_t>(facets, p.vertices.size());
  return mesh_of(std::move(p));
}

}  // namespace

mesh_value made_mesh(const py::object& vertices, const py::object& facets) {
  const char* rows = "N rows of 2 numbers (in the plane) or 3 (in space)";
  const py::array points = table_from(vertices, "vertices", rows);
  const bool is_list = !py::isinstance<py::array>(vertices);
  const py::array corners = table_from(facets, "facets", "M rows of indices of vertices");
  if (points.shape(1) == 2) return mesh_from<2>(points, is_list, corners);
  if (points.shape(1) == 3) return mesh_from<3>(points, is_list, corners);
  refuse_value("shape of vertices = " + shape_of(points) + ", expected " + rows);
}

}  // namespace passive_haptics_python
