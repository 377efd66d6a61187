// docs/guide/driver.md has the table of hazards as it is in the code, and a test of each.
#include "texts.hpp"

#include <passive_haptics/bench/bench_run.hpp>
#include <passive_haptics/driver/hazards.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

namespace {

namespace ph = passive_haptics;
using namespace repository;

// The test of each hazard, in their order: SUITE.NAME, and its file in tests/driver.
struct test_of_a_hazard {
  std::string_view suite, name, file;
};
constexpr test_of_a_hazard fault{"a_fault", "releases_the_brakes_in_time_and_says_why", "safe_port.cpp"};
constexpr test_of_a_hazard quarter{"rejected_samples",
                                   "release_the_brakes_if_they_are_a_quarter_of_those_that_arrived",
                                   "sample_checks.cpp"};
constexpr std::array tests_of_hazards{
    fault,
    fault,
    fault,
    test_of_a_hazard{"a_supervised_loop", "that_does_not_know_what_flows_gives_no_heartbeat",
                     "supervisor.cpp"},
    fault,
    fault,
    fault,
    test_of_a_hazard{"a_frozen_encoder", "is_noticed_after_the_others_turned_so_far_without_a_brake",
                     "sample_checks.cpp"},
    quarter,
    quarter,
    test_of_a_hazard{"a_counter", "that_may_have_wrapped_unseen_needs_homing_in_each_state",
                     "sample_checks.cpp"},
    fault,
    fault,
    test_of_a_hazard{"a_control_loop", "of_a_machine_that_was_suspended_releases_before_the_next_cycle",
                     "control_loop.cpp"},
    test_of_a_hazard{"a_control_loop", "may_overrun_so_often_from_its_first_cycle_on", "control_loop.cpp"},
    test_of_a_hazard{"a_supervised_loop", "whose_law_throws_leaves_no_current", "supervisor.cpp"},
    test_of_a_hazard{"a_request", "to_stop_releases_first_and_ends_the_loop", "supervisor.cpp"},
    test_of_a_hazard{"threaded_port", "carries_out_what_was_ordered_before_its_end", "threaded_port.cpp"},
    test_of_a_hazard{"a_signal", "that_kills_the_loop_leaves_no_current_and_no_record_behind",
                     "supervisor.cpp"},
    test_of_a_hazard{"a_driver_without", "close_range_leaves_no_process_where_it_is_killed",
                     "program/surroundings.cpp"},
    test_of_a_hazard{"a_supervised_loop", "that_is_stopped_is_released_and_stays_so_when_it_goes_on",
                     "supervisor.cpp"},
    test_of_a_hazard{"a_driver_whose", "rearm_request_waited_in_a_freeze_stays_released",
                     "program/faults.cpp"},
    test_of_a_hazard{"a_supervised_loop", "whose_hold_is_over_stays_without_current", "supervisor.cpp"},
    test_of_a_hazard{"a_supervised_loop", "whose_port_does_not_come_back_is_released", "supervisor.cpp"},
    test_of_a_hazard{"a_driver_whose", "supervisor_is_killed_is_released_for_good", "program/faults.cpp"},
    test_of_a_hazard{"process_faults", "end_as_the_release_policy_says_and_lose_nothing_untold",
                     "program/process_faults.cpp"},
    test_of_a_hazard{"record_on_bench", "ends_with_the_brakes_released_and_the_name_of_what_was_wrong",
                     "bench_run.cpp"},
    test_of_a_hazard{"record_on_bench", "ends_on_the_clock_of_this_machine_whatever_the_samples_say",
                     "bench_run.cpp"},
    test_of_a_hazard{"a_driver_without", "standard_descriptors_leaves_a_whole_log",
                     "program/surroundings.cpp"},
    test_of_a_hazard{"a_handle", "deep_in_a_wall_gets_no_brakes_and_the_end_says_so", "program/home.cpp"},
};

std::string milliseconds(double seconds) {
  if (std::isinf(seconds)) return "never";
  std::ostringstream text;
  text << 1e3 * seconds;
  return text.str();
}

std::string table_of_hazards() {
  std::string all =
      "| Hazard | Noticed by | 0 A after [ms] | Afterwards | Test |\n| --- | --- | --- | --- | --- |\n";
  const auto hazards = ph::hazards();
  for (std::size_t i = 0; i < hazards.size() && i < tests_of_hazards.size(); ++i) {
    const auto& [what, found_by, longest, after] = hazards[i];
    const auto& [suite, name, file] = tests_of_hazards[i];
    const auto cell = [&](const auto& text) { all.append("| ").append(text).append(" "); };
    cell(what), cell(found_by), cell(milliseconds(longest)), cell(after);
    cell(std::string("[`").append(suite).append("`](../../tests/driver/").append(file).append(")"));
    all.append("|\n");
  }
  return all;
}

TEST(hazards, of_a_bench_are_those_of_its_parameters) {
  EXPECT_EQ(ph::driver_timing().bench_hold_over, ph::bench_parameters().hold_over);
  EXPECT_EQ(ph::driver_timing().bench_overtime, ph::max_bench_overtime);
}

TEST(hazards, have_a_test_each) {
  ASSERT_EQ(ph::hazards().size(), tests_of_hazards.size());
  for (const auto& [suite, name, file] : tests_of_hazards) {
    const std::string text = read(root / "tests/driver" / file);
    const std::string test = std::string("(").append(suite).append(", ").append(name).append(")");
    EXPECT_NE(text.find(test), std::string::npos) << "tests/driver/" << file << " has no test " << test;
  }
}

TEST(hazards, stand_in_the_guide_as_they_are_in_the_code) {
  const fs::path path = root / "docs/guide/driver.md";
  const std::string now = read(path), begin = "<!-- hazards -->\n", end = "<!-- end of hazards -->\n";
  const auto from = now.find(begin), to = now.find(end);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos);
  const std::string right = now.substr(0, from + begin.size()) + table_of_hazards() + now.substr(to);
  if (std::getenv("PASSIVE_HAPTICS_WRITE_PAGES") != nullptr) std::ofstream(path) << right;
  else EXPECT_TRUE(now == right) << path << " is out of date, expected:\n" << table_of_hazards();
}

