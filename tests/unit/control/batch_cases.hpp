// Batches beside single cycles: what they promise of each mechanism, law and scene.
#pragma once

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace batch_cases {

namespace ph = passive_haptics;

// N numbers for each component.
template <class T, int Components>
struct columns {
  std::array<std::vector<T>, std::size_t(Components)> of;
  explicit columns(std::size_t n) { of.fill(std::vector<T>(n, T(-7))); }
  // In place of std::span<X>, which may be const
  template <class X = T>
  ph::component_arrays<X, Components> spans() {
    ph::component_arrays<X, Components> s;
    for (std::size_t i = 0; i < s.size(); ++i) s[i] = of[i];
    return s;
  }
};

template <class M>
struct states {
  using T = typename M::scalar;
  columns<T, M::dof> q, qd;
  columns<T, M::task_dimension> hand_force;
  std::vector<double> time;

  explicit states(const std::vector<ph::device_state<M>>& given)
      : q(given.size()), qd(given.size()), hand_force(given.size()) {
    for (std::size_t k = 0; k < given.size(); ++k) {
      for (int i = 0; i < M::dof; ++i) q.of[std::size_t(i)][k] = given[k].q[i];
      for (int i = 0; i < M::dof; ++i) qd.of[std::size_t(i)][k] = given[k].qd[i];
      for (int i = 0; i < M::task_dimension; ++i) hand_force.of[std::size_t(i)][k] = given[k].hand_force[i];
      time.push_back(given[k].time);
    }
  }
  ph::batch_states<M> spans() {
    return {q.template spans<const T>(), qd.template spans<const T>(), hand_force.template spans<const T>(),
            time};
  }
};

template <class M>
struct results {
  using T = typename M::scalar;
  explicit results(std::size_t states) : n(states) {}

  std::size_t n;
  columns<T, M::brake_count> capacity{n}, torque{n}, cone_coefficients{n}, signs{n};
  columns<T, M::task_dimension> desired_force{n}, control_force{n};
  std::vector<ph::status> outcome = std::vector<ph::status>(n);
  std::vector<ph::power_class> power = std::vector<ph::power_class>(n);
  std::vector<ph::display_class> display = std::vector<ph::display_class>(n);
  std::vector<std::uint8_t> saturated = std::vector<std::uint8_t>(n);
  std::vector<int> wall_number = std::vector<int>(n);
  std::vector<T> alpha = std::vector<T>(n), approximation_cosine = std::vector<T>(n);

  ph::batch_results<M> commands() { return {capacity.spans(), outcome}; }
  ph::batch_results<M> spans() {
    return {capacity.spans(),
            outcome,
            torque.spans(),
            power,
            display,
            saturated,
            wall_number,
            alpha,
            approximation_cosine,
            desired_force.spans(),
            control_force.spans(),
            cone_coefficients.spans(),
            signs.spans()};
  }
};

// What a value may differ by: nothing where products and sums are contracted in neither, else some roundings.
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(__aarch64__)
inline constexpr double relative = 1e-9;
#else
inline constexpr double relative = 0;
#endif

template <class T>
bool agree(T got, T expected) {
  if (std::isnan(expected)) return std::isnan(got);
  return got == expected || std::abs(got - expected) <= T(relative) * std::abs(expected);
}
template <class T, std::size_t N, class X, int Components>
bool agree(const std::array<std::vector<T>, N>& got, std::size_t k,
           const ph::vector<X, Components>& expected) {
  bool all = true;
  for (int i = 0; i < Components; ++i) all &= agree(got[std::size_t(i)][k], expected[i]);
  return all;
}

// Whether result k of a batch is that of a single cycle.
template <class M, class Result>
bool agree(const results<M>& got, std::size_t k, const Result& expected) {
  return got.outcome[k] == expected.outcome && got.power[k] == expected.power &&
         got.display[k] == expected.display && (got.saturated[k] != 0) == expected.saturated &&
         got.wall_number[k] == expected.wall_number && agree(got.signs.of, k, expected.signs) &&
         agree(got.capacity.of, k, expected.capacity) && agree(got.torque.of, k, expected.torque) &&
         agree(got.alpha[k], expected.alpha) &&
         agree(got.approximation_cosine[k], expected.approximation_cosine) &&
         agree(got.desired_force.of, k, expected.desired_force) &&
         agree(got.control_force.of, k, expected.control_force) &&
         agree(got.cone_coefficients.of, k, expected.cone_coefficients);
}

// The batch stores what a fresh controller returns for each of these states; how often each power class came.
template <class M, class S, class L, class B>
std::array<int, 4> expect_that_of_single_cycles(const M& mechanism, const B& brakes, const S& scene,
                                                const L& law,
                                                const ph::step_options<typename M::scalar>& options,
                                                const std::vector<ph::device_state<M>>& given) {
  const ph::controller control(mechanism, brakes, scene, law, options);
  states<M> in(given);
  results<M> whole(given.size()), commands(given.size());
  control.batch(in.spans(), whole.spans());
  control.batch(in.spans(), commands.commands());
  std::array<int, 4> seen{};
  int wrong = 0;
  for (std::size_t k = 0; k < given.size() && wrong < 3; ++k) {
    auto single = control;
    const auto expected = single(given[k]);
    ++seen[std::size_t(expected.power)];
    auto commanded = control;
    const auto command = commanded.command(given[k]);
    const bool is_right = agree(whole, k, expected) && commands.outcome[k] == command.outcome &&
                          agree(commands.capacity.of, k, command.capacity);
    wrong += !is_right;
    EXPECT_TRUE(is_right) << "state " << k << ": q = " << given[k].q.transpose()
                          << ", qd = " << given[k].qd.transpose()
                          << ", hand force = " << given[k].hand_force.transpose();
  }
  return seen;
}

// A number in the place of any number of a state, in most cases none.
template <class T>
T odd_number(ph::testing::random_source& random, T usual) {
  using limits = std::numeric_limits<T>;
  constexpr T tiny = limits::denorm_min(), infinite = limits::infinity(), nan = limits::quiet_NaN();
  constexpr std::array odd{T(0),          -T(0),     tiny,          -tiny,
                           limits::min(), T(1e-300), limits::max(), limits::epsilon(),
                           T(-1e200),     infinite,  nan,           T(1e6)};
  const auto k = std::size_t(random.uniform(0.0, 40.0 * double(odd.size())));
  return k < odd.size() ? odd[k] : usual;
}

// States about a wall through `at` [m], of any rates and hand forces; among them slow brakes and hands that
// do not push, exact zeros, NaN, infinity, denormal and huge numbers.
template <class M, class Reach>
std::vector<ph::device_state<M>> any_states(unsigned seed, std::size_t n, Reach&& reach) {
  using T = typename M::scalar;
  ph::testing::random_source random(seed);
  std::vector<ph::device_state<M>> all(n);
  for (auto& s : all) {
    s.time = odd_number(random, 1.0);
    s.q = reach(random);
    const T speed = random.uniform(0.0, 1.0) < 0.3 ? T(0.01) : T(1);
    for (int i = 0; i < M::dof; ++i) {
      s.q[i] = odd_number(random, s.q[i]);
      s.qd[i] = odd_number(random, speed * random.uniform(T(-1), T(1)));
    }
    const T push = random.positive(T(1e-12), T(1e2));
    for (int i = 0; i < M::task_dimension; ++i)
      s.hand_force[i] = odd_number(random, push * random.uniform(T(-1), T(1)));
    if (random.uniform(0.0, 1.0) < 0.03) s.hand_force.setZero();
    if (random.uniform(0.0, 1.0) < 0.03) s.qd.setZero();
  }
  return all;
}

}  // namespace batch_cases
