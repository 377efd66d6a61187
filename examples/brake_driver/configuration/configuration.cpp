#include <configuration/configuration.hpp>
#include <configuration/home.hpp>

#include <catalogue/catalogue.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <variant>

namespace example {
namespace {

using ph::runtime::toml_section;

// Keys with other names than the members.
const std::map<std::string_view, std::string_view> keys{{"continuous", "continuous_current"},
                                                        {"max_current", "current_limit"}};

template <class Parameters>
void check(const toml_section& from, const Parameters& p) {
  from.check(p, keys);
}

// Error text without the library's name.
std::string without_library(const std::string& text) {
  constexpr std::string_view library = "passive_haptics: ";
  return text.starts_with(library) ? text.substr(library.size()) : text;
}

// A question about the free side of a wall with this shape.
std::string free_side(ph::runtime::any_parameters shape) {
  for (const auto& f : shape.fields()) {
    const std::string_view key = f.about.name;
    if (key == "normal") return "check that its normal points to the free side";
    if (key == "inside") return "check its inside (solid: free outside, hollow: free inside)";
  }
  return "check its free side (free inside, it is a complement)";
}

template <int D>
std::vector<named_wall> walls_of(const ph::runtime::device_description& device) {
  std::vector<named_wall> all;
  for (ph::runtime::wall_description wall : device.walls) {
    auto& [type, parameters] = wall.shapes.front();
    named_wall& made = all.emplace_back(named_wall{type, free_side(parameters), {}});
    if (type == "mesh_surface") type = "mesh_solid";
    try {
      ph::runtime::any_shape<D> shape = *ph::runtime::make_shape<D>(catalogue(), wall, 0);
      if (wall.motion)  // grown by its motion, so that its outside is always outside
        shape = ph::runtime::any_shape<D>(
            ph::offset(shape, wall.motion->as<ph::runtime::wall_motion<D>>().amplitude.norm()));
      made.shape = std::move(shape);
    } catch (const std::invalid_argument&) {  // an open surface
    }
  }
  return all;
}

// Reads a key with a number for each of the first values, or one for all.
template <class Values>
void read_first(toml_section& from, std::string_view key, Values& values, int count) {
  from.read(key, values.data(), static_cast<std::size_t>(count));
}

// Limits of the brakes follow from the curves, unless the file has them.
void read_curves(toml_section from, configuration& c, ph::runtime::brake_numbers& brakes) {
  const int count = c.mechanism.brakes();
  std::array<double, max_axes> residual{}, slope, limit, hysteresis{}, loss{};
  slope.fill(1);
  limit.fill(1);
  read_first(from, "residual_torque", residual, count);
  read_first(from, "torque_per_ampere", slope, count);
  read_first(from, "current_limit", limit, count);
  read_first(from, "hysteresis", hysteresis, count);
  read_first(from, "loss_per_kelvin", loss, count);
  int tables = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    ph::brake_curve& curve = c.curves[i];
    curve.residual_torque = residual[i];
    curve.current_limit = limit[i];
    curve.hysteresis = hysteresis[i];
    curve.loss_per_kelvin = loss[i];
    std::array<double, 2 * ph::brake_curve::max_points> pairs{};
    const std::string table = "table_" + std::to_string(i + 1);
    curve.points = static_cast<int>(from.read_pairs(table, pairs.data(), ph::brake_curve::max_points));
    if (curve.points == 0) {
      from.refuse(table, "2 to 16 pairs of amperes and newton metres; write them down, or remove it");
      curve.torque_per_ampere = slope[i];
    }
    tables += curve.points > 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(curve.points); ++k)
      curve.table[k] = {pairs[2 * k], pairs[2 * k + 1]};
    brakes.torque_limit[i] = torque_of_current(curve, curve.current_limit);
  }
  if (tables == count)
    from.refuse("torque_per_ampere", "no slope if all brakes have a table, which is used instead; remove it");
  if (std::any_of(loss.begin(), loss.end(), [](double x) { return x != 0; }))
    from.refuse("loss_per_kelvin", "0, as no sensor of this program reads a brake's temperature; remove it");
  from.require(validate(c.curves));
  for (const ph::brake_curve& curve : c.curves) check(from, curve);

