// MuJoCo as a second plant: its model of a mechanism, what its soft brakes return and how they creep, and the
// paper's walls, which are followed there as in simulated_device.
#include "../realtime/allocations.hpp"

#include <passive_haptics/interop/mujoco.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/plant.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <experiments/plants.hpp>
#include <experiments/rods.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace ph = passive_haptics;
using arm = ph::tendon_two_link<double>;

static_assert(ph::Plant<ph::mujoco_device<arm>> && ph::Plant<ph::simulated_device<arm>>);

// ---- the model

// In random states: place of the handle, M and c of MuJoCo are those of the mechanism, relative to their
// size.
template <class M>
void expect_same_model(const char* name, const M& mechanism, double tolerance = 1e-9) {
  SCOPED_TRACE(name);
  ph::testing::random_source random(experiments::plant_seed);
  ph::mujoco_device<M> device(mechanism, ph::brakes_of<M>(), 0.0, ph::joint_vector<M>::Zero());
  const mjModel& model = device.model();
  const int handle = mj_name2id(&model, mjOBJ_BODY, "handle");
  for (int k = 0; k < 20; ++k) {
    const ph::joint_vector<M> q = 2 * random.normal_vector<double, M::dof>(),
                              qd = 3 * random.normal_vector<double, M::dof>();
    device.set_motion(q, qd);
    device.advance(1e-4, ph::brake_vector<M>::Zero(), ph::task_vector<M>::Zero());
    const mjData& data = device.data();
    ph::matrix<double, M::dof, M::dof> mass;
    mj_fullM(&model, mass.data(), data.qM);
    const ph::task_vector<M> x(data.xpos + 3 * handle);
    const ph::joint_vector<M> c(data.qfrc_bias), torque = mechanism.bias_torque(q, qd);
    EXPECT_LE((x - mechanism.position(q)).norm(), 1e-12);
    EXPECT_LE((mass - mechanism.mass_matrix(q)).norm(), tolerance * mass.norm());
    EXPECT_LE((c - torque).norm(), tolerance * (1e-3 + torque.norm()));
    // Both integrate alike
    EXPECT_LE((device.q() - ph::joint_vector<M>(data.qpos)).norm(), 1e-15 * q.norm());
  }
}

TEST(a_model_of_mujoco, is_the_mechanism) {
  expect_same_model("two links", ph::two_link<double>({.length_2 = 0.2, .mass_1 = 0.3}));
  expect_same_model("tendons", arm({.rotor_inertia_2 = 3e-4, .reduction_2 = 2}));
  expect_same_model("table", ph::xy_table<double>({.mass_x = 0.7, .mass_y = 0.4}));
  expect_same_model("brakes 1 and 3",
                    experiments::with_brakes<0, 2>(experiments::planar_rods<3>({0.15, 0.12, 0.1})));
  // Turns, slides and turns about a slanted line, under gravity
  using V2 = ph::vector<double, 2>;
  using V3 = ph::vector<double, 3>;
  ph::serial_chain_parameters<double, 2, 2> planar{
      {ph::revolute_joint<double>(V2(0.1, 0.05)), ph::prismatic_joint<double, 2>(V2(2, 1))}, {0.3, 0.1}};
  ph::serial_chain_inertia<double, 2, 2> planar_inertia;
  planar_inertia.links = {ph::uniform_rod<double, 2>(0.3, {0.1, 0.05}, {0.2, 0.03}),
                          ph::link_inertia<double, 2>{.mass = 0.2, .centre = {0.3, 0.1}}};
  planar_inertia.gravity = {1, -9.81};
  expect_same_model("arm with a slide", ph::serial_chain_with_inertia<double, 2, 2>(planar, planar_inertia));
  auto spatial = experiments::spatial_rods<2>({0.2, 0.15}).parameters();
  auto spatial_inertia = experiments::spatial_rods<2>({0.2, 0.15}).inertia();
  spatial.joints[1].axis = V3(0.1, -2, 0.3);
  spatial_inertia.links[1].centre += V3(0.01, 0.02, -0.03);
  spatial_inertia.gravity = {0.5, 0, -9.81};
  expect_same_model("in space", ph::serial_chain_with_inertia<double, 3, 3>(spatial, spatial_inertia), 1e-8);
}

