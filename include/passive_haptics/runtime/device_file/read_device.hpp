/// @file
/// Reads the sections [mechanism], [brakes], [[brakes.model]], [law], [[walls]], [[effects]] and [scene] of a
/// device file, and type = "none" of [sensor]. Keys are the names of the parameters (core/parameters.hpp),
/// and `type` is the name in the catalogue. A program reads other sections from the same toml_section.
#pragma once

#include <passive_haptics/runtime/device_file/device_description.hpp>
#include <passive_haptics/runtime/device_file/toml_section.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Reads the parts of a device. Call its functions in their order; a program that knows more about the device
/// sets members of `device` in between. All of them throw std::invalid_argument with file, line, key, value
/// and expectation.
class device_reader {
 public:
  device_description device;  ///< As far as it is read.

  /// Of an open file, with finish() left to the caller, and of what its names mean.
  device_reader(toml_section file, const catalogue& all) : file_(std::move(file)), all_(all) {}

  /// Reads [mechanism].
  void read_mechanism() {
    toml_section from = file_.section("mechanism");
    device.mechanism = entry(from, device.mechanism.name, all_.mechanisms());
    from.read_all(device.mechanism.parameters);
    from.require(error_of([&] { device.make_mechanism(all_); }));
    device.remarks += device.mechanism.parameters.remarks("mechanism: ");
  }

  /// Reads [brakes] and [[brakes.model]]. The brakes of `device` are the defaults, if it has any.
  void read_brakes() {
    toml_section from = file_.section("brakes");
    const int count = mechanism().sizes.brake_count;
    if (device.brakes.torque_limit.empty()) device.brakes = brake_numbers(count);
    field_list fields;
    add_fields(fields, device.brakes);
    for (const field& f : fields) from.read_field(f);
    from.check(device.brakes);
    device.remarks += remarks(device.brakes, "brakes: ");
    for (toml_section& model : from.sections("model")) {
      named_parameters& made = device.brake_models.emplace_back(entry(model, "coulomb", all_.brake_models()));
      model.read_all(made.parameters);
      device.remarks +=
          made.parameters.remarks("brake model " + std::to_string(device.brake_models.size()) + ": ");
    }
    if (!device.brake_models.empty() && std::ssize(device.brake_models) != count)
      from.refuse("model", std::to_string(count) + " tables [[brakes.model]], one for each brake of a " +
                               device.mechanism.name);
  }

  /// Reads [[walls]], [[effects]] and [scene]. Without the first two there is the paper's wall, in space a
  /// floor; `walls = []` is none.
  void read_scene() {
    if (mechanism().sizes.task_dimension == 2) read_scene_in<2>();
    else read_scene_in<3>();
    file_.section("scene").read_all(device.scene);
  }

  /// Reads whether [sensor] has type = "none".
  void read_sensor() {
    std::string type;
    file_.section("sensor").read("type", type);
    device.has_force_sensor = type != "none";
  }

  /// Reads [law]. Without a type it is the recommended law (control/laws/recommended_law.hpp), or with
  /// effects direct_control, as no other law displays them. Unless the file has a lead, on_off_control leads
  /// by the lag of the slowest brake.
  void read_law() {
    toml_section from = file_.section("law", "a table, [law], with type = \"...\": the key was renamed");
    const bool is_measured = mechanism().has_inertia && device.has_force_sensor;
    const char* const usual = !device.effects.empty() ? "direct_control"
                              : is_measured           ? "velocity_direct_control"
                                                      : "on_off_control";
    device.law = entry(from, usual, all_.laws());
    const law_entry& law = *find(all_.laws(), device.law.name);
    require_possible(from, law);
    if (law.takes_one_wall && device.walls.size() > 1)
      device.remarks += "law: " + law.name + " takes one wall at a time, the one with the largest force\n";
    if (law.name == "on_off_control")
      for (const field& f : device.law.parameters.fields())
        if (std::string_view(f.about.name) == "lead")
          *f.numbers() = std::ranges::max(device.brakes.time_constant);
    from.read_all(device.law.parameters);
    from.read_all(device.options);
    device.remarks += device.law.parameters.remarks("law: ");
    device_description without_walls = device;
    without_walls.walls.clear();
    const std::string error =
        error_of([&] { without_walls.make_controller(all_, *device.make_mechanism(all_)); });
    (error.starts_with("brakes") ? file_.section("brakes") : file_).require(error);
  }

 private:
  const mechanism_entry& mechanism() const { return *find(all_.mechanisms(), device.mechanism.name); }

  // `type` of a section, one of these, and its parameters over those of the entry.
  template <class Entry>
  static named_parameters entry(toml_section& from, std::string usual, const std::vector<Entry>& all,
                                std::string_view reason = {}) {
    std::vector<std::string_view> names;
    for (const Entry& one : all) names.push_back(one.name);
    named_parameters chosen{std::move(usual), {}};
    from.read("type", chosen.name, names, reason);
    chosen.parameters = find(all, chosen.name)->defaults;
    return chosen;
  }

