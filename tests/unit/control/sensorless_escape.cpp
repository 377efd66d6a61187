// slow, optimised
// Simulated hands that want to leave a wall, without a force sensor.
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/sensorless/sensorless_controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;
using state = ph::sensorless_device_state<device>;
using phase = ph::release_probe<2>::phase;
const ph::half_space<2> wall({0, 0.225}, {0, -1});

template <class L>
auto controller_with(const L& law) {
  return ph::sensorless_controller(device(), ph::brakes_of<device>(), ph::scene(ph::wall(wall)), law);
}

struct escape {
  double depth_at_reversal = 0, max_depth = 0;
  double to_release =
      -1;  // from the reversal until the probe released the brakes for good, or the handle was out
  double to_leave = -1;  // until the handle was out; -1 if it never was
};

template <class Control>
escape press_and_pull(Control& control, double press, double pull, double along, double reversal) {
  const device arm;
  ph::brakes_of<device> brakes;
  ph::simulated_device<device> handle(arm, brakes, 0.5, arm.inverse({0.1, 0.224}, ph::elbow::left).q);
  const double dt = 1e-4;
  Eigen::Vector2d told(0, 0);
  escape found;
  bool released = false;
  for (int k = 0; k * dt < reversal + 3; ++k) {
    const double time = k * dt;
    const bool leaves = time >= reversal;
    if (k % 10 == 0) {
      told = control(state{time, handle.q(), handle.qd()}).capacity;
      if (leaves && !released && control.probing() == phase::released) found.to_release = time - reversal;
      released = leaves && control.probing() == phase::released;
    }
    // Fingers damp what they hold
    const Eigen::Vector2d wish =
        Eigen::Vector2d(leaves ? 0 : along, leaves ? -pull : press) - 5.0 * handle.velocity();
    handle.advance(dt, told, wish);
    const double depth = -wall.distance(handle.position());
    if (!leaves) found.depth_at_reversal = depth;
    found.max_depth = std::max(found.max_depth, depth);
    if (leaves && depth < 0) {
      found.to_leave = time - reversal;
      if (found.to_release < 0) found.to_release = found.to_leave;
      break;
    }
  }
  return found;
}

// 1 N moves handle and hand, less than 1.5 kg, out of the depth; twice for what the brakes lag.
template <class L>
void expect_escapes_within_the_stated_time() {
  const ph::sensorless_parameters p;
  const double stated = ph::max_release_time(p.probe);
  for (unsigned seed = 1; seed <= 15; ++seed) {
    ph::testing::random_source random(seed);
    const double press = random.uniform(0.5, 3.0), along = random.uniform(-1.0, 1.0);
    const double reversal = random.uniform(0.3, 1.5);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", press " << press << " N, along " << along
                                      << " N, reversal at " << reversal << " s");
    auto control = controller_with(L());
    const escape e = press_and_pull(control, press, 1.0, along, reversal);
    EXPECT_GT(e.max_depth, 0);
    ASSERT_GE(e.to_leave, 0) << "locked inside";
    EXPECT_LE(e.to_release, stated);
    EXPECT_LE(e.to_leave, stated + 2 * std::sqrt(2 * e.max_depth * 1.5) + 0.06);
  }
}

TEST(sensorless_escape, is_within_the_stated_time) {
  expect_escapes_within_the_stated_time<ph::direct_control>();
  expect_escapes_within_the_stated_time<ph::velocity_direct_control>();
}

// How fast a hand that only presses sinks by its probes [mm/s].
template <class L>
double sinking() {
  const auto depth_after = [](double time) {
    auto control = controller_with(L());
    return press_and_pull(control, 2, 1, 0, time).depth_at_reversal;
  };
  return 1e3 * (depth_after(6) - depth_after(2)) / 4;
}

// The second law counts on what its brakes make: 1.2 mm/s unless they make up for what a probe took.
TEST(sensorless_pressing, sinks_slowly) {
  EXPECT_LT(sinking<ph::direct_control>(), 0.15);
  EXPECT_LT(sinking<ph::velocity_direct_control>(), 0.3);
}

}  // namespace
