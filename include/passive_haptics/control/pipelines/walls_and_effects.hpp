/// @file
/// Input and result of a cycle with effects beside its walls.
#pragma once

#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/core/for_each.hpp>
#include <passive_haptics/force/effect.hpp>

#include <type_traits>
#include <utility>

namespace passive_haptics {

/// The result of a cycle with effects. Walls: of the contacts.
template <class M, class Walls>
struct step_result_with_effects : step_result_for<M, Walls> {
  /// Fe, what the effects want at the end effector [N], base frame.
  task_vector<M> effect_force = task_vector<M>::Zero();
  /// What effects on joints, such as end stops, want of the joints [N m].
  joint_vector<M> effect_torque = joint_vector<M>::Zero();
  /// Desired torques of the brakes for the walls, as without effects [N m].
  brake_vector<M> torque_for_walls = brake_vector<M>::Zero();
  /// Desired torques of the brakes that effects add [N m]: capacity_i is the size of the sum of both.
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

/// The walls that are touched, and the effects. Walls: contacts, or a reference to them.
template <class Walls, class... Effects>
struct walls_and_effects {
  using walls_type = std::remove_cvref_t<Walls>;           ///< Contacts.
  static constexpr bool has_effects = true;                ///< For the pipeline beside_effects.
  static constexpr int dimension = walls_type::dimension;  ///< d
  static constexpr int capacity = walls_type::capacity;    ///< Most walls at once.
  /// What a cycle returns.
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

  Walls walls;                                    ///< Touched.
  const detail::effects_of<Effects...>& effects;  ///< Beside them.

  /// Walls.
  int size() const { return walls.size(); }
  /// True where no wall is touched.
  bool empty() const { return walls.empty(); }
  /// Wall j.
  decltype(auto) operator[](int j) const { return walls[j]; }
};

}  // namespace passive_haptics