  // What a constructor of the library throws, without the library's name; empty if it throws nothing.
  template <class F>
  static std::string error_of(F make) {
    try {
      make();
    } catch (const std::invalid_argument& thrown) {
      constexpr std::string_view library = "passive_haptics: ";
      const std::string_view error = thrown.what();
      return std::string(error.starts_with(library) ? error.substr(library.size()) : error);
    }
    return "";
  }

  template <int D>
  static constexpr std::string_view moves_in =
      D == 2 ? "; the mechanism moves in the plane" : "; the mechanism moves in space";

  template <int D>
  static half_space_parameters<D> usual_wall() {
    if constexpr (D == 2) return {{0, 0.225}, {0, -1}};  // the paper's
    else return {{0, 0, -0.15}, {0, 0, 1}};              // a floor
  }

  template <int D>
  void read_scene_in() {
    file_.rename("wall", "[[walls]]");
    auto walls = file_.sections("walls"), effects = file_.sections("effects");
    if (!file_.has("walls") && effects.empty()) walls.push_back(toml_section::nothing());
    for (toml_section& from : walls) read_wall<D>(from);
    for (toml_section& from : effects) {
      named_parameters& e = device.effects.emplace_back(entry(from, "", all_.effects<D>(), moves_in<D>));
      from.read_all(e.parameters);
      from.require(error_of([&] { find(all_.effects<D>(), e.name)->make(e.parameters); }));
      device.remarks += e.parameters.remarks("effect " + std::to_string(device.effects.size()) + ": ");
    }
  }

  template <int D>
  void read_wall(toml_section& from) {
    wall_description& w = device.walls.emplace_back();
    read_shape<D>(from, w.shapes);
    wall stiff(half_space<D>(usual_wall<D>()), w.stiffness);
    from.read_all(stiff);
    w.stiffness = stiff.stiffness();
    from.require(error_of([&] { make_wall<D>(all_, w); }));
    const std::string part = "wall " + std::to_string(device.walls.size()) + ": ";
    device.remarks += remarks(stiff, part);
    for (const named_parameters& one : w.shapes) device.remarks += one.parameters.remarks(part);
  }

  // The shape of a section and, in [of], those that it is made of.
  template <int D>
  void read_shape(toml_section& from, std::vector<named_parameters>& shapes) {
    const auto& known = all_.shapes<D>();
    from.rename("point", "surface_point");
    from.rename("filling", "inside");
    std::string type;
    from.read("type", type);
    if (type == "plane" && find(known, type) == nullptr)
      from.refuse("type", "\"half_space\": the shape was renamed");
    named_parameters shape = entry(from, "half_space", known, moves_in<D>);
    any_parameters& p = shape.parameters;
    if (shape.name == "half_space") p = any_parameters(usual_wall<D>());
    from.read_all(p);
    for (const field& f : p.fields())
      if (f.type == field::kind::text && std::string_view(f.about.name) == "file")
        f.text() = from.beside(f.text());
    const bool takes_shape = find(known, shape.name)->takes_shape;
    shapes.push_back(std::move(shape));
    if (!takes_shape) return;
    toml_section of = from.section("of");
    read_shape<D>(of, shapes);
  }

  // Throws unless there are controllers under this law, and the device has what it needs.
  void require_possible(toml_section& from, const law_entry& law) {
    const auto made = device.make_mechanism(all_);
    const std::string& type = device.mechanism.name;
    const auto missing = [&](const law_entry& one) -> std::string {
      if (one.needs_dynamics && !mechanism().has_inertia)
        return "inertia, which a " + type + " does not have";
      if (one.needs_hand_force && !device.has_force_sensor)
        return "a hand force, and [sensor] has type = \"none\"";
      if (!all_.is_compiled(*made, one)) return "controllers that are not compiled for a " + type;
      return "";
    };
    const std::string lacks = missing(law);
    if (lacks.empty()) return;
    std::vector<std::string_view> possible;
    for (const law_entry& one : all_.laws())
      if (missing(one).empty()) possible.push_back(one.name);
    if (possible.empty())
      file_.section("mechanism")
          .require("type = " + type +
                   ", expected one with controllers: the program "
                   "compiles none of this kind (catalogue::compile_for)");
    const std::string expected = one_of(possible) + ": " + law.name + " needs " + lacks;
    from.refuse("type", expected);
    from.require("type is missing, expected " + expected);
  }

  toml_section file_;
  const catalogue& all_;
};

/// All these parts of an open file, with finish() left to the caller. Throws as a device_reader does.
inline device_description read_device(const toml_section& file, const catalogue& all) {
  device_reader reader(file, all);
  reader.read_mechanism();
  reader.read_brakes();
  reader.read_scene();
  reader.read_sensor();
  reader.read_law();
  return std::move(reader.device);
}

}  // namespace passive_haptics::runtime
