// Random devices and hands, which differ from the model as real devices do.
#pragma once

#include "planar.hpp"

#include <passive_haptics/plant/random_numbers.hpp>

#include <random>

namespace experiments {

inline constexpr std::uint64_t plant_seed = 20040627;  // default of the experiments

// The torque limit [N m] that just holds a hand with this push [N] on the paper's walls.
constexpr double weak_brake_limit(double push) { return 1.25 / 17 * push; }

// Number k of this seed: calls draw uniformly between two numbers.
inline auto evenly(std::uint64_t seed, std::size_t k) {
  return [bits = ph::random_bits(seed, k)](double low, double high) mutable {
    return low + (high - low) * ph::uniform_number(bits);
  };
}

// Plant number k of this seed: gain, residual torque, lag and limit of the brakes, up to 25 % error of the
// inertia, a noisy sensor, a hand with another push and mass. The controller only knows limit and lag.
inline setup random_plant(std::uint64_t seed, std::size_t k) {
  auto between = evenly(seed, k);
  setup how;
  how.gain = between(0.85, 1.1);
  how.residual = between(0, 0.005);
  how.lag = between(0.0067, 0.020);
  how.limit = between(0.3, 2);
  how.inertia = between(0.75, 1.25);
  how.noise = 0.02;
  how.seed = seed + k;
  how.gap = between(0.002, 0.006);
  how.hand.push = between(1, 3);
  how.hand.mass = between(0.3, 0.8);
  return how;
}

// The paper's reading of direct control: a compliant hand, 300 N/m towards a point 3 mm beyond the push, and
// brakes just strong enough for it. This one is in the middle of the range below.
inline setup middle_hand() {
  setup how;
  how.hand.push = 1.75;
  how.hand.normal_stiffness = 300;
  how.hand.target_depth = 0.003;
  how.limit = weak_brake_limit(how.hand.push);
  return how;
}

// Hand number k of this seed.
inline setup yielding_hand(std::uint64_t seed, std::size_t k) {
  auto between = evenly(seed, k);
  setup how = middle_hand();
  how.hand.push = between(1, 2.5);
  how.hand.normal_damping = between(12, 30);
  how.hand.mass = between(0.2, 0.8);
  how.hand.speed = between(0.04, 0.07);
  how.gap = between(0.003, 0.005);
  how.approach = between(0.05, 0.12);
  how.limit = weak_brake_limit(how.hand.push);
  how.noise = 0.01;
  how.seed = seed + k;
  return how;
}

}  // namespace experiments