  c.safety.currents.max_current = limit;
  c.safety.currents.continuous = limit;
  read_first(from, "continuous_current", c.safety.currents.continuous, count);
  read_first(from, "heat", c.safety.currents.heat, count);
  read_first(from, "max_rise_rate", c.safety.currents.max_rise_rate, count);
  check(from, c.safety.currents);
}

void read_encoders(toml_section from, configuration& c) {
  const int count = c.safety.encoders.encoders = c.mechanism.encoders();
  c.encoders.slides = joint_motion(c.mechanism).axis_slides;
  for (std::size_t i = 0; i < c.encoders.slides.size(); ++i)
    if (c.encoders.slides[i]) c.encoders.counts_per_turn[static_cast<int>(i)] = 100'000;  // 10 um
  read_first(from, "counts_per_turn", c.encoders.counts_per_turn, count);
  read_first(from, "slides", c.encoders.slides, count);
  from.read("window", c.rates.window);
  from.read("max_rate", c.safety.encoders.max_rate);
  from.read("frozen_travel", c.safety.encoders.frozen_travel);
  check(from, c.encoders);
  check(from, c.rates);
  try {
    ph::rate_estimator<max_axes>{c.rates};
  } catch (const std::invalid_argument& error) {
    from.require(without_library(error.what()));
  }
  check(from, c.safety.encoders);
}

void read_homing(toml_section from, configuration& c) {
  const int count = c.mechanism.joints();
  // In front of the default wall [m]
  const std::vector<double> usual =
      c.mechanism.dimension() == 2 ? std::vector{0.08, 0.2245} : std::vector{0.0, 0.0, -0.1495};
  if (const auto q = c.mechanism.of().inverse(usual); q.count == count) c.home = filled_up<axis_numbers>(q);
  else if (!from.has("pose"))
    from.require(
        "pose is missing: expected joint positions at the start [rad or m]: without it the handle of a " +
        c.device.mechanism.name + " would start at " +
        (usual.size() == 2 ? "(0.08, 0.2245)" : "(0, 0, -0.1495)") + " m, for which no pose is known");
  read_first(from, "pose", c.home, count);
  if (from.has("pose")) from.require(ph::check_value("pose", c.home, "rad or m", ph::range::finite));
  from.read_all(c.homing);
  from.read_all(c.start);
  from.require(home_error(c));
}

// Orientation of the sensor: rotates with the last link of a serial chain.
void read_sensor_frame(toml_section& from, configuration& c) {
  if (c.mechanism.dimension() == 3) return;
  const joint_motion joints(c.mechanism);
  if (!joints.angles_add_up && !from.has("link"))
    from.require(
        "link is missing: expected how far each joint turns the sensor: both angles of a " +
        c.device.mechanism.name +
        " are measured from the base, so [1, 0] or [0, 1] on a driven link, [0, 0] if the sensor does not "
        "rotate; distal links are not supported");
  for (int i = 0; i < joints.joints; ++i)
    c.sensor_link.link[i] = joints.slides[static_cast<std::size_t>(i)] || !joints.angles_add_up ? 0 : 1;
  read_first(from, "link", c.sensor_link.link, joints.joints);
  for (int i = 0; i < joints.joints; ++i)
    if (joints.slides[static_cast<std::size_t>(i)] && c.sensor_link.link[i] != 0)
      from.refuse("link", std::string(joints.all(true) ? "0" : "0 for joint " + std::to_string(i + 1)) +
                              ", as a slide does not rotate the sensor; remove it");
  from.read("mounting", c.sensor_link.mounting);
  check(from, c.sensor_link);
}

// Channels that the sensor lacks have no range.
void read_range_of_values(toml_section& from, configuration& c) {
  auto& range = c.safety.sensor.range;
  if (c.sensor == "comedi") read_first(from, "range_of_values", range, c.mechanism.dimension());
  else from.read("range_of_values", range);
  check(from, c.safety.sensor);
}

