/// @file
/// Shapes, walls and scenes as Python holds them, in the plane or in space.
#pragma once

#include "named.hpp"

#include <passive_haptics/runtime/any_design.hpp>
#include <passive_haptics/runtime/catalogue.hpp>

#include <functional>
#include <optional>
#include <tuple>
#include <variant>

namespace passive_haptics_python {

/// x as a vector of N numbers.
template <int N>
ph::vector<double, N> vector_of(py::handle x, const std::string& name) {
  return ph::vector<double, N>(vector_from(x, name, N).data());
}

/// A shape of D dimensions, and walls of it; a mesh_surface has no inside.
template <int D>
struct shape_in {
  std::optional<rt::any_shape<D>> solid;                     ///< The shape, where it has an inside.
  std::function<ph::any_wall<D>(double stiffness)> wall_of;  ///< A wall with a stiffness [N/m].
};
/// A shape of the plane or of space.
struct shape {
  std::variant<shape_in<2>, shape_in<3>> in;  ///< The shape.
};

/// A wall of D dimensions: in a world, and where it has an inside by itself.
template <int D>
struct wall_in {
  ph::any_wall<D> any;                              ///< For a world.
  std::optional<ph::wall<rt::any_shape<D>>> solid;  ///< For a scene of one wall.
};
/// A wall of the plane or of space.
struct wall {
  std::variant<wall_in<2>, wall_in<3>> in;  ///< The wall.
};

/// A scene; without monostate.
struct scene {
  rt::scene_variant held;  ///< As a controller takes it.

  /// f(walls), an any_scene<D>; a TypeError if there are effects.
  template <class F>
  auto without_effects(const F& f) const {
    if (const auto* plane = std::get_if<rt::any_scene<2>>(&held)) return f(*plane);
    if (const auto* space = std::get_if<rt::any_scene<3>>(&held)) return f(*space);
    refuse_type(
        "scene has effects: expected one without: with_effects(held_scene(...), effect, ...) with all "
        "effects");
  }
};

/// An effect in the plane, in space, or in both.
struct effect {
  std::tuple<std::optional<rt::any_effect<2>>, std::optional<rt::any_effect<3>>> in;  ///< The effect.
};

}  // namespace passive_haptics_python
