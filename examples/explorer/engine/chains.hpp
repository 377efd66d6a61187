/// @file
/// Arms of three joints, of which the page has only lengths and masses.
#pragma once

#include "places.hpp"

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

#include <array>
#include <cmath>

namespace explorer {

/// Lengths of three links and the masses of a light desktop device in D dimensions; uniform rods with a point
/// mass at the handle.
template <int D>
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
  /// From the base to the handle of the stretched arm [m].
  double reach() const {
    return D == 2 ? length_1 + length_2 + length_3 : std::hypot(length_1, length_2 + length_3);
  }
};
using planar_3r_parameters = arm_parameters<2>;   ///< Three links in a plane.
using spatial_3r_parameters = arm_parameters<3>;  ///< A turning base with shoulder and elbow.

/// A chain of these joints, with rods between `points`, the last of which is the handle.
template <int D>
ph::serial_chain_with_inertia<double, 3, D> chain_of(const std::array<ph::chain_joint<double, D>, 3>& joints,
                                                     const std::array<ph::vector<double, D>, 4>& points,
                                                     const arm_parameters<D>& p) {
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

/// Three links in a plane, a brake on each joint: a device with self-motion.
struct planar_3r : ph::serial_chain_with_inertia<double, 3, 2> {
  /// With these lengths and masses.
  explicit planar_3r(const planar_3r_parameters& p)
      : planar_3r(p, ph::planar_arm(std::array{p.length_1, p.length_2, p.length_3})) {}

 private:
  planar_3r(const planar_3r_parameters& p, const ph::serial_chain_parameters<double, 3, 2>& arm)
      : ph::serial_chain_with_inertia<double, 3, 2>(chain_of<2>(
            arm.joints, {arm.joints[0].point, arm.joints[1].point, arm.joints[2].point, arm.handle}, p)) {}
};

/// An arm in space: in the zero pose a column, then two links along x. Base about z, shoulder and elbow about
/// -y, so that positive angles lift the arm.
struct spatial_3r : ph::serial_chain_with_inertia<double, 3, 3> {
  /// With these lengths and masses.
  explicit spatial_3r(const spatial_3r_parameters& p)
      : ph::serial_chain_with_inertia<double, 3, 3>(
            chain_of<3>({ph::revolute_joint<double>({0, 0, 1}, {0, 0, 0}),
                         ph::revolute_joint<double>({0, -1, 0}, {0, 0, p.length_1}),
                         ph::revolute_joint<double>({0, -1, 0}, {p.length_2, 0, p.length_1})},
                        {place(0, 0, 0), place(0, 0, p.length_1), place(p.length_2, 0, p.length_1),
                         place(p.length_2 + p.length_3, 0, p.length_1)},
                        p)) {}
};

}  // namespace explorer
