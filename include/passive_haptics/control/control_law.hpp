/// @file
/// The ControlLaw concept: how much of the approximated force is displayed.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <concepts>

namespace passive_haptics {

/// What a law sees of the governing contact.
template <class T, int D>
struct contact_situation {
  const vector<T, D>& normal;  ///< n = Fd / |Fd|, unit, out of the wall.
  T desired_magnitude;         ///< |Fd| [N], > 0.
  T normal_velocity;  ///< n . (v - v_wall) [m/s], > 0 where the handle leaves; 0 for laws that do not need
                      ///< it.
  const vector<T, D>& hand_force;  ///< Fh [N]; zero for laws that do not need it.
};

namespace detail {
template <class L>
concept states_its_needs = requires {
  { L::needs_hand_force } -> std::convertible_to<bool>;
  { L::needs_dynamics } -> std::convertible_to<bool>;
  { L::needs_brake_lag } -> std::convertible_to<bool>;
  typename L::memory;
  requires std::default_initializable<typename L::memory>;
};

// torque() is a template over mechanisms: that it is there can be asked only of one of them.
template <class L>
concept commands_torques = requires { requires L::commands_torques; };
}  // namespace detail

/// A law that scales the approximated force, beside the needs of ControlLaw:
///   - `T scale(const contact_situation<T, d>&, memory&) const noexcept`: alpha in [0, 1], Fc' = alpha Fc
///   (7).
///
/// Optional:
///   - `static constexpr bool gives_way`, true if it scales the force of a contact being left so that nothing
///   remains
///     normal; of several contacts these are then met before the others. Without it, false;
///   - `static constexpr bool needs_normal_velocity`, false if it does not read that. Without it, true.
template <class L>
concept ScalingLaw =
    detail::states_its_needs<L> &&
    requires(const L law, const contact_situation<double, 2> situation, typename L::memory memory) {
      { law.scale(situation, memory) } noexcept -> std::same_as<double>;
    };

/// A law that commands the brakes itself, beside the needs of ControlLaw:
///   - `static constexpr bool commands_torques = true`;
///   - `brake_vector<M> torque(const brake_situation<M, E>&, const contacts<d, N>&, memory&) const noexcept`,
///   a
///     template over mechanisms: the torques [N m] that the brakes shall make, at least one wall being
///     touched. The step cuts them to the limits; a torque that does not oppose its brake (s_i t_i > 0)
///     releases it.
///
/// Optional:
///   - `void released(memory&, double time) const noexcept`, called in each cycle that commands nothing (free
///   space,
///     faults), so that the law knows what its brakes were told;
///   - `static constexpr bool needs_torque_limit`, true if it reads the brakes' limits, as one that locks
///   brakes does.
///     Without it, false.
template <class L>
concept TorqueLaw = detail::states_its_needs<L> && detail::commands_torques<L>;

/// A control law.
///
/// Minimal complete definition, beside that of a ScalingLaw or a TorqueLaw:
///   - `static constexpr bool needs_hand_force, needs_dynamics, needs_brake_lag`: what it reads. A law that
///   needs
///     no hand force runs on a device without a force sensor;
///   - `struct memory`: what it remembers from cycle to cycle, default-constructible (may be empty).
template <class L>
concept ControlLaw = ScalingLaw<L> || TorqueLaw<L>;

/// Whether a law gives way to a hand that leaves a wall.
template <class L>
inline constexpr bool gives_way = requires { requires L::gives_way; };

/// Whether a law reads the normal velocity of a contact: unless it says that it does not.
template <class L>
inline constexpr bool needs_normal_velocity = !requires { requires !L::needs_normal_velocity; };

/// Whether a law reads the torque limits, so that brakes without any are none for it.
template <class L>
inline constexpr bool needs_torque_limit = requires { requires L::needs_torque_limit; };

}  // namespace passive_haptics
