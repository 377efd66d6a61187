// Every shipped mechanism as a case of the property suites, and devices whose Jacobian has any condition.
#pragma once

#include "../property/chain_cases.hpp"
#include "../property/closed_chain_cases.hpp"
#include "../property/device_cases.hpp"

#include <passive_haptics/mechanism/adaptors/with_self_motion.hpp>

#include <cmath>

namespace stress {

namespace ph = passive_haptics;

template <class T>
struct four_brakes : closed_chains::lopsided_five_bar<T, 4> {};

template <class Chain>
struct with_kinetostatic_forces : Chain {
  using mechanism = ph::kinetostatic_mechanism<typename Chain::mechanism>;
  static mechanism make() { return mechanism(Chain::make()); }
};

// x = J q with J of the condition that a test asks for: its singular values fall evenly from 1 to 1 /
// condition.
template <class T, int N, int D>
struct linear_device {
  using scalar = T;
  static constexpr int dof = N, task_dimension = D, brake_count = N;
  static constexpr auto self_motion = ph::self_motion_form::kinetostatic;
  ph::matrix<T, D, N> J;

  linear_device(double condition, ph::testing::random_source& random) {
    const auto U = random.orthogonal_directions<D>();
    const auto V = random.orthogonal_directions<N, D>();
    ph::matrix<double, D, N> A = ph::matrix<double, D, N>::Zero();
    for (int i = 0; i < D; ++i) {
      const double singular_value = std::pow(condition, -static_cast<double>(i) / (D - 1));
      for (int r = 0; r < D; ++r) {
        for (int c = 0; c < N; ++c) A(r, c) += singular_value * U(r, i) * V(c, i);
      }
    }
    J = A.template cast<T>();
  }
  ph::vector<T, D> position(const ph::vector<T, N>& q) const { return J * q; }
  ph::matrix<T, D, N> jacobian() const { return J; }
};

}  // namespace stress
