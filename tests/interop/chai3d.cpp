// A scene's forces displayed by a simulated arm: the same tests with a double of CHAI3D 3.3.0 and with
// CHAI3D.
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/interop/chai3d.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;
using capacities = ph::brake_vector<arm>;

constexpr double stiffness = 2e4;  // [N/m]
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

constexpr double patience = 60;  // [s]: no test runs so slowly

ph::chai3d_parameters<2> parameters_for(const ph::point<2>& centre) {
  return {.stiffness = stiffness, .centre = centre, .timeout = patience};
}

// An arm whose hand moves to the right along a wall at y = 0.225 m, and presses on it.
struct simulated_arm {
  ph::simulated_device<arm>* plant;
  ph::following_hand<double, 2> hand{{1, 0}, plant->position()};
  double time = 0;  // [s]

  ph::device_state<arm> measure() noexcept { return {time, plant->q(), plant->qd(), plant->sensed_force()}; }
  void command(const capacities& capacity) noexcept {
    for (int i = 0; i < 10; ++i, time += 1e-4) {
      const auto x = plant->position();
      plant->advance(1e-4, capacity, hand.force(time, x, plant->velocity(), {0, -1}, x[1] - 0.225));
    }
  }
};

struct wall_figures {
  int failed = 0, separations = 0;
  double max_depth = 0, way = 0, max_brake_power = 0;  // [m], [m], [W]
};

// The calls of a tool of CHAI3D, 1000 times a second, at a wall 5 mm ahead of the centre.
template <class Law>
wall_figures at_a_wall(const Law& law) {
  const arm mechanism;
  const ph::brakes_of<arm> brakes;
  ph::simulated_device<arm> plant(mechanism, brakes, 0.5, mechanism.inverse({0.03, 0.22}, ph::elbow::left).q);
  const chai3d::cGenericHapticDevicePtr device(
      new ph::chai3d_device(mechanism, brakes, law, simulated_arm{&plant}, parameters_for({0, 0.22})));
  wall_figures figures;
  bool touches = false;
  figures.failed += !device->open();
  for (int k = 0; k < 2500; ++k) {
    chai3d::cVector3d x, v;
    figures.failed += !device->getPosition(x) + !device->getLinearVelocity(v);
    const double depth = -0.005 - x(0);
    figures.failed += !device->setForce({stiffness * std::max(depth, 0.0), 0, 0});
    figures.max_depth = std::max(figures.max_depth, depth);
    figures.separations += touches && depth < -1e-5;
    touches = depth > 1e-5 || (touches && depth >= -1e-5);
  }
  figures.way = plant.position()[0] - 0.03;
  figures.max_brake_power = plant.energy().max_brake_power;
  return figures;
}

TEST(a_chai3d_device, displays_a_wall_of_the_scene) {
  const wall_figures glides = at_a_wall(ph::velocity_direct_control());
  EXPECT_EQ(glides.failed, 0);
  EXPECT_EQ(glides.separations, 0);
  EXPECT_GT(glides.way, 0.11);
  EXPECT_GT(glides.max_depth, 1.9e-3) << "the law's rest_depth is 2 mm";
  EXPECT_LT(glides.max_depth, 2.4e-3);
  EXPECT_LT(glides.max_brake_power, 1e-15);

  const wall_figures bounces = at_a_wall(ph::no_direct_control());
  EXPECT_EQ(bounces.failed, 0);
  EXPECT_GT(bounces.separations, 5);
  EXPECT_LT(bounces.max_brake_power, 1e-15);
}

// What a test sets and what the device commanded.
struct recorded_loop {
  struct record {
    ph::device_state<arm> state;
    capacities capacity = capacities::Constant(nan);
    std::atomic<bool> braking = false;
  };
  std::shared_ptr<record> at = std::make_shared<record>();

  ph::device_state<arm> measure() noexcept {
    at->state.time += 1e-3;
    return at->state;
  }
  void command(const capacities& capacity) noexcept {
    at->capacity = capacity;
    at->braking = (capacity.array() != 0).any();
  }
};

struct an_open_chai3d_device : testing::Test {
  const arm mechanism;
  const ph::brakes_of<arm> brakes;
  const ph::point<2> centre{0.03, 0.22};
  recorded_loop loop;
  std::unique_ptr<chai3d::cGenericHapticDevice> device = make(parameters_for(centre));
  chai3d::cVector3d x, v;

  an_open_chai3d_device() {
    loop.at->state = {.time = 0, .q = mechanism.inverse({0.04, 0.25}, ph::elbow::left).q, .qd = {0.5, 0.5}};
    device->open();
  }
  std::unique_ptr<chai3d::cGenericHapticDevice> make(const ph::chai3d_parameters<2>& p) const {
    return std::make_unique<ph::chai3d_device<arm, ph::brakes_of<arm>, ph::no_direct_control, recorded_loop>>(
        mechanism, brakes, ph::no_direct_control(), loop, p);
  }
  // Measures, then displays a force [N].
  bool displays(const chai3d::cVector3d& force) {
    device->getPosition(x);
    return device->setForce(force);
  }
  bool brakes_are_off() const { return loop.at->capacity == capacities::Zero(); }
};

