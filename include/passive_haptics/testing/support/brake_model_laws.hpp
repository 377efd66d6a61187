/// The laws of a BrakeModel as functions that return an error text, empty if the law holds.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace passive_haptics::testing {

namespace detail {

// Resistance of a brake at a rate [N m].
template <class T>
T total(const brake_resistance<T>& r, T rate) {
  return r.strength + r.drag * std::abs(rate);
}

// Maximum limit over the rates of a haptic device [N m].
template <BrakeModel B>
typename B::scalar max_limit(const B& brake) {
  using T = typename B::scalar;
  T peak = brake.torque_limit_at(T(0));
  for (T rate = T(1e-4); rate < T(1e4); rate *= T(1.3)) peak = std::max(peak, brake.torque_limit_at(rate));
  return peak;
}

// Uniform in 0, ..., count - 1.
inline int one_of(random_source& random, int count) {
  return static_cast<int>(random.uniform(0.0, static_cast<double>(count)));
}

template <class T>
T some_command(random_source& random, T limit) {
  using real = std::numeric_limits<T>;
  constexpr std::array<T, 7> odd{real::quiet_NaN(),  -T(1), -real::infinity(), real::infinity(), real::max(),
                                 real::denorm_min(), T(0)};
  const int k = one_of(random, 14);
  return k < 7 ? nth(odd, k) : random.uniform(T(0), T(1.5) * limit);
}

template <class... Values>
std::string broken(const char* law, Values... values) {
  std::string text = law;
  ((text += " " + std::to_string(values)), ...);
  return text;
}

}  // namespace detail

/// Passive and bounded: a rotor on the brake's axis is driven randomly over `steps` steps of 1 us to 10 ms.
/// Its kinetic energy grows by at most the work done on it, at the new rate since the steps are implicit.
template <BrakeModel B>
std::string broken_energy_law(const B& brake, std::uint64_t seed, int steps) {
  using T = typename B::scalar;
  constexpr T eps = std::numeric_limits<T>::epsilon();
  random_source random(seed);
  const T limit = detail::max_limit(brake), inertia = limit * T(1e-3);
  typename B::state state;
  T rate = T(0), command = T(0), drive = T(0);
  for (int k = 0; k < steps; ++k) {
    if (k % 8 == 0) {
      command = detail::some_command(random, limit);
      drive = random.uniform(-T(2) * limit, T(2) * limit);
      if (detail::one_of(random, 4) == 0)
        rate = random.uniform(-T(1), T(1)) * random.positive(T(1e-4), T(1e3));
    }
    const T dt = random.positive(T(1e-6), T(1e-2));
    const brake_resistance<T> r = brake.advance(dt, command, rate, state);
    const T peak = brake.torque_limit_at(rate);
    if (!(r.strength >= T(0) && r.drag >= T(0) &&
          detail::total(r, rate) < std::numeric_limits<T>::infinity()))
      return detail::broken("not passive: strength, drag", r.strength, r.drag);
    if (!(detail::total(r, rate) <= peak * (T(1) + T(16) * eps)))
      return detail::broken("not bounded: torque, limit, rate", detail::total(r, rate), peak, rate);

    const T slowed = T(1) / (inertia + dt * r.drag), free = slowed * (inertia * rate + dt * drive);
    const T left = std::max(std::abs(free) - slowed * dt * r.strength, T(0));
    const T next = free < T(0) ? -left : left;
    const T gained = inertia / T(2) * (next * next - rate * rate), work = dt * drive * next;
    const T scale = inertia * (next * next + rate * rate) + dt * std::abs(drive) * (left + std::abs(rate));
    if (!(gained <= work + T(16) * eps * scale)) return detail::broken("energy created", gained - work);
    rate = next;
  }
  return {};
}

