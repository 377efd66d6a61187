// libFuzzer: a log, whose first line may say how it is replayed. What is read is in order and finite, and
// reads back as it was written. A replay decides without harm, and its own output replays to the last digit.
// What is refused is named with line and expectation.
#include "input.hpp"

#include <log/log_reader.hpp>
#include <log/replay_program.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace ph = passive_haptics;
using example::log_reader;
using fuzz::require;

// Of "# replay MECHANISM LAW WALL STIFFNESS LIMIT DEAD_BAND NAME=VALUE ...", or as much of it as there
// is.
example::replay_options options_of(const std::string& log) {
  constexpr std::array laws{"direct_control", "velocity_direct_control", "no_direct_control"};
  example::replay_options o{.mechanism = "0"};
  std::istringstream words(log.substr(0, log.find('\n')));
  std::string word;
  if (!(words >> word) || word != "#" || !(words >> word) || word != "replay") return o;
  std::size_t law = 0;
  words >> o.mechanism >> law >> o.wall;
  o.law = laws[law % laws.size()];
  // As its command line asks of them
  for (double* const at : {&o.stiffness, &o.limit, &o.dead_band}) {
    double value = 0;
    if (words >> value && std::isfinite(value) && value > 0) *at = value;
  }
  for (std::string one; words >> one;) o.parameters.push_back(one);
  return o;
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

std::string replay(const example::replay_job& job, const example::replay_options& options,
                   const std::string& log) {
  std::istringstream in(log);
  log_reader reader(in, "log");
  std::ostringstream out;
  const example::replay_summary all = job(options, reader, out, {});
  require(all.same <= all.compared && all.compared <= all.decided && all.decided <= all.lines,
          "more than all lines");
  return out.str();
}

void check(const example::replay_options& options, const std::string& log) {
  static const std::array jobs{
      example::replay_of<ph::tendon_two_link<double>, ph::tendon_two_link_parameters<double>>(),
      example::replay_of<ph::xy_table<double>, ph::xy_table_parameters<double>>(),
      example::replay_of<ph::delta<double>, ph::delta_parameters<double>>()};
  const auto& job = jobs[static_cast<unsigned char>(options.mechanism.front()) % jobs.size()];
  const std::string once = replay(job, options, log);
  for (const char* cell : {",nan", ",-nan", ",inf", ",-inf"})
    require(!fuzz::has(once, cell), "what is not finite was written", once);
  require(replay(job, options, once) == once, "another replay of its own output", once);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  std::cerr.setstate(std::ios::failbit);  // replay remarks on what is unusual
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string log = fuzz::reader(data, size).text();
  try {
    const std::string once = written_again(log);
    if (!once.empty()) require(written_again(once) == once, "another log was read back", once);
    check(options_of(log), log);
  } catch (const example::log_error& error) {
    const std::string text = error.what();
    require(text.starts_with("log, line ") && fuzz::has(text, ", expected "), "an error without its place",
            text);
    fuzz::require_readable(text);
  } catch (const std::invalid_argument& error) {
    require(fuzz::has(error.what(), "expected "), "nothing was expected", error.what());
  }
  return 0;
}
