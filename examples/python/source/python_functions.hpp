/// @file
/// A mechanism whose functions are written in Python.
#pragma once

#include "deferred_error.hpp"

#include <passive_haptics_python/from_python.hpp>

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>

#include <pybind11/eigen.h>
#include <Eigen/Cholesky>

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
  bool is_checked = false;       ///< Or they are still to be compared with each other.
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
  using n_by_n = ph::matrix<double, N, N>;                            ///< M

  /// Of these functions.
  explicit python_functions(callables of) : of_(std::make_shared<callables>(std::move(of))) {}

  /// End effector [m], base frame.
  task position(const joints& q) const {
    return guarded<task>([&] { return vector_from<D>(of_->position(array(q)), "position(q)"); });
  }
  /// J [m/rad or 1], by central differences where there is no function.
  d_by_n jacobian(const joints& q) const {
    return guarded<d_by_n>([&] {
      check_once(q);
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
  n_by_n mass_matrix(const joints& q) const {
    return guarded<n_by_n>([&] {
      check_once(q);
      return matrix_from<N, N>(of_->mass_matrix(array(q)), "mass_matrix(q)");
    });
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
  /// Compares the functions with each other at finite q. Throws ValueError with the entry of J that is not
  /// the central difference of the position, or the entry of M that is not symmetric. Throws it also for an M
  /// that is not positive definite, and for inertia that is not finite. If x or J is not finite, the cycle's
  /// status reports it.
  void check(const joints& q) const {
    if (!q.allFinite()) return;
    of_->is_checked = true;  // its own calls below need no check
    try {
      check_jacobian(q);
      if (!of_->mass_matrix.is_none()) check_inertia(q);
    } catch (...) {
      of_->is_checked = false;
      throw;
    }
  }

 private:
  static constexpr double tolerance = 1e-4;  // relative

  void check_once(const joints& q) const {
    if (!of_->is_checked) check(q);
  }
  void check_jacobian(const joints& q) const {
    const d_by_n expected = differences(q);
    if (of_->jacobian.is_none() || !expected.allFinite()) return;
    const d_by_n J = jacobian(q);
    if (!J.allFinite()) return;
    const double largest = expected.cwiseAbs().maxCoeff();
    for (int j = 0; j < N; ++j) {  // a column has a unit of its own
      const double size = std::max(expected.col(j).cwiseAbs().maxCoeff(), 0.01 * largest);
      for (int i = 0; i < D; ++i)
        if (!(std::abs(J(i, j) - expected(i, j)) <= tolerance * size))
          refuse_value(entry("jacobian(q)", i, j, J(i, j)) + ", expected " + shown_number(expected(i, j)) +
                       ", the slope of position(q)[" + std::to_string(i) + "] over q[" + std::to_string(j) +
                       "] at q = " + std::string(py::str(array(q))) +
                       "; correct the function (a transposed matrix?), or pass check=False");
    }
  }
  void check_inertia(const joints& q) const {
    const n_by_n M = mass_matrix(q);
    const auto expect_finite = [](const auto& x, const char* name) {
      for (int i = 0; i < x.size(); ++i)
        if (!std::isfinite(x[i]))
          refuse_value(std::string(name) + "[" + std::to_string(i) + "] = " + shown_number(x[i]) +
                       ", expected a finite number");
    };
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) {
        if (!std::isfinite(M(i, j)))
          refuse_value(entry("mass_matrix(q)", i, j, M(i, j)) + ", expected a finite number");
        if (!(std::abs(M(i, j) - M(j, i)) <= tolerance * std::sqrt(std::abs(M(i, i) * M(j, j)))))
          refuse_value(entry("mass_matrix(q)", i, j, M(i, j)) + ", expected " + shown_number(M(j, i)) +
                       ", as the matrix is symmetric; correct the function, or pass check=False");
      }
    }
    if (Eigen::LLT<n_by_n>(M).info() != Eigen::Success)
      refuse_value("mass_matrix(q) = " + shown(py::cast(M)) +
                   ", expected a positive definite matrix; correct the function, or pass check=False");
    expect_finite(bias_torque(q, joints::Zero()), "bias_torque(q, qd)");
    expect_finite(bias_acceleration(q, joints::Zero()), "bias_acceleration(q, qd)");
  }
  static std::string shown_number(double x) { return py::str(py::float_(x)); }
  static std::string entry(const char* name, int i, int j, double x) {
    return std::string(name) + "[" + std::to_string(i) + "][" + std::to_string(j) + "] = " + shown_number(x);
  }

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

  // With the step that leaves about as much rounding as it cuts off. Not finite at a q so large that the step
  // is lost in its rounding.
  d_by_n differences(const joints& q) const {
    const double step = std::cbrt(std::numeric_limits<double>::epsilon());
    d_by_n J;
    for (int i = 0; i < N; ++i) {
      joints above = q, below = q;
      above[i] += step;
      below[i] -= step;
      J.col(i) = (position(above) - position(below)) / (above[i] - below[i]);
    }
    return J;
  }

  std::shared_ptr<callables> of_;
};

}  // namespace passive_haptics_python
