/// @file
/// The force a wall asks for.
#pragma once

#include <passive_haptics/scene/contacts.hpp>

#include <cmath>

namespace passive_haptics {

/// Fd = magnitude * direction, kept apart: a wall of 1e7 N/m asks for 5e4 N where 2 N are displayed, so
/// everything but the magnitude is computed for a unit force.
template <class T, int D>
struct desired_force {
  vector<T, D> direction;  ///< n = Fd / |Fd|.
  T magnitude;             ///< |Fd| [N].
};

/// Fd = k depth n of a frictionless elastic wall (section 5.1), base frame.
template <class T, int D>
desired_force<T, D> force_of(const contact<D>& c) {
  return {as<T>(c.normal), static_cast<T>(c.stiffness * c.depth)};
}

/// Index of the contact that asks for the largest force; -1 if there is none. A force that is not finite
/// governs, so that the step reports it.
template <int D, int Capacity>
int governing_contact(const contacts<D, Capacity>& touched) {
  if constexpr (Capacity == 1) return touched.size() - 1;
  int governing = -1;
  double largest = 0;
  for (int i = 0; i < touched.size(); ++i) {
    const double force = touched[i].stiffness * touched[i].depth;
    if (!std::isfinite(force)) return i;
    if (governing < 0 || force > largest) {
      governing = i;
      largest = force;
    }
  }
  return governing;
}

/// The contact that asks for a force F [N], base frame: how an effect (force/effects) joins the walls of a
/// step. An effect that resists motion has F . v <= 0, so no law ever scales it.
template <class T, int D>
contact<D> contact_asking_for(const vector<T, D>& F) {
  const point<D> force = F.template cast<double>();
  const double magnitude = force.stableNorm();
  contact<D> c;
  if (magnitude > 0) c.normal = force / magnitude;
  c.depth = magnitude;  // [m], with 1 N/m
  c.stiffness = 1;
  c.wall = -1;
  return c;
}

}  // namespace passive_haptics
