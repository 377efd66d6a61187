/// Desired force of a wall.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <cmath>

namespace passive_haptics {

/// Desired force Fd = magnitude * direction. The parts are separate because a wall of 1e7 N/m may demand 5e4
/// N while 2 N are displayed: everything except the magnitude is computed for a unit force.
template <class T, int D>
struct desired_force {
  vector<T, D> direction;      ///< n = Fd / |Fd|.
  T magnitude;                 ///< |Fd| [N].
  vector<T, D> wall_velocity;  ///< Velocity of the wall surface [m/s].
};

/// Fd = k depth n of a frictionless elastic wall (section 5.1), base frame.
template <class T, int D>
desired_force<T, D> desired_force_of(const contact<D>& c) {
  return {as<T>(c.normal), static_cast<T>(c.stiffness * c.depth), as<T>(c.wall_velocity)};
}

/// True if the magnitude is positive (not NaN).
template <class T, int D>
bool is_nonzero(const desired_force<T, D>& Fd) {
  return Fd.magnitude > T(0);
}

/// Normal velocity n . (v - v_wall) [m/s] of the handle relative to the wall; > 0 if it leaves.
template <class T, int D>
T outward(const desired_force<T, D>& Fd, const vector<T, D>& v) {
  return Fd.direction.dot(v - Fd.wall_velocity);
}

/// Index of the contact with the maximum force (or a non-finite one, for the report); -1 if none.
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

/// Returns ok, or contact_invalid if a contact is not finite or its force overflows T.
template <class T, class Contacts>
status check_contacts(const Contacts& touched) {
  for (int j = 0; j < touched.size(); ++j) {
    const auto [n, magnitude, velocity] = desired_force_of<T>(touched[j]);
    if (!all_finite(magnitude, n, velocity)) return status::contact_invalid;
  }
  return status::ok;
}

}  // namespace passive_haptics
