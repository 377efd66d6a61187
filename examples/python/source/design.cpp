// Functions of a device before it is built, and its simulation, for devices.py and simulations.py of the
// package.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/design/fme_boundary.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace passive_haptics_python {
namespace {

// Without brakes, torque limits are infinite.
rt::brake_numbers brakes_of(const mechanism& m, const named* n) {
  if (n != nullptr) return n->table.as<rt::brake_numbers>();
  rt::brake_numbers unlimited(m.sizes().brake_count);
  std::ranges::fill(unlimited.torque_limit, std::numeric_limits<double>::infinity());
  return unlimited;
}
rt::design_brakes without_motors(const mechanism& m, const named* brakes) {
  rt::design_brakes all{brakes_of(m, brakes), {}};
  all.motor_limit.assign(all.brakes.torque_limit.size(), 0);
  return all;
}

// Places on a path: vectors of Python, or a row for each.
struct places {
  rows_of q, direction, normal;
  places(const mechanism& m, py::handle q_, py::handle direction_, py::handle normal_, const char* way)
      : q(q_, "q", m.sizes().dof),
        direction(direction_, way, m.sizes().task_dimension, q),
        normal(normal_, "normal", m.sizes().task_dimension, q) {}
  rt::path_place operator[](py::ssize_t k) const { return {q[k], direction[k], normal[k]}; }
};

// Rows of structured arrays.
struct force_row {
  std::int32_t outcome, display;
  double angle, max_force, max_approximated_force;
};
struct figures_row {
  std::int32_t outcome, display;
  double cosine, drag, max_force, sink_slope, isotropy;
};

// A force_row, the nearest force and the signs of each place.
py::tuple displayable(const mechanism& m, py::handle q, py::handle velocity, py::handle normal,
                      const named* brakes) {
  const places at(m, q, velocity, normal, "velocity");
  const rt::brake_numbers of = brakes_of(m, brakes);
  const auto [n, d, count] = m.sizes();
  auto forces = results_for<force_row>(at.q, {});
  auto signs = results_for(at.q, {count});
  const auto nearest = by_rows(at.q, {d}, [&, count = count](py::ssize_t k) {
    const auto f = m.functions().displayable(at[k], of);
    forces.mutable_data()[k] = {int(f.outcome), int(f.display), f.angle, f.max_force,
                                f.max_approximated_force};
    std::copy_n(f.signs.data(), count, signs.mutable_data() + k * count);
    return f.nearest;
  });
  return py::make_tuple(forces, nearest, signs);
}

// A figures_row of each place.
py::array map_of(const mechanism& m, py::handle q, py::handle direction, py::handle normal,
                 const named* brakes, py::handle push) {
  const places at(m, q, direction, normal, "direction");
  const rt::design_brakes of = without_motors(m, brakes);
  return by_rows<figures_row>(at.q, {}, [&](py::ssize_t k) {
    const auto f = m.functions().figures(at[k], of, number_from(push, "push"));
    return std::array{
        figures_row{int(f.outcome), int(f.display), f.cosine, f.drag, f.max_force, f.sink_slope, f.isotropy}};
  });
}

double depth_of(const mechanism& m, py::handle q, py::handle direction, py::handle normal,
                const named* brakes, py::handle push) {
  const places at(m, q, direction, normal, "direction");
  std::vector<rt::path_place> path;
  for (py::ssize_t k = 0; k < at.q.size(); ++k) path.push_back(at[k]);
  return m.functions().sink_depth(path, without_motors(m, brakes), number_from(push, "push"));
}

py::tuple references_of(const mechanism& m, py::handle q) {
  const auto set = m.functions().reference_forces(vector_from(q, "q", m.sizes().dof));
  const auto [n, d, count] = m.sizes();
  py::array_t<double> G({d, count});
  Eigen::MatrixXd::Map(G.mutable_data(), count, d) = Eigen::MatrixXd::Map(set.G.data(), d, count).transpose();
  return py::make_tuple(G, enumerated("status", set.outcome));
}

py::list fmes_of(const mechanism& m, py::handle q, py::handle segments) {
  const auto set = m.functions().reference_forces(vector_from(q, "q", 2));
  const ph::matrix<double, 2, 2> G(set.G.data());
  py::list all;
  for (const auto& region : ph::passive_fme_regions<2>()) {
    const auto outline = ph::passive_fme_outline<double>(G, region, whole_number_from(segments, "segments"));
    const py::array_t<double> points({py::ssize_t(outline.size()), py::ssize_t(2)}, outline.front().data());
    all.append(py::make_tuple(py::make_tuple(region[0], region[1]), points));
  }
  return all;
}

// ---- simulations

rt::hand_description made_hand(const named& n, py::handle direction, py::handle start) {
  rt::hand_description of{vector_from(direction, "direction"), vector_from(start, "start"),
                          n.table.as<ph::following_hand_parameters<double>>()};
  const double length = Eigen::VectorXd::Map(of.direction.data(), std::ssize(of.direction)).norm();
  if (!(length > 0 && length < std::numeric_limits<double>::infinity()))
    refuse_value("length of the direction of a following_hand = " + std::to_string(length) +
                 ": expected a direction of finite length > 0");
  if (of.direction.size() == 2) of.hand<2>();
  else of.hand<3>();
  return of;
}

py::array hand_force(const rt::hand_description& of, py::handle time, py::handle x, py::handle v,
                     py::handle normal, py::handle depth) {
  const auto force = [&]<int D>() -> py::array {
    return array_of(of.hand<D>().force(number_from(time, "time"), vector_of<D>(x, "position"),
                                       vector_of<D>(v, "velocity"), vector_of<D>(normal, "normal"),
                                       number_from(depth, "depth")));
  };
  return of.direction.size() == 2 ? force.operator()<2>() : force.operator()<3>();
}

std::unique_ptr<rt::any_plant> made_plant(const mechanism& m, const std::vector<const named*>& models,
                                          double hand_mass, py::handle q) {
  std::vector<rt::run_time_brake> brakes;
  for (const named* n : models)
    brakes.push_back(rt::find(example::catalogue().brake_models(), n->name)->make(n->table));
  auto made = example::catalogue().make_plant(*m.held, brakes, hand_mass, vector_from(q, "q", m.sizes().dof));
  if (!made) refuse_type("simulated_device needs a mechanism with inertia; take one, such as two_link");
  return made;
}

// Figures, and the time steps as rows of 8-byte numbers: doubles, and whole numbers in the same width.
py::tuple follow(const mechanism& m, rt::any_plant& plant, controller& control, const shape& of_shape,
                 const rt::hand_description& hand, const named& parameters, bool is_recorded) {
  py::ssize_t steps = 0;
  std::vector<double> rows;
  const auto record = [&](const rt::following_record& now) {
    let_others_run(++steps);
    if (!is_recorded) return;
    const rt::cycle_record& c = *now.control;
    rows.insert(rows.end(), {now.time, now.depth});
    for (const std::span<const double> v : std::initializer_list<std::span<const double>>{
             now.position, now.velocity, now.rates, now.brake_torque, now.brake_power, now.hand_force,
             now.brake_force, c.capacity})
      rows.insert(rows.end(), v.begin(), v.end());
    rows.push_back(c.alpha);
    for (const std::int64_t whole :
         {int(c.outcome), int(c.power), int(c.display), int(c.saturated), c.wall_number})
      rows.push_back(std::bit_cast<double>(whole));
  };
  const rt::shape_variant surface =
      std::visit([](const auto& s) -> rt::shape_variant { return *s.solid; }, of_shape.in);
  const auto f = m.functions().follow_wall(
      plant, [&](const rt::state_view& s) { return control.step(s); }, surface, hand,
      parameters.table.as<ph::wall_following_parameters>(), record);
  const py::module_ results = py::module_::import("passive_haptics.results");
  return py::make_tuple(
      results.attr("contact_metrics")(f.separations, f.recontacts, f.depth_mean, f.depth_std, f.depth_range,
                                      f.depth_drift, f.max_depth, f.stick_share, f.hand_force_std,
                                      f.retarding_force, f.brake_energy, f.max_brake_power, f.duration,
                                      f.arrived, f.touched, enumerated("run_end", f.end)),
      array_of(rows));
}

}  // namespace

