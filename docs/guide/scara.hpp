// The mechanism of the tutorial after step 5.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

#include <cmath>

namespace ph = passive_haptics;

class scara {
 public:
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;

  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    using std::cos, std::sin;
    return {0.2 * cos(q[0]) + 0.1 * cos(q[0] + q[1]), 0.2 * sin(q[0]) + 0.1 * sin(q[0] + q[1])};
  }

  ph::matrix<double, 2, 2> jacobian(const ph::vector<double, 2>& q) const {
    const ph::vector<double, 2> x = position(q);
    const double a = q[0] + q[1];
    return ph::matrix<double, 2, 2>{{-x[1], -0.1 * std::sin(a)}, {x[0], 0.1 * std::cos(a)}};
  }

  // The second brake rotates with the sum of both joints, geared 3 : 1.
  ph::matrix<double, 2, 2> transmission() const { return ph::matrix<double, 2, 2>{{1, 0}, {3, 3}}; }

  // 0.5 kg at the elbow, 0.3 kg at the handle
  ph::matrix<double, 2, 2> mass_matrix(const ph::vector<double, 2>& q) const {
    const double inner = (0.5 + 0.3) * 0.2 * 0.2, outer = 0.3 * 0.1 * 0.1;
    const double coupling = 0.3 * 0.2 * 0.1 * std::cos(q[1]);
    return ph::matrix<double, 2, 2>{{inner + outer + 2 * coupling, outer + coupling},
                                    {outer + coupling, outer}};
  }
  ph::vector<double, 2> bias_torque(const ph::vector<double, 2>& q, const ph::vector<double, 2>& qd) const {
    const double h = 0.3 * 0.2 * 0.1 * std::sin(q[1]);
    return {-h * (2 * qd[0] + qd[1]) * qd[1], h * qd[0] * qd[0]};
  }
  ph::vector<double, 2> bias_acceleration(const ph::vector<double, 2>& q,
                                          const ph::vector<double, 2>& qd) const {
    const double a = q[0] + q[1], w1 = qd[0] * qd[0], w2 = (qd[0] + qd[1]) * (qd[0] + qd[1]);
    return {-0.2 * std::cos(q[0]) * w1 - 0.1 * std::cos(a) * w2,
            -0.2 * std::sin(q[0]) * w1 - 0.1 * std::sin(a) * w2};
  }
};

static_assert(ph::describe<scara>().has("jacobian"));
static_assert(ph::describe<scara>().has("transmission"));
static_assert(ph::describe<scara>().has("mass_matrix"));
static_assert(ph::describe<scara>().has("bias_torque"));
static_assert(ph::describe<scara>().has("bias_acceleration"));
