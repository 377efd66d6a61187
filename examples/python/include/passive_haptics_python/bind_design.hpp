/// @file
/// Binds what there is to know of a device before it is built (passive_haptics/design).
#pragma once

#include <passive_haptics_python/mechanisms.hpp>

#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/design/displayable.hpp>

#include <pybind11/eigen.h>

namespace passive_haptics_python {

/// displayable_force of any device.
struct displayable_values {
  ph::status outcome;         ///< ok, or why nothing is known.
  ph::display_class display;  ///< How the normal force is displayed.
  double angle;               ///< gamma [rad]
  double strongest;           ///< [N]
  double strongest_nearest;   ///< [N]
  numbers signs;              ///< s
};

/// A wall made of brakes, as Python has it.
struct braked_wall_base {};
/// Its parameters are those of braked_wall.
using braked_wall_value = table_value<braked_wall_base, ph::braked_wall>;

namespace detail {

// Brakes that are all on, without limits where none are given.
template <class X, class M = std::remove_cvref_t<decltype(std::declval<const X&>().model())>>
ph::switchable_brakes<M> brakes_on(const py::object& given) {
  ph::switchable_brakes<M> of;
  of.torque_limit.setConstant(std::numeric_limits<double>::infinity());
  if (given.is_none()) return of;
  const ph::brakes_of<M>& known = X::brakes_from(given);
  of.torque_limit = known.torque_limit;
  of.time_constant = known.time_constant;
  return of;
}

}  // namespace detail

/// Binds the functions of design/ that take a mechanism to its class.
template <class X, class... Options>
void bind_design(py::class_<X, Options...>& bound) {
  using M = std::remove_cvref_t<decltype(std::declval<const X&>().model())>;
  constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  bound.def(
      "displayable",
      [](const X& x, py::handle q, py::handle velocity, py::handle normal, const py::object& given) {
        const auto found =
            ph::displayable(x.model(), vector_from<n>(q, "q"), vector_from<d>(velocity, "velocity"),
                            vector_from<d>(normal, "normal"), detail::brakes_on<X>(given));
        return displayable_values{found.outcome,   found.display,           found.angle,
                                  found.strongest, found.strongest_nearest, found.signs};
      },
      py::arg("q"), py::arg("velocity"), py::arg("normal"), py::arg("brakes") = py::none(),
      "displayable(self, q: Numbers, velocity: Numbers, normal: Numbers, brakes: brake_parameters | None = "
      "...) -> displayable_force\n\nWhat the brakes can display along the normal of a wall while the handle "
      "moves with a velocity (its direction counts). Brakes without limits where none are given.");
  if constexpr (ph::Dynamics<M>) {
    bound.def(
        "braked_wall_at",
        [](const X& x, py::handle q, py::handle velocity, py::handle normal, const py::object& given,
           py::handle residual_torque, py::handle resolution, double hand_mass) {
          constexpr int axes = ph::encoder_axes<M>::count;
          return braked_wall_value(
              ph::braked_wall_at(x.model(), vector_from<n>(q, "q"), vector_from<d>(velocity, "velocity"),
                                 vector_from<d>(normal, "normal"), detail::brakes_on<X>(given),
                                 vector_from<m>(residual_torque, "residual_torque"),
                                 vector_from<axes>(resolution, "resolution"), hand_mass));
        },
        py::arg("q"), py::arg("velocity"), py::arg("normal"), py::arg("brakes"), py::arg("residual_torque"),
        py::arg("resolution"), py::arg("hand_mass"),
        "braked_wall_at(self, q: Numbers, velocity: Numbers, normal: Numbers, brakes: brake_parameters, "
        "residual_torque: Numbers, resolution: Numbers, hand_mass: float) -> braked_wall\n\nThe wall of this "
        "normal that the brakes can make at q, touched with a velocity [m/s], for limits_of(). "
        "residual_torque [N m] of each brake, resolution: a count of each encoder [rad or m], hand_mass "
        "[kg].");
  }
}

}  // namespace passive_haptics_python
