// The state of a device and the result of a cycle.
#include <precompiled.hpp>

#include "module.hpp"

#include <passive_haptics_python/any_device.hpp>

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

namespace passive_haptics_python {
namespace {

state_values made_state(py::handle time, py::handle q, py::handle qd, py::handle hand_force) {
  state_values s{number_from(time, "time"), vector_from<Eigen::Dynamic>(q, "q"),
                 vector_from<Eigen::Dynamic>(qd, "qd"), std::nullopt};
  if (!hand_force.is_none()) s.hand_force = vector_from<Eigen::Dynamic>(hand_force, "hand_force");
  return s;
}
bool equal(const state_values& a, const state_values& b) {
  return same_bits(a.time, b.time) && same_bits(a.q, b.q) && same_bits(a.qd, b.qd) &&
         a.hand_force.has_value() == b.hand_force.has_value() &&
         (!a.hand_force || same_bits(*a.hand_force, *b.hand_force));
}

// All values of a result, in the order of the class.
template <class R, class F>
void for_each_value(R& r, F&& f) {
  f("capacity", r.capacity);
  f("torque", r.torque);
  f("outcome", r.outcome);
  f("power", r.power);
  f("display", r.display);
  f("saturated", r.saturated);
  f("wall_number", r.wall_number);
  f("alpha", r.alpha);
  f("approximation_cosine", r.approximation_cosine);
  f("desired_force", r.desired_force);
  f("control_force", r.control_force);
  f("cone_coefficients", r.cone_coefficients);
  f("signs", r.signs);
  f("settled_signs", r.settled_signs);
  f("settled_velocity", r.settled_velocity);
}

py::object to_object(const numbers& x) { return py::cast(x); }
py::object to_object(bool x) { return py::bool_(x); }
py::object to_object(int x) { return py::int_(x); }
py::object to_object(double x) { return py::float_(x); }
py::object to_object(ph::status x) { return enumerated("status", x); }
py::object to_object(ph::power_class x) { return enumerated("power_class", x); }
py::object to_object(ph::display_class x) { return enumerated("display_class", x); }

void from_object(numbers& x, const py::object& from) { x = vector_from<Eigen::Dynamic>(from, "a vector"); }
void from_object(bool& x, const py::object& from) { x = py::cast<bool>(from); }
void from_object(double& x, const py::object& from) { x = number_from(from, "a number"); }
template <class E>
void from_object(E& x, const py::object& from) {
  x = static_cast<E>(py::cast<int>(from));
}

py::list reports(const result_values& r) {
  const py::object report = py::module_::import("passive_haptics.results").attr("contact_report");
  py::list all;
  for (const auto& c : r.contacts) all.append(report(c.wall_number, c.wanted, c.displayed, c.has_priority));
  return all;
}
py::dict contents(const result_values& r) {
  py::dict all;
  for_each_value(r, [&](const char* name, const auto& value) { all[name] = to_object(value); });
  all["contacts"] = reports(r);
  return all;
}
result_values restored(const py::dict& from) {
  result_values r;
  for_each_value(r, [&](const char* name, auto& value) { from_object(value, py::object(from[name])); });
  for (const auto& c : from["contacts"])
    r.contacts.push_back({py::cast<int>(c.attr("wall_number")), py::cast<double>(c.attr("wanted")),
                          py::cast<double>(c.attr("displayed")), py::cast<bool>(c.attr("has_priority"))});
  return r;
}
bool equal(const result_values& a, const result_values& b) {
  bool same = reports(a).equal(reports(b));
  std::vector<py::object> of_b;
  for_each_value(b, [&](const char*, const auto& value) { of_b.push_back(to_object(value)); });
  std::size_t i = 0;
  for_each_value(a, [&](const char*, const auto& value) {
    const py::object other = of_b[i++];
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, numbers>)
      same = same && same_bits(value, py::cast<numbers>(other));
    else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>)
      same = same && same_bits(value, py::cast<double>(other));
    else same = same && to_object(value).equal(other);
  });
  return same;
}

void bind_state(py::module_& module) {
  py::class_<state_values>(module, "device_state",
                           "(time: float, q: Numbers, qd: Numbers, hand_force: Numbers | None = ...)\n\nWhat "
                           "a device measures, once a "
                           "control cycle: time [s], joint positions [rad or m] and rates, and what the hand "
                           "does to the handle [N] in "
                           "the base frame; None without a force sensor.")
      .def(py::init(&made_state), py::arg("time"), py::arg("q"), py::arg("qd"),
           py::arg("hand_force") = py::none())
      .def_readonly("time", &state_values::time, "float: [s], of a clock that does not jump.")
      .def_readonly("q", &state_values::q, "Array: Joint positions [rad or m].")
      .def_readonly("qd", &state_values::qd, "Array: Joint rates [rad/s or m/s].")
      .def_readonly("hand_force", &state_values::hand_force,
                    "Array | None: What the hand does to the handle [N], base frame.")
      .def("__repr__",
           [](const state_values& s) {
             py::dict all;
             all["time"] = s.time;
             for (const auto& [name, v] : {std::pair{"q", &s.q}, {"qd", &s.qd}})
               all[name] = py::cast(*v).attr("tolist")();
             if (s.hand_force) all["hand_force"] = py::cast(*s.hand_force).attr("tolist")();
             return call_text("device_state", all);
           })
      .def("__eq__",
           [](const state_values& s, const py::object& other) -> py::object {
             if (!py::isinstance<state_values>(other))
               return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(equal(s, py::cast<const state_values&>(other)));
           })
      .def(py::pickle([](const state_values& s) { return py::make_tuple(s.time, s.q, s.qd, s.hand_force); },
                      [](const py::tuple& t) {
                        if (t.size() != 4)
                          refuse_value("a pickled device_state has 4 parts, expected one of ours");
                        return made_state(t[0], t[1], t[2], t[3]);
                      }))
      .attr("__hash__") = py::none();
}

