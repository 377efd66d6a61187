// The hand at the wall: the log of a run shows that it stays there.
#include "program.hpp"

#include <algorithm>

namespace wall_tests {

using namespace program;

// Of the first way of the hand along the wall, from the first touch on, by the encoders.
struct way_along_the_wall {
  std::size_t cycles = 0;
  int separations = 0;
  double max_depth = -1;  // [m]
  double latest = 0;      // that a cycle began [s]

  // A machine that stalls for as long as the brakes' lag says nothing of a law.
  bool is_telling() const { return latest < 0.020; }
};

// The simulated hand begins at x = 0.08 m, and lifts off after 0.06 m; the wall is at y = 0.225 m.
way_along_the_wall first_way(const log_file& log) {
  constexpr double one_count = 0.1e-3;  // of 8192 a turn, at the handle [m]
  way_along_the_wall found;
  bool in_contact = false;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (log.text(i, "capacity1").empty()) continue;  // before the law runs
    const double depth = log.number(i, "y") - 0.225;
    if (found.cycles == 0 && !(depth > 0)) continue;
    if (log.number(i, "x") > 0.08 + 0.058) break;
    if (found.cycles == 0) in_contact = true;
    ++found.cycles;
    found.max_depth = std::max(found.max_depth, depth);
    found.latest = std::max(found.latest, log.number(i, "late"));
    if (in_contact && depth < -one_count) {
      in_contact = false;
      ++found.separations;
    } else if (!in_contact && depth > one_count) {
      in_contact = true;
    }
  }
  return found;
}

struct a_hand_at_the_wall : a_driver {
  way_along_the_wall along_the_wall(const settings& s) {
    constexpr int max_runs = 10;
    way_along_the_wall found;
    for (int k = 0; k == 0 || (k < max_runs && !found.is_telling()); ++k) {
      const outcome o = run(s.text(), {"--seconds", "3", "--quiet"});
      EXPECT_EQ(o.status, 0) << o.err;
      found = first_way(log());
    }
    EXPECT_TRUE(found.is_telling()) << "in each of " << max_runs << " runs the machine stalled";
    return found;
  }
  static void expect_gliding(const way_along_the_wall& found) {
    EXPECT_GT(found.cycles, 500u) << "the hand goes along the wall";
    EXPECT_EQ(found.separations, 0);
    EXPECT_GT(found.max_depth, 0.5e-3) << "it is in the wall";
    EXPECT_LT(found.max_depth, 3e-3) << "and held";
  }
};

TEST_F(a_hand_at_the_wall, stays_there_where_the_configuration_names_no_law) {
  expect_gliding(along_the_wall({.hand_start = 0.5, .top = ""}));
}

// That the log shows it.
TEST_F(a_hand_at_the_wall, bounces_off_under_the_law_of_the_paper) {
  const auto found = along_the_wall({.hand_start = 0.5, .top = "law.type = \"direct_control\""});
  EXPECT_GT(found.cycles, 500u);
  EXPECT_GE(found.separations, 3);
}

// From the bench to the law: brake_bench writes what brake_driver reads, whole and as a section.
TEST_F(a_hand_at_the_wall, stays_there_with_the_brakes_that_a_bench_measured) {
  ASSERT_EQ(status_of(spawn({PASSIVE_HAPTICS_BRAKE_BENCH, "--brake=coulomb", "--output=."}, "bench")), 0);
  const outcome whole = run({"--config", "brakes.toml", "--check"});
  EXPECT_EQ(whole.status, 0) << whole.err;
  expect_gliding(
      along_the_wall({.hand_start = 0.5, .top = "", .sections = text_of(directory / "brakes.toml")}));
}

}  // namespace wall_tests
