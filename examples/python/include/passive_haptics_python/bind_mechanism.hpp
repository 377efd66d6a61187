/// @file
/// Binds a mechanism, of the library or of yours, to Python with one line.
#pragma once

#include <passive_haptics_python/bind_design.hpp>
#include <passive_haptics_python/bind_forces.hpp>

#include <passive_haptics/control/laws/rivals/on_off_control.hpp>
#include <passive_haptics/control/ways/free_joints_form.hpp>
#include <passive_haptics/control/ways/generator_form.hpp>
#include <passive_haptics/control/ways/settled_form.hpp>
#include <passive_haptics/control/ways/several_walls.hpp>

namespace passive_haptics_python {

namespace detail {

// The parameters of M where none are named: its own table, or none.
template <class M>
struct own_parameters : std::conditional<ph::Parameters<M>, M, no_parameters> {};

// The class of brakes of this number, once for each number.
template <int Brakes>
void bind_brakes(py::module_& module) {
  using X = brakes_value<Brakes>;
  if (py::detail::get_type_info(typeid(X)) != nullptr) return;
  const std::string name = "brakes_" + std::to_string(Brakes);
  const std::string text = "(" + stub_arguments<ph::brake_parameters<double, Brakes>>() +
                           ")\n\nThe brakes of a device with " + std::to_string(Brakes) + " of them.\n\n" +
                           parameter_lines<ph::brake_parameters<double, Brakes>>();
  py::class_<X, brakes> bound(module, name.c_str(), text.c_str());
  add_value_protocol(bound, name);
}

// Kinematics with numbers of Python.
template <class M>
struct numbers_of {
  static numbers position(const M& model, py::handle q) {
    return model.position(ph::joint_vector<M>(vector_from<M::dof>(q, "q")));
  }
  static Eigen::MatrixXd jacobian(const M& model, py::handle q) {
    return ph::jacobian_matrix<M>(ph::jacobian(model, vector_from<M::dof>(q, "q")));
  }
};

}  // namespace detail

/// Binds mechanism M as a class `name` of this module: its parameters as keywords, its kinematics, what it
/// can display, and its controllers under these laws. A mechanism of yours in a module of yours:
///
///     PYBIND11_MODULE(mine, module) {
///       pybind11::module_::import("passive_haptics");
///       passive_haptics_python::bind_mechanism<my_arm>(module, "my_arm");
///     }
///
/// P: the struct with the table of its parameters, from which it is made; my_arm itself if it has a table, or
/// none. Throws pybind11's error where the package is not imported first.
template <class M, ph::Parameters P = typename detail::own_parameters<M>::type, class Laws = usual_laws<M>>
auto bind_mechanism(py::module_& module, const char* name, const char* about = "A mechanism.") {
  static_assert(ph::mechanism_requirements<M>::met);
  static_assert(std::is_same_v<typename M::scalar, double>,
                "passive_haptics: a mechanism for Python has `using scalar = double;`.");
  using X = mechanism_value<M, P, Laws>;
  py::options options;
  options.disable_function_signatures();
  detail::bind_brakes<M::brake_count>(module);
  const std::string text = "(" + stub_arguments<P>() + ")\n\n" + about + "\n\nIt has " +
                           std::to_string(M::dof) + " joints, " + std::to_string(M::brake_count) +
                           " brakes and " + std::to_string(M::task_dimension) + " task dimensions.\n\n" +
                           parameter_lines<P>();
  py::class_<X, mechanism> bound(module, name, text.c_str());
  add_value_protocol(bound, name);

  const std::string brakes_name = "brakes_" + std::to_string(M::brake_count);
  const std::string brakes_text = "brakes(self, " + stub_arguments<ph::brakes_of<M>>() + ") -> " +
                                  brakes_name + "\n\nThe brakes of this device.\n\n" +
                                  parameter_lines<ph::brakes_of<M>>();
  bound.def(
      "brakes",
      [brakes_name](const X&, const py::args& args, const py::kwargs& kwargs) {
        using B = brakes_value<M::brake_count>;
        return B::made(named(args, kwargs, B::names(), brakes_name), brakes_name);
      },
      brakes_text.c_str());
  bound.def(
      "position", [](const X& x, py::handle q) { return detail::numbers_of<M>::position(x.model(), q); },
      py::arg("q"), "position(self, q: Numbers) -> Array\n\nThe end effector [m], base frame.");
  bound.def(
      "jacobian", [](const X& x, py::handle q) { return detail::numbers_of<M>::jacobian(x.model(), q); },
      py::arg("q"), "jacobian(self, q: Numbers) -> Array\n\nJ in v = J qd, d x n [m/rad or 1].");
  bound.def(
      "velocity",
      [](const X& x, py::handle q, py::handle qd) -> numbers {
        return ph::velocity(x.model(), ph::joint_vector<M>(vector_from<M::dof>(q, "q")),
                            ph::joint_vector<M>(vector_from<M::dof>(qd, "qd")));
      },
      py::arg("q"), py::arg("qd"),
      "velocity(self, q: Numbers, qd: Numbers) -> Array\n\nThe velocity of the end effector [m/s].");
  bound.def(
      "brake_rates",
      [](const X& x, py::handle q, py::handle qd) -> numbers {
        return ph::brake_rates(x.model(), ph::joint_vector<M>(vector_from<M::dof>(q, "q")),
                               ph::joint_vector<M>(vector_from<M::dof>(qd, "qd")));
      },
      py::arg("q"), py::arg("qd"),
      "brake_rates(self, q: Numbers, qd: Numbers) -> Array\n\nThe rates of the brakes, w = T qd [rad/s or "
      "m/s].");
  bound.def(
      "recommended_law",
      [](const X& x, const py::object& given) {
        using L = recommended_law_of<M>;
        const ph::brakes_of<M> of = given.is_none() ? ph::brakes_of<M>() : X::brakes_from(given);
        const L chosen = ph::recommended_law(x.model(), of);
        if constexpr (requires { chosen.parameters(); }) return law_value<L>(chosen.parameters());
        else return law_value<L>(chosen.parameters);
      },
      py::arg("brakes") = py::none(),
      "recommended_law(self, brakes: brake_parameters | None = ...) -> law\n\nThe law for a device with a "
      "force sensor whose "
      "user has not chosen one.");
  bind_forces(bound);
  bind_design(bound);
  return bound;
}

}  // namespace passive_haptics_python
