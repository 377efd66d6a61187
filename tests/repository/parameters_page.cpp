// docs/guide/parameters.md has the tables of all structs of parameters as they are in the code.
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
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <typeindex>
#include <vector>

namespace {

namespace fs = std::filesystem;
namespace ph = passive_haptics;

const fs::path root = PASSIVE_HAPTICS_SOURCE_DIR;

std::string read_file(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// All single values of a member
struct value_collector : ph::detail::visitor {
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
  const bool same = std::all_of(all.begin(), all.end(), [&](const auto& v) { return v == all.front(); });
  if (same) return all.front() + (all.size() > 1 ? " each" : "");
  std::string list;
  for (const std::string& one : all) list += (list.empty() ? "" : ", ") + one;
  return list;
}

// Of a vector or array, that of its elements
template <class V>
struct scalar_of {
  using type = V;
};
template <class V>
  requires requires { typename V::value_type; } && (!std::is_same_v<V, std::string>)
struct scalar_of<V> : scalar_of<typename V::value_type> {};

class page {
 public:
  void stage(const std::string& name) { text_ += "\n## " + name + "\n"; }

  template <class P>
  void table(const std::string& name, const std::string& header) {
    names_[typeid(P)] = name;
    const std::string path = "passive_haptics/" + header;
    text_ += "\n### " + name + "\n[" + path + "](../../include/" + path + ")\n\n";
    text_ += "| member | unit | default | must be | usually |\n|---|---|---|---|---|\n";
    const P defaults{};
    ph::for_each_member(defaults, [&](const auto& m, const auto& value) { row(m, value); });
    if constexpr (requires { defaults.rules(); }) text_ += "\nMore holds across members: its `rules()`.\n";
  }

  const std::string& text() const { return text_; }

 private:
  template <class V>
  void row(const ph::member_description& about, const V& value) {
    using scalar = typename scalar_of<V>::type;
    constexpr bool is_bool = std::is_same_v<scalar, bool>;
    const auto range_text = [](const ph::range& r) {
      return r.is_checked ? to_text(r, std::is_integral_v<scalar>) : std::string();
    };
    std::string unit = about.unit, expected = range_text(about.hard), fallback;
    if constexpr (ph::Parameters<scalar>) {
      expected = "[" + names_.at(typeid(scalar)) + "](#" + names_.at(typeid(scalar)) + ")";
    } else {
      fallback = default_text(about, value);
      if (is_bool) expected = "true or false";
      if (*about.choices != '\0') expected = "one of " + std::string(about.choices);
      if (about.large < ph::range::infinity)
        expected += "; large over " + ph::detail::number_text(about.large);
    }
    text_ += std::string("| `") + about.name + "` | " + unit + " | " + fallback + " | " + expected + " | " +
             range_text(about.plausible) + " |\n";
  }

  std::string text_;
  std::map<std::type_index, std::string> names_;
};

std::string tables() {
  page p;
  using T = double;
  p.stage("Mechanisms");
  p.table<ph::two_link_parameters<T>>("two_link_parameters", "mechanism/models/two_link.hpp");
  p.table<ph::tendon_two_link_parameters<T>>("tendon_two_link_parameters",
                                             "mechanism/models/tendon_two_link.hpp");
  p.table<ph::xy_table_parameters<T>>("xy_table_parameters", "mechanism/models/xy_table.hpp");
  p.table<ph::five_bar_parameters<T>>("five_bar_parameters", "mechanism/models/five_bar_parameters.hpp");
  p.table<ph::delta_parameters<T>>("delta_parameters", "mechanism/models/delta_parameters.hpp");
  const std::string chain = "mechanism/chains/serial_chain_parameters.hpp",
                    inertia = "mechanism/chains/link_inertia.hpp";
  p.table<ph::chain_joint<T, 3>>("chain_joint", chain);
  p.table<ph::serial_chain_parameters<T, 3, 3>>("serial_chain_parameters", chain);
  p.table<ph::link_inertia<T, 3>>("link_inertia", inertia);
  p.table<ph::serial_chain_inertia<T, 3, 3>>("serial_chain_inertia", inertia);
  p.stage("Brakes");
  p.table<ph::brake_parameters<T, 2>>("brake_parameters", "brake/brake_parameters.hpp");
  p.stage("Scenes");
  const std::string shapes = "scene/shapes/";
  p.table<ph::half_space_parameters<3>>("half_space_parameters", shapes + "half_space.hpp");
  p.table<ph::ball_parameters<3>>("ball_parameters", shapes + "ball.hpp");
  p.table<ph::box_parameters<3>>("box_parameters", shapes + "box.hpp");
  p.table<ph::capsule_parameters<3>>("capsule_parameters", shapes + "capsule.hpp");
  p.table<ph::convex_polygon_parameters<3>>("convex_polygon_parameters", shapes + "convex_polygon.hpp");
  p.table<ph::convex_polytope_parameters<3, 4>>("convex_polytope_parameters", shapes + "convex_polytope.hpp");
  p.table<ph::offset_parameters>("offset_parameters", shapes + "offset.hpp");
  p.table<ph::height_field_parameters>("height_field_parameters", "scene/mesh/height_field.hpp");
  p.table<ph::hold_parameters>("hold_parameters", "scene/held_scene.hpp");
  p.table<ph::latest_scene_parameters>("latest_scene_parameters", "scene/world/scene_exchange.hpp");
  p.stage("Effects");
  const std::string effects = "force/effects/";
  p.table<ph::viscous_field_parameters<T, 2>>("viscous_field_parameters", effects + "viscous_field.hpp");
  p.table<ph::detents_parameters<T, 2>>("detents_parameters", effects + "detents.hpp");
  p.table<ph::guide_parameters<T, 2>>("guide_parameters", effects + "guide.hpp");
  p.table<ph::wall_friction_parameters<T>>("wall_friction_parameters", effects + "wall_friction.hpp");
  p.table<ph::end_stops_parameters<T, 2>>("end_stops_parameters", effects + "end_stops.hpp");
  p.stage("Control");
  p.table<ph::approximation_parameters<T>>("approximation_parameters", "force/approximation.hpp");
  p.table<ph::direct_control>("direct_control", "control/direct_control.hpp");
  const std::string laws = "control/laws/", sensorless = "control/sensorless/";
  p.table<ph::velocity_direct_control_parameters>("velocity_direct_control_parameters",
                                                  laws + "velocity/velocity_direct_control.hpp");
  p.table<ph::braked_wall>("braked_wall", "design/wall_limits.hpp");
  p.table<ph::on_off_parameters>("on_off_parameters", laws + "rivals/on_off_control.hpp");
  p.table<ph::bang_bang_parameters>("bang_bang_parameters", laws + "rivals/bang_bang_control.hpp");
  p.table<ph::single_degree_of_freedom_parameters>("single_degree_of_freedom_parameters",
                                                   laws + "rivals/single_degree_of_freedom_control.hpp");
  p.table<ph::velocity_ratio_parameters>("velocity_ratio_parameters",
                                         laws + "rivals/velocity_ratio_control.hpp");
  p.table<ph::momentum_observer_parameters>("momentum_observer_parameters",
                                            sensorless + "momentum_observer.hpp");
  p.table<ph::release_probe_parameters>("release_probe_parameters", sensorless + "release_probe.hpp");
  p.table<ph::sensorless_parameters>("sensorless_parameters", sensorless + "sensorless_controller.hpp");
  p.stage("Simulation");
  p.table<ph::brake_resistance<T>>("brake_resistance", "brake/models/brake_model.hpp");
  const std::string models = "plant/brakes/";
  p.table<ph::coulomb_brake<T>>("coulomb_brake", models + "coulomb_brake.hpp");
  p.table<ph::stribeck_brake<T>>("stribeck_brake", models + "stribeck_brake.hpp");
  p.table<ph::magnetorheological_brake<T>>("magnetorheological_brake",
                                           models + "magnetorheological_brake.hpp");
  p.table<ph::eddy_current_brake<T>>("eddy_current_brake", models + "eddy_current_brake.hpp");
  p.table<ph::delayed_brake<ph::coulomb_brake<T>>>("delayed_brake", models + "delayed_brake.hpp");
  p.table<ph::encoder_parameters>("encoder_parameters", "plant/encoder.hpp");
  p.table<ph::force_sensor_parameters>("force_sensor_parameters", "plant/force_sensor.hpp");
  p.table<ph::following_hand_parameters<T>>("following_hand_parameters", "plant/following_hand.hpp");
  p.table<ph::wall_following_parameters>("wall_following_parameters", "plant/wall_following.hpp");
  p.stage("Driver");
  const std::string calibration = "driver/calibration/", checks = "driver/checks/";
  p.table<ph::control_loop_parameters>("control_loop_parameters", "driver/control_loop.hpp");
  p.table<ph::real_time_parameters>("real_time_parameters", "driver/real_time.hpp");
  p.table<ph::supervisor_parameters>("supervisor_parameters", "driver/process/supervisor.hpp");
  p.table<ph::polling_parameters>("polling_parameters", "driver/thread/polling_thread.hpp");
  p.table<ph::encoder_limits>("encoder_limits", checks + "encoder_check.hpp");
  p.table<ph::sensor_limits<2>>("sensor_limits", checks + "sensor_check.hpp");
  p.table<ph::current_limits<2>>("current_limits", checks + "current_limiter.hpp");
  p.table<ph::release_parameters>("release_parameters", "driver/release_policy.hpp");
  p.table<ph::safe_port_parameters<2, 2>>("safe_port_parameters", "driver/safe_port_parameters.hpp");
  p.table<ph::encoder_calibration_parameters<2>>("encoder_calibration_parameters",
                                                 calibration + "encoder_calibration.hpp");
  p.table<ph::rate_estimator_parameters>("rate_estimator_parameters", "driver/rate_estimator.hpp");
  p.table<ph::brake_curve>("brake_curve", calibration + "brake_curve.hpp");
  p.table<ph::planar_sensor_frame<2>>("planar_sensor_frame", calibration + "force_calibration.hpp");
  p.table<ph::force_calibration_parameters<2>>("force_calibration_parameters",
                                               calibration + "force_calibration.hpp");
  p.table<ph::device_calibration_parameters<ph::two_link<T>>>("device_calibration_parameters",
                                                              calibration + "device_calibration.hpp");
  p.table<ph::steady_parameters>("steady_parameters", calibration + "steady_mean.hpp");
  p.table<ph::bench_parameters>("bench_parameters", "bench/bench_run.hpp");
  return p.text();
}

TEST(parameters_page, has_the_tables_of_the_code) {
  const fs::path path = root / "docs/guide/parameters.md";
  const std::string now = read_file(path), marker = "parameters_page.cpp -->\n";
  const auto end = now.find(marker);
  ASSERT_NE(end, std::string::npos);
  const std::string right = now.substr(0, end + marker.size()) + tables();
  if (std::getenv("PASSIVE_HAPTICS_WRITE_PAGES") != nullptr) std::ofstream(path) << right;
  else EXPECT_TRUE(now == right) << path << " is out of date, expected:\n" << tables();
}

// A mesh has no default, and a wall has a shape
TEST(parameters_page, has_every_struct_with_a_table) {
  const std::string all = tables();
  const std::regex declared(R"(using p = (\w+);\s+return member_table)");
  for (const auto& file : fs::recursive_directory_iterator(root / "include")) {
    if (!file.is_regular_file()) continue;
    const std::string text = read_file(file.path());
    for (std::sregex_iterator i(text.begin(), text.end(), declared), none; i != none; ++i) {
      const std::string name = (*i)[1];
      if (name == "wall" || name == "mesh_surface_parameters") continue;
      EXPECT_NE(all.find("### " + name + "\n"), std::string::npos) << name << " is not on the page";
    }
  }
}

}  // namespace
