// The simulated device and the wall-following experiment.
#include <precompiled.hpp>

#include "devices.hpp"
#include "module.hpp"
#include "recorder.hpp"

#include <pybind11/eigen.h>

namespace passive_haptics_python {
namespace {

py::dict without(const py::dict& given, std::initializer_list<const char*> names) {
  py::dict others;
  for (const auto& [key, value] : given) others[key] = value;
  for (const char* name : names)
    if (others.contains(name)) others.attr("pop")(name);
  return others;
}
py::object part_of(const py::dict& given, const char* part, const std::string& name, const char* all) {
  if (!given.contains(part)) refuse_type(name + " needs " + all + ", but no " + part + " was given");
  return given[part];
}
py::list list_of(const numbers& x) { return py::cast(x).attr("tolist")(); }

// A simulated device and what it was made of.
struct simulated_device {
  py::object of_mechanism, of_brakes;
  double hand_mass = 0;
  numbers start;
  std::unique_ptr<any_simulation> held;

  static std::vector<std::string> names() { return {"mechanism", "brakes", "hand_mass", "q"}; }
  static simulated_device made(const py::dict& given, const std::string& name) {
    const char* const all = "(mechanism, brakes, hand_mass, q)";
    simulated_device s;
    s.of_mechanism = part_of(given, "mechanism", name, all);
    s.of_brakes = part_of(given, "brakes", name, all);
    s.hand_mass = number_from(part_of(given, "hand_mass", name, all), "hand_mass");
    s.start = any_numbers(part_of(given, "q", name, all), "q");
    for (const auto& [key, value] : without(given, {"mechanism", "brakes", "hand_mass", "q"}))
      refuse_type(name + " has no parameter " + std::string(py::repr(key)) + ", expected " + joined(names()));
    const auto& of = expect<mechanism>(s.of_mechanism, "mechanism", "a mechanism such as two_link()");
    if (py::isinstance<brakes>(s.of_brakes))
      s.held = of.device().simulation(brakes_for(of, s.of_brakes), s.hand_mass, s.start);
    else s.held = of.device().simulation(brake_models_from(s.of_brakes), s.hand_mass, s.start);
    return s;
  }
  py::dict parameters() const {
    py::dict all;
    all["mechanism"] = of_mechanism;
    all["brakes"] = of_brakes;
    all["hand_mass"] = hand_mass;
    all["q"] = list_of(start);
    return all;
  }
  py::dict changed() const { return parameters(); }
  device_sizes sizes() const { return py::cast<const mechanism&>(of_mechanism).device().sizes(); }
};

// A hand that follows a wall.
struct following_hand : hand_values {
  using table_type = ph::following_hand_parameters<double>;

  static std::vector<std::string> names() {
    std::vector<std::string> all = member_names<table_type>();
    all.insert(all.begin(), {"direction", "start"});
    return all;
  }
  static following_hand made(const py::dict& given, const std::string& name) {
    following_hand h;
    h.direction = any_numbers(part_of(given, "direction", name, "(direction, start)"), "direction");
    h.start = any_numbers(part_of(given, "start", name, "(direction, start)"), "start");
    if (h.direction.size() != h.start.size())
      refuse_value("length of start = " + std::to_string(h.start.size()) + ", expected " +
                   std::to_string(h.direction.size()) + ", as direction has");
    if (!(h.direction.squaredNorm() > 0) || !h.direction.allFinite())
      refuse_value("direction of a " + name + " = " + std::string(py::repr(list_of(h.direction))) +
                   ", expected a direction of finite length > 0");
    const py::dict others = without(given, {"direction", "start"});
    assign_members(h.hand_values::parameters, others, name);
    ph::require_no_error(ph::validate(h.hand_values::parameters));
    return h;
  }
  py::dict parameters() const { return with(to_dict(hand_values::parameters)); }
  py::dict changed() const { return with(changed_members(hand_values::parameters, table_type{})); }

