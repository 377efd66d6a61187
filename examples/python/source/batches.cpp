// The results of a batch.
#include <precompiled.hpp>

#include "batch_arrays.hpp"
#include "module.hpp"

#include <string>

namespace passive_haptics_python {
namespace {

py::dict arrays_of(const batch_values& r) {
  py::dict all;
  batch_values::for_each(r, [&](const char* name, const py::object& x, char) { all[name] = x; });
  return all;
}
batch_values restored(const py::dict& arrays) {
  batch_values r;
  batch_values::for_each(r, [&](const char* name, py::object& x, char) {
    x = arrays[name];
    if (!x.is_none() && !py::isinstance<py::array>(x))
      refuse_type(std::string(name) + " of a batch_result is no array, expected what batch() returned");
  });
  return r;
}
bool equal(const batch_values& a, const batch_values& b) {
  bool same = true;
  const py::dict others = arrays_of(b);
  batch_values::for_each(a, [&](const char* name, const py::object& x, char) {
    const py::object y = others[name];
    if (x.is_none() || y.is_none()) same = same && x.is_none() && y.is_none();
    else
      same = same && x.attr("shape").equal(y.attr("shape")) &&
             x.attr("tobytes")("F").equal(y.attr("tobytes")("F"));
  });
  return same;
}

}  // namespace

void bind_batches(py::module_& module) {
  using B = batch_values;
  py::class_<B>(module, "batch_result",
                "What batch() stores: an array for each member of step_result, a row or a number for each "
                "state; None where it was not wanted. Arrays of rows stand in memory column by column.")
      .def_readonly("capacity", &B::capacity, "Array: The most each brake may hold [N m], N x m.")
      .def_readonly("outcome", &B::outcome, "Integers: status, N.")
      .def_readonly("torque", &B::torque, "Array: What the mechanism is predicted to feel [N m], N x m.")
      .def_readonly("power", &B::power, "Integers: power_class, N.")
      .def_readonly("display", &B::display, "Integers: display_class, N.")
      .def_readonly("saturated", &B::saturated, "Booleans: Whether a torque limit was reached, N.")
      .def_readonly("wall_number", &B::wall_number, "Integers: -1 in free space, N.")
      .def_readonly("alpha", &B::alpha, "Array: Scale factor of the law (12), N.")
      .def_readonly("approximation_cosine", &B::approximation_cosine, "Array: cos(gamma), N.")
      .def_readonly("desired_force", &B::desired_force, "Array: Fd [N], N x d.")
      .def_readonly("control_force", &B::control_force, "Array: Fc [N], N x d.")
      .def_readonly("cone_coefficients", &B::cone_coefficients, "Array: Torques that make Fc [N m], N x m.")
      .def_readonly("signs", &B::signs, "Array: s, N x m.")
      .def(
          "__len__", [](const B& b) { return py::len(b.capacity); }, "__len__(self) -> int\n\nN.")
      .def("__repr__",
           [](const B& b) {
             std::string fields;
             B::for_each(b, [&](const char* name, const py::object& x, char) {
               if (!x.is_none()) fields += (fields.empty() ? "" : ", ") + std::string(name);
             });
             return "<batch_result of " + std::to_string(py::len(b.capacity)) + " states: " + fields + ">";
           })
      .def("__eq__",
           [](const B& b, const py::object& other) -> py::object {
             if (!py::isinstance<B>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(equal(b, py::cast<const B&>(other)));
           })
      .def(py::pickle(&arrays_of, &restored))
      .attr("__hash__") = py::none();
}

}  // namespace passive_haptics_python
