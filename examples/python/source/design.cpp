// Functions of a device before it is built, and its simulation, for devices.py and simulations.py of the
// package.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>

#include <passive_haptics/design/fme_boundary.hpp>

#include <pybind11/stl.h>

#include <bit>
#include <cstdint>

namespace passive_haptics_python {
namespace {

rt::brake_numbers brakes_of(const named& n) { return n.table.as<rt::brake_numbers>(); }

// Places on a path: vectors of Python, or a row for each.
struct places {
  rows_of q, direction, normal;
  places(const mechanism& m, py::handle q_, py::handle direction_, py::handle normal_, const char* way)
      : q(q_, "q", m.sizes().dof),
        direction(direction_, way, m.sizes().task_dimension),
        normal(normal_, "normal", m.sizes().task_dimension) {
    const auto check = [&](const rows_of& rows, const char* name) {
      if (!rows.is_one() && rows.size() != q.size())
        refuse_value("number of rows of " + std::string(name) + " = " + std::to_string(rows.size()) +
                     ": expected " + std::to_string(q.size()) + ", as q has");
    };
    check(direction, way);
    check(normal, "normal");
  }
  rt::path_place operator[](py::ssize_t k) const { return {q[k], direction[k], normal[k]}; }
};

rt::design_brakes without_motors(const named& brakes) {
  rt::design_brakes all{brakes_of(brakes), {}};
  all.motor_limit.assign(all.brakes.torque_limit.size(), 0);
  return all;
}

// outcome, display, angle, max_force, max_approximated_force and signs of each place.
py::tuple displayable(const mechanism& m, py::handle q, py::handle velocity, py::handle normal,
                      const named& brakes) {
  const places at(m, q, velocity, normal, "velocity");
  const rt::brake_numbers of = brakes_of(brakes);
  const int count = m.sizes().brake_count;
  auto outcome = results_for<int>(at.q, {}), display = results_for<int>(at.q, {});
  auto angle = results_for(at.q, {}), force = results_for(at.q, {}), approximated = results_for(at.q, {});
  auto signs = results_for(at.q, {count});
  for (py::ssize_t k = 0; k < at.q.size(); ++k) {
    const auto found = m.functions().displayable(at[k], of);
    outcome.mutable_data()[k] = static_cast<int>(found.outcome);
    display.mutable_data()[k] = static_cast<int>(found.display);
    angle.mutable_data()[k] = found.angle;
    force.mutable_data()[k] = found.max_force;
    approximated.mutable_data()[k] = found.max_approximated_force;
    std::copy_n(found.signs.data(), count, signs.mutable_data() + k * count);
  }
  return py::make_tuple(outcome, display, angle, force, approximated, signs);
}

// A row of a design map as it stands in the array.
struct figures_row {
  std::int32_t outcome, display;
  double cosine, drag, max_force, sink_slope, isotropy;
};

// Fills the rows of a structured array; calls tick(k) now and then.
void map_of(const mechanism& m, py::handle q, py::handle direction, py::handle normal, const named& brakes,
            double push, py::array rows, const py::object& tick) {
  constexpr py::ssize_t places_between_signals = 1 << 8;
  const places at(m, q, direction, normal, "direction");
  const rt::design_brakes of = without_motors(brakes);
  auto* const row = static_cast<figures_row*>(rows.mutable_data());
  for (py::ssize_t k = 0; k < at.q.size(); ++k) {
    const auto f = m.functions().figures(at[k], of, push);
    row[k] = {static_cast<std::int32_t>(f.outcome),
              static_cast<std::int32_t>(f.display),
              f.cosine,
              f.drag,
              f.max_force,
              f.sink_slope,
              f.isotropy};
    if (k % places_between_signals != 0) continue;
    let_others_run();
    tick(k);
  }
}

double depth_of(const mechanism& m, py::handle q, py::handle direction, py::handle normal,
                const named& brakes, double push) {
  const places at(m, q, direction, normal, "direction");
  std::vector<rt::path_place> path;
  for (py::ssize_t k = 0; k < at.q.size(); ++k) path.push_back(at[k]);
  return m.functions().sink_depth(path, without_motors(brakes), push);
}

py::tuple references_of(const mechanism& m, py::handle q) {
  const auto set = m.functions().reference_forces(vector_from(q, "q", m.sizes().dof));
  const auto [n, d, count] = m.sizes();
  py::array_t<double> G({d, count});
  for (int i = 0; i < d; ++i)
    for (int j = 0; j < count; ++j) G.mutable_at(i, j) = set.G[static_cast<std::size_t>(i + d * j)];
  return py::make_tuple(G, enumerated("status", set.outcome));
}

py::list fmes_of(const mechanism& m, py::handle q, int segments) {
  const auto set = m.functions().reference_forces(vector_from(q, "q", 2));
  const ph::matrix<double, 2, 2> G(set.G.data());
  py::list all;
  for (const auto& region : ph::passive_fme_regions<2>()) {
    const auto outline = ph::passive_fme_outline<double>(G, region, segments);
    py::array_t<double> points({py::ssize_t(outline.size()), py::ssize_t(2)});
    for (std::size_t k = 0; k < outline.size(); ++k)
      for (int i = 0; i < 2; ++i) points.mutable_at(py::ssize_t(k), i) = outline[k][i];
    all.append(py::make_tuple(py::make_tuple(region[0], region[1]), points));
  }
  return all;
}

// ---- simulations

// Time steps as rows of 8-byte numbers: doubles, and whole numbers in the same width.
class recorder {
 public:
  recorder(bool is_wanted, const py::object& tick) : is_wanted_(is_wanted), tick_(tick) {}
  void see(const rt::following_record& now) {
    constexpr int steps_between_signals = 1 << 10;
    if (++steps_ % steps_between_signals == 0) {
      let_others_run();
      tick_(now.time);
    }
    if (!is_wanted_) return;
    const rt::cycle_record& c = *now.control;
    for (const double x : {now.time, now.depth}) numbers_.push_back(x);
    for (const std::span<const double> v :
         {std::span<const double>(now.position), std::span<const double>(now.velocity),
          std::span<const double>(now.rates), std::span<const double>(now.brake_torque),
          std::span<const double>(now.brake_power), std::span<const double>(now.hand_force),
          std::span<const double>(now.brake_force), std::span<const double>(c.capacity)})
      numbers_.insert(numbers_.end(), v.begin(), v.end());
    numbers_.push_back(c.alpha);
    for (const int whole : {static_cast<int>(c.outcome), static_cast<int>(c.power),
                            static_cast<int>(c.display), static_cast<int>(c.saturated), c.wall_number})
      numbers_.push_back(std::bit_cast<double>(std::int64_t(whole)));
  }
  const std::vector<double>& numbers() const { return numbers_; }