 private:
  py::dict with(const py::dict& others) const {
    py::dict all;
    all["direction"] = list_of(direction);
    all["start"] = list_of(start);
    for (const auto& [key, value] : others) all[key] = value;
    return all;
  }
};

struct following_base {};
using following_value = table_value<following_base, ph::wall_following_parameters>;

py::object metrics_of(const ph::contact_metrics& f) {
  const py::module_ results = py::module_::import("passive_haptics.results");
  return results.attr("contact_metrics")(
      f.separations, f.recontacts, f.depth_mean, f.depth_std, f.depth_range, f.depth_drift, f.max_depth,
      f.stick_share, f.hand_force_std, f.retarding_force, f.brake_energy, f.max_brake_power, f.duration,
      f.arrived, f.touched, results.attr("run_end")(int(f.end)));
}

py::tuple follow(py::handle device, py::handle controller, py::handle of_shape, py::handle hand,
                 const py::object& parameters, bool record) {
  auto& simulated = expect<simulated_device>(device, "device", "a simulated_device");
  any_controller& control = controller_for(simulated.sizes(), controller);
  const auto& wall = expect<shape>(of_shape, "shape", "a shape such as half_space(...)");
  const auto& of_hand = expect<following_hand>(hand, "hand", "a following_hand(direction, start)");
  ph::wall_following_parameters p;
  if (!parameters.is_none())
    p = expect<following_value>(parameters, "parameters", "wall_following_parameters(...)").table;
  recorder seen(simulated.sizes(), record, p);
  const ph::contact_metrics found = simulated.held->follow_wall(control, wall.geometry, of_hand, p, seen);
  return py::make_tuple(metrics_of(found), seen.rows());
}

py::dict energies(const ph::energy_balance& e) {
  py::dict all;
  all["start"] = e.start;
  all["hand"] = e.hand;
  all["gravity"] = e.gravity;
  all["brakes"] = e.brakes;
  all["residual_friction"] = e.residual_friction;
  all["drag"] = e.drag;
  all["kinetic"] = e.kinetic;
  all["max_brake_power"] = e.max_brake_power;
  return all;
}

void bind_device(py::module_& module) {
  using S = simulated_device;
  py::class_<S> bound(
      module, "simulated_device",
      "(mechanism: mechanism, brakes: brake_parameters | Sequence[brake_model], hand_mass: float, q: "
      "Numbers)\n\nA device without hardware, at rest at joint positions q [rad or m]: a mechanism with "
      "inertia, real brakes and a hand's mass [kg] on its handle. brakes: what brakes() of the mechanism "
      "returns, for brakes that are what their controller believes, or a brake model for each brake. A "
      "pickled one, and parameters, are those of the start.");
  add_value_protocol(bound, "simulated_device");
  bound
      .def(
          "advance",
          [](S& s, py::handle dt, py::handle capacity, py::handle muscle_force) {
            s.held->advance(number_from(dt, "dt"), any_numbers(capacity, "capacity"),
                            any_numbers(muscle_force, "muscle_force"));
          },
          py::arg("dt"), py::arg("capacity"), py::arg("muscle_force"),
          "advance(self, dt: float, capacity: Numbers, muscle_force: Numbers) -> None\n\nOne time step dt "
          "[s] "
          "under commanded capacities [N m] and the force that the hand's muscles exert [N]. No time passes "
          "where dt is not a finite number > 0. A dt over twice the time constants of the hand's spring and "
          "damper makes the motion grow until it is NaN.")
      .def(
          "set_motion",
          [](S& s, py::handle q, py::handle qd) {
            s.held->set_motion(any_numbers(q, "q"), any_numbers(qd, "qd"));
          },
          py::arg("q"), py::arg("qd"),
          "set_motion(self, q: Numbers, qd: Numbers) -> None\n\nSets joint positions [rad or m] and rates, "
          "and begins the energy balance anew.")
      .def_property_readonly(
          "q", [](const S& s) { return s.held->q(); }, "Array: Joint positions now [rad or m].")
      .def_property_readonly(
          "qd", [](const S& s) { return s.held->qd(); }, "Array: Joint rates now [rad/s or m/s].")
      .def_property_readonly(
          "position", [](const S& s) { return s.held->position(); }, "Array: The handle now [m].")
      .def_property_readonly(
          "velocity", [](const S& s) { return s.held->velocity(); }, "Array: The handle's velocity [m/s].")
      .def_property_readonly(
          "rates", [](const S& s) { return s.held->rates(); }, "Array: Rates of the brakes [rad/s or m/s].")
      .def_property_readonly(
          "sensed_force", [](const S& s) { return s.held->sensed_force(); },
          "Array: Force of the hand on the handle in the last step [N].")
      .def_property_readonly(
          "brake_torque", [](const S& s) { return s.held->brake_torque(); },
          "Array: Mean torque of the brakes in the last step [N m].")
      .def_property_readonly(
          "brake_force", [](const S& s) { return s.held->brake_force(); },
          "Array: The force at the handle that does what these torques do [N].")
      .def_property_readonly(
          "energy", [](const S& s) { return energies(s.held->energy()); },
          "dict[str, float]: Where the energy came from and went since the motion was set [J], and the "
          "largest power of a brake [W].");
}

}  // namespace

void bind_simulations(py::module_& module) {
  bind_device(module);
  const std::string of_hand =
      "(direction: Numbers, start: Numbers, " + stub_arguments<following_hand::table_type>() +
      ")\n\nA hand that moves along a wall in a direction and presses on it, at start "
      "[m] at time 0.\n\n" +
      parameter_lines<following_hand::table_type>();
  py::class_<following_hand> hand(module, "following_hand", of_hand.c_str());
  add_value_protocol(hand, "following_hand");
  const std::string of_parameters = "(" + stub_arguments<ph::wall_following_parameters>() +
                                    ")\n\nTiming and sensing of a wall-following experiment.\n\n" +
                                    parameter_lines<ph::wall_following_parameters>();
  py::class_<following_value> parameters(module, "wall_following_parameters", of_parameters.c_str());
  add_value_protocol(parameters, "wall_following_parameters");
  module.def(
      "follow_wall", &follow, py::arg("device"), py::arg("controller"), py::arg("shape"), py::arg("hand"),
      py::arg("parameters") = py::none(), py::kw_only(), py::arg("record") = false,
      "follow_wall(device: simulated_device, controller: controller, shape: shape, hand: following_hand, "
      "parameters: wall_following_parameters | None = ..., *, record: bool = ...) -> tuple[contact_metrics, "
      "Records]\n\nThe wall-following experiment: a hand moves the device along a shape, the wall whose "
      "depth "
      "is measured, under a controller. Returns its figures and, if record is true, an array with a row for "
      "each time step (else none): time [s], depth [m], position [m], velocity [m/s], rates of the brakes, "
      "brake_torque [N m], brake_power [W], hand_force [N], brake_force [N], and of the latest control cycle "
      "capacity [N m], alpha, outcome, power, display, saturated and wall_number. The device and the "
      "controller go on from where they are; time begins at 0, so reset() a controller that has run before. "
      "Ctrl-C ends it.");
}

}  // namespace passive_haptics_python
