/// Random control cycles in contact, for the property suites.
#pragma once

#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <array>
#include <string>

namespace passive_haptics::testing {

/// Input of a step with one contact.
template <class M>
struct step_sample {
  device_state<M> state;                     ///< Pose, rates and hand force.
  brakes_of<M> brakes;                       ///< Limits and dead bands.
  contacts<M::task_dimension, 1> touched{};  ///< The wall.

  const contact<M::task_dimension>& wall() const { return touched[0]; }  ///< The contact.
};

/// Dense E.
template <class M>
brake_matrix<M> dense_brake_jacobian(const M& mechanism, const joint_vector<M>& q) {
  return brake_matrix<M>(passive_haptics::brake_jacobian(mechanism, q));
}

/// Calls visit(signs) for each of the 3^m patterns of -1, 0, 1.
template <int Brakes, class Visit>
void for_each_sign_pattern(Visit&& visit) {
  std::array<int, static_cast<std::size_t>(Brakes)> signs;
  signs.fill(-1);
  for (bool more = true; more;) {
    visit(signs);
    // Counts up with carry
    const auto next = std::find_if(signs.begin(), signs.end(), [](int s) { return s < 1; });
    std::fill(signs.begin(), next, -1);
    more = next != signs.end();
    if (more) ++*next;
  }
}

/// A random cycle of a mechanism with brakes that rotate with the given signs (0: slower than the dead band).
/// Contact: any normal, 1 um to 1 cm deep, 1 to 1e9 N/m, a wall that moves in half of the cases.
template <class Case>
step_sample<typename Case::mechanism> random_sample(
    const typename Case::mechanism& mechanism,
    const std::array<int, static_cast<std::size_t>(Case::mechanism::brake_count)>& signs,
    random_source& random) {
  using M = typename Case::mechanism;
  using T = typename M::scalar;
  constexpr int d = M::task_dimension;
  step_sample<M> sample;
  brake_vector<M> w;
  for (int i = 0; i < M::brake_count; ++i) {
    sample.brakes.torque_limit[i] = random.positive(T(1e-2), T(1e3));
    sample.brakes.rate_dead_band[i] = random.positive(T(1e-3), T(1e-1));
    const T band = sample.brakes.rate_dead_band[i];
    const int s = nth(signs, i);
    w[i] = s == 0 ? (random.coin() ? T(0) : random.uniform(T(-0.9), T(0.9)) * band)
                  : static_cast<T>(s) * random.positive(T(1.1) * band, T(10));
  }
  sample.state.time = random.uniform(0.0, 100.0);
  sample.state.q = random.between<T, M::dof>(Case::lower(), Case::upper());
  if constexpr (!passive_haptics::detail::has_exact_transmission<M>) sample.state.qd = w;
  else sample.state.qd = pseudo_inverse(passive_haptics::transmission(mechanism, sample.state.q)) * w;
  if (random.coin() || random.coin())
    sample.state.hand_force = random.positive(T(1e-3), T(1e2)) * random.direction<T, d>();
  sample.touched.push_back({.normal = random.direction<double, d>(),
                            .depth = random.positive(1e-6, 1e-2),
                            .stiffness = random.positive(1.0, 1e9),
                            .wall_velocity = random.coin() ? point<d>(0.1 * random.normal_vector<double, d>())
                                                           : point<d>(point<d>::Zero()),
                            .wall_number = 0,
                            .sensed_at = as<double>(mechanism.position(sample.state.q))});
  return sample;
}

/// Calls visit(sample) for `each` random cycles per sign pattern.
template <class Case, class Visit>
void for_each_sample(const typename Case::mechanism& mechanism, unsigned seed, int each, Visit&& visit) {
  random_source random(seed);
  for_each_sign_pattern<Case::mechanism::brake_count>([&](const auto& signs) {
    for (int k = 0; k < each; ++k) visit(random_sample<Case>(mechanism, signs, random));
  });
}

/// Calls visit(name, number) for each number of a step's input. `wall` replaces the sample's contact.
template <class M, class Visit>
void for_each_input(step_sample<M>& sample, contact<M::task_dimension>& wall, Visit&& visit) {
  const auto each = [&](const std::string& name, auto& values) {
    for (int i = 0; i < values.size(); ++i) visit(name + "[" + std::to_string(i) + "]", values[i]);
  };
  visit("time", sample.state.time);
  each("q", sample.state.q);
  each("qd", sample.state.qd);
  each("hand_force", sample.state.hand_force);
  each("torque_limit", sample.brakes.torque_limit);
  each("rate_dead_band", sample.brakes.rate_dead_band);
  each("torque_dead_band", sample.brakes.torque_dead_band);
  each("normal", wall.normal);
  visit("depth", wall.depth);
  visit("stiffness", wall.stiffness);
  each("wall_velocity", wall.wall_velocity);
}

}  // namespace passive_haptics::testing
