/// @file
/// Geometry and inertia of a delta.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/validate.hpp>

#include <cmath>

namespace passive_haptics {

/// Two poses of the platform close the loops; a delta keeps to one.
enum class delta_assembly {
  lower,  ///< Below the plane of the elbows (numbered counterclockwise seen from above).
  upper,  ///< Above it.
};

/// Sizes of a desktop device, an own choice, no maker's: a ball of 0.1 m diameter about (0, 0, -0.14 m) is
/// reached with both conditioning figures over 0.29. Light links.
template <class T>
struct delta_parameters {
  T base_radius = T(0.05);      ///< From the middle of the base to a base joint's axis [m].
  T platform_radius = T(0.02);  ///< From the middle of the platform to a forearm's end [m].
  T upper_arm = T(0.07);        ///< From a base joint's axis to its elbow [m].
  T forearm = T(0.13);          ///< From the elbow to the platform [m].
  delta_assembly assembly = delta_assembly::lower;  ///< Side of the platform.
  T upper_arm_mass = T(0.05);                       ///< A uniform rod [kg].
  T forearm_mass = T(0.03);                         ///< Both rods of one parallelogram [kg].
  T platform_mass = T(0.1);                         ///< With what the hand holds [kg].
  vector<T, 3> rotor_inertia =
      vector<T, 3>::Constant(T(5e-5));          ///< On the base joints' axes [kg m^2]; that of two_link.
  vector<T, 3> gravity = vector<T, 3>::Zero();  ///< [m/s^2]; zero: the device is counterbalanced.
};

/// What is wrong with the parameters; empty if nothing.
template <class T>
std::string validate(const delta_parameters<T>& p) {
  using namespace detail;
  const std::string lengths =
      first_error(check_not_negative("base_radius [m]", p.base_radius),
                  check_not_negative("platform_radius [m]", p.platform_radius),
                  check_positive("upper_arm [m]", p.upper_arm), check_positive("forearm [m]", p.forearm));
  std::string rotors, gravity;
  for (int i = 0; i < 3; ++i) {
    const std::string index = detail::indexed("[", i, "] ");
    if (rotors.empty()) rotors = check_not_negative("rotor_inertia" + index + "[kg m^2]", p.rotor_inertia[i]);
    if (gravity.empty()) gravity = check_finite("gravity" + index + "[m/s^2]", p.gravity[i]);
  }
  const std::string loop =
      std::abs(p.base_radius - p.platform_radius) < p.upper_arm + p.forearm
          ? ""
          : error_text("base_radius - platform_radius [m]", p.base_radius - p.platform_radius,
                       "less than upper_arm + forearm in magnitude");
  return first_error(lengths, loop, check_positive("upper_arm_mass [kg]", p.upper_arm_mass),
                     check_not_negative("forearm_mass [kg]", p.forearm_mass),
                     check_not_negative("platform_mass [kg]", p.platform_mass), rotors, gravity);
}

}  // namespace passive_haptics