// Spatial platforms only translate.
bool has_orientation(const configuration& c) {
  return c.mechanism.dimension() == 2 || !c.mechanism.of().handle_rotates();
}

void read_sensor(toml_section from, configuration& c) {
  const int dimension = c.mechanism.dimension();
  if (!has_orientation(c)) {
    c.sensor = "none";
    from.read("type", c.sensor, {"none"},
              ": the handle of a " + c.device.mechanism.name +
                  " rotates, and the program supports no sensor that rotates with it");
  } else {
    from.read("type", c.sensor, {"simulated", "comedi", "net_ft", "none"});
  }
  if (c.sensor == "comedi") {
    if (dimension == 3) c.comedi_sensor.emplace<1>();
    std::visit([&](auto& p) { from.read_all(p); }, c.comedi_sensor);
  } else if (c.sensor == "net_ft") {
    from.read_all(c.net_ft);
  } else if (c.sensor == "none") {
    c.tare = false;
    return;
  }
  // Rows for the first channels; by default the channels are the components
  constexpr std::array rows{"x_newtons_per_unit", "y_newtons_per_unit", "z_newtons_per_unit"};
  const auto size = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < size; ++i) {
    spatial row = spatial::Unit(static_cast<int>(i));
    from.read_vector(rows[i], row.data(), size);
    c.force.newtons_per_unit.row(static_cast<int>(i)).head<3>() = row;
  }
  read_range_of_values(from, c);
  from.read("handle_mass", c.force.handle_mass);
  from.read_vector("gravity", c.force.gravity.data(), size);
  read_sensor_frame(from, c);
  from.read("tare", c.tare);
  from.read("tare_tolerance", c.tare_tolerance);
  if (!c.tare)
    from.refuse("tare_tolerance",
                "tare = true, without which nothing is tared; set tare = true, or remove the key");
  check(from, c.force);
  check(from, ph::steady_parameters{.tolerance = c.tare_tolerance});
}

template <int N>
void read_comedi(toml_section& from, const configuration& c, comedi_port_parameters<N, N>& card) {
  from.read("device", card.device);
  from.read("output_subdevice", card.output_subdevice);
  constexpr auto size = static_cast<std::size_t>(N);
  std::array<int, size> channel, range{}, subdevice, counter, a, b;
  std::iota(channel.begin(), channel.end(), 0);
  counter = channel;
  subdevice.fill(-1);
  a = b = subdevice;
  std::array<double, size> gain{};
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
                  "counter_setup = \"ni_quadrature\", without which no terminal is set; add it, or "
                  "remove the key");
  for (std::size_t i = 0; i < size; ++i) {
    card.brakes[i] = {channel[i], range[i], gain[i], c.safety.currents.max_current[i]};
    card.encoders[i] = {subdevice[i], counter[i],
                        setup == "keep" ? comedi_counter_setup::keep : comedi_counter_setup::ni_quadrature,
                        a[i], b[i]};
  }
  check(from, card);
}

void read_port(toml_section from, configuration& c) {
  from.read("type", c.port, {"simulated", "comedi", "serial"});
  if (c.port == "comedi") {
    const int count = c.mechanism.brakes();
    if (count != c.mechanism.encoders() || count < 2 || count > 3)
      from.refuse("type",
                  "\"simulated\" or \"serial\": a card supports two or three brakes with an encoder each");
    if (count == 3) c.comedi.emplace<1>();
    std::visit([&](auto& card) { read_comedi(from, c, card); }, c.comedi);
  } else if (c.port == "serial") {
    from.read_all(c.serial);
  }
}

void read_simulation(toml_section from, configuration& c) {
  if (!c.device.brake_models.empty())
    from.refuse("brake_lag",
                "no lag in [simulation], as the file has [[brakes.model]]; remove one of the two");
  c.simulation.direction.resize(static_cast<std::size_t>(c.mechanism.dimension()));
  from.read_all(c.simulation);
}

