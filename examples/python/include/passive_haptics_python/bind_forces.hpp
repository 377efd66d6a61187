/// @file
/// Binds what a device can display: reference forces, passive FMEs, the nearest force, signs of brakes.
#pragma once

#include <passive_haptics_python/mechanisms.hpp>

#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/design/fme_boundary.hpp>
#include <passive_haptics/force/nearest_force.hpp>

#include <pybind11/eigen.h>

namespace passive_haptics_python {

/// The value of an enumeration as the IntEnum of the package.
template <class E>
py::object enumerated(const char* name, E value) {
  return py::module_::import("passive_haptics.results").attr(name)(int(value));
}

namespace detail {

// brake_signs of a state with or without a hand force.
template <class X>
numbers signs_of(const X& x, py::handle q, py::handle qd, py::handle hand_force, const py::object& given) {
  using M = std::remove_cvref_t<decltype(x.model())>;
  const ph::joint_vector<M> at = vector_from<M::dof>(q, "q"), rates = vector_from<M::dof>(qd, "qd");
  ph::task_vector<M> Fh = ph::task_vector<M>::Zero();
  if (!hand_force.is_none()) Fh = vector_from<M::task_dimension>(hand_force, "hand_force");
  const ph::brakes_of<M> of = given.is_none() ? ph::brakes_of<M>() : X::brakes_from(given);
  const auto E = ph::brake_jacobian(x.model(), at);
  const ph::brake_vector<M> th = ph::brake_torque(E, Fh);
  return ph::brake_signs(ph::brake_rates(x.model(), at, rates), th, of);
}

// The passive FMEs of two brakes in the plane: signs and outline of each.
template <class M>
py::list passive_fmes(const M& model, py::handle q, int segments) {
  if (segments < 1) refuse_value("segments = " + std::to_string(segments) + ", expected 1 or more");
  const auto set = ph::reference_forces(model, vector_from<2>(q, "q"));
  py::list all;
  for (const auto& region : ph::passive_fme_regions<2>()) {
    const auto outline = ph::passive_fme_outline<double>(set.G, region, segments);
    py::array_t<double> points({py::ssize_t(outline.size()), py::ssize_t(2)});
    auto at = points.mutable_unchecked<2>();
    for (std::size_t k = 0; k < outline.size(); ++k)
      for (int i = 0; i < 2; ++i) at(py::ssize_t(k), i) = outline[k][i];
    all.append(py::make_tuple(py::make_tuple(region[0], region[1]), points));
  }
  return all;
}

}  // namespace detail

/// Binds them to the class of mechanism M; those of which the library has none for such a device are left
/// out.
template <class X, class... Options>
void bind_forces(py::class_<X, Options...>& bound) {
  using M = std::remove_cvref_t<decltype(std::declval<const X&>().model())>;
  constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  bound.def("brake_signs", &detail::signs_of<X>, py::arg("q"), py::arg("qd"),
            py::arg("hand_force") = py::none(), py::arg("brakes") = py::none(),
            "brake_signs(self, q: Numbers, qd: Numbers, hand_force: Numbers | None = ..., brakes: "
            "brake_parameters | None = ...) "
            "-> Array\n\nThe signs of the brakes: those of their rates, at rest those of the hand's torque.");
  if constexpr (n == d && m == n) {
    bound.def(
        "reference_forces",
        [](const X& x, py::handle q) {
          const auto set = ph::reference_forces(x.model(), vector_from<n>(q, "q"));
          return py::make_tuple(ph::matrix<double, d, m>(set.G), enumerated("status", set.outcome));
        },
        py::arg("q"),
        "reference_forces(self, q: Numbers) -> tuple[Array, status]\n\nThe forces of unit torques, a column "
        "for "
        "each brake [N per N m] (6); NaN unless the status is ok.");
    bound.def(
        "nearest_force",
        [](const X& x, py::handle q, py::handle signs, py::handle desired) {
          const auto E = ph::brake_jacobian(x.model(), ph::joint_vector<M>(vector_from<n>(q, "q")));
          const ph::vector<double, m> s = vector_from<m>(signs, "signs");
          const ph::vector<double, d> Fd = vector_from<d>(desired, "desired_force");
          return ph::vector<double, d>(ph::nearest_force(E, s, Fd).force);
        },
        py::arg("q"), py::arg("signs"), py::arg("desired_force"),
        "nearest_force(self, q: Numbers, signs: Numbers, desired_force: Numbers) -> Array\n\nThe force [N] "
        "nearest "
        "to the desired one that brakes of these signs can make.");
  }
  if constexpr (n == 2 && d == 2 && m == 2) {
    bound.def(
        "passive_fme",
        [](const X& x, py::handle q, int segments) { return detail::passive_fmes(x.model(), q, segments); },
        py::arg("q"), py::arg("segments") = 32,
        "passive_fme(self, q: Numbers, segments: int = ...) -> list[tuple[tuple[int, int], Array]]\n\nThe "
        "four passive "
        "FMEs: the signs of the torques, and the closed outline [N] as K rows of 2 numbers. NaN at a "
        "singular pose.");
  }
}

}  // namespace passive_haptics_python
