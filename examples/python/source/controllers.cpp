// Controllers.
#include <precompiled.hpp>

#include "batch_arrays.hpp"
#include "devices.hpp"
#include "module.hpp"

namespace passive_haptics_python {
namespace {

// Options of a step.
struct option_values {
  double max_approximation_angle = ph::approximation_parameters<double>().max_approximation_angle;  // [rad]
  ph::saturation limits = ph::saturation::keep_direction;

  static constexpr auto members() {
    using p = option_values;
    return ph::member_table(ph::member("max_approximation_angle", &p::max_approximation_angle, "rad"),
                            ph::choice("limits", &p::limits, "keep_direction, clamp_each"));
  }
  ph::step_options<double> options() const {
    ph::approximation_parameters<double> approximation;
    approximation.max_approximation_angle = max_approximation_angle;
    return ph::step_options<double>(approximation, limits);
  }
};

// A controller and what it was made of.
struct controller {
  py::object of_mechanism, of_brakes, of_scene, of_law;
  option_values options;
  device_sizes sizes;
  std::unique_ptr<any_controller> held;
  mutable int batches = 0;  // that run now, in other threads
  static std::vector<std::string> names() {
    return {"mechanism", "brakes", "scene", "law", "max_approximation_angle", "limits"};
  }
  static controller made(const py::dict& given, const std::string& name) {
    controller c;
    py::dict others;
    for (const auto& [key, value] : given) others[key] = value;
    const auto take = [&](const char* part) {
      if (!others.contains(part))
        refuse_type(name + " needs (mechanism, brakes, scene, law), but no " + part + " was given");
      return py::object(others.attr("pop")(part));
    };
    c.of_mechanism = take("mechanism");
    c.of_brakes = take("brakes");
    c.of_scene = take("scene");
    c.of_law = take("law");
    assign_members(c.options, others, name);
    const auto& device = expect<mechanism>(c.of_mechanism, "mechanism", "a mechanism such as two_link()");
    const auto& walls = expect<scene>(c.of_scene, "scene", "a scene: scene(wall(shape, stiffness))");
    const brake_numbers known = brakes_for(device, c.of_brakes);
    expect<law>(c.of_law, "law", "a law such as direct_control()");
    c.sizes = device.device().sizes();
    c.held = device.make_controller(known, walls, c.of_law, c.options.options());
    return c;
  }
  batch_values batch(py::handle q, py::handle qd, py::handle hand_force, py::handle time,
                     const py::object& fields, const py::object& out) const {
    struct counted {
      explicit counted(int& of) : count(of) { ++count; }
      ~counted() { --count; }
      int& count;
    } const now(batches);
    return run_batch(*held, sizes, q, qd, hand_force, time, fields, out);
  }
  void set_brakes(const py::object& given) {
    if (batches > 0)
      refuse_value("set_brakes() while a batch of this controller runs, expected none: let it end first");
    held->set_brakes(brakes_for(py::cast<const mechanism&>(of_mechanism), given));
    of_brakes = given;
  }
  py::dict with(const py::dict& of_options) const {
    py::dict all;
    all["mechanism"] = of_mechanism;
    all["brakes"] = of_brakes;
    all["scene"] = of_scene;
    all["law"] = of_law;
    for (const auto& [key, value] : of_options) all[key] = value;
    return all;
  }
  py::dict parameters() const { return with(to_dict(options)); }
  py::dict changed() const { return with(changed_members(options, option_values())); }
};

}  // namespace

any_controller& controller_for(const device_sizes& sizes, py::handle given) {
  controller& c = expect<controller>(given, "controller", "a controller(mechanism, brakes, scene, law)");
  const auto check = [](int has, int expected, const char* of) {
    if (has != expected)
      refuse_value("controller is of a mechanism with " + std::to_string(has) + " " + of + ", expected " +
                   std::to_string(expected) + ": make it for the mechanism of the device");
  };
  check(c.sizes.dof, sizes.dof, "joints");
  check(c.sizes.task_dimension, sizes.task_dimension, "task dimensions");
  check(c.sizes.brake_count, sizes.brake_count, "brakes");
  return *c.held;
}

void bind_controllers(py::module_& module) {
  const std::string text =
      "(mechanism: mechanism, brakes: brake_parameters, scene: scene, law: law, " +
      stub_arguments<option_values>() +
      ")\n\nA mechanism, its brakes, a scene and a law, called once a cycle or for many states at once. "
      "max_approximation_angle [rad]: beyond it nothing is displayed. limits: what gives way at a torque "
      "limit. A "
      "pickled controller remembers nothing of its motion.";
  py::class_<controller> bound(module, "controller", text.c_str());
  add_value_protocol(bound, "controller");
  bound.def(
      "__call__",
      [](controller& c, py::handle state) {
        return c.held->step(expect<state_values>(state, "state", "a device_state"));
      },
      py::arg("state"), "__call__(self, state: device_state) -> step_result\n\nOne control cycle.");
  bound.def(
      "batch", &controller::batch, py::arg("q"), py::arg("qd"), py::arg("hand_force") = py::none(),
      py::arg("time") = py::none(), py::kw_only(), py::arg("fields") = py::none(),
      py::arg("out") = py::none(),
      "batch(self, q: Array, qd: Array, hand_force: Array | None = ..., time: Array | None = ..., *, fields: "
      "Iterable[str] | None = ..., out: batch_result | None = ...) -> batch_result\n\nThe cycle of N states, "
      "each the "
      "first of a motion. q and qd: N x n, hand_force: N x d, time: N, of float64. Columns that are one "
      "piece of "
      "memory (order='F') are read where they stand. fields: names of the results that are wanted beside "
      "capacity and "
      "outcome; None: all. out: an earlier result of as many states, whose arrays are written again. "
      "Python's lock "
      "is released.");
  bound.def(
      "set_brakes", &controller::set_brakes, py::arg("brakes"),
      "set_brakes(self, brakes: brake_parameters) -> None\n\nOther brakes of the device from the next cycle "
      "on, such as some that are off (torque_lower = torque_upper = 0). What the law remembers stays.");
  bound.def(
      "reset", [](controller& c) { c.held->reset(); },
      "reset(self) -> None\n\nForgets the motion so far, and the scene the handle.");
}

}  // namespace passive_haptics_python
