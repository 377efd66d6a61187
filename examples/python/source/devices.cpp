// Mechanisms, states, controllers and batches, for devices.py and controllers.py of the package.
#include "devices.hpp"

#include <catalogue/catalogue.hpp>
#include <catalogue/designs.hpp>

#include <passive_haptics/runtime/device_file/device_description.hpp>

#include <pybind11/stl.h>

#include <cmath>
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

only_call::only_call(bool& is_called) : is_called_(is_called) {
  if (is_called)
    refuse_value(
        "the controller is called while a function of its mechanism runs: expected one call at a time: make "
        "a controller for each thread, and call none from such a function");
  is_called = true;
}

rt::cycle_record controller::step(const rt::state_view& state) {
  const rt::device_sizes sizes = held_->sizes();
  const auto check = [](const char* name, std::size_t size, int expected) {
    if (std::ssize(std::span<const char>(name, size)) != expected)
      refuse_value(std::string("length of ") + name + " = " + std::to_string(size) + ": expected " +
                   std::to_string(expected));
  };
  check("q", state.q.size(), sizes.dof);
  check("qd", state.qd.size(), sizes.dof);
  if (!state.hand_force.empty()) check("hand_force", state.hand_force.size(), sizes.task_dimension);
  else if (held_->needs_hand_force())
    refuse_value("hand_force = None: expected a force [N]: the law needs one; or use a law that needs none");
  const only_call alone(is_called_);
  deferred_error errors;
  const rt::cycle_record record = (*held_)(state);
  errors.rethrow();
  return record;
}

