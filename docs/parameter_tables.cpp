// parameter_tables INCLUDE: prints the table of every struct of parameters, as docs/guide/device.md shows
// them on the site, and names those structs with a table in the folder INCLUDE that main() does not show.
#include <passive_haptics/bench/bench_run.hpp>
#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/driver/thread/polling_thread.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <cxxabi.h>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <typeinfo>
#include <vector>

namespace {

namespace fs = std::filesystem;
namespace ph = passive_haptics;

// A mesh has no default, a wall has a shape, and a header of interop/ needs another library
std::set<std::string> shown = {"mesh_surface_parameters", "wall", "chai3d_parameters"};

// Without namespace and template arguments
template <class P>
std::string name_of() {
  const std::string full = abi::__cxa_demangle(typeid(P).name(), nullptr, nullptr, nullptr);
  const std::string whole = full.substr(0, full.find('<'));
  return whole.substr(whole.rfind(':') + 1);
}

// Of a vector or array, that of its elements
template <class V>
struct scalar_of {
  using type = V;
};
template <class V>
  requires requires { typename V::value_type; } && (!std::is_same_v<V, std::string>)
struct scalar_of<V> : scalar_of<typename V::value_type> {};

struct value_collector {
  std::vector<std::string> values = {};

  template <class T>
  void value(const ph::member_description& about, const ph::detail::place&, const T& x) {
    values.push_back(ph::detail::text_of(about, x));
  }
};

template <class V>
std::string default_text(const ph::member_description& about, const V& value) {
  value_collector collected;
  ph::detail::visit_member(about, {}, value, collected);
  const auto& all = collected.values;
  if (all.empty()) return "";
  if (all.front() == "nan") return "none";
  if (std::count(all.begin(), all.end(), all.front()) == std::ssize(all))
    return all.front() + (all.size() > 1 ? " each" : "");
  std::string list = all.front();
  for (std::size_t i = 1; i < all.size(); ++i) list += ", " + all[i];
  return list;
}

template <class V>
void row(const ph::member_description& about, const V& value) {
  using scalar = typename scalar_of<V>::type;
  std::string expected = about.hard.is_checked ? to_text(about.hard, std::is_integral_v<scalar>) : "";
  std::string fallback;
  if constexpr (ph::Parameters<scalar>) {
    expected = "@ref parameters_of_" + name_of<scalar>() + " \"" + name_of<scalar>() + "\"";
  } else {
    fallback = default_text(about, value);
    if (std::is_same_v<scalar, bool>) expected = "true or false";
    if (*about.choices != '\0') expected = "one of " + std::string(about.choices);
    const ph::range plausible = ph::plausible_magnitude(about);
    if (plausible.lower > 0) expected += "; suspicious below " + ph::detail::number_text(plausible.lower);
    if (plausible.upper < ph::range::infinity)
      expected += "; suspicious above " + ph::detail::number_text(plausible.upper);
  }
  std::cout << "| `" << about.name << "` | " << about.unit << " | " << fallback << " | " << expected
            << " |\n";
}

template <class P>
void table() {
  const std::string name = name_of<P>();
  shown.insert(name);
  std::cout << "\n### " << name << " {#parameters_of_" << name << "}\n\n@ref passive_haptics::" << name
            << " \"What each is\"\n\n| member | unit | default | must be |\n|---|---|---|---|\n";
  const P defaults{};
  ph::for_each_member(defaults, [](const auto& m, const auto& value) { row(m, value); });
  if constexpr (requires { defaults.rules(); }) std::cout << "\nMore holds across members: its `rules()`.\n";
}

template <class... Ps>
void layer(const std::string& name) {
  std::cout << "\n## " << name << " {#parameters_of_stage_" << name << "}\n";
  (table<Ps>(), ...);
}

// Structs with a table that main() does not show, and where they stand.
void list_others(const fs::path& include) {
  const std::regex declared(R"(using p = (\w+);\s+return member_table)");
  std::string others;
  for (const auto& file : fs::recursive_directory_iterator(include)) {
    if (!file.is_regular_file()) continue;
    std::ifstream in(file.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (std::sregex_iterator i(text.begin(), text.end(), declared), end; i != end; ++i) {
      if (shown.insert((*i)[1]).second)
        others += "- `" + i->str(1) + "` in `" + file.path().generic_string() + "`\n";
    }
  }
  if (!others.empty()) std::cout << "\n### Others\n" << others;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  using T = double;
  layer<ph::two_link_parameters<T>, ph::tendon_two_link_parameters<T>, ph::xy_table_parameters<T>,
        ph::five_bar_parameters<T>, ph::delta_parameters<T>, ph::chain_joint<T, 3>,
        ph::serial_chain_parameters<T, 3, 3>, ph::link_inertia<T, 3>, ph::serial_chain_inertia<T, 3, 3>>(
      "Mechanisms");
  layer<ph::brake_parameters<T, 2>, ph::switchable_brake_parameters<T, 2>>("Brakes");
  layer<ph::half_space_parameters<3>, ph::ball_parameters<3>, ph::box_parameters<3>,
        ph::capsule_parameters<3>, ph::convex_polygon_parameters<3>, ph::convex_polytope_parameters<3, 4>,
        ph::offset_parameters, ph::height_field_parameters, ph::hold_parameters, ph::latest_scene_parameters>(
      "Scenes");
  layer<ph::viscous_field_parameters<T, 2>, ph::detents_parameters<T, 2>, ph::guide_parameters<T, 2>,
        ph::wall_friction_parameters<T>, ph::end_stops_parameters<T, 2>>("Effects");
  layer<ph::approximation_parameters<T>, ph::direct_control, ph::velocity_direct_control_parameters,
        ph::on_off_parameters, ph::momentum_observer_parameters, ph::release_probe_parameters,
        ph::sensorless_parameters>("Control");
  layer<ph::braked_wall>("Design");
  layer<ph::brake_resistance<T>, ph::coulomb_brake<T>, ph::stribeck_brake<T>, ph::magnetorheological_brake<T>,
        ph::eddy_current_brake<T>, ph::delayed_brake<ph::coulomb_brake<T>>,
        ph::presliding_brake<ph::coulomb_brake<T>>, ph::encoder_parameters, ph::force_sensor_parameters,
        ph::following_hand_parameters<T>, ph::wall_following_parameters>("Simulation");
  layer<ph::control_loop_parameters, ph::real_time_parameters, ph::supervisor_parameters,
        ph::polling_parameters, ph::encoder_limits, ph::sensor_limits<2>, ph::current_limits<2>,
        ph::release_parameters, ph::safe_port_parameters<2, 2>, ph::encoder_calibration_parameters<2>,
        ph::rate_estimator_parameters, ph::brake_curve, ph::planar_sensor_frame<2>,
        ph::force_calibration_parameters<2>, ph::device_calibration_parameters<ph::two_link<T>>,
        ph::steady_parameters, ph::bench_parameters>("Driver");
  list_others(arguments[1]);
}
