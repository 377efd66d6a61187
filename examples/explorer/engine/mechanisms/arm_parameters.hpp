/// @file
/// Parameters of arms of three joints: lengths and masses of their links.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

namespace explorer {

namespace ph = passive_haptics;

/// Lengths of three links and the masses of a light desktop device; uniform rods with a point mass at the
/// handle.
struct arm_parameters {
  double length_1 = 0.12;       ///< [m]
  double length_2 = 0.12;       ///< [m]
  double length_3 = 0.08;       ///< [m]
  double mass_1 = 0.2;          ///< [kg]
  double mass_2 = 0.2;          ///< [kg]
  double mass_3 = 0.1;          ///< [kg]
  double handle_mass = 0.1;     ///< [kg]
  double rotor_inertia = 5e-5;  ///< On each joint's axis [kg m^2].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = arm_parameters;
    return ph::member_table(ph::member("length_1", &p::length_1, "m", ph::range::positive),
                            ph::member("length_2", &p::length_2, "m", ph::range::positive),
                            ph::member("length_3", &p::length_3, "m", ph::range::positive),
                            ph::member("mass_1", &p::mass_1, "kg", ph::range::positive),
                            ph::member("mass_2", &p::mass_2, "kg", ph::range::positive),
                            ph::member("mass_3", &p::mass_3, "kg", ph::range::positive),
                            ph::member("handle_mass", &p::handle_mass, "kg", ph::range::not_negative),
                            ph::member("rotor_inertia", &p::rotor_inertia, "kg m^2", ph::range::positive));
  }
  /// All lengths [m].
  double reach() const { return length_1 + length_2 + length_3; }
};

/// The chain of these joints, whose links are rods between `points`, the last of which is the handle.
template <int D>
ph::serial_chain_with_inertia<double, 3, D> chain_of(const std::array<ph::chain_joint<double, D>, 3>& joints,
                                                     const std::array<ph::vector<double, D>, 4>& points,
                                                     const arm_parameters& p) {
  ph::serial_chain_parameters<double, 3, D> geometry;
  geometry.joints = joints;
  geometry.handle = points[3];
  ph::serial_chain_inertia<double, 3, D> inertia;
  const double masses[3] = {p.mass_1, p.mass_2, p.mass_3};
  for (std::size_t i = 0; i < 3; ++i)
    inertia.links[i] = ph::uniform_rod<double, D>(masses[i], points[i], points[i + 1]);
  inertia.rotor_inertia.setConstant(p.rotor_inertia);
  inertia.handle_mass = p.handle_mass;
  return {geometry, inertia};
}

}  // namespace explorer