TEST(a_model_of_mujoco, that_does_not_fit_is_an_error) {
  const auto error_of = [](const std::string& text, double presliding = 0) {
    using model = ph::presliding_brake<ph::coulomb_brake<double>>;
    ph::brake_models_of<arm, model> brakes;
    for (auto& brake : brakes) brake.presliding = presliding;
    try {
      ph::mujoco_device<arm, model> device(arm(), brakes, 0.5, {0.1, 1.0}, text);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  const std::string text = ph::mujoco_model(arm(), 0.5);
  const auto without = [&](const std::string& name) {
    std::string other = text;
    return other.replace(other.find("name='" + name + "'"), 7 + name.size(), "name='x'");
  };
  EXPECT_EQ(error_of(text), "none");
  EXPECT_EQ(error_of(without("brake_2")),
            "passive_haptics: the MuJoCo model has no 'brake_2'; mujoco_model() lists the names");
  EXPECT_EQ(error_of(without("handle")),
            "passive_haptics: the MuJoCo model has no 'handle'; mujoco_model() lists the names");
  EXPECT_EQ(error_of(ph::mujoco_model(experiments::planar_rods<3>({0.1, 0.1, 0.1}), 0.5)),
            "passive_haptics: degrees of freedom of the MuJoCo model = 3: expected 2 as the mechanism has");
  EXPECT_TRUE(error_of("<mujoco>").starts_with("passive_haptics: MuJoCo rejects the model: XML parse error"));
  EXPECT_TRUE(error_of(text, 0.01).ends_with("expected 0 in MuJoCo; use a simulated_device"));
}

TEST(a_plant_in_mujoco, that_is_lost_stays_lost_and_allocates_nothing) {
  ph::mujoco_device<arm> device(arm(), {}, 0.5, {0.1, 1.0});
  const auto malloc_before = mju_user_malloc;
  mju_user_malloc = [](std::size_t size) -> void* {
    ++allocations;
    return std::aligned_alloc(64, (size + 63) / 64 * 64);
  };
  EXPECT_EQ(allocations_in([&] {
              for (int k = 0; k < 100; ++k) device.advance(1e-4, {0.2, 0.3}, {1, 1});
            }),
            0);
  mju_user_malloc = malloc_before;
  EXPECT_GT(device.velocity().norm(), 1e-3);
  device.advance(1e-4, {0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0});
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(std::isnan(device.position()[0]));
    device.advance(1e-4, {0, 0}, {0, 0});
  }
  device.set_motion({0.1, 1.0}, {0, 0});
  device.advance(1e-4, {0, 0}, {1, 0});
  EXPECT_GT(device.velocity()[0], 0);
}

// ---- soft brakes

TEST(a_brake_in_mujoco, that_holds_creeps_as_its_page_says) {
  ph::brakes_of<arm> brakes;
  brakes.time_constant.setZero();
  ph::mujoco_device<arm> device(arm(), brakes, 0.5, {0.3, 1.2});
  for (const double dt : {1e-4, 1e-3}) {
    for (int k = 0; k < 100; ++k) device.advance(dt, {1, 1}, {2, -1});
    const ph::brake_vector<arm> expected = -device.creep_rates(dt).cwiseProduct(device.brake_torque());
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(device.rates()[i], expected[i], 1e-3 * std::abs(expected[i]));
      std::printf("dt %g s, brake %d: creeps at %.2e rad/s for each N m\n", dt, i + 1,
                  device.creep_rates(dt)[i]);
    }
  }
}

// Capacities jump and the hand pushes at random, so that brakes catch, hold, slip and turn back.
TEST(a_brake_in_mujoco, returns_no_more_than_its_softness_allows) {
  ph::testing::random_source random(experiments::plant_seed);
  ph::brakes_of<arm> brakes;
  brakes.time_constant.setZero();
  ph::mujoco_device<arm> device(arm(), brakes, 0.1, {0.3, 1.2});
  double max_power = 0, max_share = 0;
  ph::brake_vector<arm> capacity(0, 0);
  ph::task_vector<arm> force(0, 0);
  for (int k = 0; k < 40000; ++k) {
    if (k % 20 == 0) capacity = {random.positive(1e-3, 1.0), random.positive(1e-3, 1.0)};
    if (k % 50 == 0)
      force = 10 * random.normal_vector<double, 2>() - 20 * (device.position() - ph::point<2>(0.1, 0.2));
    const ph::brake_vector<arm> before = device.rates();
    device.advance(1e-4, capacity, force);
    for (int i = 0; i < 2; ++i) {
      const double power = device.brake_power()[i],
                   bound = device.softness * std::abs(device.brake_torque()[i] * before[i]);
      ASSERT_LE(power, bound * (1 + 1e-9) + 1e-15) << "seed " << experiments::plant_seed << ", step " << k;
      max_power = std::max(max_power, power);
      if (power > 1e-12) max_share = std::max(max_share, power / bound);
    }
  }
  std::printf("a brake returned at most %.1e W, %.2f of s |t w|\n", max_power, max_share);
  EXPECT_GT(max_share, 0.01);
}

