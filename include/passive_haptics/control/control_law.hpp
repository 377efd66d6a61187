/// @file
/// The ControlLaw concept: how much of the approximated force is displayed.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/control/step_options.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

/// The device at one instant; E from brake_jacobian. Lives no longer than the values that it refers to. A law
/// that takes any B also runs on brakes that lack members (brake/brake_concepts.hpp).
template <class M, class EMatrix, class B = brakes_of<M>>
struct brake_situation {
  using mechanism_type = M;  ///< Of the mechanism.

  const M& mechanism;                 ///< The mechanism,
  const mechanism_pose<M>& pose;      ///< what it gives in this pose,
  const B& brakes;                    ///< its brakes.
  double time;                        ///< Now [s],
  const joint_vector<M>& q;           ///< joint positions [rad or m],
  const joint_vector<M>& qd;          ///< their rates [rad/s or m/s],
  const point<M::task_dimension>& x;  ///< the end effector [m].
  const EMatrix& E;                   ///< E = J T^+.
  const brake_vector<M>& w;           ///< Rates of the brakes [rad/s or m/s].
  const task_vector<M>& v;            ///< Velocity of the end effector [m/s].
  const brake_vector<M>& s;           ///< Signs of the brakes: s_i t_i <= 0. Of one-way brakes signs_within.
  const task_vector<M>& hand_force;   ///< Fh [N]; zero where the state has none.
  const brake_vector<M>& th;          ///< What the hand does to each brake at rest [N m].
  const step_options<typename M::scalar>&
      options;  ///< Of the controller; a law that approximates obeys them.
};

/// What a law sees of one contact.
template <class T, int D>
struct contact_situation {
  const vector<T, D>& normal;      ///< n = Fd / |Fd|, unit, out of the wall.
  T desired_magnitude;             ///< |Fd| [N], > 0.
  T normal_velocity;               ///< n . (v - v_wall) [m/s], > 0 where the handle leaves.
  const vector<T, D>& hand_force;  ///< Fh [N]; zero where the state has none.
};

/// A law that scales the approximated force. Minimal complete definition:
///   - `T scale(const contact_situation<T, d>&) const noexcept`: alpha in [0, 1], Fc' = alpha Fc.
///
/// Optional, false where it is not named:
///   - `static constexpr bool needs_hand_force`: the state must have a hand force, so the device a sensor;
///   - `static constexpr bool saturates_before_scaling`: alpha scales torques that are already cut to the
///     brakes' limits. Else they are cut after, as the paper prints it. Of one contact only;
///   - `static constexpr bool nulls_normal_force`: the force of a contact being left is scaled so that
///     nothing remains normal to the wall. Of several contacts these are then met before the others.
template <class L>
concept ScalingLaw = requires(const L law, const contact_situation<double, 2> situation) {
  { law.scale(situation) } noexcept -> std::same_as<double>;
};

namespace detail {
template <class L>
struct memory_of {
  struct type {};
};
template <class L>
  requires requires { typename L::memory; }
struct memory_of<L> {
  using type = typename L::memory;
};
}  // namespace detail

/// What a law remembers from cycle to cycle: its memory, or nothing.
template <class L>
using law_memory = typename detail::memory_of<L>::type;

/// A law that commands the brakes itself. Minimal complete definition:
///   - `static constexpr bool commands_torques = true`;
///   - `brake_vector<M> torque(const brake_situation<M, E, B>&, const contacts<d, N>&) const noexcept`, a
///     template over mechanisms: the torques [N m] that the brakes shall make, at least one wall being
///     touched. The cycle cuts them to the limits; a torque that does not oppose its brake releases it, but
///     where a self-motion settles: there the magnitudes count.
///
/// Optional:
///   - `struct memory`, default-constructible: what it remembers from cycle to cycle. torque() then takes a
///     `memory&` as well. What a cycle leaves in it is kept only if the cycle ends well;
///   - `void released(memory&, double time) const noexcept`, called in each cycle that commands nothing (free
///     space, faults), so that the law can follow what was commanded;
///   - `static constexpr bool needs_hand_force, needs_dynamics, needs_brake_lag`: what it reads of the state,
///     the mechanism and the brakes. False where they are not named;
///   - `static constexpr bool needs_sensed_at`: it reads contact::sensed_at. A contact without it is a fault,
///     status::contact_invalid;
///   - `static constexpr bool needs_rising_time`: it uses time differences. A cycle that is no later than the
///     one before is a fault, status::time_not_rising, also in free space;
///   - `double margin(const B& brakes) const noexcept`: how far off a wall it needs its contact [m], >= 0.
///     From there on a scene that can (SeesAhead) gives it, with a depth < 0 until the touch. Where more
///     than max_contacts are so near, the law gets those that are touched;
///   - `static constexpr int max_contacts`: walls that it takes at once; in a cycle that touches more the
///     brakes are released. Any number where it is not named.
template <class L>
concept TorqueLaw = requires { requires L::commands_torques; } && std::default_initializable<law_memory<L>>;

/// A control law.
template <class L>
concept ControlLaw = ScalingLaw<L> || TorqueLaw<L>;

/// Whether a law gives way to a hand that leaves a wall.
template <class L>
inline constexpr bool nulls_normal_force = requires { requires L::nulls_normal_force; };
/// Whether alpha of a law scales what the brakes can make of Fc, not Fc itself.
template <class L>
inline constexpr bool saturates_before_scaling = requires { requires L::saturates_before_scaling; };
/// Whether a law reads the hand force.
template <class L>
inline constexpr bool needs_hand_force = requires { requires L::needs_hand_force; };
/// Whether a law reads the mechanism's inertia.
template <class L>
inline constexpr bool needs_dynamics = requires { requires L::needs_dynamics; };
/// Whether a law reads the brakes' time constants.
template <class L>
inline constexpr bool needs_brake_lag = requires { requires L::needs_brake_lag; };
/// Whether a law reads where each contact was sensed.
template <class L>
inline constexpr bool needs_sensed_at = requires { requires L::needs_sensed_at; };
/// Whether a law uses time differences.
template <class L>
inline constexpr bool needs_rising_time = requires { requires L::needs_rising_time; };
/// Whether a law needs to see walls before they are touched.
template <class L, class B>
inline constexpr bool has_margin = requires(const L law, const B brakes) { law.margin(brakes); };
/// Most walls that a law takes at once.
template <class L>
inline constexpr int max_contacts = [] {
  if constexpr (requires { L::max_contacts; }) return L::max_contacts;
  else return std::numeric_limits<int>::max();
}();

}  // namespace passive_haptics