namespace {

// ---- states and results

// Joint positions that are angles in degrees: a revolute joint turns less, and a slide is shorter.
void warn_of_degrees(std::span<const double> q) {
  constexpr double two_turns = 12.57, million = 1e6;
  for (const double x : q) {
    if (!(std::abs(x) > two_turns) || !(std::abs(x) < million)) continue;
    return warn("q has " + std::string(py::str(py::float_(x))) +
                ", usually within two turns: degrees? numpy.radians(q) makes radians of them");
  }
}

device_state made_state(py::handle time, py::handle q, py::handle qd, py::handle hand_force) {
  device_state s{number_from(time, "time"), vector_from(q, "q"), vector_from(qd, "qd"), {}};
  if (!hand_force.is_none()) s.hand_force = vector_from(hand_force, "hand_force");
  warn_of_degrees(s.q);
  return s;
}

// All values of a result, in the order of the class. 'm', 'd': as many numbers as brakes or task dimensions.
template <class R, class F>
void for_each_value(R& r, F&& f) {
  f("capacity", r.capacity, 'm', "Array: The most each brake may hold [N m], to be commanded.");
  f("torque", r.torque, 'm', "Array: What the mechanism is predicted to feel (3) [N m].");
  f("outcome", r.outcome, '1', "status: ok, or why the brakes were released.");
  f("power", r.power, '1', "power_class: Of the desired force.");
  f("display", r.display, '1', "display_class: How Fd is displayed.");
  f("saturated", r.saturated, '1', "bool: True if a torque limit was reached.");
  f("wall_number", r.wall_number, '1', "int: Wall that demands the force; -1 in free space.");
  f("alpha", r.alpha, '1', "float: Scale factor of the law (12).");
  f("approximation_cosine", r.approximation_cosine, '1', "float: cos(gamma).");
  f("desired_force", r.desired_force, 'd', "Array: Fd [N], base frame.");
  f("control_force", r.control_force, 'd', "Array: Fc [N], base frame, before alpha and limits.");
  f("cone_coefficients", r.cone_coefficients, 'm', "Array: Torques that make Fc [N m].");
  f("signs", r.signs, 'm', "Array: s, -1, 0 or 1 of each brake.");
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
      "d "
      "numbers [N]\n    Of the hand on the handle, base frame; None without a force sensor.")
      .def(py::init(&made_state), py::arg("time"), py::arg("q"), py::arg("qd"),
           py::arg("hand_force") = py::none())
      .def_readonly("time", &S::time, "float: [s]")
      .def_property_readonly(
          "q", [](const S& s) { return array_of(s.q); }, "Array: Joint positions [rad or m].")
      .def_property_readonly(
          "qd", [](const S& s) { return array_of(s.qd); }, "Array: Joint rates [rad/s or m/s].")
      .def_property_readonly("hand_force", force_of,
                             "Array: Of the hand on the handle [N], base frame; None without a force sensor.")
      .def(py::pickle([](const S& s) { return py::make_tuple(s.time, s.q, s.qd, s.hand_force); },
                      [](const py::tuple& t) {
                        const auto vector = [&](int i) {
                          return t[std::size_t(i)].cast<std::vector<double>>();
                        };
                        return S{t[0].cast<double>(), vector(1), vector(2), vector(3)};
                      }));
  using R = rt::cycle_record;
  py::class_<R> result(module, "step_result", "What one control cycle decides, and why.");
  R layout;
  const auto bind = [&](const char* name, auto& member, char, const char* about) {
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
  bind("settled_signs", layout.settled_signs, 'm',
       "Array: s* once the self-motion has settled; empty of a device without it.");
  bind("settled_velocity", layout.settled_velocity, 'd',
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
  std::vector<std::tuple<std::string, std::string>> fields;
  for_each_value(layout, [&](const char* name, auto&, char width, const char*) {
    fields.emplace_back(name, std::string(1, width));
  });
  module.attr("BATCH_FIELDS") = py::cast(fields);
}

// ---- batches

// Where a batch stores one member of each result.
struct column {
  char* first;
  py::ssize_t step, across;
};

template <class T, class V>
void store(const V& value, char* to, py::ssize_t across) {
  if constexpr (requires { value.count; }) {
    for (std::size_t i = 0; i < value.size(); ++i, to += across)
      std::memcpy(to, value.data() + i, sizeof(double));
  } else {
    const T x = static_cast<T>(value);
    std::memcpy(to, &x, sizeof x);
  }
}

// Runs the cycle of N states, each the first of a motion, without Python's lock, and stores results in arrays
// of the names of members.
void run_batch(const controller& of, py::handle q, py::handle qd, py::handle hand_force, py::handle time,
               const py::dict& out) {
  const rt::device_sizes sizes = of.held().sizes();
  const rows_of joints(q, "q", sizes.dof), rates(qd, "qd", sizes.dof);
  std::optional<rows_of> forces;
  if (!hand_force.is_none()) forces.emplace(hand_force, "hand_force", sizes.task_dimension);
  else if (of.held().needs_hand_force())
    refuse_value("hand_force = None: expected an array of forces [N]: the law needs a hand force");
  std::vector<double> times;
  if (!time.is_none()) times = vector_from(time, "time", static_cast<int>(joints.size()));
  std::vector<column> columns;
  rt::cycle_record layout;
  for_each_value(layout, [&](const char* name, auto&, char width, const char*) {
    if (!out.contains(name)) return columns.push_back({});
    auto array = py::reinterpret_borrow<py::array>(out[name]);
    columns.push_back(
        {static_cast<char*>(array.mutable_data()), array.strides(0), width == '1' ? 0 : array.strides(1)});
  });
  const auto control = of.held().copy();
  deferred_error errors;
  {
    constexpr py::ssize_t states_between_signals = 1 << 16;
    const py::gil_scoped_release unlocked;
    for (py::ssize_t k = 0; k < joints.size() && !deferred_error::is_kept(); ++k) {
      control->reset();
      const rt::cycle_record r =
          (*control)({times.empty() ? 0 : times[static_cast<std::size_t>(k)], joints[k], rates[k],
                      forces ? (*forces)[k] : std::span<const double>()});
      const column* c = columns.data();
      for_each_value(r, [&](const char*, const auto& value, char, const char*) {
        using V = std::remove_cvref_t<decltype(value)>;
        using T = std::conditional_t<std::is_enum_v<V>, int, V>;
        if (c->first != nullptr) store<T>(value, c->first + k * c->step, c->across);
        ++c;
      });
      if (k % states_between_signals != states_between_signals - 1) continue;
      const py::gil_scoped_acquire locked;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  }
  errors.rethrow();
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
      .def("sizes",
           [](const controller& c) {
             const rt::device_sizes of = c.held().sizes();
             return py::make_tuple(of.dof, of.task_dimension, of.brake_count);
           })
      .def("batch", &run_batch)
      .def("set_brakes", [](controller& c, const named& brakes) { c.set_brakes(brakes_of(brakes)); })
      .def("reset", &controller::reset);
}

}  // namespace passive_haptics_python
