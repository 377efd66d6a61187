// What several unit tests share.
#pragma once

#include "../tested_types.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/testing/support/print.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace ph = passive_haptics;

using scalars = tested_types<double, float>;

// The state of a mechanism, written out.
template <class M>
ph::device_state<M> state_of(const ph::joint_vector<M>& q, const ph::joint_vector<M>& qd,
                             const ph::task_vector<M>& hand_force = ph::task_vector<M>::Zero()) {
  return {0.0, q, qd, hand_force};
}

// x = 1 / q: no position and no Jacobian at 0.
template <class T>
struct hyperbola {
  using scalar = T;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<T, 2> position(const ph::vector<T, 2>& q) const { return q.cwiseInverse(); }
  ph::diagonal_matrix<T, 2> jacobian(const ph::vector<T, 2>& q) const {
    return ph::diagonal_matrix<T, 2>(-q.cwiseInverse().cwiseAbs2());
  }
};

// A contact that asks for the force Fd [N].
template <int D>
ph::contact<D> asking_for(const ph::point<D>& Fd) {
  const double depth = 1e-3;
  return {.normal = Fd.normalized(), .depth = depth, .stiffness = Fd.norm() / depth};
}

// One step against the given contacts, with a fresh memory.
template <class L, class M, class State, class... Contacts>
ph::step_result<M> step_once(const M& mechanism, const ph::brakes_of<M>& brakes, const State& state,
                             const Contacts&... touched) {
  ph::contacts<M::task_dimension, static_cast<int>(sizeof...(Contacts))> all;
  (all.push_back(touched), ...);
  ph::step_memory<L> memory;
  return ph::step(mechanism, brakes, all, L{}, state, memory);
}

// What f() says in the std::invalid_argument that it throws.
template <class F>
std::string thrown_by(F&& f) {
  try {
    f();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "nothing";
}

// |a - b| up to rounding of numbers of this size.
template <class A, class B>
void expect_near(const A& a, const B& b, double size, double roundings = 16) {
  using T = typename A::Scalar;
  const double eps = static_cast<double>(std::numeric_limits<T>::epsilon());
  EXPECT_LE(static_cast<double>((a - b).norm()), roundings * eps * size) << a.transpose() << "\ninstead of\n"
                                                                         << b.transpose();
}
