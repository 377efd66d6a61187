/// @file
/// Inverse kinematics in Python, and what else the sources of mechanisms share.
#pragma once

#include "../batches_at_walls.hpp"
#include "../module.hpp"

#include <passive_haptics_python/bind_mechanism.hpp>

#include <passive_haptics/mechanism/models/two_link.hpp>

namespace passive_haptics_python {

/// q and the status of a solution.
template <int N>
py::tuple solution(const ph::joint_solution<double, N>& found) {
  return py::make_tuple(numbers(found.q), enumerated("status", found.outcome));
}

/// The elbow that a text names.
inline ph::elbow elbow_from(const std::string& branch) {
  if (branch != "left" && branch != "right")
    refuse_value("branch = '" + branch + "', expected 'left' or 'right'");
  return branch == "left" ? ph::elbow::left : ph::elbow::right;
}

/// Binds inverse(x) by the mechanism's default branches. about: what it returns.
template <class X, class... Options>
void bind_usual_inverse(py::class_<X, Options...>& bound, const std::string& about) {
  using M = std::remove_cvref_t<decltype(std::declval<const X&>().model())>;
  bound.def(
      "inverse",
      [](const X& x, py::handle at) {
        return solution<M::dof>(x.model().inverse(vector_from<M::task_dimension>(at, "x")));
      },
      py::arg("x"),
      ("inverse(self, x: Numbers) -> tuple[Array, status]\n\n" + about + ", and whether it is in reach.")
          .c_str());
}

/// Binds inverse(x, branch) of a two-link arm.
template <class X, class... Options>
void bind_two_link_inverse(py::class_<X, Options...>& bound) {
  bound.def(
      "inverse",
      [](const X& x, py::handle at, const std::string& branch) {
        return solution<2>(x.model().inverse(vector_from<2>(at, "x"), elbow_from(branch)));
      },
      py::arg("x"), py::arg("branch") = "left",
      "inverse(self, x: Numbers, branch: Literal[\"left\", \"right\"] = ...) -> tuple[Array, "
      "status]\n\nJoint positions "
      "that put the handle at x [m], and whether it is in reach.");
}

}  // namespace passive_haptics_python
