// What a device of parts from a data sheet renders (passive_haptics/design).
#include <precompiled.hpp>

#include "devices.hpp"
#include "module.hpp"

namespace passive_haptics_python {
namespace {

struct data_sheet_base {};
using data_sheet_value = table_value<data_sheet_base, data_sheet_values>;

py::object rendering_of(const rendering_values& found) {
  const py::module_ results = py::module_::import("passive_haptics.results");
  py::list figures, of_joints;
  for (const auto& [name, unit, f] : found.figures) {
    const py::object banded = results.attr("banded")(name, unit, f.value, f.low, f.high, f.share, f.source);
    if (name.starts_with("rate_noise")) of_joints.append(banded);
    else figures.append(banded);
  }
  return results.attr("rendering")(*figures, py::tuple(of_joints), found.holds_push, found.text);
}

py::object expected_rendering(const mechanism& m, py::handle parts, py::handle q, py::handle velocity,
                              py::handle normal) {
  const auto& sheet = expect<data_sheet_value>(parts, "parts", "a data_sheet(brakes, encoders, ...)");
  const path_values place{any_numbers(q, "q"), any_numbers(velocity, "velocity"),
                          any_numbers(normal, "normal")};
  return rendering_of(m.device().expected_rendering(sheet.table, place));
}

}  // namespace

void bind_rendering(py::class_<mechanism>& bound) {
  bound.def(
      "expected_rendering", &expected_rendering, py::arg("parts"), py::arg("q"), py::arg("velocity"),
      py::arg("normal"),
      "expected_rendering(self, parts: data_sheet, q: Numbers, velocity: Numbers, normal: Numbers) -> "
      "rendering\n\nWhat a device of this mechanism, built of these parts, renders at joint positions q on "
      "a wall of this normal, which the handle touches with a velocity [m/s]: each figure with the band in "
      "which nine of ten simulated devices lie. Of a mechanism with inertia; TypeError for others. "
      "ValueError at a singular pose.");
}

void bind_data_sheets(py::module_& module) {
  const std::string text = "(" + stub_arguments<data_sheet_values>() +
                           ")\n\nThe parts that a device is to be built of, as their makers describe them, "
                           "and the hand that is to use it. brakes and encoders: one for each of the "
                           "device's; none stands for as many defaults. inf counts_per_turn: an ideal "
                           "encoder.\n\n" +
                           parameter_lines<data_sheet_values>();
  py::class_<data_sheet_value> bound(module, "data_sheet", text.c_str());
  add_value_protocol(bound, "data_sheet");
}

}  // namespace passive_haptics_python
