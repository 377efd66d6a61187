// What there is to know of a device before it is built (passive_haptics/design).
#include <precompiled.hpp>

#include "devices.hpp"
#include "module.hpp"
#include "progress.hpp"

#include <passive_haptics/design/map/task_points.hpp>

#include <pybind11/eigen.h>

#include <limits>

namespace passive_haptics_python {
namespace {

// A wall made of brakes, as Python has it.
struct braked_wall_base {};
using braked_wall_value = table_value<braked_wall_base, ph::braked_wall>;

// Brakes that are all on, without limits where none are given, nor motors.
design_brakes design_brakes_of(const mechanism& of, const py::object& given, const py::object& motors) {
  const int m = of.device().sizes().brake_count;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  design_brakes all;
  if (given.is_none()) {
    all.torque_limit = all.torque_upper = numbers::Constant(m, infinity);
    all.torque_lower = numbers::Constant(m, -infinity);
    all.time_constant = numbers::Constant(m, ph::brake_parameters<double, 1>().time_constant[0]);
  } else {
    const brake_numbers known = brakes_for(of, given);
    all.torque_limit = known.torque_limit;
    all.time_constant = known.time_constant;
    all.torque_lower = known.torque_lower;
    all.torque_upper = known.torque_upper;
  }
  all.motor_limit = motors.is_none() ? numbers(numbers::Zero(m)) : any_numbers(motors, "motor_limit");
  for (int i = 0; i < all.motor_limit.size(); ++i)
    if (!(all.motor_limit[i] >= 0))
      refuse_value("motor_limit[" + std::to_string(i) + "] [N m] = " +
                   std::string(py::repr(py::float_(all.motor_limit[i]))) + ", expected a number >= 0");
  return all;
}

double push_of(double push) {
  if (push == push) return push;
  refuse_value("push [N] = nan, expected a number");
}

// Rows of places on a path: N x n, and a row of each direction for each place or one for all.
class rows_of_places {
 public:
  rows_of_places(const mechanism& of, py::handle q, py::handle direction, py::handle normal)
      : q_(matrix_from(q, "q", of.device().sizes().dof, -1)),
        direction_(matrix_from(direction, "direction", of.device().sizes().task_dimension, q_.rows())),
        normal_(matrix_from(normal, "normal", of.device().sizes().task_dimension, q_.rows())) {}
  py::ssize_t size() const { return q_.rows(); }
  path_values operator[](py::ssize_t k) const {
    return {q_.row(k).transpose(), row(direction_, k), row(normal_, k)};
  }

 private:
  using rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  static numbers row(const rows& x, py::ssize_t k) { return x.row(x.rows() == 1 ? 0 : k).transpose(); }
  // states: how many rows there must be unless it is one vector; -1: any number of rows.
  static rows matrix_from(py::handle x, const char* name, int width, py::ssize_t states) {
    const std::string expected = ", expected (N, " + std::to_string(width) + ")";
    if (states >= 0 && (PyList_Check(x.ptr()) || PyTuple_Check(x.ptr()) ||
                        (py::isinstance<py::array>(x) && py::reinterpret_borrow<py::array>(x).ndim() == 1))) {
      const numbers one = any_numbers(x, name);
      if (one.size() != width)
        refuse_value("length of " + std::string(name) + " = " + std::to_string(one.size()) + ", expected " +
                     std::to_string(width));
      return one.transpose();
    }
    if (!py::isinstance<py::array>(x))
      refuse_type(std::string(name) + " = " + shown(x) +
                  ", expected a numpy.ndarray of float64, a row for "
                  "each place");
    const py::array array = plain_array(x, name);
    if (array.dtype().kind() != 'f' || array.dtype().itemsize() != py::ssize_t(sizeof(double)))
      refuse_type(std::string(name) + " has dtype " + dtype_of(array) + ", expected float64: " + name +
                  ".astype(float)");
    if (array.ndim() != 2 || array.shape(1) != width)
      refuse_value("shape of " + std::string(name) + " = " + std::string(py::str(array.attr("shape"))) +
                   expected + ", a row for each place");
    if (states >= 0 && array.shape(0) != states)
      refuse_value("number of rows of " + std::string(name) + " = " + std::to_string(array.shape(0)) +
                   ", expected " + std::to_string(states) + ", as q has");
    if (array.shape(0) > py::ssize_t(ph::max_task_points))
      refuse_value("number of rows of " + std::string(name) + " = " + std::to_string(array.shape(0)) +
                   ", expected at most " + std::to_string(ph::max_task_points) +
                   "; pass the places in parts");
    const py::array_t<double, py::array::forcecast> numbers_in(array);
    const auto at = numbers_in.unchecked<2>();
    rows all(array.shape(0), width);
    for (py::ssize_t k = 0; k < all.rows(); ++k)
      for (int i = 0; i < width; ++i) all(k, i) = at(k, i);
    return all;
  }