const chai3d::cVector3d outward(3, 0, 0);  // Towards the user

TEST_F(an_open_chai3d_device, reports_the_handle_in_the_frame_of_chai3d) {
  EXPECT_TRUE(device->getPosition(x) && device->getLinearVelocity(v));
  const auto expected = ph::velocity(mechanism, loop.at->state.q, loop.at->state.qd);
  EXPECT_NEAR(x(0), -0.03, 1e-15) << "away from the user";
  EXPECT_NEAR(x(1), 0.01, 1e-15) << "to the right";
  EXPECT_EQ(x(2), 0);
  EXPECT_EQ(v(0), -expected[1]);
  EXPECT_EQ(v(1), expected[0]);
  ph::chai3d_parameters<2> upright = parameters_for(centre);
  upright.axes << 0, 0, 1, 0, 0, 1;  // x to the right, y up
  device = make(upright);
  EXPECT_TRUE(device->open() && device->getPosition(x));
  EXPECT_EQ(x(0), 0);
  EXPECT_NEAR(x(1), 0.01, 1e-15);
  EXPECT_NEAR(x(2), 0.03, 1e-15);
}

TEST_F(an_open_chai3d_device, commands_no_brake_beyond_its_limit) {
  for (const double size : {3.0, 1e3, 1e9}) {
    EXPECT_TRUE(displays({size, size, 0}));
    EXPECT_FALSE(brakes_are_off());
    EXPECT_TRUE((loop.at->capacity.array() <= brakes.torque_limit.array()).all()) << size;
  }
}

TEST_F(an_open_chai3d_device, releases_the_brakes_for_a_force_that_is_no_force) {
  const double infinite = std::numeric_limits<double>::infinity(), large = std::numeric_limits<double>::max();
  for (const chai3d::cVector3d& force : {chai3d::cVector3d(nan, 0, 0),
                                         {3, nan, 0},
                                         {3, 0, nan},
                                         {infinite, 0, 0},
                                         {3, 0, -infinite},
                                         {large, large, large}}) {
    ASSERT_TRUE(displays(outward) && !brakes_are_off());
    EXPECT_FALSE(displays(force));
    EXPECT_TRUE(brakes_are_off());
  }
  EXPECT_TRUE(displays({0, 0, 5}) && brakes_are_off()) << "out of the plane";
}

TEST_F(an_open_chai3d_device, releases_the_brakes_without_a_new_measurement) {
  ASSERT_TRUE(displays(outward) && !brakes_are_off());
  EXPECT_FALSE(device->setForce(outward));
  EXPECT_TRUE(brakes_are_off());
  ASSERT_TRUE(displays(outward) && !brakes_are_off());
  const double before = x(0);
  loop.at->state.q[0] = nan;
  EXPECT_FALSE(device->getPosition(x));
  EXPECT_EQ(x(0), before) << "the last good one";
  EXPECT_FALSE(device->setForce(outward));
  EXPECT_TRUE(brakes_are_off());
}

TEST_F(an_open_chai3d_device, releases_the_brakes_when_it_is_disabled_or_closed) {
  ASSERT_TRUE(displays(outward) && !brakes_are_off());
  EXPECT_TRUE(device->enableForces(false) && displays(outward));
  EXPECT_TRUE(brakes_are_off());
  EXPECT_TRUE(device->enableForces(true) && displays(outward));
  EXPECT_FALSE(brakes_are_off());
  EXPECT_TRUE(!device->open() && device->close() && !device->close());
  EXPECT_TRUE(brakes_are_off());
  EXPECT_FALSE(displays(outward));
  EXPECT_TRUE(brakes_are_off());
  EXPECT_TRUE(device->open() && displays(outward));
  EXPECT_FALSE(brakes_are_off());
  device.reset();
  EXPECT_TRUE(brakes_are_off());
}

TEST_F(an_open_chai3d_device, releases_the_brakes_when_the_scene_stalls) {
  ph::chai3d_parameters<2> p = parameters_for(centre);
  p.timeout = 1e-3;
  device = make(p);
  device->open();
  while (!displays(outward)) {
  }  // On a busy machine the first ones may come late
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (loop.at->braking && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  device->getPosition(x);  // after the watch
  EXPECT_TRUE(brakes_are_off());
  EXPECT_FALSE(device->setForce(outward)) << "status::scene_stale";
  EXPECT_TRUE(brakes_are_off());
}

TEST_F(an_open_chai3d_device, requires_a_stiffness_and_orthonormal_axes) {
  const auto error_of = [&](const auto& change) -> std::string {
    ph::chai3d_parameters<2> p = parameters_for(centre);
    change(p);
    try {
      make(p);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  const std::string a_stiffness = "passive_haptics: stiffness of a chai3d_device [N/m] = ";
  for (const double k : {0.0, -2000.0, nan})
    EXPECT_EQ(error_of([k](auto& p) { p.stiffness = k; }).find(a_stiffness), 0u) << k;
  EXPECT_NE(error_of([](auto& p) { p.axes *= 2; }).find("make the columns of axes unit vectors"),
            std::string::npos);
}

}  // namespace
