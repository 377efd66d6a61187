/// @file
/// Effects in Python.
#pragma once

#include <passive_haptics_python/any_effects.hpp>
#include <passive_haptics_python/from_python.hpp>

#include <passive_haptics/control/direct_control.hpp>

#include <memory>
#include <type_traits>

namespace passive_haptics_python {

/// The base class of all effects. Each function returns nullptr where the effect is of another kind.
struct effect {
  template <class E>
  using kind = std::type_identity<E>;  ///< Which kind is wanted.

  /// As of a base class.
  virtual ~effect() = default;
  /// The effect in the plane.
  virtual std::shared_ptr<const any_effect<2>> as(kind<any_effect<2>>) const { return nullptr; }
  /// The effect in space.
  virtual std::shared_ptr<const any_effect<3>> as(kind<any_effect<3>>) const { return nullptr; }
  /// The effect on two joints.
  virtual std::shared_ptr<const any_joint_effect<2>> as(kind<any_joint_effect<2>>) const { return nullptr; }
  /// The effect on three joints.
  virtual std::shared_ptr<const any_joint_effect<3>> as(kind<any_joint_effect<3>>) const { return nullptr; }
};

/// Whether the module is built for effects beside the walls of mechanism M under law L. Each such pair
/// takes the compiler about 5 s.
template <class M, class L>
inline constexpr bool takes_effects = std::is_same_v<L, ph::direct_control> && M::dof == M::task_dimension &&
                                      M::brake_count == M::task_dimension;

/// Adds the effects of a scene to one of a controller; a ValueError if one does not fit.
template <int D>
void add_effects(scene_with_effects<D, D>& to, const py::tuple& effects) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const auto& one = py::cast<const effect&>(effects[i]);
    if (auto on_handle = one.as(std::type_identity<any_effect<D>>())) to.on_handle().add(on_handle);
    else if (auto on_joints = one.as(std::type_identity<any_joint_effect<D>>()))
      to.on_joints().add(on_joints);
    else
      refuse_value("effect " + std::to_string(i) + " of the scene = " + shown(effects[i]) +
                   ", expected one of vectors of " + std::to_string(D) +
                   " numbers, as many as the mechanism has joints and task dimensions");
  }
}

}  // namespace passive_haptics_python
