/// Wall friction of all touched walls.
#pragma once

#include <passive_haptics/force/effect.hpp>
#include <passive_haptics/force/effects/wall_friction.hpp>

namespace passive_haptics {

/// A WallEffect: the sum of wall_friction() over the touched walls, with the load from pressing_force() and
/// the velocity relative to each wall. Without a known hand force there is no load, so the dry part is zero.
template <class T, int D>
class rough_walls {
 public:
  using scalar = T;                    ///< Scalar type.
  static constexpr int dimension = D;  ///< Task dimension d.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit rough_walls(const wall_friction_parameters<T>& p) : p_(require_valid(p)) {}

  /// Friction [N] at these contacts, for a handle with velocity v [m/s] and hand force [N].
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
