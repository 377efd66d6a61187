// A joint that turns, a slide on it and a tendon over both, each with a brake: redundant, in N m, N and N.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>

namespace ph = passive_haptics;

// The rates of slide and tendon are in `per_metre` to the metre, their torques in N / per_metre.
struct polar_arm {
  double per_metre = 1;
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 3;
  using joints = ph::vector<double, 2>;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    using std::cos, std::sin;
    return {q[1] * cos(q[0]), q[1] * sin(q[0])};
  }
  ph::matrix<double, 3, 2> transmission() const {
    return ph::matrix<double, 3, 2>{{1, 0}, {0, per_metre}, {0.05 * per_metre, per_metre}};
  }
  // A handle of 0.3 kg
  ph::matrix<double, 2, 2> mass_matrix(const joints& q) const {
    return ph::matrix<double, 2, 2>{{0.3 * q[1] * q[1], 0}, {0, 0.3}};
  }
  joints bias_torque(const joints& q, const joints& qd) const {
    return {0.6 * q[1] * qd[0] * qd[1], -0.3 * q[1] * qd[0] * qd[0]};
  }
  ph::vector<double, 2> bias_acceleration(const joints& q, const joints& qd) const {
    const ph::vector<double, 2> radial(std::cos(q[0]), std::sin(q[0])), across(-radial[1], radial[0]);
    return -q[1] * qd[0] * qd[0] * radial + 2 * qd[0] * qd[1] * across;
  }
};