// Error text for mechanisms without inertia
std::string without_inertia(const configuration& c) {
  if (c.mechanism.of().has_inertia()) return "";
  return "[mechanism] type = \"" + c.device.mechanism.name +
         "\": expected one with inertia, which a simulated device needs";
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
  if (path.empty()) c.safety.hold_over = c.supervisor.timeout = 0.2;  // simulated, on a desktop with delays
  ph::runtime::device_reader reader(file, catalogue());
  reader.read_mechanism();
  c.mechanism = driven_mechanism(reader.device.make_mechanism(catalogue()));
  file.read("log", c.log);
  read_loop(file.section("loop"), c);
  c.device.mechanism = reader.device.mechanism;
  read_encoders(file.section("encoders"), c);
  ph::runtime::brake_numbers& brakes = reader.device.brakes =
      ph::runtime::brake_numbers(c.mechanism.brakes());
  // Minimum rate that the encoders distinguish from rest, unless the file has it
  const axis_numbers resolution = ph::encoder_calibration<max_axes>(c.encoders).resolution();
  for (int i = 0; i < c.mechanism.brakes() && i < c.mechanism.encoders(); ++i)
    brakes.rate_dead_band[static_cast<std::size_t>(i)] =
        ph::rate_dead_band(resolution[i], c.rates.window, c.loop.period);
  read_curves(file.section("brakes"), c, brakes);
  reader.read_brakes();
  reader.read_scene();
  reader.read_sensor();
  if (!has_orientation(c)) reader.device.has_force_sensor = false;
  reader.read_law();
  c.device = std::move(reader.device);
  c.walls = c.mechanism.dimension() == 2 ? walls_of<2>(c.device) : walls_of<3>(c.device);
  read_safety(file.section("safety"), c);
  read_homing(file.section("homing"), c);
  read_sensor(file.section("sensor"), c);
  read_port(file.section("port"), c);
  read_simulation(file.section("simulation"), c);
  file.finish();
  if (auto from = file.section("brakes"); !from.has("continuous_current"))
    from.refuse("heat", "continuous_current, above which a coil heats up; add it, or remove heat");
  const toml_section safety = file.section("safety");
  if (c.port == "comedi" && c.safety.at_release.policy != ph::release_policy::zero)
    safety.refuse("at_release",
                  "\"zero\": a card under Comedi has no watchdog, so its currents stay if the program dies");
  const auto require_periods = [&](const char* name, double seconds, int count) {
    if (seconds < count * c.loop.period)
      safety.require(ph::detail::error_text(
          name, seconds, ph::detail::indexed("at least ", count, " times the period of [loop]")));
  };
  require_periods("hold_over [s]", c.safety.hold_over, 2);
  require_periods("supervisor_timeout [s]", c.supervisor.timeout, 4);
  if ((c.sensor == "simulated") != (c.port == "simulated") && c.sensor != "none")
    file.require("[port] type = \"" + c.port + "\" and [sensor] type = \"" + c.sensor +
                 "\": expected both simulated or none");
  if (c.port == "simulated") file.require(without_inertia(c));
  return c;
}

calibration calibration_of(const configuration& c) {
  return {c.mechanism, {c.encoders, c.rates, c.curves, c.force}, {c.mechanism, c.sensor_link}};
}

std::string remarks(const configuration& c) {
  std::string all = c.device.remarks;
  const auto add = [&](const auto&... parameters) { (all.append(ph::remarks(parameters)), ...); };
  for (int i = 0; i < c.mechanism.brakes(); ++i) add(c.curves[static_cast<std::size_t>(i)]);
  add(c.encoders, c.rates, c.homing, c.start, c.force, c.loop, c.real_time, c.safety, c.supervisor);
  if (c.sensor != "none") add(c.sensor_link);
  if (c.port == "simulated") add(c.simulation);
  if (c.port == "serial") add(c.serial);
  if (c.sensor == "net_ft") add(c.net_ft);
  return all;
}

configuration simulated(configuration c) {
  if (const std::string error = without_inertia(c); !error.empty()) throw std::invalid_argument(error);
  c.port = "simulated";
  if (c.sensor != "none") c.sensor = "simulated";
  return c;
}

std::string summary(const configuration& c) {
  return c.device.mechanism.name + ", " + c.port + " device, " + c.sensor + " force sensor, " +
         c.device.law.name;
}

}  // namespace example
