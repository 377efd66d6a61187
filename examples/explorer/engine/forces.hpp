/// @file
/// What the brakes can produce, as points to draw.
#pragma once

#include <passive_haptics/brake/passive_fme.hpp>
#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/design/displayable.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace explorer {

namespace ph = passive_haptics;

/// The torques of brakes that are drawn: from lower to upper on each axis [N m].
template <int Brakes>
struct torque_set {
  ph::vector<double, Brakes> lower, upper;  ///< [N m]

  /// The torques whose force G t goes farthest in a direction, where `gain` = G^T direction.
  ph::vector<double, Brakes> farthest(const ph::vector<double, Brakes>& gain) const {
    ph::vector<double, Brakes> t;
    for (int i = 0; i < Brakes; ++i) t[i] = gain[i] > 0 ? upper[i] : gain[i] < 0 ? lower[i] : 0.0;
    return t;
  }
};

/// Adds a force as x y z.
template <int D>
void add_force(std::vector<double>& points, const ph::vector<double, D>& F) {
  for (int i = 0; i < 3; ++i) points.push_back(i < D ? F[std::min(i, D - 1)] : 0.0);
}

/// A direction of the plane.
inline ph::vector<double, 2> direction_at(int k, int count) {
  const double a = 2 * std::numbers::pi * k / count;
  return {std::cos(a), std::sin(a)};
}

/// The closed outline of { G t } over a convex set of torques that contains 0: the farthest point in each of
/// many directions [N].
template <int Brakes>
std::vector<double> outline_of(const ph::matrix<double, 2, Brakes>& G, const torque_set<Brakes>& set) {
  constexpr int directions = 180;
  std::vector<double> points;
  for (int k = 0; k <= directions; ++k) {
    const ph::vector<double, Brakes> gain = G.transpose() * direction_at(k, directions);
    add_force<2>(points, G * set.farthest(gain));
  }
  return points;
}

/// The surface of { G t } in space as triangles [N].
template <int Brakes>
std::vector<double> outline_of(const ph::matrix<double, 3, Brakes>& G, const torque_set<Brakes>& set) {
  constexpr int slices = 32, stacks = 16;
  const auto on = [&](int i, int j) {
    const double a = 2 * std::numbers::pi * i / slices, b = std::numbers::pi * j / stacks;
    const ph::vector<double, 3> u(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b));
    return ph::vector<double, 3>(G * set.farthest(ph::vector<double, Brakes>(G.transpose() * u)));
  };
  std::vector<double> points;
  for (int i = 0; i < slices; ++i)
    for (int j = 0; j < stacks; ++j) {
      const auto a = on(i, j), b = on(i + 1, j), c = on(i + 1, j + 1), e = on(i, j + 1);
      for (const auto& x : {a, b, c, a, c, e}) add_force<3>(points, x);
    }
  return points;
}

/// What can be displayed exactly in each direction of the plane while the handle moves along `direction` [N]:
/// for devices with self-motion, whose brakes do not make a force each. The sides of the area are found by
/// bisection, as the nearest force to one outside lies there.
template <class M>
std::vector<double> displayable_outline(const M& mechanism, const ph::joint_vector<M>& q,
                                        const ph::task_vector<M>& direction,
                                        const ph::hybrid_brakes<M>& brakes) {
  constexpr int directions = 180, bisections = 30;
  const auto at = [&](double k) {
    const double a = 2 * std::numbers::pi * k / directions;
    const ph::vector<double, 2> u(std::cos(a), std::sin(a));
    const auto found = ph::displayable(mechanism, q, direction, u, brakes);
    const bool is_exact = found.outcome == ph::status::ok && found.display == ph::display_class::exact &&
                          std::isfinite(found.max_approximated_force);
    return is_exact ? ph::vector<double, 2>(found.max_approximated_force * u) : ph::vector<double, 2>(0, 0);
  };
  std::vector<double> points;
  ph::vector<double, 2> last(0, 0);
  for (int k = 0; k <= directions; ++k) {
    const ph::vector<double, 2> F = at(k);
    const bool begins = F.norm() > 0, ends = last.norm() > 0;
    if (k > 0 && begins != ends) {
      double inside = begins ? k : k - 1, outside = begins ? k - 1 : k;
      for (int i = 0; i < bisections; ++i) {
        const double middle = (inside + outside) / 2;
        (at(middle).norm() > 0 ? inside : outside) = middle;
      }
      add_force<2>(points, at(inside));
    }
    add_force<2>(points, F);
    last = F;
  }
  return points;
}

}  // namespace explorer
