// A log by the library's own writer, for the reader of Python.
#include "reference.hpp"

#include <log/decision.hpp>
#include <log/log_row.hpp>

#include <passive_haptics/passive_haptics.hpp>

#include <fstream>

namespace reference {
namespace {

using arm = ph::tendon_two_link<double>;

// The cycles of a file of states as a log like that of brake_driver, and its numbers beside it.
void write_log(const std::string& in, const std::string& to) {
  const task<arm> given(in);
  std::ofstream log(to);
  doubles_out numbers(to + ".numbers");
  const ph::half_space<2> plane({0, 0.225}, {0, -1});
  ph::controller control(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(plane, 1e5)), ph::direct_control());
  example::log_row row;
  std::int64_t cycle = 0;
  for (auto state : given.states) {
    if (!std::isfinite(state.time)) continue;
    const auto decision = control(state);
    row.start();
    example::put_motion(row, {}, state);
    example::put_decision(row, {}, decision, decision.outcome == ph::status::ok);
    row.put("cycle", "1", ++cycle);
    row.put("reason", cycle % 3 == 0 ? "late, \"twice\"" : "");
    if (cycle == 1) log << row.header();
    log << row.csv();
    numbers.add(state.time);
    numbers.add(state.q);
    numbers.add(state.qd);
    numbers.add(state.hand_force);
  }
}

}  // namespace
}  // namespace reference

bool reference::run_log(const std::string& device, const std::string& law, const std::string& mode,
                        const std::string& in, const std::string& to) {
  if (device != "tendon_two_link" || law != "log" || mode != "write") return false;
  write_log(in, to);
  return true;
}
