// libFuzzer: a log, before which there may be a device file and a line ---. What is read is in order and
// finite, and reads back as it was written. A replay decides without harm, and its own output replays to the
// last digit. What is refused is named with line and expectation.
#include "input.hpp"

#include <log/log_reader.hpp>
#include <log/log_row.hpp>
#include <log/replay.hpp>

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace ph = passive_haptics;
using example::log_reader;
using fuzz::require;

// Some of each kind.
ph::runtime::catalogue some() {
  using namespace ph;
  runtime::catalogue all;
  all.add_mechanism<tendon_two_link<double>, tendon_two_link_parameters<double>>("tendon_two_link");
  all.add_mechanism<xy_table<double>, xy_table_parameters<double>>("xy_table");
  all.add_mechanism<delta<double>, delta_parameters<double>>("delta");
  all.add_shape<half_space<2>, half_space_parameters<2>>("half_space");
  all.add_shape<half_space<3>, half_space_parameters<3>>("half_space");
  all.add_shape<ball<2>, ball_parameters<2>>("ball");
  all.add_shape<ball<3>, ball_parameters<3>>("ball");
  all.add_brake_model<coulomb_brake<double>>("coulomb");
  const auto add = [&](const auto&... laws) {
    all.add_laws(laws...);
    all.compile_for<tendon_two_link<double>>(laws...);
    all.compile_for<xy_table<double>>(laws...);
    all.compile_for<delta<double>>(laws...);
  };
  add(runtime::named_law<direct_control>{"direct_control"},
      runtime::named_law<velocity_direct_control>{"velocity_direct_control"},
      runtime::named_law<on_off_control>{"on_off_control"});
  return all;
}

// The numbers of each line, once all of it is read.
std::string written_again(const std::string& log) {
  std::istringstream in(log);
  log_reader reader(in, "log");
  std::string all;
  example::log_row row;
  double time = -HUGE_VAL;
  const std::size_t t = reader.column("t", {"s"});
  std::vector<std::pair<const char*, std::size_t>> columns;
  for (const char* name : {"q1", "q2", "qd1", "Fh_x"})
    if (const auto found = reader.find(name)) columns.emplace_back(name, *found);
  for (bool first = true; reader.next(); first = false) {
    require(reader.number(t) >= time, "time goes back");
    time = reader.number(t);
    row.start();
    row.put("t", "s", time);
    for (const auto& [name, column] : columns) {
      require(!std::isinf(reader.number(column)), "a number that is not finite");
      row.put(name, "1", reader.number(column));
    }
    if (first) all = row.header();
    all += row.csv();
  }
  return all;
}

std::string replay(const ph::runtime::any_controller& begins, const std::string& log) {
  const auto control = begins.copy();
  std::istringstream in(log);
  log_reader reader(in, "log");
  std::ostringstream out;
  const example::replay_summary all = replay(reader, out, *control);
  require(all.same <= all.compared && all.compared <= all.decided && all.decided <= all.lines,
          "more than all lines");
  return out.str();
}

void check(const std::string& device, const std::string& log) {
  static const ph::runtime::catalogue all = some();
  auto file = ph::runtime::toml_section::text("device", device);
  const auto d = ph::runtime::read_device(file, all);
  file.finish();
  require(ph::validate(d.brakes).empty() && d.mechanism.parameters.error().empty() &&
              d.law.parameters.error().empty() && ph::validate(d.options).empty(),
          "what is not valid was accepted", device);
  const auto control = d.make_controller(all, *d.make_mechanism(all));
  const std::string once = replay(*control, log);
  for (const char* cell : {",nan", ",-nan", ",inf", ",-inf"})
    require(!fuzz::has(once, cell) || fuzz::has(log, cell), "what is not finite was written", once);
  require(replay(*control, once) == once, "another replay of its own output", once);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::reader(data, size).text(), line = "\n---\n";
  const std::size_t end = text.find(line);
  const std::string device = end == text.npos ? "" : text.substr(0, end);
  const std::string log = end == text.npos ? text : text.substr(end + line.size());
  try {
    const std::string once = written_again(log);
    if (!once.empty()) require(written_again(once) == once, "another log was read back", once);
    check(device, log);
  } catch (const example::log_error& error) {
    const std::string found = error.what();
    require(found.starts_with("log, line ") && fuzz::has(found, ": expected "), "an error without its place",
            found);
    fuzz::require_readable(found);
  } catch (const std::invalid_argument& error) {
    const std::string found = error.what();
    require(found.starts_with("device"), "an error without the file", found);
    fuzz::require_readable(found);
  }
  return 0;
}
