#include <configuration/configuration.hpp>
#include <configuration/home.hpp>
#include <configuration/toml_section.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace example {
namespace {

// Keys that have other names than the members that they set.
const std::map<std::string_view, std::string_view> keys{
    {"continuous", "continuous_current"}, {"max_current", "current_limit"}, {"surface_point", "point"}};

template <class Parameters>
void check(const toml_section& from, const Parameters& p) {
  from.check(p, keys);
}

void read_mechanism(toml_section from, configuration& c) {
  from.read("type", c.mechanism, {"tendon_two_link", "xy_table", "five_bar"});
  if (c.mechanism == "tendon_two_link") from.read_all(c.tendon_two_link);
  else if (c.mechanism == "xy_table") from.read_all(c.xy_table);
  else from.read_all(c.five_bar);
}

// What a constructor of the library throws begins with its name.
std::string without_library(const std::string& text) {
  constexpr std::string_view library = "passive_haptics: ";
  return text.starts_with(library) ? text.substr(library.size()) : text;
}

// A wall, and its normal near a point.
wall_normal add_wall(toml_section& from, configuration& c) {
  std::string type = "plane", filling = "solid";
  ph::half_space_parameters<2> plane{{0, 0.225}, {0, -1}};
  ph::ball_parameters<2> ball{.centre = plane.surface_point};
  from.read("type", type, {"plane", "ball"});
  const auto add = [&](const auto& shape) -> wall_normal {
    ph::wall wall(shape);
    double stiffness = wall.stiffness();
    from.read("stiffness", stiffness);
    if (!wall.set_stiffness(stiffness)) from.refuse("stiffness", "a finite number >= 0 [N/m]");
    check(from, wall);
    c.walls.add(wall);
    c.named_walls.push_back({type, [shape](const ph::point<2>& x) { return shape.distance(x); }});
    c.wall_remarks += ph::remarks(wall);
    return [shape](const ph::point<2>& x) { return shape.gradient(x); };
  };
  if (type == "plane") {
    from.read_vector("point", plane.surface_point);
    from.read_vector("normal", plane.normal);
    check(from, plane);
    return add(ph::half_space<2>(plane));
  }
  from.read_vector("centre", ball.centre);
  from.read("radius", ball.radius);
  from.read("filling", filling, {"solid", "hollow"});
  ball.inside = filling == "solid" ? ph::filling::solid : ph::filling::hollow;
  check(from, ball);
  return add(ph::ball<2>(ball));
}

void read_walls(toml_section& file, configuration& c) {
  auto walls = file.sections("wall");
  if (walls.empty()) {
    auto usual = toml_section::nothing();  // the paper's wall
    c.first_normal = add_wall(usual, c);
  }
  for (auto& from : walls) {
    const wall_normal normal = add_wall(from, c);
    if (!c.first_normal) c.first_normal = normal;
  }
}

void read_brakes(toml_section from, configuration& c) {
  std::array<double, axes> residual{}, slope, limit, hysteresis{}, loss{};
  slope.fill(1);
  limit.fill(1);
  from.read("residual_torque", residual);
  from.read("torque_per_ampere", slope);
  from.read("current_limit", limit);
  from.read("hysteresis", hysteresis);
  from.read("loss_per_kelvin", loss);
  for (std::size_t i = 0; i < c.curves.size(); ++i) {
    ph::brake_curve& curve = c.curves[i];
    curve.residual_torque = residual[i];
    curve.current_limit = limit[i];
    curve.hysteresis = hysteresis[i];
    curve.loss_per_kelvin = loss[i];
    std::array<double, 2 * ph::brake_curve::max_points> pairs{};
    const char* const table = i == 0 ? "table_1" : "table_2";
    curve.points = static_cast<int>(from.read_pairs(table, pairs.data(), ph::brake_curve::max_points));
    if (curve.points == 0) {
      from.refuse(table, "2 to 16 pairs of amperes and newton metres; write them down, or remove it");
      curve.torque_per_ampere = slope[i];
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(curve.points); ++k)
      curve.table[k] = {pairs[2 * k], pairs[2 * k + 1]};
    c.brakes.torque_limit[static_cast<int>(i)] = torque_of_current(curve, curve.current_limit);
  }
  if (c.curves[0].points > 0 && c.curves[1].points > 0)
    from.refuse("torque_per_ampere",
                "no slope where both brakes have a table, which is read in its place; remove it");
  if (std::any_of(loss.begin(), loss.end(), [](double x) { return x != 0; }))
    from.refuse("loss_per_kelvin", "0, as no sensor of this program reads a brake's temperature; remove it");
  from.require(validate(c.curves));
  for (const ph::brake_curve& curve : c.curves) check(from, curve);
  from.read_all(c.brakes);

  c.safety.currents.max_current = limit;
  c.safety.currents.continuous = limit;
  from.read("continuous_current", c.safety.currents.continuous);
  from.read("heat", c.safety.currents.heat);
  from.read("max_rise_rate", c.safety.currents.max_rise_rate);
  check(from, c.safety.currents);
}

void read_encoders(toml_section from, configuration& c) {
  c.encoders.slides.fill(c.mechanism == "xy_table");
  if (c.mechanism == "xy_table") c.encoders.counts_per_turn.setConstant(100'000);  // 10 um
  from.read("counts_per_turn", c.encoders.counts_per_turn);
  from.read("slides", c.encoders.slides);
  from.read("window", c.rates.window);
  from.read("max_rate", c.safety.encoders.max_rate);
  from.read("frozen_travel", c.safety.encoders.frozen_travel);
  check(from, c.encoders);
  check(from, c.rates);
  try {
    ph::rate_estimator<axes>{c.rates};
  } catch (const std::invalid_argument& error) {
    from.require(without_library(error.what()));
  }
  check(from, c.safety.encoders);
}

void read_homing(toml_section from, configuration& c) {
  if (c.mechanism == "five_bar" && !from.has("pose"))
    from.require("pose is missing, expected the joint positions at the start [rad]");
  if (c.mechanism == "xy_table") c.home = {0.08, 0.2245};
  else c.home = ph::tendon_two_link<double>(c.tendon_two_link).inverse({0.08, 0.2245}, ph::elbow::left).q;
  from.read("pose", c.home);
  if (from.has("pose")) from.require(ph::check_value("pose", c.home, "rad or m", ph::range::finite));
  if (!c.home.allFinite())
    from.require(
        "pose is missing, expected joint positions at the start [rad]: this arm does not reach (0.08, "
        "0.2245) m");
  from.read_all(c.homing);
  from.read_all(c.start);
  from.require(home_error(c));
}

// How the sensor turns, which a five_bar does not say by itself.
void read_sensor_frame(toml_section& from, configuration& c) {
  if (c.mechanism == "five_bar" && !from.has("link"))
    from.require(
        "link is missing, expected how far each joint turns the sensor: both angles of a five_bar are "
        "measured "
        "from the base, so [1, 0] or [0, 1] on a driven link, [0, 0] where the sensor does not turn; no such "
        "sum is the angle of a distal link");
  from.read("link", c.sensor_frame.link);
  if (c.mechanism == "xy_table" && !c.sensor_frame.link.isZero(0))
    from.refuse("link", "0, as the slides of an xy_table do not turn the sensor; remove it");
  from.read("mounting", c.sensor_frame.mounting);
  check(from, c.sensor_frame);
}

// A channel that the sensor lacks has no range.
void read_range_of_values(toml_section& from, configuration& c) {
  auto& range = c.safety.sensor.range;
  if (c.sensor == "comedi") from.read("range_of_values", range.data(), c.comedi_sensor.channels.size());
  else from.read("range_of_values", range);
  check(from, c.safety.sensor);
}

void read_sensor(toml_section from, configuration& c) {
  from.read("type", c.sensor, {"simulated", "comedi", "net_ft", "none"});
  c.sensor_frame.link.setConstant(c.mechanism == "tendon_two_link" ? 1 : 0);
  std::array<double, 2> x{1, 0}, y{0, 1};
  if (c.sensor == "comedi") {
    from.read_all(c.comedi_sensor);
  } else if (c.sensor == "net_ft") {
    from.read_all(c.net_ft);
  } else if (c.sensor == "none") {
    c.tare = false;
    return;
  }
  from.read_vector("x_newtons_per_unit", x);
  from.read_vector("y_newtons_per_unit", y);
  c.force.newtons_per_unit.setZero();
  c.force.newtons_per_unit.leftCols<2>() << x[0], x[1], y[0], y[1];
  read_range_of_values(from, c);
  from.read("handle_mass", c.force.handle_mass);
  from.read_vector("gravity", c.force.gravity);
  read_sensor_frame(from, c);
  from.read("tare", c.tare);
  from.read("tare_tolerance", c.tare_tolerance);
  if (!c.tare)
    from.refuse("tare_tolerance", "tare = true beside it, else nothing is tared; remove one of both");
  check(from, c.force);
  check(from, ph::steady_parameters{.tolerance = c.tare_tolerance});
}

void read_port(toml_section from, configuration& c) {
  from.read("type", c.port, {"simulated", "comedi", "serial"});
  if (c.port == "comedi") {
    from.read("device", c.comedi.device);
    from.read("output_subdevice", c.comedi.output_subdevice);
    std::array<int, axes> channel{0, 1}, range{}, subdevice{-1, -1}, counter{0, 1}, a{-1, -1}, b{-1, -1};
    std::array<double, axes> gain{};
    std::string setup = "keep";
    from.read("output_channels", channel);
    from.read("output_ranges", range);
    from.read("amperes_per_volt", gain);
    from.read("counter_subdevices", subdevice);
    from.read("counter_channels", counter);
    from.read("counter_setup", setup, {"keep", "ni_quadrature"});
    from.read("counter_a", a);
    from.read("counter_b", b);
    const auto is_given = [](int terminal) { return terminal != -1; };
    for (const auto& [key, terminals] : {std::pair{"counter_a", &a}, std::pair{"counter_b", &b}})
      if (setup == "keep" && std::any_of(terminals->begin(), terminals->end(), is_given))
        from.refuse(key,
                    "counter_setup = \"ni_quadrature\" beside it, else no terminal is set; add it, or "
                    "remove the key");
    for (std::size_t i = 0; i < static_cast<std::size_t>(axes); ++i) {
      c.comedi.brakes[i] = {channel[i], range[i], gain[i], c.safety.currents.max_current[i]};
      c.comedi.encoders[i] = {
          subdevice[i], counter[i],
          setup == "keep" ? comedi_counter_setup::keep : comedi_counter_setup::ni_quadrature, a[i], b[i]};
    }
    check(from, c.comedi);
  } else if (c.port == "serial") {
    from.read_all(c.serial);
  }
}

void read_loop(toml_section from, configuration& c) {
  from.read_all(c.loop);
  c.safety.period = c.loop.period;
  from.read_all(c.real_time);
}

void read_safety(toml_section from, configuration& c) {
  std::string policy = "zero";
  from.read("at_release", policy, {"zero", "ramp", "hold"});
  c.safety.at_release.policy = policy == "zero"   ? ph::release_policy::zero
                               : policy == "ramp" ? ph::release_policy::ramp
                                                  : ph::release_policy::hold;
  from.read("ramp_time", c.safety.at_release.ramp_time);
  from.read("hold_time", c.safety.at_release.hold_time);
  from.read("hold_over", c.safety.hold_over);
  check(from, c.safety);
  from.read("supervisor_timeout", c.supervisor.timeout);
  from.read("supervisor_priority", c.supervisor.priority);
  check(from, c.supervisor);
}

}  // namespace

configuration read_configuration(const std::string& path) {
  toml_section file = path.empty() ? toml_section::nothing() : toml_section::file(path);
  configuration c;
  if (path.empty())
    c.safety.hold_over = c.supervisor.timeout = 0.2;  // simulated, on a desktop that may be late
  read_mechanism(file.section("mechanism"), c);
  read_walls(file, c);
  const bool has_law = file.has("law");
  file.read("law", c.law,
            {"velocity_direct_control", "on_off_control", "saturated_direct_control", "direct_control",
             "no_direct_control"});
  file.read("log", c.log);
  read_loop(file.section("loop"), c);
  read_encoders(file.section("encoders"), c);
  // The slowest rate that the encoders distinguish from rest, unless the file has its own
  for (int i = 0; i < axes; ++i)
    c.brakes.rate_dead_band[i] = ph::rate_dead_band(ph::encoder_calibration<axes>(c.encoders).resolution()[i],
                                                    c.rates.window, c.loop.period);
  read_brakes(file.section("brakes"), c);
  read_safety(file.section("safety"), c);
  read_homing(file.section("homing"), c);
  read_sensor(file.section("sensor"), c);
  read_port(file.section("port"), c);
  file.section("simulation").read_all(c.simulation);
  file.finish();
  if (auto brakes = file.section("brakes"); !brakes.has("continuous_current"))
    brakes.refuse("heat",
                  "continuous_current beside it, over which a coil gets warm; add it, or remove heat");
  if (c.port == "comedi" && c.safety.at_release.policy != ph::release_policy::zero)
    file.require(
        "[safety] at_release, expected \"zero\": a card under Comedi has no watchdog, so that its currents "
        "would "
        "stay where the program dies");
  if (c.safety.hold_over < 2 * c.loop.period || c.supervisor.timeout < 4 * c.loop.period)
    file.require(
        "[safety] hold_over and supervisor_timeout, expected at least 2 and 4 times the period of [loop]");
  // As recommended_law: the mechanisms have inertia, the brakes lags, so that the sensor decides
  if (!has_law && c.sensor == "none") c.law = "on_off_control";
  if (c.sensor == "none" && c.law != "no_direct_control" && c.law != "on_off_control")
    file.require("law = \"" + c.law +
                 "\" needs a force sensor, expected [sensor] type other than \"none\", or law = "
                 "\"on_off_control\"");
  if ((c.sensor == "simulated") != (c.port == "simulated") && c.sensor != "none")
    file.require("[port] type = \"" + c.port + "\" and [sensor] type = \"" + c.sensor +
                 "\", expected both simulated or none");
  return c;
}

std::string remarks(const configuration& c) {
  std::string all;
  const auto add = [&](const auto&... parameters) { (all.append(ph::remarks(parameters)), ...); };
  if (c.mechanism == "tendon_two_link") add(c.tendon_two_link);
  else if (c.mechanism == "xy_table") add(c.xy_table);
  else add(c.five_bar);
  add(c.brakes, c.curves[0], c.curves[1], c.encoders, c.rates, c.homing, c.start, c.force, c.loop,
      c.real_time, c.safety, c.supervisor);
  if (c.sensor != "none") add(c.sensor_frame);
  if (c.port == "simulated") add(c.simulation);
  if (c.port == "serial") add(c.serial);
  if (c.sensor == "net_ft") add(c.net_ft);
  return all + c.wall_remarks;
}

configuration simulated(configuration c) {
  c.port = "simulated";
  if (c.sensor != "none") c.sensor = "simulated";
  return c;
}

}  // namespace example