  rows q_, direction_, normal_;
};

// A row of a design map as it stands in the array.
struct figures_row {
  std::int32_t outcome, display;
  double cosine, drag, max_force, sink_slope, isotropy;
};

py::array map_of(const mechanism& of, py::handle q, py::handle direction, py::handle normal,
                 const py::object& given, double push, const py::object& motors) {
  constexpr py::ssize_t points_between_signals = 1 << 8;
  const rows_of_places places(of, q, direction, normal);
  const design_brakes brakes_there = design_brakes_of(of, given, motors);
  push_of(push);
  py::list fields;
  for (const char* name : {"outcome", "display"}) fields.append(py::make_tuple(name, "i4"));
  for (const char* name : {"cosine", "drag", "max_force", "sink_slope", "isotropy"})
    fields.append(py::make_tuple(name, "f8"));
  py::array rows(py::dtype::from_args(fields), std::vector<py::ssize_t>{places.size()});
  auto* const row = static_cast<figures_row*>(rows.mutable_data());
  progress shown(places.size(), "places");
  for (py::ssize_t k = 0; k < places.size(); ++k) {
    const auto f = of.device().design_figures(places[k], brakes_there, push);
    row[k] = {std::int32_t(f.outcome),
              std::int32_t(f.display),
              f.cosine,
              f.drag,
              f.max_force,
              f.sink_slope,
              f.isotropy};
    if (k % points_between_signals != 0) continue;
    let_others_run();
    shown.show(k);
  }
  return rows;
}

double depth_of(const mechanism& of, py::handle q, py::handle direction, py::handle normal,
                const py::object& given, double push, const py::object& motors) {
  const rows_of_places places(of, q, direction, normal);
  std::vector<path_values> path;
  for (py::ssize_t k = 0; k < places.size(); ++k) path.push_back(places[k]);
  return of.device().sink_depth(path, design_brakes_of(of, given, motors), push_of(push));
}

void bind_braked_wall(py::module_& module) {
  const std::string text =
      "(" + stub_arguments<ph::braked_wall>() +
      ")\n\nA wall at one place of a device, the hand that comes, and the control, along the "
      "wall's normal.\n\n" +
      parameter_lines<ph::braked_wall>();
  py::class_<braked_wall_value> bound(module, "braked_wall", text.c_str());
  add_value_protocol(bound, "braked_wall");
  module.def(
      "limits_of",
      [](py::handle wall) {
        const ph::wall_limits found = ph::limits_of(
            expect<braked_wall_value>(wall, "wall", "a braked_wall, as braked_wall_at() returns").table);
        return py::module_::import("passive_haptics.results")
            .attr("wall_limits")(found.depth, found.rigid_depth, found.stiffness, found.drift,
                                 found.pushed_out);
      },
      py::arg("wall"), "limits_of(wall: braked_wall) -> wall_limits\n\nWhat a wall made of brakes can be.");
}

}  // namespace

void bind_design(py::class_<mechanism>& bound) {
  bound
      .def(
          "displayable",
          [](const mechanism& m, py::handle q, py::handle velocity, py::handle normal,
             const py::object& given) {
            const path_values place{any_numbers(q, "q"), any_numbers(velocity, "velocity"),
                                    any_numbers(normal, "normal")};
            return m.device().displayable(place, design_brakes_of(m, given, py::none()));
          },
          py::arg("q"), py::arg("velocity"), py::arg("normal"), py::arg("brakes") = py::none(),
          "displayable(self, q: Numbers, velocity: Numbers, normal: Numbers, brakes: brake_parameters | None "
          "= ...) -> displayable_force\n\nWhat the brakes can display along the normal of a wall while the "
          "handle moves with a velocity (its direction counts). Brakes without limits where none are given.")
      .def(
          "sink_slope",
          [](const mechanism& m, py::handle q, py::handle direction, py::handle normal,
             const py::object& given, double push, const py::object& motors) {
            const path_values place{any_numbers(q, "q"), any_numbers(direction, "direction"),
                                    any_numbers(normal, "normal")};
            const auto found = m.device().sink_slope(place, design_brakes_of(m, given, motors), push);
            return py::make_tuple(found.slope, enumerated("status", found.outcome));
          },
          py::arg("q"), py::arg("direction"), py::arg("normal"), py::arg("brakes") = py::none(),
          py::arg("push") = 1.0, py::kw_only(), py::arg("motor_limit") = py::none(),
          "sink_slope(self, q: Numbers, direction: Numbers, normal: Numbers, brakes: brake_parameters | None "
          "= ..., push: float = ..., *, motor_limit: Numbers | None = ...) -> tuple[float, status]\n\nThe "
          "least slope [1], metres into a wall for each metre along it, at which the brakes resist a push "
          "[N] while a hand leads the end effector in this direction; infinite where they do at none. Brakes "
          "without limits where none are given. motor_limit: the torque of a motor beside each brake [N m].")
      .def("sink_depth", &depth_of, py::arg("q"), py::arg("direction"), py::arg("normal"),
           py::arg("brakes") = py::none(), py::arg("push") = 1.0, py::kw_only(),
           py::arg("motor_limit") = py::none(),
           "sink_depth(self, q: Array, direction: Numbers | Array, normal: Numbers | Array, brakes: "
           "brake_parameters | None = ..., push: float = ..., *, motor_limit: Numbers | None = ...) -> "
           "float\n\nThe depth [m] to which a hand that pushes [N] sinks on a path, at least. q: N x n joint "
           "positions at the middles of N >= 2 equal parts of the path; direction and normal of the wall "
           "there: N x d, or one vector for all.")
      .def("design_map", &map_of, py::arg("q"), py::arg("direction"), py::arg("normal"),
           py::arg("brakes") = py::none(), py::arg("push") = 1.0, py::kw_only(),
           py::arg("motor_limit") = py::none(),
           "design_map(self, q: Array, direction: Numbers | Array, normal: Numbers | Array, brakes: "
           "brake_parameters | None = ..., push: float = ..., *, motor_limit: Numbers | None = ...) -> "
           "Records\n\nThe figures of the device at N places of a task, an array with the fields outcome "
           "(status), display (display_class), cosine of gamma [1], drag for each newton that is displayed "
           "[1], strongest force along the normal [N], sink_slope [1] and isotropy of E [1]. q: N x n joint "
           "positions; direction of the motion and normal of the wall: N x d, or one vector for all. push "
           "[N]. N is at most 100 million. Ctrl-C ends it.")
      .def(
          "braked_wall_at",
          [](const mechanism& m, py::handle q, py::handle velocity, py::handle normal,
             const py::object& given, py::handle residual_torque, py::handle resolution, double hand_mass) {
            const path_values place{any_numbers(q, "q"), any_numbers(velocity, "velocity"),
                                    any_numbers(normal, "normal")};
            return braked_wall_value(
                m.device().braked_wall_at(place, design_brakes_of(m, given, py::none()),
                                          any_numbers(residual_torque, "residual_torque"),
                                          any_numbers(resolution, "resolution"), hand_mass));
          },
          py::arg("q"), py::arg("velocity"), py::arg("normal"), py::arg("brakes"), py::arg("residual_torque"),
          py::arg("resolution"), py::arg("hand_mass"),
          "braked_wall_at(self, q: Numbers, velocity: Numbers, normal: Numbers, brakes: brake_parameters, "
          "residual_torque: Numbers, resolution: Numbers, hand_mass: float) -> braked_wall\n\nThe wall of "
          "this normal that the brakes can make at q, touched with a velocity [m/s], for limits_of(). "
          "residual_torque [N m] of each brake, resolution: a count of each encoder [rad or m], hand_mass "
          "[kg]. Of a mechanism with inertia; TypeError for others.");
}

void bind_walls_of_brakes(py::module_& module) { bind_braked_wall(module); }

}  // namespace passive_haptics_python
