// Every shipped mechanism as a case of the property suites, and devices whose Jacobian has any condition.
#pragma once

#include "../property/chain_cases.hpp"
#include "../property/closed_chain_cases.hpp"
#include "../property/device_cases.hpp"

#include <cmath>

namespace stress {

namespace ph = passive_haptics;

template <class T>
struct four_brakes : closed_chains::lopsided_five_bar<T, 4> {};

// x = J q with J of the condition that a test asks for: its singular values fall evenly from 1 to 1 /
// condition.
template <class T, int D>
struct linear_device {
  using scalar = T;
  static constexpr int dof = D, task_dimension = D, brake_count = D;
  ph::matrix<T, D, D> J;

  linear_device(double condition, ph::testing::random_source& random) {
    const auto U = random.orthogonal_directions<D>();
    const auto V = random.orthogonal_directions<D>();
    ph::matrix<double, D, D> A = ph::matrix<double, D, D>::Zero();
    for (int i = 0; i < D; ++i) {
      const double singular_value = std::pow(condition, -static_cast<double>(i) / (D - 1));
      for (int r = 0; r < D; ++r) {
        for (int c = 0; c < D; ++c) A(r, c) += singular_value * U(r, i) * V(c, i);
      }
    }
    J = A.template cast<T>();
  }
  ph::vector<T, D> position(const ph::vector<T, D>& q) const { return J * q; }
  ph::matrix<T, D, D> jacobian() const { return J; }
};

}  // namespace stress
