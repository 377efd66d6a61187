// Chains of these tests: the numbers stand in devices.py, too.
#pragma once

#include "reference.hpp"

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

namespace reference {

// Links of 0.1 m along x; in space the first joint turns about z, the others in turn about -y and z.
template <int N, int D>
ph::serial_chain_parameters<double, N, D> geometry() {
  ph::serial_chain_parameters<double, N, D> p;
  for (int i = 0; i < N; ++i) {
    auto& joint = p.joints[std::size_t(i)];
    joint.point[0] = 0.1 * i;
    if constexpr (D == 3) joint.axis = i % 2 == 0 ? ph::point<3>(0, 0, 1) : ph::point<3>(0, -1, 0);
  }
  p.handle = ph::point<D>::Zero();
  p.handle[0] = 0.1 * N;
  return p;
}

// Each link of 0.2 kg with its mass in the middle.
template <int N, int D>
ph::serial_chain_inertia<double, N, D> inertia() {
  ph::serial_chain_inertia<double, N, D> p;
  for (int i = 0; i < N; ++i) {
    auto& link = p.links[std::size_t(i)];
    link.mass = 0.2;
    link.centre[0] = 0.1 * i + 0.05;
    link.about_centre.setIdentity();
    link.about_centre *= 0.0002;
  }
  return p;
}

}  // namespace reference