void bind_design(py::class_<mechanism>& bound) {
  bound
      .def("brake_signs",
           [](const mechanism& m, py::handle q, py::handle qd, py::handle hand_force, const named* brakes) {
             const auto [n, d, count] = m.sizes();
             std::vector<double> force;
             if (!hand_force.is_none()) force = vector_from(hand_force, "hand_force", d);
             return array_of(m.functions().brake_signs(vector_from(q, "q", n), vector_from(qd, "qd", n),
                                                       force, brakes_of(m, brakes)));
           })
      .def("reference_forces", &references_of)
      .def("nearest_force",
           [](const mechanism& m, py::handle q, py::handle signs, py::handle desired) {
             const auto [n, d, count] = m.sizes();
             const auto s = vector_from(signs, "signs", count);
             if (!std::ranges::all_of(s, [](double x) { return x == -1 || x == 0 || x == 1; }))
               refuse_value("signs = " + shown(signs) + ": expected -1, 0 or 1 for each brake");
             return array_of(m.functions().nearest_force(vector_from(q, "q", n), s,
                                                         vector_from(desired, "desired_force", d)));
           })
      .def("passive_fme", &fmes_of)
      .def("displayable", &displayable)
      .def("sink_depth", &depth_of)
      .def("design_map", &map_of);
}

void bind_simulations(py::module_& module) {
  using H = rt::hand_description;
  using P = rt::any_plant;
  PYBIND11_NUMPY_DTYPE(force_row, outcome, display, angle, max_force, max_approximated_force);
  PYBIND11_NUMPY_DTYPE(figures_row, outcome, display, cosine, drag, max_force, sink_slope, isotropy);
  py::class_<H>(module, "hand").def(py::init(&made_hand)).def("force", &hand_force);
  const auto numbers = [](auto get) { return [get](const P& p) { return array_of((p.*get)()); }; };
  py::class_<P>(module, "plant")
      .def(py::init(&made_plant))
      .def("advance",
           [](P& p, double dt, py::handle capacity, py::handle muscle_force) {
             p.advance(dt, vector_from(capacity, "capacity", static_cast<int>(p.rates().size())),
                       vector_from(muscle_force, "muscle_force", static_cast<int>(p.position().size())));
           })
      .def("set_motion",
           [](P& p, py::handle q, py::handle qd) {
             const auto n = static_cast<int>(p.q().size());
             p.set_motion(vector_from(q, "q", n), vector_from(qd, "qd", n));
           })
      .def("q", numbers(&P::q))
      .def("qd", numbers(&P::qd))
      .def("position", numbers(&P::position))
      .def("velocity", numbers(&P::velocity))
      .def("sensed_force", numbers(&P::sensed_force))
      .def("brake_torque", numbers(&P::brake_torque));
  module.def("follow_wall", &follow);
}

}  // namespace passive_haptics_python
