/// Definitions of the other headers of this directory. Include it in exactly one source of a program, so that
/// toml++ and scenes are compiled once (examples: catalogue/device_file.cpp).
#pragma once

#include <passive_haptics/runtime/device_file/parse_toml.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/world.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace passive_haptics::detail {

// Reads `type`, one of these entries, with default parameters.
template <class Entry>
runtime::named_parameters entry_in(runtime::toml_section& from, std::string usual,
                                   const std::vector<Entry>& all, std::string_view reason = {}) {
  std::vector<std::string_view> names;
  for (const Entry& one : all) names.push_back(one.name);
  runtime::named_parameters chosen{std::move(usual), {}};
  from.read("type", chosen.name, names, reason);
  chosen.parameters = runtime::find(all, chosen.name)->defaults;
  return chosen;
}

// Error text of a library constructor without the library's name, empty if it succeeds.
template <class F>
std::string error_of(F make) {
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
inline constexpr std::string_view moves_in =
    D == 2 ? "; the mechanism is planar" : "; the mechanism is spatial";

template <int D>
half_space_parameters<D> usual_wall() {
  if constexpr (D == 2) return {{0, 0.225}, {0, -1}};  // the paper's
  else return {{0, 0, -0.15}, {0, 0, 1}};              // a floor
}

template <int D>
runtime::scene_variant scene_of(const runtime::device_description& device, const runtime::catalogue& all) {
  world_walls<D> made;
  std::vector<std::pair<int, runtime::wall_motion<D>>> motions;
  for (const runtime::wall_description& w : device.walls) {
    any_wall<D> wall = runtime::make_wall<D>(all, w);
    if (w.motion)
      motions.emplace_back(made.add_moving(std::move(wall)), w.motion->as<runtime::wall_motion<D>>());
    else made.add(std::move(wall));
  }
  world<D> whole(made);
  using runtime::scene_in_motion;
  runtime::any_scene<D> sampled =
      device.scene.period == 0 ? runtime::any_scene<D>(scene_in_motion(std::move(whole), std::move(motions)))
                               : runtime::any_scene<D>(scene_in_motion(
                                     held_scene(std::move(whole), device.scene.period), std::move(motions)));
  if (device.effects.empty()) return sampled;
  std::vector<runtime::any_effect<D>> beside;
  for (const runtime::named_parameters& e : device.effects)
    beside.push_back(runtime::entry_of(all.effects<D>(), e.name).make(e.parameters));
  return runtime::any_scene_with_effects<D>(std::move(sampled), std::move(beside));
}

}  // namespace passive_haptics::detail