// ---- the paper's walls

using experiments::law;
constexpr std::size_t hands = 20;
constexpr std::array laws{law::none, law::direct, law::velocity};

struct band {
  std::vector<double> values;
  double median() const { return (values[hands / 2 - 1] + values[hands / 2]) / 2; }
  bool contains(double x) const { return values.front() <= x && x <= values.back(); }
};

band band_of(const std::vector<ph::contact_metrics>& runs, auto ph::contact_metrics::* member) {
  band all;
  for (const auto& run : runs) all.values.push_back(static_cast<double>(run.*member));
  std::sort(all.values.begin(), all.values.end());
  return all;
}

// Hands that yield along the planar wall and the circles, in both simulations. Bouncing is chaotic, so bands
// are compared: the median of separations is within those of 20 hands in the other simulation; medians of
// depth and of its deviation differ by at most 5 %.
TEST(a_plant_in_mujoco, follows_the_walls_of_the_paper) {
  const std::pair<const char*, experiments::test_wall> walls[] = {{"planar", experiments::planar_wall()},
                                                                  {"concave", experiments::concave_wall()},
                                                                  {"convex", experiments::convex_wall()}};
  std::printf("seed %llu, hands 0 to %zu\n", static_cast<unsigned long long>(experiments::plant_seed),
              hands - 1);
  for (const auto& [name, wall] : walls) {
    for (const law which : laws) {
      SCOPED_TRACE(std::string(name) + ", " + std::string(name_of(which)));
      std::vector<ph::contact_metrics> own, mujoco;
      for (std::size_t k = 0; k < hands; ++k) {
        experiments::setup how = experiments::yielding_hand(experiments::plant_seed, k);
        how.environment_rate = k % 2 == 0 ? 1000 : 20;
        own.push_back(follow_with_arm(which, wall, how).figures);
        how.plant = experiments::simulation::mujoco;
        mujoco.push_back(follow_with_arm(which, wall, how).figures);
        // P = s t w, with t the limit of its brakes; no axis is faster than w
        constexpr double fastest = 5;  // [rad/s]
        EXPECT_LE(mujoco.back().max_brake_power, ph::mujoco_device<arm>::softness * how.limit * fastest);
        EXPECT_TRUE(mujoco.back().arrived);
      }
      using figures = ph::contact_metrics;
      const band separations = band_of(own, &figures::separations),
                 there = band_of(mujoco, &figures::separations);
      EXPECT_TRUE(separations.contains(there.median()) && there.contains(separations.median()));
      const double depth = band_of(own, &figures::depth_mean).median(),
                   depth_there = band_of(mujoco, &figures::depth_mean).median(),
                   deviation = band_of(own, &figures::depth_std).median(),
                   deviation_there = band_of(mujoco, &figures::depth_std).median();
      EXPECT_NEAR(depth_there, depth, 0.05 * depth);
      EXPECT_NEAR(deviation_there, deviation, 0.05 * deviation);
      std::printf(
          "%-8s %-26s separations %4.1f (%2.0f to %2.0f), MuJoCo %4.1f (%2.0f to %2.0f); depth %.3f, %.3f "
          "mm; "
          "deviation %.4f, %.4f mm; power %.1e W\n",
          name, std::string(name_of(which)).c_str(), separations.median(), separations.values.front(),
          separations.values.back(), there.median(), there.values.front(), there.values.back(), 1e3 * depth,
          1e3 * depth_there, 1e3 * deviation, 1e3 * deviation_there,
          band_of(mujoco, &figures::max_brake_power).values.back());
    }
  }
}

}  // namespace
