// Arms of thin rods, for experiments and tests.
#pragma once

#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

#include <array>
#include <cstddef>

namespace experiments {

namespace ph = passive_haptics;

// A planar arm of rods of 0.2 kg per 0.15 m, with 0.1 kg at the handle.
template <std::size_t N>
ph::serial_chain_with_inertia<double, static_cast<int>(N), 2> planar_rods(
    const std::array<double, N>& lengths) {
  ph::serial_chain_inertia<double, static_cast<int>(N), 2> inertia;
  double reached = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const double end = reached + lengths[i];
    inertia.links[i] = ph::uniform_rod<double, 2>(0.2 * lengths[i] / 0.15, {reached, 0}, {end, 0});
    reached = end;
  }
  inertia.rotor_inertia.setConstant(5e-5);
  inertia.handle_mass = 0.1;
  return {ph::planar_arm<double>(lengths), inertia};
}

// Yaw, and N - 1 joints that lift, with links of these lengths; rods of 0.2 kg and a column of equal mass. No
// gravity.
template <std::size_t N>
ph::serial_chain_with_inertia<double, static_cast<int>(N) + 1, 3> spatial_rods(
    const std::array<double, N>& lengths) {
  using V = ph::vector<double, 3>;
  constexpr int n = static_cast<int>(N) + 1;
  ph::serial_chain_parameters<double, n, 3> geometry;
  ph::serial_chain_inertia<double, n, 3> inertia;
  geometry.joints[0] = ph::revolute_joint<double>(V(0, 0, 1), V(0, 0, 0));
  inertia.links[0] = ph::uniform_rod<double, 3>(0.2, {0, 0, -0.1}, {0, 0, 0});
  inertia.links[0].about_centre += 1e-4 * ph::matrix<double, 3, 3>::Identity();
  V reached(0, 0, 0);
  for (std::size_t i = 0; i < N; ++i) {
    const V end = reached + V(lengths[i], 0, 0);
    geometry.joints[i + 1] = ph::revolute_joint<double>(V(0, -1, 0), reached);
    inertia.links[i + 1] = ph::uniform_rod<double, 3>(0.2, reached, end);
    reached = end;
  }
  geometry.handle = reached;
  return {geometry, inertia};
}

// Three revolute joints, 0.1 m of column, two links of 0.15 m: uniform rods of 0.2 kg times `inertia`.
using arm_3r = ph::serial_chain_with_inertia<double, 3, 3>;
inline arm_3r arm_3r_of(double inertia) {
  using V = ph::vector<double, 3>;
  const V base(0, 0, 0), shoulder(0, 0, 0.1), elbow(0.15, 0, 0.1), handle(0.3, 0, 0.1);
  ph::serial_chain_parameters<double, 3, 3> geometry;
  geometry.joints = {ph::revolute_joint<double>({0, 0, 1}, base),
                     ph::revolute_joint<double>({0, -1, 0}, shoulder),
                     ph::revolute_joint<double>({0, -1, 0}, elbow)};
  geometry.handle = handle;
  const double mass = 0.2 * inertia;
  ph::serial_chain_inertia<double, 3, 3> rods;
  rods.links = {ph::uniform_rod<double, 3>(mass, base, shoulder),
                ph::uniform_rod<double, 3>(mass, shoulder, elbow),
                ph::uniform_rod<double, 3>(mass, elbow, handle)};
  return {geometry, rods};
}

// The arm with only these brakes, by their numbers from 0.
template <int... Brakes, class M>
ph::braked_joints<M, Brakes...> with_brakes(const M& arm) {
  return ph::braked_joints<M, Brakes...>(arm);
}

}  // namespace experiments
