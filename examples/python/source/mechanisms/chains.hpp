/// @file
/// Serial chains in Python, with and without inertia: what is compiled for their size serves both.
#pragma once

#include "any_devices.hpp"
#include "inverse.hpp"

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

namespace passive_haptics_python {

/// Both structs that make a chain with inertia.
template <int N, int D>
struct chain_with_inertia_parameters {
  ph::serial_chain_parameters<double, N, D> geometry;  ///< Joints and handle.
  ph::serial_chain_inertia<double, N, D> inertia;      ///< Links, rotors, handle and gravity.

  /// The table.
  static constexpr auto members() {
    using p = chain_with_inertia_parameters;
    return ph::member_table(ph::member("geometry", &p::geometry), ph::member("inertia", &p::inertia));
  }
  /// The chain; throws std::invalid_argument.
  ph::serial_chain_with_inertia<double, N, D> mechanism() const { return {geometry, inertia}; }
};

/// Binds chains of N joints, name and name_with_inertia. about: what they are.
template <int N, int D>
void bind_chains(py::module_& module, const std::string& name, const std::string& about) {
  using chain = ph::serial_chain<double, N, D>;
  using heavy_chain = ph::serial_chain_with_inertia<double, N, D>;
  using any_chain = any_mechanism<N, D>;
  bind_mechanism<chain, ph::serial_chain_parameters<double, N, D>, usual_laws<chain>, any_chain,
                 any_device_laws>(module, name.c_str(), (about + ", a brake on each.").c_str());
  bind_mechanism<heavy_chain, chain_with_inertia_parameters<N, D>, usual_laws<heavy_chain>, any_chain,
                 any_device_laws>(module, (name + "_with_inertia").c_str(),
                                  (about + ", a brake on each, with inertia.").c_str());
}

}  // namespace passive_haptics_python
