// Brakes of simulated devices (passive_haptics/plant/brakes).
#include <precompiled.hpp>

#include "devices.hpp"
#include "module.hpp"

#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

namespace passive_haptics_python {
namespace {

// The base class of all brake models.
struct brake_model {
  virtual ~brake_model() = default;
  virtual run_time_brake brake() const = 0;
};

template <class Model>
struct brake_model_value : brake_model {
  Model table = {};

  run_time_brake brake() const override { return run_time_brake(table); }
  static std::vector<std::string> names() { return member_names<Model>(); }
  static brake_model_value made(const py::dict& given, const std::string& name) {
    brake_model_value b;
    assign_members(b.table, given, name);
    ph::require_no_error(ph::validate(b.table));
    return b;
  }
  py::dict parameters() const { return to_dict(table); }
  py::dict changed() const { return changed_members(table, Model{}); }
};

template <class Model>
void bind_model(py::module_& module, const std::string& name, const std::string& about) {
  using X = brake_model_value<Model>;
  const std::string text =
      "(" + stub_arguments<Model>() + ")\n\n" + about + "\n\n" + parameter_lines<Model>();
  py::class_<X, brake_model> bound(module, name.c_str(), text.c_str());
  add_value_protocol(bound, name);
}

}  // namespace

std::vector<run_time_brake> brake_models_from(py::handle given) {
  if (!PyList_Check(given.ptr()) && !PyTuple_Check(given.ptr()))
    refuse_type("brakes = " + shown(given) +
                ", expected what brakes() of the mechanism returns, or a list of brake models");
  std::vector<run_time_brake> all;
  for (const py::handle each : py::reinterpret_borrow<py::sequence>(given)) {
    const std::string name = "brakes[" + std::to_string(all.size()) + "]";
    all.push_back(expect<brake_model>(each, name.c_str(), "a brake model such as coulomb_brake()").brake());
  }
  return all;
}

void bind_brake_models(py::module_& module) {
  py::class_<brake_model>(module, "brake_model", "What one brake of a simulated device makes of a command.");
  bind_model<ph::coulomb_brake<double>>(module, "coulomb_brake",
                                        "Friction that follows its command with a lag.");
  bind_model<ph::stribeck_brake<double>>(module, "stribeck_brake",
                                         "A coulomb_brake whose friction is larger at rest.");
  bind_model<ph::eddy_current_brake<double>>(module, "eddy_current_brake",
                                             "Drag by eddy currents: no torque at rest.");
  bind_model<ph::magnetorheological_brake<double>>(
      module, "magnetorheological_brake", "A magnetorheological brake, with saturation and hysteresis.");
  bind_model<ph::presliding_brake<ph::coulomb_brake<double>>>(
      module, "presliding_brake", "A coulomb_brake that turns elastically before it slips.");
}

}  // namespace passive_haptics_python
