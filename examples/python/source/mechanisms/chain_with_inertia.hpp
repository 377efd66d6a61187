/// @file
/// Serial chains with inertia in Python.
#pragma once

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

/// Binds such a chain.
template <int N, int D>
void bind_chain_with_inertia(py::module_& module, const char* name, const char* about) {
  bind_mechanism<ph::serial_chain_with_inertia<double, N, D>, chain_with_inertia_parameters<N, D>>(
      module, name, about);
}

}  // namespace passive_haptics_python
