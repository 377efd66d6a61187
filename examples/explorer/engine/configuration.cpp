#include "configuration.hpp"

namespace explorer {
namespace {

const runtime::mechanism_entry& entry_of(const page_mechanism& about) {
  return *runtime::find(catalogue().mechanisms(), about.id);
}

std::vector<double> axis(int d, int i, double size) {
  std::vector<double> x(static_cast<std::size_t>(d));
  x[std::size_t(i)] = size;
  return x;
}

// The hand of examples/03_wall_following.cpp, which yields.
ph::following_hand_parameters<double> yielding_hand() {
  ph::following_hand_parameters<double> p;
  p.push = 1.75;
  p.normal_stiffness = 300;
  p.target_depth = 0.003;
  return p;
}

// Options of a step. The default needs no cosine, which another libm rounds in another way.
ph::step_options<double> options_of(const ph::approximation_parameters<double>& p) {
  const ph::approximation_parameters<double> usual;
  return p.max_approximation_angle == usual.max_approximation_angle ? ph::step_options<double>()
                                                                    : ph::step_options<double>(p);
}

}  // namespace

brake_numbers brake_settings::numbers() const {
  brake_numbers all(static_cast<int>(present.size()));
  all.torque_limit = torque_limit;
  all.rate_dead_band = rate_dead_band;
  all.torque_dead_band = torque_dead_band;
  all.time_constant = time_constant;
  for (std::size_t i = 0; i < present.size(); ++i)
    if (!is_present(int(i))) all.torque_lower[i] = all.torque_upper[i] = 0;
  return all;
}

configuration::configuration(const page_mechanism& of)
    : about(&of), sizes(entry_of(of).sizes), mechanism(entry_of(of).defaults), along(yielding_hand()) {
  const int d = sizes.task_dimension;
  const brake_numbers usual(sizes.brake_count);
  brakes = {std::vector<double>(usual.torque_limit.size(), 1), usual.torque_limit, usual.rate_dead_band,
            usual.torque_dead_band, usual.time_constant};
  for (const runtime::law_entry& one : catalogue().laws()) {
    if (one.name == "direct_control") law = laws.size();
    laws.push_back(one.defaults);
  }
  path.direction = map.direction = axis(d, 0, 1);
  map.normal = d == 3 ? axis(d, 2, 1) : axis(d, 1, -1);  // a floor in space, a wall ahead in the plane
  state.scene = of.scene;
  state.q = of.start;
  state.qd.resize(of.start.size());
  state.Fh = state.Fd = std::vector<double>(std::size_t(d));
}

configuration configuration::defaults() const {
  configuration usual(*about);
  usual.law = law;
  return usual;
}

field_list configuration::fields() {
  field_list all;
  add_fields(all, mechanism, "mechanism.", "mechanism");
  add_fields(all, brakes, "brakes.", "brakes");
  add_fields(all, laws[law], "law.", "law");
  add_fields(all, options, "options.", "options");
  add_fields(all, state, "", "scene");
  add_fields(all, wall, "scene.", "scene");
  add_fields(all, hand, "hand.", "hand");
  add_fields(all, along, "hand.along.", "hand");
  add_fields(all, path, "hand.path.", "hand");
  add_fields(all, map, "map.", "map");
  return all;
}

void configuration::take(const settings& given) {
  const auto& known = catalogue().laws();
  if (const std::string* id = given.find("law")) {
    const auto* found = runtime::find(known, *id);
    if (found == nullptr) refuse("law", *id, names_of(known, [](const auto& l) { return l.name; }));
    law = static_cast<std::size_t>(found - known.data());
  }
  const field_list all = fields();
  read(all, given);
  field_list of_laws;  // those of another law may be there, too
  for (auto& table : laws) add_fields(of_laws, table, "law.", "law");
  for (const auto& [name, value] : given.lines())
    if (name != "mechanism" && name != "law" && find(all, name) == nullptr && find(of_laws, name) == nullptr)
      refuse("setting", name, "a name of the device's form");
  for (const auto* table : {&mechanism, &laws[law]}) ph::require_no_error(table->error());
  for (const auto& error :
       {ph::validate(brakes), ph::validate(options), ph::validate(state), ph::validate(wall),
        ph::validate(hand), ph::validate(along), ph::validate(path), ph::validate(map)})
    ph::require_no_error(error);
}

std::unique_ptr<runtime::any_mechanism> configuration::make_mechanism() const {
  return entry_of(*about).make(mechanism);
}

page_controller configuration::controller(const device_kind& kind, const scene_source& scene) const {
  const bool is_given = state.alpha >= 0;
  return kind.controller(is_given ? "constant_scale" : law_name(),
                         is_given ? runtime::any_parameters(constant_scale{state.alpha}) : laws[law],
                         brakes.numbers(), scene, options_of(options));
}

page_controller configuration::controller_without_law(const device_kind& kind,
                                                      const scene_source& scene) const {
  configuration whole = *this;
  whole.state.alpha = 1;
  return whole.controller(kind, scene);
}

}  // namespace explorer
