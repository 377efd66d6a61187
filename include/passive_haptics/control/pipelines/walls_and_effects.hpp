/// Input and result of a cycle with effects in addition to walls.
#pragma once

#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/core/for_each.hpp>
#include <passive_haptics/force/effect.hpp>

#include <type_traits>
#include <utility>

namespace passive_haptics {

/// Result of a cycle with effects. Walls: contacts.
template <class M, class Walls>
struct step_result_with_effects : step_result_for<M, Walls> {
  /// Desired force Fe of the effects at the end effector [N], base frame.
  task_vector<M> effect_force = task_vector<M>::Zero();
  /// Desired joint torques of effects on joints, such as end stops [N m].
  joint_vector<M> effect_torque = joint_vector<M>::Zero();
  /// Desired brake torques for the walls, as without effects [N m].
  brake_vector<M> torque_for_walls = brake_vector<M>::Zero();
  /// Additional brake torques for the effects [N m]: capacity_i is the magnitude of the sum.
  brake_vector<M> torque_for_effects = brake_vector<M>::Zero();
};

namespace detail {

template <class... Effects>
using effects_of = boost::hana::basic_tuple<Effects...>;

template <class E>
concept names_effect_scalar = requires { typename E::scalar; };
template <class E>
inline constexpr bool is_effect = Effect<E> || WallEffect<E> || JointEffect<E>;

template <class E, int D>
concept has_dimension_other_than = requires { requires E::dimension != D; };

}  // namespace detail

/// Touched walls and effects. Walls: contacts, or a reference to them.
template <class Walls, class... Effects>
struct walls_and_effects {
  using walls_type = std::remove_cvref_t<Walls>;           ///< Contacts.
  static constexpr bool has_effects = true;                ///< Selects the pipeline beside_effects.
  static constexpr int dimension = walls_type::dimension;  ///< Task dimensions d.
  static constexpr int capacity = walls_type::capacity;    ///< Maximum number of walls.
  /// Result of a cycle.
  template <class M>
  using result_type = step_result_with_effects<M, walls_type>;

  static_assert(sizeof...(Effects) > 0, "passive_haptics: with_effects needs at least one effect.");
  static_assert((detail::names_effect_scalar<Effects> && ...),
                "passive_haptics: each effect needs `using scalar = double;` (that of the mechanism).");
  static_assert(
      (detail::is_effect<Effects> && ...),
      "passive_haptics: each effect must model Effect, WallEffect or JointEffect (force/effect.hpp).");
  static_assert((!detail::has_dimension_other_than<Effects, dimension> && ...),
                "passive_haptics: an effect's dimension must be the scene's.");

  Walls walls;                                    ///< Touched walls.
  const detail::effects_of<Effects...>& effects;  ///< Effects.

  int size() const { return walls.size(); }                    ///< Number of walls.
  bool empty() const { return walls.empty(); }                 ///< True if no wall is touched.
  decltype(auto) operator[](int j) const { return walls[j]; }  ///< Wall j.
};

}  // namespace passive_haptics