namespace passive_haptics::runtime {

void toml_section::read_allowed() {
  const char* const key = "allow_large";
  const toml_value* found = state_->find(key);
  if (found == nullptr) return;
  const auto is_text = [](const toml_value& one) { return one.type == kind::text; };
  if (found->type != kind::list || !std::ranges::all_of(found->items, is_text))
    state_->expected(key, *found, "a list of keys in quotes");
  for (const toml_value& one : found->items) state_->allowed->was_large[one.text] = false;
}

void toml_section::read_field(const field& f) {
  const char* const key = f.about.name;
  std::string meaning;
  if (f.about.hard.is_checked) meaning.append(": ").append(to_text(f.about.hard));
  if (*f.about.unit != '\0') meaning.append(" [").append(f.about.unit).append("]");
  const auto rows = static_cast<std::size_t>(f.rows), columns = static_cast<std::size_t>(f.columns);
  const toml_value* const found = state_->find(key);
  if (found == nullptr) return;
  switch (f.type) {
    case field::kind::text: return read(key, f.text());
    case field::kind::choice: {
      const auto words = choices_of(f.about);
      std::string chosen;
      read(key, chosen, words);
      f.set(f.at, static_cast<int>(std::find(words.begin(), words.end(), chosen) - words.begin()));
      return;
    }
    case field::kind::truth: {
      bool is = false;
      read(key, is);
      f.set(f.at, is ? 1 : 0);
      return;
    }
    case field::kind::whole: {
      std::vector<int> numbers(rows);
      read(key, numbers, meaning);
      for (std::size_t i = 0; i < rows; ++i)
        if (!f.set(static_cast<std::byte*>(f.at) + i * f.stride, numbers[i]))
          require(check_value(key, numbers[i], f.about.unit, range::at_least(0)));
      return;
    }
    case field::kind::tables: {
      auto given = sections(key);
      if (given.empty()) return;
      const auto tables = f.resize_tables == nullptr ? f.tables : f.resize_tables(f.at, given.size());
      if (given.size() != tables.size())
        state_->expected(key, *found,
                         std::to_string(tables.size()) + " tables, [[" + state_->named(key) + "]] each");
      for (std::size_t i = 0; i < given.size(); ++i) given[i].read_fields(tables[i]);
      return;
    }
    case field::kind::points: {
      const std::string what = "a list of points of " + std::to_string(rows) + " numbers each" + meaning;
      if (found->type != kind::list || found->items.empty()) state_->expected(key, *found, what);
      return read_rows(key, *found, what, f.resize(f.at, found->items.size()), rows, rows, 1);
    }
    case field::kind::numbers: {
      if (columns > 1) {  // by rows, but stored column by column
        const std::string what =
            std::to_string(rows) + " rows of " + std::to_string(columns) + " numbers" + meaning;
        if (found->type != kind::list || found->items.size() != rows) state_->expected(key, *found, what);
        return read_rows(key, *found, what, f.numbers(), columns, 1, rows);
      }
      // Points, directions, velocities and accelerations have components instead of values per axis
      const std::string_view unit = f.about.unit;
      return read_each(key, f.numbers(), rows, meaning,
                       !f.about.hard.is_direction && unit != "m" && unit != "m/s" && unit != "m/s^2");
    }
  }
}

void toml_section::finish() const {
  if (state_->table != nullptr) {
    for (const toml_value& one : state_->table->items) {
      if (state_->known.contains(one.key)) continue;
      if (const auto now = state_->renamed.find(one.key); now != state_->renamed.end())
        state_->expected(one.key, one, now->second + ": the key was renamed");
      std::string all;
      for (const std::string& key : state_->known) all.append(all.empty() ? "" : ", ").append(key);
      state_->fail(&one, "unknown key '" + detail::beginning_of(state_->named(one.key)) +
                             "': expected one of " + all + did_you_mean(one.key, state_->known));
    }
  }
  for (const auto& inner : state_->inner) toml_section(inner).finish();
  if (!state_->name.empty() || !state_->allowed->all_are_read) return;
  for (const auto& [key, was_large] : state_->allowed->was_large)
    if (!was_large)
      require("allow_large = [\"" + detail::beginning_of(key) +
              "\"]: expected keys of values that no device has; remove it");
}

scene_variant device_description::make_scene(const catalogue& all) const {
  if (entry_of(all.mechanisms(), mechanism.name).sizes.task_dimension == 2)
    return detail::scene_of<2>(*this, all);
  return detail::scene_of<3>(*this, all);
}

void device_reader::read_mechanism() {
  toml_section from = file_.section("mechanism");
  if (from.has("urdf")) read_urdf(from);
  else device.mechanism = detail::entry_in(from, device.mechanism.name, all_.mechanisms());
  from.read_all(device.mechanism.parameters);
  from.require(detail::error_of([&] { device.make_mechanism(all_); }));
  device.remarks += device.mechanism.parameters.remarks("mechanism: ");
}

void device_reader::read_urdf(toml_section& from) {
  urdf_source source;
  from.read_all(source);
  source.urdf = from.beside(source.urdf);
  std::string type;
  from.read("type", type);
  if (!all_.urdf_reader())
    from.refuse("urdf", "a program that reads URDFs; install Debian's liburdfdom-dev, then build it again");
  urdf_mechanism made;
  from.require(detail::error_of([&] { made = all_.urdf_reader()(source, type); }));
  device.mechanism = {std::move(made.name), std::move(made.parameters)};
  for (std::size_t at = 0, end = 0; (end = made.remarks.find('\n', at)) != std::string::npos; at = end + 1)
    device.remarks += "mechanism: " + made.remarks.substr(at, end + 1 - at);
}

void device_reader::read_brakes() {
  toml_section from = file_.section("brakes");
  const int count = mechanism().sizes.brake_count;
  if (device.brakes.torque_limit.empty()) device.brakes = brake_numbers(count);
  from.read_all(device.brakes);
  device.remarks += remarks(device.brakes, "brakes: ");
  for (toml_section& model : from.sections("model")) {
    named_parameters& made =
        device.brake_models.emplace_back(detail::entry_in(model, "coulomb", all_.brake_models()));
    model.read_all(made.parameters);
    device.remarks +=
        made.parameters.remarks("brake model " + std::to_string(device.brake_models.size()) + ": ");
  }
  if (!device.brake_models.empty() && std::ssize(device.brake_models) != count)
    from.refuse("model", std::to_string(count) + " tables [[brakes.model]], one for each brake of a " +
                             device.mechanism.name);
}

void device_reader::read_scene() {
  if (mechanism().sizes.task_dimension == 2) read_scene_in<2>();
  else read_scene_in<3>();
  file_.section("scene").read_all(device.scene);
}

template <int D>
void device_reader::read_scene_in() {
  file_.rename("wall", "[[walls]]");
  auto walls = file_.sections("walls"), effects = file_.sections("effects");
  if (!file_.has("walls") && effects.empty()) walls.push_back(toml_section::nothing());
  for (toml_section& from : walls) read_wall<D>(from);
  for (toml_section& from : effects) {
    named_parameters& e =
        device.effects.emplace_back(detail::entry_in(from, "", all_.effects<D>(), detail::moves_in<D>));
    from.read_all(e.parameters);
    from.require(detail::error_of([&] { find(all_.effects<D>(), e.name)->make(e.parameters); }));
    device.remarks += e.parameters.remarks("effect " + std::to_string(device.effects.size()) + ": ");
  }
}

template <int D>
void device_reader::read_wall(toml_section& from) {
  wall_description& w = device.walls.emplace_back();
  read_shape<D>(from, w.shapes);
  wall stiff(half_space<D>(detail::usual_wall<D>()), w.stiffness);
  from.read_all(stiff);
  w.stiffness = stiff.stiffness();
  from.require(detail::error_of([&] { make_wall<D>(all_, w); }));
  const std::string part = "wall " + std::to_string(device.walls.size()) + ": ";
  toml_section moves = from.section("motion");
  if (from.has("motion")) {
    moves.read_all(w.motion.emplace(wall_motion<D>()));
    device.remarks += w.motion->remarks(part);
  }
  device.remarks += remarks(stiff, part);
  for (const named_parameters& one : w.shapes) device.remarks += one.parameters.remarks(part);
}

// The shape of a section and, in [of], the shapes that it is made from.
template <int D>
void device_reader::read_shape(toml_section& from, std::vector<named_parameters>& shapes) {
  const auto& known = all_.shapes<D>();
  from.rename("point", "surface_point");
  from.rename("filling", "inside");
  std::string type;
  from.read("type", type);
  if (type == "plane" && find(known, type) == nullptr)
    from.refuse("type", "\"half_space\": the shape was renamed");
  named_parameters shape = detail::entry_in(from, "half_space", known, detail::moves_in<D>);
  any_parameters& p = shape.parameters;
  if (shape.name == "half_space") p = any_parameters(detail::usual_wall<D>());
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

void device_reader::read_sensor() {
  std::string type;
  file_.section("sensor").read("type", type);
  device.has_force_sensor = type != "none";
}

void device_reader::read_law() {
  toml_section from = file_.section("law", "a table, [law], with type = \"...\": the key was renamed");
  const auto made = device.make_mechanism(all_);
  const auto is_usual = [&](const law_entry& one) {
    return device.effects.empty() ? missing(one, *made).empty() : one.displays_effects;
  };
  const auto usual = std::ranges::find_if(all_.laws(), is_usual);
  device.law =
      detail::entry_in(from, (usual == all_.laws().end() ? all_.laws().begin() : usual)->name, all_.laws());
  const law_entry& law = *find(all_.laws(), device.law.name);
  require_possible(from, law, *made);
  if (law.takes_one_wall && device.walls.size() > 1)
    device.remarks += "law: " + law.name + " displays one wall at a time, that with the maximum force\n";
  for (const field& f : device.law.parameters.fields())
    if (std::string_view(f.about.name) == "lead")
      *f.numbers() = std::ranges::max(device.brakes.time_constant);
  from.read_all(device.law.parameters);
  from.read_all(device.options);
  device.remarks += device.law.parameters.remarks("law: ");
  device_description without_walls = device;
  without_walls.walls.clear();
  const std::string error = detail::error_of([&] { without_walls.make_controller(all_, *made); });
  (error.starts_with("brakes") ? file_.section("brakes") : file_).require(error);
}

// A need of the law that the device does not meet; empty if there is none.
std::string device_reader::missing(const law_entry& law, const any_mechanism& made) const {
  const std::string& type = device.mechanism.name;
  if (law.needs_dynamics && !mechanism().has_inertia) return "inertia, which a " + type + " does not have";
  if (law.needs_hand_force && !device.has_force_sensor)
    return "a hand force, and [sensor] has type = \"none\"";
  if (!all_.is_compiled(made, law)) return "controllers that are not compiled for a " + type;
  return "";
}

// Throws unless controllers under this law are compiled and the device meets its needs.
void device_reader::require_possible(toml_section& from, const law_entry& law, const any_mechanism& made) {
  const std::string lacks = missing(law, made);
  if (lacks.empty()) return;
  std::vector<std::string_view> possible;
  for (const law_entry& one : all_.laws())
    if (missing(one, made).empty()) possible.push_back(one.name);
  if (possible.empty())
    file_.section("mechanism")
        .require("type = " + device.mechanism.name +
                 ": expected one with controllers: the program "
                 "compiles none of this kind (catalogue::compile_for)");
  const std::string expected = one_of(possible) + ": " + law.name + " needs " + lacks;
  from.refuse("type", expected);
  from.require("type is missing: expected " + expected);
}

device_description read_device(const toml_section& file, const catalogue& all) {
  device_reader reader(file, all);
  reader.read_mechanism();
  reader.read_brakes();
  reader.read_scene();
  reader.read_sensor();
  reader.read_law();
  return std::move(reader.device);
}

}  // namespace passive_haptics::runtime