/// Invalid input is replaced in any state: commands < 0 or NaN, time steps < 0 or not finite and NaN rates by
/// 0; infinite commands and rates by the maximum.
template <BrakeModel B>
std::string broken_input_law(const B& brake, std::uint64_t seed) {
  using T = typename B::scalar;
  struct input {
    T dt, command, rate;
  };
  struct exchange {
    const char* name;
    T input::* where;
    std::vector<T> odd;
    T meant;
  };
  constexpr T none = std::numeric_limits<T>::quiet_NaN(), infinite = std::numeric_limits<T>::infinity(),
              largest = std::numeric_limits<T>::max(), dt = T(2e-3);
  random_source random(seed);
  const T limit = detail::max_limit(brake);
  const std::vector<exchange> exchanges{{"command", &input::command, {none, -limit, -infinite}, T(0)},
                                        {"command", &input::command, {infinite}, largest},
                                        {"time step", &input::dt, {none, -dt, -infinite, infinite}, T(0)},
                                        {"rate", &input::rate, {none}, T(0)},
                                        {"rate", &input::rate, {infinite}, largest},
                                        {"rate", &input::rate, {-infinite}, -largest}};
  typename B::state state;
  for (int k = 0; k < 1000; ++k) {
    const T rate = random.uniform(-T(5), T(5)), command = random.uniform(T(0), limit);
    brake.advance(T(1e-3), command, rate, state);
    for (const auto& [name, where, odd_values, meant_value] : exchanges) {
      for (const T odd_value : odd_values) {
        input odd{dt, command, rate}, meant = odd;
        odd.*where = odd_value;
        meant.*where = meant_value;
        typename B::state one = state, other = state;
        for (int j = 0; j < 5; ++j) {
          const auto a = brake.advance(odd.dt, odd.command, odd.rate, one),
                     b = brake.advance(meant.dt, meant.command, meant.rate, other);
          if (!(a.strength == b.strength && a.drag == b.drag &&
                brake.torque_limit_at(odd.rate) == brake.torque_limit_at(meant.rate)))
            return std::string(name) + detail::broken(": taken for; strengths, drags", odd_value, meant_value,
                                                      a.strength, b.strength, a.drag, b.drag);
        }
      }
    }
  }
  return {};
}

/// Halving the time step halves the error, for stepwise commands and an oscillating rate.
template <BrakeModel B>
std::string broken_time_step_law(const B& brake, std::uint64_t seed) {
  using T = typename B::scalar;
  constexpr int steps = 4096, held = 512;
  constexpr T dt = T(1) / T(1 << 15);
  const T limit = detail::max_limit(brake);
  const auto run = [&](int parts) {
    random_source random(seed);
    std::vector<T> torques;
    typename B::state state;
    T command = T(0);
    for (int k = 0; k < steps; ++k) {
      if (k % held == 0) command = detail::one_of(random, 3) == 0 ? T(0) : random.uniform(T(0), limit);
      T torque = T(0);
      for (int j = 0; j < parts; ++j) {
        const T time = (T(k) + T(j) / T(parts)) * dt, rate = T(3) * std::sin(T(40) * time);
        torque = detail::total(brake.advance(dt / T(parts), command, rate, state), rate);
      }
      torques.push_back(torque);
    }
    return torques;
  };
  const std::vector<T> exact = run(8);
  const auto error = [&](int parts) {
    const std::vector<T> torques = run(parts);
    T peak = T(0);
    for (std::size_t k = 0; k < torques.size(); ++k) peak = std::max(peak, std::abs(torques[k] - exact[k]));
    return peak;
  };
  const T whole = error(1), half = error(2);
  // Accumulated rounding of a lag of 1 / share steps
  const T rounding = T(8 * steps) * std::numeric_limits<T>::epsilon() * limit;
  if (!(half <= T(0.55) * whole + rounding))
    return detail::broken("not of first order: errors at dt, dt / 2", whole, half);
  return {};
}

/// No constant command ends nearer than command_for by more than error times the maximum limit.
template <InvertibleBrakeModel B>
std::string broken_inverse_law(const B& brake, std::uint64_t seed, double error) {
  using T = typename B::scalar;
  random_source random(seed);
  const T limit = detail::max_limit(brake);
  const T rounding = T(64) * std::numeric_limits<T>::epsilon() * limit;
  for (int k = 0; k < 500; ++k) {
    typename B::state state;
    const T rate = detail::one_of(random, 4) == 0 ? T(0) : random.positive(T(1e-3), T(100));
    for (int j = 0; j < 6; ++j) brake.advance(T(0.02), random.uniform(T(0), limit), rate, state);
    const T wanted = random.uniform(T(0), T(1.1) * brake.torque_limit_at(rate));
    const auto miss = [&](T command) {
      typename B::state now = state;
      for (int j = 0; j < 50; ++j) brake.advance(T(1), command, rate, now);
      return std::abs(detail::total(brake.advance(T(1), command, rate, now), rate) - wanted);
    };
    const T ours = miss(brake.command_for(wanted, rate, state));
    for (int j = 0; j <= 20; ++j) {
      const T other = miss(T(j) / T(20) * limit);
      if (!(ours <= other + static_cast<T>(error) * limit + rounding))
        return detail::broken("inverse: wanted, off by, another by", wanted, ours, other);
    }
  }
  return {};
}

}  // namespace passive_haptics::testing
