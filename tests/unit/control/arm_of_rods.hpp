// Planar arms with more joints than dimensions.
#pragma once

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace arms {

namespace ph = passive_haptics;

template <int N>
using arm = ph::serial_chain_with_inertia<double, N, 2>;

// Links of 0.15 m and 0.2 kg.
template <int N>
arm<N> of_rods(double rotor_inertia = 1e-4) {
  std::array<double, N> lengths;
  lengths.fill(0.15);
  ph::serial_chain_inertia<double, N, 2> inertia;
  for (int i = 0; i < N; ++i)
    inertia.links[std::size_t(i)] = ph::uniform_rod<double, 2>(0.2, {0.15 * i, 0}, {0.15 * (i + 1), 0});
  inertia.rotor_inertia.setConstant(rotor_inertia);
  inertia.handle_mass = 0.1;
  return arm<N>(ph::planar_arm<double>(lengths), inertia);
}

}  // namespace arms