void bind_result(py::module_& module) {
  using R = result_values;
  py::class_<R>(module, "step_result", "What one control cycle decides, and why.")
      .def_readonly("capacity", &R::capacity, "Array: The most each brake may hold [N m], to be commanded.")
      .def_readonly("torque", &R::torque, "Array: What the mechanism is predicted to feel (3) [N m].")
      .def_property_readonly(
          "outcome", [](const R& r) { return to_object(r.outcome); },
          "status: ok, or why the brakes were released.")
      .def_property_readonly(
          "power", [](const R& r) { return to_object(r.power); }, "power_class: Of the desired force.")
      .def_property_readonly(
          "display", [](const R& r) { return to_object(r.display); }, "display_class: How Fd is displayed.")
      .def_readonly("saturated", &R::saturated, "bool: Whether a torque limit was reached.")
      .def_readonly("wall_number", &R::wall_number, "int: Wall that demands the force; -1 in free space.")
      .def_readonly("alpha", &R::alpha, "float: Scale factor of the law (12).")
      .def_readonly("approximation_cosine", &R::approximation_cosine, "float: cos(gamma).")
      .def_readonly("desired_force", &R::desired_force, "Array: Fd [N], base frame.")
      .def_readonly("control_force", &R::control_force, "Array: Fc [N], base frame, before alpha and limits.")
      .def_readonly("cone_coefficients", &R::cone_coefficients, "Array: Torques that make Fc [N m].")
      .def_readonly("signs", &R::signs, "Array: s, -1, 0 or 1 of each brake.")
      .def_readonly("settled_signs", &R::settled_signs,
                    "Array: s* once the self-motion has settled; empty of a device that has none.")
      .def_readonly("settled_velocity", &R::settled_velocity,
                    "Array: v' [m/s], to which s* belongs; empty of a device that has none.")
      .def_property_readonly(
          "contacts", &reports,
          "list[contact_report]: Each touched wall, under any law; empty if the scene has one wall.")
      .def("__repr__",
           [](const R& r) {
             const py::dict all = contents(r);
             for (const auto& [key, value] : all)
               if (py::isinstance<py::array>(value)) all[key] = value.attr("tolist")();
             return call_text("step_result", all);
           })
      .def("__eq__",
           [](const R& r, const py::object& other) -> py::object {
             if (!py::isinstance<R>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             return py::bool_(equal(r, py::cast<const R&>(other)));
           })
      .def(py::pickle(&contents, &restored))
      .attr("__hash__") = py::none();
}

void bind_displayable(py::module_& module) {
  using F = displayable_values;
  py::class_<F>(module, "displayable_force", "What brakes can display along the normal of a wall.")
      .def_property_readonly(
          "outcome", [](const F& f) { return to_object(f.outcome); }, "status: ok, or why nothing is known.")
      .def_property_readonly(
          "display", [](const F& f) { return to_object(f.display); },
          "display_class: How a force along the normal is displayed.")
      .def_readonly("angle", &F::angle, "float: gamma [rad] between the normal and the nearest force.")
      .def_readonly("max_force", &F::max_force, "float: The most along the normal [N] of all forces.")
      .def_readonly("max_approximated_force", &F::max_approximated_force,
                    "float: The most along the normal [N] of the nearest force.")
      .def_readonly("signs", &F::signs, "Array: s of the brakes in this motion.")
      .def("__repr__",
           [](const F& f) {
             py::dict all;
             all["outcome"] = to_object(f.outcome);
             all["display"] = to_object(f.display);
             all["angle"] = f.angle;
             all["max_force"] = f.max_force;
             all["max_approximated_force"] = f.max_approximated_force;
             all["signs"] = to_object(f.signs).attr("tolist")();
             return call_text("displayable_force", all);
           })
      .def("__eq__",
           [](const F& f, const py::object& other) -> py::object {
             if (!py::isinstance<F>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
             const auto& g = py::cast<const F&>(other);
             return py::bool_(f.outcome == g.outcome && f.display == g.display &&
                              same_bits(f.angle, g.angle) && same_bits(f.max_force, g.max_force) &&
                              same_bits(f.max_approximated_force, g.max_approximated_force) &&
                              same_bits(f.signs, g.signs));
           })
      .def(py::pickle(
          [](const F& f) {
            return py::make_tuple(int(f.outcome), int(f.display), f.angle, f.max_force,
                                  f.max_approximated_force, f.signs);
          },
          [](const py::tuple& t) {
            if (t.size() != 6) refuse_value("a pickled displayable_force has 6 parts, expected one of ours");
            return F{ph::status(py::cast<int>(t[0])), ph::display_class(py::cast<int>(t[1])),
                     py::cast<double>(t[2]),          py::cast<double>(t[3]),
                     py::cast<double>(t[4]),          py::cast<numbers>(t[5])};
          }))
      .attr("__hash__") = py::none();
}

}  // namespace

void bind_states(py::module_& module) {
  bind_state(module);
  bind_result(module);
  bind_displayable(module);
}

}  // namespace passive_haptics_python
