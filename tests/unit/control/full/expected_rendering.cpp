// What parts are expected to render against the simulation, on random devices that know nothing of it.
#include "../landing.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/design/expected_rendering.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace landings;
using rendered = ph::rendering<tendon::dof>;
using square = ph::matrix<double, 2, 2>;
using plant_type = ph::simulated_device<tendon>;

constexpr double period = 1e-3, time_step = 1e-4;  // [s]

// The real brakes and encoders of a device, behind gears that differ from device to device.
ph::data_sheet<tendon> sheet_of(const device& d, std::uint64_t k) {
  ph::data_sheet<tendon> parts;
  for (std::size_t i = 0; i < 2; ++i) {
    const ph::coulomb_brake<double>& real = d.brakes[i];
    const double gear = 1 + static_cast<double>((k + i) % 7);
    parts.brakes[i] = {.torque_limit = real.torque_limit / gear,
                       .residual_torque = real.residual.strength / gear,
                       .time_constant = real.time_constant,
                       .fall_time_constant = real.fall_ratio * real.time_constant,
                       .gear_ratio = gear};
    parts.encoders[i] = {.counts_per_turn = 2 * std::numbers::pi / d.run.encoder_resolution / gear,
                         .gear_ratio = gear};
  }
  parts.scene_rate = d.environment_rate;
  parts.rate_corner = d.run.rate_corner;
  parts.hand = {.mass = d.hand.mass,
                .push = d.hand.push + d.hand.normal_stiffness * d.hand.target_depth,
                .stiffness = d.hand.normal_stiffness,
                .damping = d.hand.normal_damping};
  return parts;
}

V joint_rates(const tendon& real, const V& q, const V& v) {
  return square(ph::jacobian(real, q)).inverse() * v;
}

// A hand that moves or slides: its mean force along the motion [N] within 0.1 s, and the state in the middle.
struct slide {
  bool lasts = false;
  double force = 0;
  V q, velocity;
};

// Adds one time step, `since` [s] after the 0.1 s began.
template <class Sample>
void add(slide& s, const plant_type& plant, const Sample& now, const V& direction, double since) {
  constexpr double length = 0.1;  // [s]
  if (since < 0 || since >= length) return;
  s.force += plant.sensed_force().dot(direction) * time_step / length;
  if (since < length / 2) {
    s.q = plant.q();
    s.velocity = now.velocity;
  }
  s.lasts = since > length - 2 * time_step;
}

// In free space, without current.
slide move_freely(const device& d) {
  const tendon real = tendon_of(d.inertia);
  plant_type plant(real, d.brakes, d.hand.mass, d.plane.q);
  plant.set_motion(d.plane.q, joint_rates(real, d.plane.q, d.hand.speed * d.plane.direction));
  ph::following_hand_parameters<double> hand = d.hand;
  hand.push = hand.normal_stiffness = 0;
  ph::wall_following_parameters run = d.run;
  run.longest = 0.16;
  slide s;
  const auto released = [](const ph::device_state<tendon>&) { return ph::step_result<tendon>(); };
  ph::follow_wall(plant, released, ph::half_space<2>(d.plane.surface - d.plane.normal, d.plane.normal),
                  ph::following_hand<double, 2>(d.plane.direction, d.plane.start, hand), run,
                  [&](const auto& now) { add(s, plant, now, now.velocity.normalized(), now.time - 0.05); });
  return s;
}

// A hand that slides along the wall, and turns away 0.45 s after it touched it.
struct held_hand {
  slide along;
  double release = 0;  // until the strongest torque is a tenth of what it was [s]; infinite if never
};

held_hand hold(const device& d) {
  plant_type plant(tendon_of(d.inertia), d.brakes, d.hand.mass, d.plane.q);
  plant.set_motion(d.plane.q, d.plane.qd);
  const ph::half_space<2> wall(d.plane.surface, d.plane.normal);
  ph::controller control(tendon_of(1), d.known_brakes,
                         ph::held_scene(ph::scene(ph::wall(wall, rigid)), 1 / d.environment_rate),
                         ph::velocity_direct_control({.approach_speed = 0}));
  held_hand h;
  double touch = std::numeric_limits<double>::infinity(), turned = 0;
  ph::wall_following_parameters run = d.run;
  run.longest = 0.5;
  ph::follow_wall(plant, control, wall,
                  ph::following_hand<double, 2>(d.plane.direction, d.plane.start, d.hand), run,
                  [&](const auto& now) {
                    if (now.depth > 0) touch = std::min(touch, now.time);
                    add(h.along, plant, now, d.plane.direction, now.time - touch - 0.3);
                    turned = now.time;
                  });
  ph::following_hand_parameters<double> away = d.hand;
  away.push = -(d.hand.push + d.hand.normal_stiffness * d.hand.target_depth);
  away.normal_stiffness = 0;
  run.path_end = run.deepest = 1e9;  // neither ends it
  const double tenth = plant.brake_strength().maxCoeff() / 10;
  h.release = std::numeric_limits<double>::infinity();
  ph::follow_wall(
      plant,
      [&](ph::device_state<tendon> state) {
        state.time += turned;
        return control(state);
      },
      wall, ph::following_hand<double, 2>(d.plane.direction, plant.position(), away), run,
      [&](const auto& now) {
        if (plant.brake_strength().maxCoeff() <= tenth) h.release = std::min(h.release, now.time);
      });
  return h;
}

