/// @file
/// Binds a mechanism, of the library or of yours, to Python with one line.
#pragma once

#include <passive_haptics_python/mechanisms.hpp>

#include <passive_haptics/control/laws/on_off_control.hpp>

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
  const std::string text = "(" + stub_arguments<brake_table<Brakes>>() + ")\n\nThe brakes of a device with " +
                           std::to_string(Brakes) +
                           " of them. torque_lower = torque_upper = 0: the brake is off. One of them 0: it "
                           "works one way.\n\n" +
                           parameter_lines<brake_table<Brakes>>();
  py::class_<X, brakes> bound(module, name.c_str(), text.c_str());
  add_value_protocol(bound, name);
}

}  // namespace detail

/// Binds mechanism M as a class `name` of this module: its parameters as keywords, its kinematics, what it
/// can display, its simulation, and its controllers under these laws. A mechanism of yours in a module of
/// yours:
///
///     PYBIND11_MODULE(mine, module) {
///       pybind11::module_::import("passive_haptics");
///       passive_haptics_python::bind_mechanism<my_arm>(module, "my_arm");
///     }
///
/// P: the struct with the table of its parameters, from which it is made; my_arm itself if it has a table, or
/// none. Model and DeviceLaws: as of mechanism_value. Throws pybind11's error where the package is not
/// imported first.
template <class M, ph::Parameters P = typename detail::own_parameters<M>::type, class Laws = usual_laws<M>,
          class Model = M, class DeviceLaws = Laws>
auto bind_mechanism(py::module_& module, const char* name, const char* about = "A mechanism.") {
  static_assert(ph::is_mechanism<M, ph::explain>());
  static_assert(std::is_same_v<typename M::scalar, double>,
                "passive_haptics: a mechanism for Python has `using scalar = double;`.");
  using X = mechanism_value<M, P, Laws, Model, DeviceLaws>;
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
  const std::string brakes_text = "brakes(self, " + stub_arguments<brake_table<M::brake_count>>() + ") -> " +
                                  brakes_name + "\n\nThe brakes of this device.\n\n" +
                                  parameter_lines<brake_table<M::brake_count>>();
  bound.def(
      "brakes",
      [brakes_name](const X&, const py::args& args, const py::kwargs& kwargs) {
        using B = brakes_value<M::brake_count>;
        return B::made(named(args, kwargs, B::names(), brakes_name), brakes_name);
      },
      brakes_text.c_str());
  return bound;
}

}  // namespace passive_haptics_python
