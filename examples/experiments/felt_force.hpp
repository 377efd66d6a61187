// Forces of an arm's brakes as felt by a stiff hand: at a constant velocity of the handle, under constant
// capacities, after the self-motion has settled.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/force/torques/settled_approximation.hpp>
#include <passive_haptics/plant/random_numbers.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace experiments {

namespace ph = passive_haptics;

// An arm with a handle velocity v against a force along n.
template <class M>
struct felt_state {
  ph::joint_vector<M> q, qd;  // qd = M^-1 J^T Lambda v, for a handle that is pulled
  ph::task_vector<M> v, n;
};

// Minimum singular value of J, from J J^T.
inline double min_singular_value_of(const ph::matrix<double, 2, 2>& squared) {
  const double mean = squared.trace() / 2;
  return std::sqrt(mean - std::sqrt(std::max(0.0, mean * mean - squared.determinant())));
}

// State number k of a seed: a random pose that is not nearly singular, 0.05 m/s against n.
template <class M>
felt_state<M> draw_felt_state(const M& arm, std::uint64_t seed, std::size_t k) {
  constexpr int n = M::dof, d = M::task_dimension;
  constexpr double min_singular_value = 0.04, speed = 0.05;  // [m], [m/s]
  auto bits = ph::random_bits(seed, k);
  const auto between = [&](double low, double high) { return low + (high - low) * ph::uniform_number(bits); };
  const auto any_direction = [&] {
    const auto normal = [&] { return ph::normal_number(bits); };
    const ph::task_vector<M> u = ph::task_vector<M>::NullaryExpr(normal);
    return ph::task_vector<M>(u.normalized());
  };
  while (true) {
    felt_state<M> state;
    for (int i = 0; i < n; ++i)
      state.q[i] = i == 0 ? between(-std::numbers::pi, std::numbers::pi)
                          : between(0.5, 2.6) * (between(-1, 1) < 0 ? -1 : 1);
    state.n = any_direction();
    state.v = speed * any_direction();
    if (state.n.dot(state.v) > 0) state.v = -state.v;
    const ph::jacobian_matrix<M> J(ph::jacobian(arm, state.q));
    if (min_singular_value_of(J * J.transpose()) < min_singular_value) continue;
    const ph::matrix<double, n, d> by_inertia =
        ph::matrix<double, n, n>(arm.mass_matrix(state.q)).inverse() * J.transpose();
    state.qd = by_inertia * ph::matrix<double, d, d>(J * by_inertia).partialPivLu().solve(state.v);
    return state;
  }
}

// Fc of 1 N along n and its torques; empty if cos(gamma) is 0.3 or less.
template <class M>
auto force_for(const M& arm, const felt_state<M>& state, const ph::brakes_of<M>& brakes) {
  constexpr double min_cosine = 0.3;
  const ph::brake_matrix<M> E(ph::brake_jacobian(arm, state.q));
  const ph::settled_rates<M> rates(ph::mechanism_pose<M>(arm, state.q));
  return ph::settled_forces(rates, E, brakes, state.v).nearest(state.n, min_cosine);
}

// The felt force, and the brake rates at the start of averaging.
template <class M>
struct felt {
  double force = 0;           // mean along n [N]
  ph::brake_vector<M> rates;  // [rad/s]
};

// Duration of the capacities, and start of averaging [s].
inline constexpr double felt_until = 0.100, felt_from = 0.050;

// A hand of a tonne moves the handle with v: 1 N slows it by 0.1 mm/s in 100 ms.
template <class Plant, class M>
felt<M> feel_once(const M& arm, const felt_state<M>& state, const ph::brake_vector<M>& capacity) {
  constexpr double hand_mass = 1000, time_step = 1e-4;  // [kg], [s]
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(1e3);  // far above any capacity
  brakes.time_constant.setZero();
  Plant plant(arm, brakes, hand_mass, state.q);
  plant.set_motion(state.q, state.qd);
  const long steps = std::lround(felt_until / time_step), first = std::lround(felt_from / time_step);
  felt<M> result;
  for (long k = 0; k < steps; ++k) {
    plant.advance(time_step, capacity, ph::task_vector<M>::Zero());
    if (k == first) result.rates = plant.rates();
    if (k >= first) result.force -= plant.sensed_force().dot(state.n) / static_cast<double>(steps - first);
  }
  return result;
}

// Felt force of 1 N along n over many states. States not within 10 % of it are classified by the first cause
// that applies.
struct felt_row {
  std::size_t states = 0, displayed = 0, within = 0;
  double median = 0;  // [N]
  // Other states: a moving brake is in its dead band, so its sign is unknown; a brake that should have come
  // to rest still moves after 50 ms; the pose has changed under constant torques.
  std::size_t unknown_sign = 0, not_at_rest = 0, pose = 0;

  double displayed_share() const { return static_cast<double>(displayed) / static_cast<double>(states); }
  double within_share() const {
    return displayed > 0 ? static_cast<double>(within) / static_cast<double>(displayed) : 0;
  }
};

// feel(state, capacity) returns the felt force.
template <class M, class Feel>
felt_row feel_with(const M& arm, std::size_t states, const Feel& feel) {
  constexpr std::uint64_t seed = 20040627;
  const ph::brakes_of<M> brakes;
  felt_row row;
  row.states = states;
  std::vector<double> forces;
  for (std::size_t k = 0; k < states; ++k) {
    const felt_state<M> state = draw_felt_state(arm, seed, k);
    const auto F = force_for(arm, state, brakes);
    if (!ph::is_displayed(F.display)) continue;
    const felt<M> there = feel(state, ph::brake_vector<M>(F.torque.cwiseAbs()));
    forces.push_back(there.force);
    const bool is_within = std::abs(there.force - 1) < 0.1;
    row.within += is_within;
    bool unknown = false, moving = false;
    for (int i = 0; i < M::brake_count; ++i) {
      unknown = unknown || (!ph::contains(F.held, i) && F.signs[i] == 0 && F.torque[i] != 0);
      moving = moving || (ph::contains(F.held, i) && std::abs(there.rates[i]) > brakes.rate_dead_band[i]);
    }
    row.unknown_sign += !is_within && unknown;
    row.not_at_rest += !is_within && !unknown && moving;
    row.pose += !is_within && !unknown && !moving;
  }
  row.displayed = forces.size();
  if (forces.empty()) return row;
  const auto middle = forces.begin() + static_cast<std::ptrdiff_t>(forces.size() / 2);
  std::nth_element(forces.begin(), middle, forces.end());
  row.median = *middle;
  return row;
}

template <class M>
felt_row feel(const M& arm, std::size_t states) {
  return feel_with(arm, states, [&](const felt_state<M>& state, const ph::brake_vector<M>& capacity) {
    return feel_once<ph::simulated_device<M>>(arm, state, capacity);
  });
}

}  // namespace experiments
