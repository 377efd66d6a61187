// libFuzzer: the bytes of a configuration file. What is accepted keeps every range, makes a device under its
// law, and that device's currents stay within their limits, whatever its sensors say; its device file makes
// the same device. What is refused is named with the file and what was expected.
#include "memory_file.hpp"

#include <catalogue/catalogue.hpp>
#include <catalogue/entries.hpp>
#include <catalogue/laws.hpp>
#include <configuration/configuration.hpp>
#include <configuration/home.hpp>
#include <devices/haptic_device.hpp>

#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/runtime/device_file/device_text.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

namespace ph = passive_haptics;

// A smaller one, with a mechanism that the driver does not take.
ph::runtime::catalogue& example::catalogue() {
  using namespace ph;
  static runtime::catalogue all = [] {
    runtime::catalogue some;
    some.add_mechanism<tendon_two_link<double>, tendon_two_link_parameters<double>>("tendon_two_link");
    some.add_mechanism<xy_table<double>, xy_table_parameters<double>>("xy_table");
    some.add_mechanism<five_bar<double>, five_bar_parameters<double>>("five_bar");
    some.add_mechanism<delta<double>, delta_parameters<double>>("delta");
    add_shapes(some);
    add_effects(some);
    add_brake_models(some);
    std::apply(
        [&](const auto&... law) {
          some.add_laws(law...);
          some.compile_for<tendon_two_link<double>>(law...);
          some.compile_for<xy_table<double>>(law...);
          some.compile_for<five_bar<double>>(law...);
        },
        laws);
    return some;
  }();
  return all;
}

namespace {

using fuzz::require;

template <class... Parameters>
void require_valid(const Parameters&... all) {
  const auto check = [](const auto& p) {
    const std::string error = ph::validate(p);
    require(error.empty(), "what is not valid was accepted", error);
  };
  (check(all), ...);
}

// All that it says, in words.
std::string text_of(const example::configuration& c) {
  std::string all =
      ph::runtime::device_text(c.device) + c.port + c.sensor + c.log + remarks(c) + std::to_string(c.tare);
  const auto add = [&](const auto&... p) { ((all += ph::to_text(p)), ...); };
  for (const ph::brake_curve& curve : c.curves) add(curve);
  add(c.encoders, c.rates, c.force, c.sensor_link, c.homing, c.start, c.loop, c.real_time, c.safety,
      c.supervisor, c.serial, c.net_ft, c.simulation);
  std::visit(add, c.comedi);
  std::visit(add, c.comedi_sensor);
  return all;
}

void check(example::configuration c) {
  require_valid(c.device.brakes, c.device.options, c.device.scene, c.curves, c.encoders, c.rates, c.force,
                c.homing, c.start, c.sensor_link, c.loop, c.real_time, c.safety, c.supervisor, c.serial,
                c.net_ft, c.simulation);
  const auto is_valid = [](const auto& p) { require_valid(p); };
  if (c.port == "comedi") std::visit(is_valid, c.comedi);
  if (c.sensor == "comedi") std::visit(is_valid, c.comedi_sensor);
  require(c.home.allFinite(), "a home pose that is not finite");
  require(home_error(c).empty(), "a home pose deep in a wall", home_error(c));

  c.simulation.wire.clear();  // no file is to be made
  example::haptic_device device(c);
  using limits = std::numeric_limits<double>;
  constexpr std::array values{0.0, 1.0, -1e3, 1e9, limits::max(), limits::infinity(), limits::quiet_NaN()};
  example::samples now;
  example::record r;
  for (std::size_t k = 0; k < 2 * values.size(); ++k) {
    now.now += c.loop.period;
    now.time += c.loop.period;
    now.counts.fill(k < values.size() ? std::floor(values[k]) : static_cast<double>(k));
    now.readings.fill(values[k % values.size()]);
    device.deepest_wall(now);
    const auto currents = device.cycle(now, example::phase::running, r);
    for (std::size_t i = 0; i < currents.size(); ++i)
      require(currents[i] >= 0 && currents[i] <= c.safety.currents.max_current[i],
              "a current out of its limits");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::memory_file file(fuzz::reader(data, size).text());
  try {
    const example::configuration c = example::read_configuration(file.path());
    require(text_of(c) == text_of(example::read_configuration(file.path())),
            "another reading of the same file");
    check(c);
    const std::string device = ph::runtime::device_text(c.device);
    const auto file_again = ph::runtime::toml_section::text("device.toml", device);
    const auto again = ph::runtime::read_device(file_again, example::catalogue());
    file_again.finish();
    require(ph::runtime::device_text(again) == device, "another device by its own file", device);
    require(simulated(c).port == "simulated", "not simulated");
    check(simulated(c));
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    require(text.starts_with(file.path()), "an error without the file", text);
    fuzz::require_readable(text);
  }
  return 0;
}