// The largest mean force along n [N] of a handle that is moved with v, over all sets of brakes that are on.
double strongest_force(const device& d, const V& q, const V& v) {
  const tendon real = tendon_of(d.inertia);
  constexpr double full = 100, stiff = 2000;  // [N m], [N s/m]
  double most = -std::numeric_limits<double>::infinity();
  for (int set = 0; set < 4; ++set) {
    const V command((set & 1) != 0 ? full : 0, (set & 2) != 0 ? full : 0);
    plant_type plant(real, d.brakes, d.hand.mass, q);
    for (int i = 0; i < 3000; ++i) {  // until the torques have risen
      plant.set_motion(q, V::Zero());
      plant.advance(time_step, command, V::Zero());
    }
    plant.set_motion(q, joint_rates(real, q, v));
    double mean = 0;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i) {
      plant.advance(time_step, command, V(stiff * (v - plant.velocity()) - plant.brake_force()));
      mean += d.plane.normal.dot(plant.brake_force()) / steps;
    }
    most = std::max(most, mean);
  }
  return most;
}

// Standard deviations of the estimated rates of joints that turn steadily, and of the velocity along n.
struct noise {
  V joints;
  double along;
};

noise noise_of(const device& d, const V& q, const V& qd) {
  const tendon real = tendon_of(d.inertia);
  const square J(ph::jacobian(real, q));
  ph::joint_encoders<tendon> encoders(real, {d.run.encoder_resolution, d.run.rate_corner}, period);
  constexpr int settling = 500, cycles = 20000;
  V mean = V::Zero();
  square squares = square::Zero();
  for (int k = 0; k < settling + cycles; ++k) {
    encoders.read(q + k * period * qd, qd);
    if (k < settling) continue;
    const V off = encoders.qd() - qd;
    mean += off / cycles;
    squares += off * off.transpose() / cycles;
  }
  const square variance = squares - mean * mean.transpose();
  const V Jn = J.transpose() * d.plane.normal;
  return {variance.diagonal().cwiseMax(0).cwiseSqrt(), std::sqrt(std::max(Jn.dot(variance * Jn), 0.0))};
}

// How often a measured value lay in its band.
class tallies {
 public:
  void add(const std::string& what, bool is_in) {
    auto& [in, of] = all_[what];
    in += is_in;
    ++of;
  }
  void expect_shares(std::uint64_t seed) const {
    for (const auto& [what, counts] : all_) {
      const auto [in, of] = counts;
      std::printf("seed %llu: %-15s in its band on %d of %d\n", static_cast<unsigned long long>(seed),
                  what.c_str(), in, of);
      EXPECT_GE(in, 0.9 * of) << what;
      EXPECT_GE(of, 100) << what;
    }
  }

 private:
  std::map<std::string, std::array<int, 2>> all_;
};

void compare(const device& d, std::uint64_t k, const landing& law, tallies& in) {
  const tendon real = tendon_of(d.inertia);
  const ph::data_sheet<tendon> parts = sheet_of(d, k);
  const V n = d.plane.normal;
  const auto expected = [&](const V& q, const V& v) { return expected_rendering(real, parts, q, v, n); };
  const rendered touch = expected(law.q, law.velocity);
  in.add("depth", touch.depth.contains(law.deepest));
  const V mean = law.velocity - n * n.dot(law.velocity) / 2;
  in.add("strongest_force", touch.strongest_force.contains(strongest_force(d, law.q, mean)));

  const slide free = move_freely(d);
  ASSERT_TRUE(free.lasts);
  const rendered moving = expected(free.q, free.velocity);
  in.add("free_drag", moving.free_drag.contains(free.force));
  const noise measured = noise_of(d, free.q, joint_rates(real, free.q, free.velocity));
  in.add("velocity_noise", moving.velocity_noise.contains(measured.along));
  for (int j = 0; j < 2; ++j)
    in.add("rate_noise", moving.rate_noise[std::size_t(j)].contains(measured.joints[j]));

  if (law.deepest <= deep) {
    const held_hand held = hold(d);
    if (held.along.lasts) {
      const rendered sliding = expected(held.along.q, held.along.velocity);
      constexpr double stands = 0.01;  // [m/s]: a slower hand is held by brakes at rest, with any force
      if (sliding.holds_push && held.along.velocity.dot(d.plane.direction) > stands)
        in.add("wall_drag", sliding.wall_drag.contains(held.along.force));
      in.add("release_time", sliding.release_time.contains(held.release));
    }
  }

  const auto depth_at = [&](double stiffness) {
    return land(d, ph::no_direct_control(), stiffness, 1 / d.environment_rate, 0.4);
  };
  const landing hard = depth_at(rigid);
  if (!hard.touched || hard.first > deep) return;  // no stiffness holds it
  const ph::banded stiffness = expected(hard.q, hard.velocity).stiffness;
  in.add("stiffness", stiffness.low > 0 && depth_at(stiffness.low).first >= 1.25 * hard.first &&
                          depth_at(stiffness.high).first <= 2 * hard.first);
}

TEST(expected_rendering, is_within_its_bands_on_90_percent_of_300_random_devices_of_each_seed) {
  const char* given = std::getenv("PASSIVE_HAPTICS_STRESS_SEED");
  std::vector<std::uint64_t> seeds = {20040627, 20070525};
  if (given != nullptr) seeds = {std::strtoull(given, nullptr, 10)};
  for (const std::uint64_t seed : seeds) {
    tallies in;
    int touched = 0;
    for (std::uint64_t k = 0; touched < 300; ++k) {
      const device d = ph::draw_device(tendon_of(1), where, seed, k);
      const landing law =
          land(d, ph::velocity_direct_control({.approach_speed = 0}), rigid, 1 / d.environment_rate, 0.8);
      if (!law.touched) continue;  // the residual torque keeps the hand off it so long
      ++touched;
      compare(d, k, law, in);
    }
    in.expect_shares(seed);
  }
}

}  // namespace