 private:
  bool is_wanted_;
  py::object tick_;
  long steps_ = 0;
  std::vector<double> numbers_;
};

rt::hand_description hand_of(const named& n, py::handle direction, py::handle start) {
  return {vector_from(direction, "direction"), vector_from(start, "start"),
          n.table.as<ph::following_hand_parameters<double>>()};
}

py::array hand_force(const named& n, py::handle direction, py::handle start, double time, py::handle x,
                     py::handle v, py::handle normal, double depth) {
  const rt::hand_description of = hand_of(n, direction, start);
  const auto force = [&]<int D>() -> py::array {
    const auto task = [&](py::handle vector, const char* name) {
      return ph::vector<double, D>(vector_from(vector, name, D).data());
    };
    return array_of(
        of.hand<D>().force(time, task(x, "position"), task(v, "velocity"), task(normal, "normal"), depth));
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

py::tuple follow(const mechanism& m, rt::any_plant& plant, controller& control, const shape& of_shape,
                 const named& hand, py::handle direction, py::handle start, const named& parameters,
                 bool is_recorded, const py::object& tick) {
  recorder seen(is_recorded, tick);
  const rt::shape_variant surface =
      std::visit([](const auto& s) -> rt::shape_variant { return *s.solid; }, of_shape.in);
  const auto f = m.functions().follow_wall(
      plant, [&](const rt::state_view& s) { return control.step(s); }, surface,
      hand_of(hand, direction, start), parameters.table.as<ph::wall_following_parameters>(),
      [&](const rt::following_record& now) { seen.see(now); });
  const py::module_ results = py::module_::import("passive_haptics.results");
  return py::make_tuple(
      results.attr("contact_metrics")(f.separations, f.recontacts, f.depth_mean, f.depth_std, f.depth_range,
                                      f.depth_drift, f.max_depth, f.stick_share, f.hand_force_std,
                                      f.retarding_force, f.brake_energy, f.max_brake_power, f.duration,
                                      f.arrived, f.touched, results.attr("run_end")(static_cast<int>(f.end))),
      array_of(seen.numbers()));
}

}  // namespace

void bind_design(py::class_<mechanism>& bound) {
  bound.def("has_reference_forces", [](const mechanism& m) { return m.functions().has_reference_forces(); })
      .def("brake_signs",
           [](const mechanism& m, py::handle q, py::handle qd, py::handle hand_force, const named& brakes) {
             const auto [n, d, count] = m.sizes();
             std::vector<double> force;
             if (!hand_force.is_none()) force = vector_from(hand_force, "hand_force", d);
             return array_of(m.functions().brake_signs(vector_from(q, "q", n), vector_from(qd, "qd", n),
                                                       force, brakes_of(brakes)));
           })
      .def("reference_forces", &references_of)
      .def("nearest_force",
           [](const mechanism& m, py::handle q, py::handle signs, py::handle desired) {
             const auto [n, d, count] = m.sizes();
             return array_of(m.functions().nearest_force(vector_from(q, "q", n),
                                                         vector_from(signs, "signs", count),
                                                         vector_from(desired, "desired_force", d)));
           })
      .def("passive_fme", &fmes_of)
      .def("displayable", &displayable)
      .def("sink_depth", &depth_of)
      .def("design_map", &map_of);
}

void bind_simulations(py::module_& module) {
  using P = rt::any_plant;
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
  module.def("hand_force", &hand_force);
  module.def("follow_wall", &follow);
}

}  // namespace passive_haptics_python
