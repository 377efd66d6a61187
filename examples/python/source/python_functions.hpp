/// @file
/// A mechanism whose functions are written in Python.
#pragma once

#include "deferred_error.hpp"

#include <passive_haptics_python/from_python.hpp>

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>

#include <pybind11/eigen.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

namespace passive_haptics_python {

/// The functions of a user, None where there is none.
struct callables {
  py::object position;           ///< q -> x
  py::object jacobian;           ///< q -> J
  py::object mass_matrix;        ///< q -> M
  py::object bias_torque;        ///< q, qd -> c
  py::object bias_acceleration;  ///< q, qd -> Jd qd
};

/// x, an array or a list of rows of real numbers, as a matrix.
template <int R, int C>
ph::matrix<double, R, C> matrix_from(py::handle x, const std::string& name) {
  ph::matrix<double, R, C> m;
  if (PyList_Check(x.ptr()) || PyTuple_Check(x.ptr())) {
    const auto rows = py::reinterpret_borrow<py::sequence>(x);
    if (rows.size() != std::size_t(R))
      refuse_value("length of " + name + " = " + std::to_string(rows.size()) + ", expected " +
                   std::to_string(R) + " rows");
    for (int i = 0; i < R; ++i)
      m.row(i) =
          vector_from<C>(py::object(rows[std::size_t(i)]), name + "[" + std::to_string(i) + "]").transpose();
    return m;
  }
  const std::string expected =
      ", expected an array of " + std::to_string(R) + " x " + std::to_string(C) + " numbers";
  if (!py::isinstance<py::array>(x)) refuse_type(name + " = " + shown(x) + expected);
  const py::array array = plain_array(x, name);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    refuse_type(name + " has dtype " + dtype_of(array) + expected);
  if (array.ndim() != 2 || array.shape(0) != R || array.shape(1) != C)
    refuse_value("shape of " + name + " = " + std::string(py::str(array.attr("shape"))) + expected);
  const py::array_t<double, py::array::forcecast> numbers(array);
  const auto at = numbers.template unchecked<2>();
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) m(i, j) = at(i, j);
  return m;
}

/// The mechanism of N joints and D task dimensions that these functions are, a brake on each joint. Calls
/// them under Python's lock. Where a deferred_error keeps their exceptions, what they return is NaN.
template <int N, int D>
class python_functions {
 public:
  using scalar = double;                                              ///< Scalar of all lengths and angles.
  static constexpr int dof = N, task_dimension = D, brake_count = N;  ///< n, d and m.
  using joints = ph::vector<double, N>;                               ///< [rad or m] or rates of them.
  using task = ph::vector<double, D>;                                 ///< [m] or [m/s^2].
  using d_by_n = ph::matrix<double, D, N>;                            ///< J or J^-T.

  /// Of these functions.
  explicit python_functions(callables of) : of_(std::make_shared<const callables>(std::move(of))) {}

  /// End effector [m], base frame.
  task position(const joints& q) const {
    return guarded<task>([&] { return vector_from<D>(of_->position(array(q)), "position(q)"); });
  }
  /// J [m/rad or 1], by central differences where there is no function.
  d_by_n jacobian(const joints& q) const {
    return guarded<d_by_n>([&] {
      return of_->jacobian.is_none() ? differences(q)
                                     : matrix_from<D, N>(of_->jacobian(array(q)), "jacobian(q)");
    });
  }
  /// J^-T, with the bits that a mechanism without this function gets; NaN where J is singular.
  d_by_n inverse_transposed_jacobian(const joints& q) const
    requires(N == 2 && D == 2)
  {
    const ph::orthogonal_decomposition<double, N, N> of(ph::transposed(jacobian(q)), 0.0);
    if (of.rank() == N) return of.solve(d_by_n(d_by_n::Identity()));
    return d_by_n::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  /// M [kg m^2, kg m or kg].
  ph::matrix<double, N, N> mass_matrix(const joints& q) const {
    return guarded<ph::matrix<double, N, N>>(
        [&] { return matrix_from<N, N>(of_->mass_matrix(array(q)), "mass_matrix(q)"); });
  }
  /// c [N m or N].
  joints bias_torque(const joints& q, const joints& qd) const {
    return guarded<joints>(
        [&] { return vector_from<N>(of_->bias_torque(array(q), array(qd)), "bias_torque(q, qd)"); });
  }
  /// Jd qd [m/s^2].
  task bias_acceleration(const joints& q, const joints& qd) const {
    return guarded<task>([&] {
      return vector_from<D>(of_->bias_acceleration(array(q), array(qd)), "bias_acceleration(q, qd)");
    });
  }

 private:
  static py::object array(const joints& x) { return py::cast(x); }

  template <class Value, class F>
  static Value guarded(const F& f) {
    if (!deferred_error::is_kept()) {
      const py::gil_scoped_acquire locked;
      try {
        return f();
      } catch (...) {
        deferred_error::keep();
      }
    }
    return Value::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  // With the steps that leave about as much rounding as they cut off.
  d_by_n differences(const joints& q) const {
    d_by_n J;
    for (int i = 0; i < N; ++i) {
      const double step = std::cbrt(std::numeric_limits<double>::epsilon()) * std::max(1.0, std::abs(q[i]));
      joints above = q, below = q;
      above[i] += step;
      below[i] -= step;
      J.col(i) = (position(above) - position(below)) / (above[i] - below[i]);
    }
    return J;
  }

  std::shared_ptr<const callables> of_;
};

}  // namespace passive_haptics_python