// With the times of other parameters, and under each policy.
TEST(hazards, follow_the_parameters) {
  ph::driver_timing p;
  p.loop.period = 0.002;
  p.hold_over = 0.03;
  p.supervisor.timeout = 0.2;
  p.watchdog = 0.5;
  p.wake_up = 0.0001;
  p.at_release = {.policy = ph::release_policy::hold, .ramp_time = 3, .hold_time = 7};
  const auto of = [&](std::string_view begins) {
    for (const auto& one : ph::hazards(p))
      if (one.what.starts_with(begins)) return one.max_time;
    ADD_FAILURE() << begins;
    return 0.0;
  };
  const double cycle = 0.0021, supervised = 0.2505, held = 7 + cycle, ramped = 3 + cycle;
  EXPECT_DOUBLE_EQ(of("A transfer of a threaded port"), 0.03 + 2 * cycle + supervised + held);
  EXPECT_DOUBLE_EQ(of("The loop is stopped (SIGSTOP)"), supervised + held);
  EXPECT_DOUBLE_EQ(of("The device rejects currents and the release"), 0.03 + cycle + supervised + held);
  EXPECT_EQ(of("The device rejects currents"), std::numeric_limits<double>::infinity())
      << "the loop holds on";
  EXPECT_DOUBLE_EQ(of("Loop and supervisor"), 0.5);
  p.at_release.policy = ph::release_policy::ramp;
  EXPECT_DOUBLE_EQ(of("The device rejects currents"), 0.03 + cycle + ramped);
  EXPECT_DOUBLE_EQ(of("The supervisor dies"), cycle + 0.2 + cycle + ramped);
  EXPECT_DOUBLE_EQ(of("The device is lost"), cycle) << "at once, whatever the policy";
  p.at_release.policy = ph::release_policy::zero;
  EXPECT_DOUBLE_EQ(of("The loop's process dies"), 0.0021);
  p.process_end = 10;
  EXPECT_DOUBLE_EQ(of("The loop's process dies"), supervised) << "no heartbeat";
}

}  // namespace
