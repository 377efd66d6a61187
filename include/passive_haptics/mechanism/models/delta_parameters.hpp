/// Geometry and inertia of a delta.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <cmath>

namespace passive_haptics {

/// Assembly mode: two platform poses close the loops; a delta stays in one.
enum class delta_assembly {
  lower,  ///< Below the plane of the elbows (numbered counterclockwise seen from above).
  upper,  ///< Above it.
};

/// Parameters of a delta. The defaults are an example of a desktop device with light links: a ball of 0.1 m
/// diameter about (0, 0, -0.14 m) is within reach with both conditioning figures over 0.29.
template <class T>
struct delta_parameters {
  T base_radius = T(0.05);                          ///< From the middle of the base to a joint axis [m].
  T platform_radius = T(0.02);                      ///< From the middle of the platform to a forearm end [m].
  T upper_arm = T(0.07);                            ///< From a base joint axis to its elbow [m].
  T forearm = T(0.13);                              ///< From the elbow to the platform [m].
  delta_assembly assembly = delta_assembly::lower;  ///< Side of the platform.
  T upper_arm_mass = T(0.05);                       ///< A uniform rod [kg].
  T forearm_mass = T(0.03);                         ///< Both rods of one parallelogram [kg].
  T platform_mass = T(0.1);                         ///< Including what the hand holds [kg].
  /// On the base joint axes [kg m^2]; as in two_link.
  vector<T, 3> rotor_inertia = vector<T, 3>::Constant(T(5e-5));
  vector<T, 3> gravity = vector<T, 3>::Zero();  ///< [m/s^2]; zero: counterbalanced.

  static constexpr auto members() {
    using p = delta_parameters;
    return member_table(member("base_radius", &p::base_radius, "m", range::not_negative),
                        member("platform_radius", &p::platform_radius, "m", range::not_negative),
                        member("upper_arm", &p::upper_arm, "m", range::positive),
                        member("forearm", &p::forearm, "m", range::positive),
                        choice("assembly", &p::assembly, "lower, upper"),
                        member("upper_arm_mass", &p::upper_arm_mass, "kg", range::positive),
                        member("forearm_mass", &p::forearm_mass, "kg", range::not_negative),
                        member("platform_mass", &p::platform_mass, "kg", range::not_negative),
                        member("rotor_inertia", &p::rotor_inertia, "kg m^2", range::not_negative),
                        member("gravity", &p::gravity, "m/s^2", range::finite));
  }
  /// The loops can be closed.
  error_message rules() const {
    if (std::abs(base_radius - platform_radius) < upper_arm + forearm) return {};
    return detail::error_text("base_radius - platform_radius [m]", base_radius - platform_radius,
                              "less than upper_arm + forearm in magnitude");
  }
};

}  // namespace passive_haptics
