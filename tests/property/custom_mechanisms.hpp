// Mechanisms as users write them, each to one way of the concept.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <cmath>

namespace custom {

namespace ph = passive_haptics;

template <class T, int Dof, int TaskDimension>
struct sizes {
  using scalar = T;
  static constexpr int dof = Dof, task_dimension = TaskDimension, brake_count = Dof;
};

// The least that is asked: nothing can be done with it but what the concept names.
class archetype final {
 public:
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;

  struct key {};
  explicit archetype(key) {}
  archetype() = delete;
  archetype(const archetype&) = delete;
  archetype& operator=(const archetype&) = delete;
  ~archetype() = default;
  void operator&() const = delete;
  template <class X>
  void operator,(X&&) const = delete;
  static void* operator new(std::size_t) = delete;

  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const {
    return {q[1] * std::cos(q[0]), q[1] * std::sin(q[0])};  // polar: turn and reach
  }
  ph::matrix<double, 2, 2> jacobian(const ph::vector<double, 2>& q) const {
    return ph::matrix<double, 2, 2>{{-q[1] * std::sin(q[0]), std::cos(q[0])},
                                    {q[1] * std::cos(q[0]), std::sin(q[0])}};
  }
};

// Only a position, templated: automatic differentiation. More joints than task dimensions.
template <class T>
struct planar_arm : sizes<T, 3, 2> {
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 3>& q) const {
    using std::cos, std::sin;
    S angle = q[0];
    ph::vector<S, 2> x(cos(angle) * T(0.3), sin(angle) * T(0.3));
    for (int i = 1; i < 3; ++i) {
      angle += q[i];
      x += ph::vector<S, 2>(cos(angle) * T(0.2), sin(angle) * T(0.2));
    }
    return x;
  }
};

// The same in space: a turning waist and two links.
template <class T>
struct spatial_arm : sizes<T, 3, 3> {
  template <class S>
  ph::vector<S, 3> position(const ph::vector<S, 3>& q) const {
    using std::cos, std::sin;
    const S q12 = q[1] + q[2];
    const S reach = cos(q[1]) * T(0.25) + cos(q12) * T(0.2);
    return {reach * cos(q[0]), reach * sin(q[0]), sin(q[1]) * T(0.25) + sin(q12) * T(0.2)};
  }
};

// A Jacobian that is diagonal but moves, under gears that are diagonal and constant.
template <class T>
struct geared_slides : sizes<T, 2, 2> {
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    using std::sin;
    return {sin(q[0]), q[1] * q[1] * q[1]};
  }
  ph::diagonal_matrix<T, 2> jacobian(const ph::vector<T, 2>& q) const {
    return ph::diagonal_matrix<T, 2>(std::cos(q[0]), T(3) * q[1] * q[1]);
  }
  ph::diagonal_matrix<T, 2> transmission() const { return ph::diagonal_matrix<T, 2>(T(4), T(-0.5)); }
};

// A constant Jacobian, more slides than axes, a diagonal transmission that moves.
template <class T>
struct skew_table : sizes<T, 3, 2> {
  ph::vector<T, 2> position(const ph::vector<T, 3>& q) const { return jacobian() * q; }
  ph::matrix<T, 2, 3> jacobian() const {
    return ph::matrix<T, 2, 3>{{T(1), T(0.5), T(0)}, {T(0), T(0.8), T(-1)}};
  }
  ph::diagonal_matrix<T, 3> transmission(const ph::vector<T, 3>& q) const {
    return ph::diagonal_matrix<T, 3>(T(2) + std::sin(q[0]), T(3), T(-1));
  }
};

// A dense transmission that depends on the pose.
template <class T>
struct coupled_arm : sizes<T, 2, 2> {
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    using std::cos, std::sin;
    const S q12 = q[0] + q[1];
    return {cos(q[0]) + cos(q12) * T(0.7), sin(q[0]) + sin(q12) * T(0.7)};
  }
  ph::matrix<T, 2, 2> transmission(const ph::vector<T, 2>& q) const {
    return ph::matrix<T, 2, 2>{{T(1), T(0.3) * std::sin(q[1])}, {T(0.5) * std::cos(q[0]), T(2)}};
  }
};

// A lever that carries a weight: one joint, one dimension, gravity.
template <class T>
struct lever : sizes<T, 1, 1> {
  using vector = ph::vector<T, 1>;
  template <class S>
  ph::vector<S, 1> position(const ph::vector<S, 1>& q) const {
    using std::sin;
    return ph::vector<S, 1>(sin(q[0]) * T(0.4));
  }
  ph::matrix<T, 1, 1> mass_matrix(const vector&) const { return ph::matrix<T, 1, 1>(T(0.16) * mass); }
  vector bias_torque(const vector& q, const vector&) const {
    return vector(T(9.81) * mass * T(0.4) * std::cos(q[0]));
  }
  vector bias_acceleration(const vector& q, const vector& qd) const {
    return vector(-T(0.4) * std::sin(q[0]) * qd[0] * qd[0]);
  }
  T mass = T(0.7);
};

}  // namespace custom
