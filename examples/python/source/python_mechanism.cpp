// A mechanism with functions written in Python, for python_mechanism.py of the package.
#include "devices.hpp"

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>

#include <pybind11/eigen.h>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics_python {
namespace {

// The functions of a user, None where there is none.
struct callables {
  py::object position;           // q -> x
  py::object jacobian;           // q -> J
  py::object mass_matrix;        // q -> M
  py::object bias_torque;        // q, qd -> c
  py::object bias_acceleration;  // q, qd -> Jd qd
  bool is_checked = false;       // Or they are still to be compared with each other.
};

template <int R, int C>
ph::matrix<double, R, C> matrix_of(py::handle x, const std::string& name) {
  const numbers_array rows = matrix_from(x, name, R, C);
  return Eigen::Matrix<double, R, C, Eigen::RowMajor>::Map(rows.data());
}

// The mechanism of N joints and D task dimensions that these functions are, a brake on each joint. Calls
// them under Python's lock. Where a deferred_error keeps their exceptions, what they return is NaN.
template <int N, int D, bool HasInertia>
class python_functions {
 public:
  using scalar = double;                                              // Scalar of all lengths and angles.
  static constexpr int dof = N, task_dimension = D, brake_count = N;  // n, d and m.
  using joints = ph::vector<double, N>;                               // [rad or m] or rates of them.
  using task = ph::vector<double, D>;                                 // [m] or [m/s^2].
  using d_by_n = ph::matrix<double, D, N>;                            // J or J^-T.
  using n_by_n = ph::matrix<double, N, N>;                            // M

  // Of these functions.
  explicit python_functions(callables of) : of_(std::make_shared<callables>(std::move(of))) {}

  // End effector [m], base frame.
  task position(const joints& q) const {
    return guarded<task>([&] { return vector_of<D>(of_->position(array(q)), "position(q)"); });
  }
  // J [m/rad or 1], by central differences where there is no function.
  d_by_n jacobian(const joints& q) const {
    return guarded<d_by_n>([&] {
      check_once(q);
      return of_->jacobian.is_none() ? differences(q)
                                     : matrix_of<D, N>(of_->jacobian(array(q)), "jacobian(q)");
    });
  }
  // M [kg m^2, kg m or kg].
  n_by_n mass_matrix(const joints& q) const
    requires HasInertia
  {
    return guarded<n_by_n>([&] {
      check_once(q);
      const py::object given = of_->mass_matrix(array(q));
      const n_by_n M = matrix_of<N, N>(given, "mass_matrix(q)");
      if (M.allFinite() && !(M.isApprox(M.transpose(), tolerance) && M.llt().info() == Eigen::Success))
        refuse_value("mass_matrix(q) = " + shown(given) + ": expected a symmetric matrix, positive definite");
      return M;
    });
  }
  // c [N m or N].
  joints bias_torque(const joints& q, const joints& qd) const
    requires HasInertia
  {
    return guarded<joints>(
        [&] { return vector_of<N>(of_->bias_torque(array(q), array(qd)), "bias_torque(q, qd)"); });
  }
  // Jd qd [m/s^2].
  task bias_acceleration(const joints& q, const joints& qd) const
    requires HasInertia
  {
    return guarded<task>([&] {
      return vector_of<D>(of_->bias_acceleration(array(q), array(qd)), "bias_acceleration(q, qd)");
    });
  }

 private:
  static constexpr double tolerance = 1e-4;  // relative

  // At the first finite q, throws ValueError with the entry of J that is not the central difference of the
  // position. If x or J is not finite, the cycle's status reports it.
  void check_once(const joints& q) const {
    if (of_->is_checked || !q.allFinite()) return;
    const d_by_n expected = differences(q);
    const bool is_known = !of_->jacobian.is_none() && expected.allFinite();
    const d_by_n J = is_known ? matrix_of<D, N>(of_->jacobian(array(q)), "jacobian(q)") : expected;
    const double largest = expected.cwiseAbs().maxCoeff();
    for (int j = 0; J.allFinite() && j < N; ++j) {  // a column has a unit of its own
      const double size = std::max(expected.col(j).cwiseAbs().maxCoeff(), 0.01 * largest);
      for (int i = 0; i < D; ++i)
        if (!(std::abs(J(i, j) - expected(i, j)) <= tolerance * size))
          throw py::value_error(
              py::str(
                  "passive_haptics: jacobian(q)[{0}][{1}] = {2}: expected {3}, the slope of position(q)[{0}] "
                  "over q[{1}] at q = {4}; correct the function (a transposed matrix?), or pass check=False")
                  .format(i, j, J(i, j), expected(i, j), array(q)));
    }
    of_->is_checked = true;
  }

  static py::object array(const joints& x) { return array_of(x); }

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

template <int N, int D>
std::unique_ptr<rt::any_mechanism> mechanism_of(const callables& of) {
  if (of.mass_matrix.is_none())
    return std::make_unique<rt::mechanism_model<python_functions<N, D, false>>>(
        python_functions<N, D, false>(of));
  return std::make_unique<rt::mechanism_model<python_functions<N, D, true>>>(
      python_functions<N, D, true>(of));
}

mechanism made(py::handle dof, py::handle task_dimension, const py::object& position,
               const py::object& jacobian, const py::object& mass_matrix, const py::object& bias_torque,
               const py::object& bias_acceleration, bool is_trusted) {
  const int n = whole_number_from(dof, "dof"), d = whole_number_from(task_dimension, "task_dimension");
  const callables of{position, jacobian, mass_matrix, bias_torque, bias_acceleration, is_trusted};
  if (n == 2 && d == 2) return mechanism(mechanism_of<2, 2>(of));
  if (n == 3 && d == 2) return mechanism(mechanism_of<3, 2>(of));
  if (n == 4 && d == 2) return mechanism(mechanism_of<4, 2>(of));
  if (n == 3 && d == 3) return mechanism(mechanism_of<3, 3>(of));
  if (n == 6 && d == 3) return mechanism(mechanism_of<6, 3>(of));
  if (n == 7 && d == 3) return mechanism(mechanism_of<7, 3>(of));
  refuse_value(
      "dof = " + std::to_string(n) + " and task_dimension = " + std::to_string(d) +
      ": expected 2 and 2, 3 and 2, 4 and 2, 3 and 3, 6 and 3, or 7 and 3; add a mechanism of another size "
      "in C++, with add_mechanism");
}

}  // namespace

void bind_python_mechanism(py::module_& module) { module.def("python_mechanism", &made); }

}  // namespace passive_haptics_python
