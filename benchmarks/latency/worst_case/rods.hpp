// Arms of thin rods, 0.2 kg each, without and with their inertia.
#pragma once

#include "devices.hpp"

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

namespace worst_case {

// N joints in the plane, 0.12 m apart; in space 0.1 m, and their axes are z, y and x in turns.
template <int N, int D>
ph::serial_chain_with_inertia<double, N, D> rods() {
  using point = ph::vector<double, D>;
  constexpr double length = D == 2 ? 0.12 : 0.1;
  const auto at = [](int i) -> point {
    if constexpr (D == 2) return {length * i, 0};
    else return {length * i, 0, 0.02 * i};
  };
  ph::serial_chain_parameters<double, N, D> geometry;
  ph::serial_chain_inertia<double, N, D> inertia;
  for (int i = 0; i < N; ++i) {
    if constexpr (D == 2) geometry.joints[std::size_t(i)] = ph::revolute_joint<double>(at(i));
    else geometry.joints[std::size_t(i)] = ph::revolute_joint<double>(point::Unit(2 - i % 3), at(i));
    inertia.links[std::size_t(i)] = ph::uniform_rod<double, D>(0.2, at(i), at(i + 1));
  }
  geometry.handle = at(N);
  return {geometry, inertia};
}

template <int N, int D>
bool add_rods(const std::string& name) {
  return add(name, ph::serial_chain<double, N, D>(rods<N, D>().parameters()), rods<N, D>());
}

}  // namespace worst_case
