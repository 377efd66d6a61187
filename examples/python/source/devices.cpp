// Mechanisms, states and controllers, for devices.py and controllers.py of the package.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>
#include <catalogue/designs.hpp>

#include <passive_haptics/runtime/device_file/device_description.hpp>

#include <pybind11/stl.h>

#include <cstring>

namespace passive_haptics_python {

mechanism::mechanism(std::unique_ptr<rt::any_mechanism> of)
    : held(std::move(of)), design(example::designs().make(*held)) {}

const rt::any_design& mechanism::functions() const {
  if (design) return *design;
  refuse_type("a mechanism of " + std::to_string(sizes().dof) + " joints, " +
              std::to_string(sizes().brake_count) + " brakes and " + std::to_string(sizes().task_dimension) +
              " task dimensions: expected one of a kind that the package has functions for");
}

std::unique_ptr<bool, void (*)(bool*)> only_call(bool& is_called) {
  if (is_called)
    refuse_value(
        "the controller is called while a function of its mechanism runs: expected one call at a time: make "
        "a controller for each thread, and call none from such a function");
  is_called = true;
  return {&is_called, [](bool* flag) { *flag = false; }};
}

rt::cycle_record controller::step(const rt::state_view& state) {
  const rt::device_sizes sizes = held_->sizes();
  require_length("q", state.q.size(), std::size_t(sizes.dof));
  require_length("qd", state.qd.size(), std::size_t(sizes.dof));
  if (!state.hand_force.empty())
    require_length("hand_force", state.hand_force.size(), std::size_t(sizes.task_dimension));
  else if (held_->needs_hand_force())
    refuse_value("hand_force = None: expected a force [N]: the law needs one; or use a law that needs none");
  const auto called = only_call(is_called_);
  deferred_error errors;
  const rt::cycle_record record = (*held_)(state);
  errors.rethrow();
  return record;
}

namespace {

// ---- states and results

device_state made_state(py::handle time, py::handle q, py::handle qd, py::handle hand_force) {
  device_state s{number_from(time, "time"), vector_from(q, "q"), vector_from(qd, "qd"), {}};
  if (!hand_force.is_none()) s.hand_force = vector_from(hand_force, "hand_force");
  return s;
}

// All values of a result of a batch too, in the order of the class.
template <class R, class F>
void for_each_value(R& r, F&& f) {
  f("capacity", r.capacity, "Array: The most each brake may hold [N m], to be commanded.");
  f("torque", r.torque, "Array: What the mechanism is predicted to feel (3) [N m].");
  f("outcome", r.outcome, "status: ok, or why the brakes were released.");
  f("power", r.power, "power_class: Of the desired force.");
  f("display", r.display, "display_class: How Fd is displayed.");
  f("saturated", r.saturated, "bool: True if a torque limit was reached.");
  f("wall_number", r.wall_number, "int: Wall that demands the force; -1 in free space.");
  f("alpha", r.alpha, "float: Scale factor of the law (12).");
  f("approximation_cosine", r.approximation_cosine, "float: cos(gamma).");
  f("desired_force", r.desired_force, "Array: Fd [N], base frame.");
  f("control_force", r.control_force, "Array: Fc [N], base frame, before alpha and limits.");
  f("cone_coefficients", r.cone_coefficients, "Array: Torques that make Fc [N m].");
  f("signs", r.signs, "Array: s, -1, 0 or 1 of each brake.");
}

template <int Max>
py::object to_object(const rt::few_numbers<Max>& x) {
  return array_of(x);
}
py::object to_object(bool x) { return py::bool_(x); }
py::object to_object(int x) { return py::int_(x); }
py::object to_object(double x) { return py::float_(x); }
py::object to_object(ph::status x) { return enumerated("status", x); }
py::object to_object(ph::power_class x) { return enumerated("power_class", x); }
py::object to_object(ph::display_class x) { return enumerated("display_class", x); }

py::list reports(const rt::cycle_record& r) {
  const py::object report = py::module_::import("passive_haptics.results").attr("contact_report");
  py::list all;
  for (int i = 0; i < r.contact_count; ++i) {
    const auto& c = r.contacts[static_cast<std::size_t>(i)];
    all.append(report(c.wall_number, c.wanted, c.displayed, c.has_priority));
  }
  return all;
}

void bind_results(py::module_& module) {
  using S = device_state;
  const auto force_of = [](const S& s) {
    return s.hand_force.empty() ? py::none() : py::object(array_of(s.hand_force));
  };
  py::class_<S>(
      module, "device_state",
      "What a device measures, once a control cycle.\n\nParameters\n----------\ntime : float [s]\n    Of a "
      "clock that does not jump.\nq, qd : n numbers\n    Joint positions [rad or m] and rates.\nhand_force : "
      "d numbers [N]\n    Of the hand on the handle, base frame; None without a force sensor.")
      .def(py::init(&made_state), py::arg("time"), py::arg("q"), py::arg("qd"),
           py::arg("hand_force") = py::none())
      .def_readonly("time", &S::time, "float: [s]")
      .def_property_readonly(
          "q", [](const S& s) { return array_of(s.q); }, "Array: Joint positions [rad or m].")
      .def_property_readonly(
          "qd", [](const S& s) { return array_of(s.qd); }, "Array: Joint rates [rad/s or m/s].")
      .def_property_readonly(
          "hand_force", force_of,
          "Array: Of the hand on the handle [N], base frame; None without a force sensor.");
  using R = rt::cycle_record;
  py::class_<R> result(module, "step_result", "What one control cycle decides, and why.");
  R layout;
  const auto bind = [&](const char* name, auto& member, const char* about) {
    const auto at = reinterpret_cast<const char*>(&member) - reinterpret_cast<const char*>(&layout);
    using V = std::remove_reference_t<decltype(member)>;
    result.def_property_readonly(
        name,
        [at](const R& r) {
          return to_object(*reinterpret_cast<const V*>(reinterpret_cast<const char*>(&r) + at));
        },
        about);
  };
  for_each_value(layout, bind);
  bind("settled_signs", layout.settled_signs,
       "Array: s* once the self-motion has settled; empty of a device without it.");
  bind("settled_velocity", layout.settled_velocity,
       "Array: v' [m/s], to which s* belongs; empty of a device without it.");
  result
      .def_property_readonly("contacts", &reports, "list[contact_report]: Each touched wall, under any law.")
      .def(py::pickle([](const R& r) { return py::bytes(reinterpret_cast<const char*>(&r), sizeof r); },
                      [](const py::bytes& pickled) {
                        const std::string content = pickled;
                        if (content.size() != sizeof(R))
                          refuse_value("a pickled step_result of another version: expected one of this one");
                        R r;
                        std::memcpy(static_cast<void*>(&r), content.data(), sizeof r);
                        return r;
                      }));
  py::list fields;
  for_each_value(layout, [&](const char* name, auto&, const char*) { fields.append(name); });
  module.attr("BATCH_FIELDS") = py::tuple(fields);
}

// ---- mechanisms and controllers

rt::brake_numbers brakes_of(const named& n) { return n.table.as<rt::brake_numbers>(); }

py::array positions(const mechanism& m, py::handle q) {
  const rows_of rows(q, "q", m.sizes().dof);
  return by_rows(rows, {m.sizes().task_dimension}, [&](py::ssize_t k) { return m.held->position(rows[k]); });
}
py::array jacobians(const mechanism& m, py::handle q) {
  const auto [n, d, brakes] = m.sizes();
  const rows_of rows(q, "q", n);
  Eigen::MatrixXd J(d, n);
  return by_rows(rows, {d, n}, [&](py::ssize_t k) -> Eigen::MatrixXd {
    m.held->jacobian(rows[k], {J.data(), std::size_t(J.size())});
    return J.transpose();  // row by row
  });
}
py::array brake_rates(const mechanism& m, py::handle q, py::handle qd) {
  const rows_of rows(q, "q", m.sizes().dof), rates(qd, "qd", m.sizes().dof, rows);
  return by_rows(rows, {m.sizes().brake_count},
                 [&](py::ssize_t k) { return m.held->brake_rates(rows[k], rates[k]); });
}
// Joint positions and whole numbers of the statuses; None where the mechanism has no formula.
py::object inverse(const mechanism& m, py::handle x, bool is_right) {
  const rows_of rows(x, "x", m.sizes().task_dimension);
  auto outcomes = results_for<int>(rows, {});
  bool has_inverse = true;
  const auto q = by_rows(rows, {m.sizes().dof}, [&](py::ssize_t k) {
    const auto found = m.held->solve(rows[k], is_right ? ph::elbow::right : ph::elbow::left);
    has_inverse = found.has_inverse;
    outcomes.mutable_data()[k] = static_cast<int>(found.outcome);
    return found.q;
  });
  return has_inverse ? py::object(py::make_tuple(q, outcomes)) : py::none();
}

std::unique_ptr<controller> made_controller(const mechanism& m, const named& brakes, const scene& walls,
                                            const named& law, const named& options) {
  const rt::catalogue& all = example::catalogue();
  const rt::law_entry& entry = *rt::find(all.laws(), law.name);
  if (entry.needs_dynamics && !m.held->has_inertia())
    refuse_type("law = " + law.name + ": expected another law: it needs the mechanism's inertia");
  if (!all.is_compiled(*m.held, entry))
    refuse_type("law = " + law.name +
                ": expected a mechanism of a kind that the package has controllers for");
  return std::make_unique<controller>(all.make_controller(
      *m.held, entry,
      {brakes_of(brakes), walls.held, law.table, options.table.as<rt::cycle_options>().for_controller()}));
}

}  // namespace

void bind_devices(py::module_& module) {
  bind_results(module);
  py::class_<mechanism> bound(module, "mechanism");
  bound
      .def(py::init([](const named& n) {
        return mechanism(rt::find(example::catalogue().mechanisms(), n.name)->make(n.table));
      }))
      .def("sizes",
           [](const mechanism& m) {
             return py::make_tuple(m.sizes().dof, m.sizes().task_dimension, m.sizes().brake_count);
           })
      .def("has_inertia", [](const mechanism& m) { return m.held->has_inertia(); })
      .def("position", &positions)
      .def("jacobian", &jacobians)
      .def("brake_rates", &brake_rates)
      .def("inverse", &inverse);
  bind_design(bound);
  py::class_<controller>(module, "controller")
      .def(py::init(&made_controller))
      .def("step", [](controller& c, const device_state& s) { return c.step(s); })
      .def("step", [](controller&,
                      py::handle s) { refuse_type("state = " + shown(s) + ": expected a device_state"); })
      .def("batch", &run_batch)
      .def("set_brakes", [](controller& c, const named& brakes) { c.set_brakes(brakes_of(brakes)); })
      .def("reset", &controller::reset);
}

}  // namespace passive_haptics_python
