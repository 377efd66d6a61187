// What all mechanisms have: kinematics, and what they can display.
#include <precompiled.hpp>

#include "devices.hpp"
#include "module.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <limits>

namespace passive_haptics_python {

brake_numbers brakes_for(const mechanism& of, const py::object& given) {
  const char* const expected = "what brakes() of the mechanism returns, for its number of brakes";
  const brake_numbers known = expect<brakes>(given, "brakes", expected).values();
  if (int(known.torque_limit.size()) != of.device().sizes().brake_count)
    refuse_type("brakes = " + shown(given) + ", expected " + expected);
  return known;
}

namespace {

// The defaults of switchable_brake_parameters, for as many brakes as the device has.
brake_numbers usual_brakes(const mechanism& of) {
  const ph::switchable_brake_parameters<double, 1> one;
  const auto all = [&](const ph::vector<double, 1>& x) -> numbers {
    return numbers::Constant(of.device().sizes().brake_count, x[0]);
  };
  return {all(one.torque_limit),  all(one.rate_dead_band), all(one.torque_dead_band),
          all(one.time_constant), all(one.torque_lower),   all(one.torque_upper)};
}
brake_numbers brakes_or_usual(const mechanism& of, const py::object& given) {
  return given.is_none() ? usual_brakes(of) : brakes_for(of, given);
}

py::list fmes_of(const mechanism& of, py::handle q, int segments) {
  py::list all;
  for (const outlined_fme& fme : of.device().passive_fmes(any_numbers(q, "q"), segments)) {
    py::array_t<double> points({py::ssize_t(fme.outline.size()), py::ssize_t(2)});
    auto at = points.mutable_unchecked<2>();
    for (std::size_t k = 0; k < fme.outline.size(); ++k)
      for (int i = 0; i < 2; ++i) at(py::ssize_t(k), i) = fme.outline[k][i];
    all.append(py::make_tuple(py::make_tuple(fme.signs[0], fme.signs[1]), points));
  }
  return all;
}

void bind_kinematics(py::class_<mechanism>& bound) {
  bound
      .def_property_readonly(
          "dof", [](const mechanism& m) { return m.device().sizes().dof; }, "int: n, the joints.")
      .def_property_readonly(
          "task_dimension", [](const mechanism& m) { return m.device().sizes().task_dimension; },
          "int: d, the size of a position.")
      .def_property_readonly(
          "brake_count", [](const mechanism& m) { return m.device().sizes().brake_count; },
          "int: m, the brakes.")
      .def(
          "position",
          [](const mechanism& m, py::handle q) { return m.device().position(any_numbers(q, "q")); },
          py::arg("q"), "position(self, q: Numbers) -> Array\n\nThe end effector [m], base frame.")
      .def(
          "jacobian",
          [](const mechanism& m, py::handle q) { return m.device().jacobian(any_numbers(q, "q")); },
          py::arg("q"), "jacobian(self, q: Numbers) -> Array\n\nJ in v = J qd, d x n [m/rad or 1].")
      .def(
          "velocity",
          [](const mechanism& m, py::handle q, py::handle qd) {
            return m.device().velocity(any_numbers(q, "q"), any_numbers(qd, "qd"));
          },
          py::arg("q"), py::arg("qd"),
          "velocity(self, q: Numbers, qd: Numbers) -> Array\n\nThe velocity of the end effector [m/s].")
      .def(
          "brake_rates",
          [](const mechanism& m, py::handle q, py::handle qd) {
            return m.device().brake_rates(any_numbers(q, "q"), any_numbers(qd, "qd"));
          },
          py::arg("q"), py::arg("qd"),
          "brake_rates(self, q: Numbers, qd: Numbers) -> Array\n\nThe rates of the brakes, w = T qd [rad/s "
          "or m/s].")
      .def(
          "brake_signs",
          [](const mechanism& m, py::handle q, py::handle qd, py::handle hand_force,
             const py::object& given) {
            std::optional<numbers> force;
            if (!hand_force.is_none()) force = any_numbers(hand_force, "hand_force");
            return m.device().brake_signs(any_numbers(q, "q"), any_numbers(qd, "qd"), force,
                                          brakes_or_usual(m, given));
          },
          py::arg("q"), py::arg("qd"), py::arg("hand_force") = py::none(), py::arg("brakes") = py::none(),
          "brake_signs(self, q: Numbers, qd: Numbers, hand_force: Numbers | None = ..., brakes: "
          "brake_parameters | None = ...) -> Array\n\nThe signs of the brakes: those of their rates, at rest "
          "those of the hand's torque.")
      .def(
          "recommended_law",
          [](const mechanism& m, const py::object& given) {
            return m.recommended_law(brakes_or_usual(m, given));
          },
          py::arg("brakes") = py::none(),
          "recommended_law(self, brakes: brake_parameters | None = ...) -> law\n\nThe law for a device with "
          "a force sensor whose user has not chosen one.");
}

void bind_forces(py::class_<mechanism>& bound) {
  bound
      .def(
          "reference_forces",
          [](const mechanism& m, py::handle q) {
            const auto set = m.device().reference_forces(any_numbers(q, "q"));
            return py::make_tuple(set.G, enumerated("status", set.outcome));
          },
          py::arg("q"),
          "reference_forces(self, q: Numbers) -> tuple[Array, status]\n\nThe forces of unit torques, a "
          "column "
          "for each brake [N per N m] (6); NaN unless the status is ok. Of a device with as many brakes and "
          "joints as task dimensions; TypeError for others.")
      .def(
          "nearest_force",
          [](const mechanism& m, py::handle q, py::handle signs, py::handle desired) {
            return m.device().nearest_force(any_numbers(q, "q"), any_numbers(signs, "signs"),
                                            any_numbers(desired, "desired_force"));
          },
          py::arg("q"), py::arg("signs"), py::arg("desired_force"),
          "nearest_force(self, q: Numbers, signs: Numbers, desired_force: Numbers) -> Array\n\nThe force [N] "
          "nearest to the desired one that brakes of these signs can make. Of a device with as many brakes "
          "and joints as task dimensions; TypeError for others.")
      .def("passive_fme", &fmes_of, py::arg("q"), py::arg("segments") = 32,
           "passive_fme(self, q: Numbers, segments: int = ...) -> list[tuple[tuple[int, int], Array]]\n\nThe "
           "four passive FMEs: the signs of the torques, and the closed outline [N] as K rows of 2 numbers. "
           "NaN at a singular pose. Of two brakes on two joints in the plane; TypeError for others.");
}

}  // namespace

void bind_mechanisms(py::module_& module) {
  py::class_<brakes>(module, "brake_parameters", "The parameters of the brakes of a device.");
  py::class_<mechanism> bound(module, "mechanism", "A mechanism: joint positions in, end effector out.");
  bind_kinematics(bound);
  bind_forces(bound);
  bind_design(bound);
}

}  // namespace passive_haptics_python
