// slow, optimised
// Sink slopes against simulated devices under constant commands: the best of them sinks as predicted, and no
// other sinks less. The 300 devices of docs/guide/force.md with PASSIVE_HAPTICS_STRESS=full, else 20.
#include "../../stress/effort.hpp"

#include <passive_haptics/design/sink_slope.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/random_device.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

namespace ph = passive_haptics;
using drawn_arm = ph::tendon_two_link<double>;
using V2 = ph::vector<double, 2>;

// A device, and a hand that pushes into the wall with a constant force and is led along it.
struct pushed_device {
  V2 q, t, n, limit;
  double push;

  explicit pushed_device(std::uint64_t seed, std::uint64_t number) {
    static const ph::workspace<drawn_arm> where{{-3.1, -2.5}, {3.1, -0.6}, 0.1};
    const auto d = ph::draw_device(drawn_arm(), where, seed, number);
    q = d.plane.q;
    n = d.plane.normal;
    t = (d.plane.direction - n.dot(d.plane.direction) * n).normalized();
    limit = d.known_brakes.torque_limit;
    push = d.hand.push + d.hand.normal_stiffness * d.hand.target_depth;
  }
  double slope_at(const V2& where, double share = 1) const {
    return ph::sink_slope(drawn_arm(), where, t, n, limit, share * push).slope;
  }
  // Whether brakes that hold, or do not, do so by a hair: then inertia decides, and the first micrometres.
  bool is_close() const {
    const double more = slope_at(q, 1.02), less = slope_at(q, 0.98);
    return std::isfinite(more) ? more - less > 0.1 : std::isfinite(less);
  }
  // The commands that the quantile names: all that the brakes have which push out at this slope, nothing of
  // the others.
  V2 commands_for(double slope) const {
    const ph::matrix<double, 2, 2> G = ph::force_generators(drawn_arm(), q);
    V2 command;
    for (int i = 0; i < 2; ++i)
      command[i] = t.dot(G.col(i)) / n.dot(G.col(i)) <= slope * (1 + 1e-9) ? limit[i] : 0.0;
    return command;
  }
};

// How the handle went under constant commands.
struct descent {
  double slope = std::numeric_limits<double>::infinity();  // infinite where it fell
  double depth = 0;                                        // [m]
  V2 end;                                                  // joint positions there
};

// Led along the wall by a stiff hand at up to `lead` [m/s], from a motion at the slope on. Brakes without
// lag.
descent descend(const pushed_device& d, double slope, const V2& command, double lead = 0.01) {
  ph::brake_models_of<drawn_arm> brakes;
  for (auto& brake : brakes) brake = {.torque_limit = 1e3, .time_constant = 0};
  ph::simulated_device<drawn_arm> plant(drawn_arm(), brakes, 0.3, d.q);
  const double steep = std::sqrt(1 + slope * slope), speed = lead / steep;
  const double first = 0.00025 / steep, last = 0.001 / steep;  // of the way that is measured [m]
  const V2 v = speed * (d.t - slope * d.n), x0 = plant.position();
  plant.set_motion(d.q, ph::matrix<double, 2, 2>(ph::jacobian(drawn_arm(), d.q)).inverse() * v);
  constexpr double dt = 5e-5;
  double way_before = -1, depth_before = 0, way = 0;
  descent seen;
  for (int k = 0; k < 40000 && way < last; ++k) {
    const double lag = speed * k * dt - way;
    const V2 hand = (2e4 * lag + 300 * (speed - d.t.dot(plant.velocity()))) * d.t - d.push * d.n;
    plant.advance(dt, command, hand);
    way = d.t.dot(plant.position() - x0);
    seen.depth = -d.n.dot(plant.position() - x0);
    seen.end = plant.q();
    if (std::abs(seen.depth) > 0.015) return seen;  // fell, or left the wall
    if (way_before < 0 && way > first) {
      way_before = way;
      depth_before = seen.depth;
    }
  }
  if (way >= last) seen.slope = (seen.depth - depth_before) / (way - way_before);
  return seen;
}

constexpr double steepest = 5;  // beyond it the handle goes nearly straight into the wall

// The slope on the short way is between those at its two ends, whatever the commands of every eighth device.
TEST(sink_slope, is_that_of_simulated_devices_and_the_least_of_all_commands) {
  const int wanted = static_cast<int>(stress::effort(20, 300));
  int sinking = 0, held = 0, lost = 0;
  for (std::uint64_t k = 0; sinking < wanted && k < 10000; ++k) {
    SCOPED_TRACE(::testing::Message() << "device " << k);
    const pushed_device d(20261, k);
    if (d.is_close()) continue;
    const double slope = d.slope_at(d.q);
    if (slope == 0 && ++held <= 10) {
      EXPECT_LT(descend(d, 0, d.commands_for(0)).depth, 1e-4) << "it is held";
    } else if (!std::isfinite(slope) && ++lost <= 10) {
      EXPECT_FALSE(std::isfinite(descend(d, 0, d.limit, 0.001).slope)) << "it falls";
    } else if (slope > 0 && slope < steepest) {
      const descent seen = descend(d, slope, d.commands_for(slope));
      const double at_end = d.slope_at(seen.end), rounding = 0.02 * (1 + slope);
      EXPECT_GT(seen.slope, std::min(slope, at_end) - rounding);
      EXPECT_LT(seen.slope, std::max(slope, at_end) + rounding);
      if (sinking++ % 8 != 0) continue;
      for (int i = 0; i < 9; ++i) {
        const descent other = descend(d, slope, V2(d.limit[0] * (i % 3) / 2, d.limit[1] * (i / 3) / 2));
        EXPECT_GT(other.slope, std::min(slope, d.slope_at(other.end)) - rounding) << "commands " << i;
      }
    }
  }
  EXPECT_EQ(sinking, wanted);
  EXPECT_GE(held, 10);
  EXPECT_GT(lost, 0);
}

}  // namespace
