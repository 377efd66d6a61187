/// @file
/// Wall friction of whatever walls are touched.
#pragma once

#include <passive_haptics/force/effect.hpp>
#include <passive_haptics/force/effects/wall_friction.hpp>

namespace passive_haptics {

/// Every touched wall is rough: the sum of their wall_friction(), each under the load with which the hand
/// presses on it (pressing_force) and with the velocity relative to it. A WallEffect.
///
/// Where no hand force is known the dry part is zero: there is no load.
template <class T, int D>
class rough_walls {
 public:
  using scalar = T;                    ///< Scalar of forces.
  static constexpr int dimension = D;  ///< d

  /// Throws std::invalid_argument with the text of validate(p).
  explicit rough_walls(const wall_friction_parameters<T>& p) : p_(require_valid(p)) {}

  /// Friction [N] at these contacts of a handle with velocity v [m/s] and hand force [N].
  template <class Walls>
  vector<T, D> force_at(const Walls& touched, const vector<T, D>& v, const vector<T, D>& hand_force) const {
    vector<T, D> sum = vector<T, D>::Zero();
    for (int j = 0; j < touched.size(); ++j) {
      const contact<D>& c = touched[j];
      const vector<T, D> n = as<T>(c.normal), relative = v - as<T>(c.wall_velocity);
      sum += wall_friction(p_, n, pressing_force(n, hand_force), relative, hand_force);
    }
    return sum;
  }

 private:
  wall_friction_parameters<T> p_;
};

}  // namespace passive_haptics
