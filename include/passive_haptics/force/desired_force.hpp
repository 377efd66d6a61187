/// @file
/// The force that a wall demands.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <cmath>

namespace passive_haptics {

/// Fd = magnitude * direction. They are kept apart: a wall of 1e7 N/m demands 5e4 N where 2 N are displayed,
/// so everything but the magnitude is computed for a unit force.
template <class T, int D>
struct desired_force {
  vector<T, D> direction;      ///< n = Fd / |Fd|.
  T magnitude;                 ///< |Fd| [N].
  vector<T, D> wall_velocity;  ///< Of the surface that demands it [m/s].
};

/// Fd = k depth n of a frictionless elastic wall (section 5.1), base frame.
template <class T, int D>
desired_force<T, D> desired_force_of(const contact<D>& c) {
  return {as<T>(c.normal), static_cast<T>(c.stiffness * c.depth), as<T>(c.wall_velocity)};
}

/// True if there is a force: its magnitude is > 0, so not NaN.
template <class T, int D>
bool is_nonzero(const desired_force<T, D>& Fd) {
  return Fd.magnitude > T(0);
}

/// n . (v - v_wall) [m/s] of a handle with velocity v: > 0 where it leaves the wall. Of a wall at rest it has
/// the sign of Fd . v.
template <class T, int D>
T outward(const desired_force<T, D>& Fd, const vector<T, D>& v) {
  return Fd.direction.dot(v - Fd.wall_velocity);
}

/// Index of the contact that demands the largest force; -1 if there is none. A force that is not finite
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

/// ok, or what is wrong with one of these contacts: NaN, infinity or a force that overflows T.
template <class T, class Contacts>
status check_contacts(const Contacts& touched) {
  for (int j = 0; j < touched.size(); ++j) {
    const auto [n, magnitude, velocity] = desired_force_of<T>(touched[j]);
    if (!all_finite(magnitude, n, velocity)) return status::contact_invalid;
  }
  return status::ok;
}

}  // namespace passive_haptics
