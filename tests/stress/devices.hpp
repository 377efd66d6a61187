// Every shipped mechanism as a case of the law suites, and devices whose Jacobian has any condition.
#pragma once

#include "../property/chain_cases.hpp"
#include "../property/closed_chain_cases.hpp"
#include "../property/device_cases.hpp"

#include <passive_haptics/mechanism/inertial.hpp>

#include <Eigen/SVD>

#include <cmath>

namespace stress {

namespace ph = passive_haptics;

template <class T>
struct four_brakes : closed_chains::lopsided_five_bar<T, 4> {};

template <class Chain>
struct with_inertial_forces : Chain {
  using mechanism = ph::inertial<typename Chain::mechanism>;
  static mechanism make() { return mechanism(Chain::make()); }
};

// x = J q with J of the condition that a test asks for: its singular values fall evenly from 1 to 1 / condition.
template <class T, int N, int D>
struct linear_device {
  using scalar = T;
  static constexpr int dof = N, task_dimension = D, brake_count = N;
  ph::matrix<T, D, N> J;

  linear_device(double condition, ph::testing::random_source& random) {
    Eigen::Matrix<double, D, N> A;
    for (int j = 0; j < N; ++j) A.col(j) = random.normal_vector<double, D>();
    const Eigen::JacobiSVD<Eigen::Matrix<double, D, N>> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    A.setZero();
    for (int i = 0; i < D; ++i) A(i, i) = std::pow(condition, -static_cast<double>(i) / (D - 1));
    J = (svd.matrixU() * A * svd.matrixV().transpose()).template cast<T>();
  }
  ph::vector<T, D> position(const ph::vector<T, N>& q) const { return J * q; }
  ph::matrix<T, D, N> jacobian() const { return J; }
};

}  // namespace stress
