// The search for hands that want to leave a wall.
#include <passive_haptics/control/sensorless/release_probe.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

namespace {

namespace ph = passive_haptics;
using probe = ph::release_probe<2>;
using phase = probe::phase;
constexpr ph::release_probe_parameters quick{
    .probe_period = 0.1, .probe_time = 0.05, .motion_threshold = 1e-5};
const ph::point<2> out(0, -1);

struct handle {
  probe p{quick};
  phase at(double time, double outward, double rest) {
    return p.update(time, {0.3, 0.2 - outward}, out, rest);
  }
};

TEST(release_probe, waits_for_the_rest_and_ends_when_nothing_moves) {
  handle h;
  EXPECT_EQ(h.at(0, 0, 0), phase::watching);
  EXPECT_EQ(h.at(0.05, 0, 0.05), phase::watching);
  EXPECT_EQ(h.at(0.1, 0, 0.1), phase::probing);
  EXPECT_EQ(h.at(0.12, 0.9e-5, 0.12), phase::probing) << "less than the threshold";
  EXPECT_EQ(h.at(0.149, -0.9e-5, 0.14), phase::probing);
  EXPECT_EQ(h.at(0.151, 0, 0.15), phase::watching);
}

TEST(release_probe, holds_again_when_the_handle_sinks) {
  handle h;
  h.at(0.1, 0, 0.1);
  EXPECT_EQ(h.at(0.11, -1.1e-5, 0), phase::watching);
}

TEST(release_probe, stays_released_until_the_handle_moves_in_again) {
  handle h;
  h.at(0.1, 0, 0.1);
  EXPECT_EQ(h.at(0.11, 1.1e-5, 0), phase::released);
  EXPECT_EQ(h.at(5, 1e-3, 0), phase::released);
  EXPECT_EQ(h.at(6, 1e-3 - 0.9e-5, 9), phase::released);
  EXPECT_EQ(h.at(7, 1e-3 - 1.1e-5, 0), phase::watching) << "from the farthest point out";
}

TEST(release_probe, forgets) {
  handle h;
  h.at(0.1, 0, 0.1);
  h.p.clear();
  EXPECT_EQ(h.p.now(), phase::watching);
  EXPECT_EQ(h.at(0.11, 1, 0), phase::watching);
}

TEST(release_probe, complains_of_its_times) {
  EXPECT_EQ(validate(quick), "");
  EXPECT_EQ(validate(ph::release_probe_parameters{.probe_time = 0}),
            "probe_time [s] = 0: expected a finite number > 0");
  EXPECT_THROW(probe({.probe_period = -1}), std::invalid_argument);
  EXPECT_DOUBLE_EQ(ph::max_release_time(quick), 0.2);
}

}  // namespace
