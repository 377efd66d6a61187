/// The ControlLaw concept: scaling of the approximated force, or torques of its own.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/control/step_options.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

/// The device at one instant. Holds references. B: see brake/brake_concepts.hpp.
template <class M, class EMatrix, class B = brakes_of<M>>
struct brake_situation {
  using mechanism_type = M;  ///< Mechanism type.

  const M& mechanism;                 ///< Mechanism.
  const mechanism_pose<M>& pose;      ///< Mechanism in this pose.
  const B& brakes;                    ///< Brakes.
  double time;                        ///< Current time [s].
  const joint_vector<M>& q;           ///< Joint positions [rad or m].
  const joint_vector<M>& qd;          ///< Joint rates [rad/s or m/s].
  const point<M::task_dimension>& x;  ///< End effector [m].
  const EMatrix& E;                   ///< E = J T^+.
  const brake_vector<M>& w;           ///< Brake rates [rad/s or m/s].
  const task_vector<M>& v;            ///< End-effector velocity [m/s].
  const brake_vector<M>& s;           ///< Brake signs, s_i t_i <= 0; from signs_within for one-way brakes.
  const task_vector<M>& hand_force;   ///< Fh [N]; zero if unknown.
  const brake_vector<M>& th;          ///< Hand torque on each brake at rest [N m].
  const step_options<typename M::scalar>&
      options;  ///< Options of the controller; laws that approximate must obey them.
};

/// One contact, as laws see it.
template <class T, int D>
struct contact_situation {
  const vector<T, D>& normal;      ///< n = Fd / |Fd|, the outward unit normal.
  T desired_magnitude;             ///< |Fd| [N], > 0.
  T normal_velocity;               ///< n . (v - v_wall) [m/s], > 0 if the handle leaves.
  const vector<T, D>& hand_force;  ///< Fh [N]; zero if unknown.
};

/// A law that scales the approximated force. Minimal complete definition:
///   - `T scale(const contact_situation<T, d>&) const noexcept`: alpha in [0, 1], Fc' = alpha Fc.
///
/// Optional, default false:
///   - `static constexpr bool needs_hand_force`: the state must have a hand force, so the device needs a
///     sensor;
///   - `static constexpr bool saturates_before_scaling`: torques are limited before alpha is applied, instead
///     of after it as the paper prints it. For one contact only;
///   - `static constexpr bool nulls_normal_force`: at a contact that is being left, no normal force may
///     remain. With several contacts, these have priority.
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

/// Memory of a law between cycles, or an empty type.
template <class L>
using law_memory = typename detail::memory_of<L>::type;

/// A law that commands the brakes directly. Minimal complete definition:
///   - `static constexpr bool commands_torques = true`;
///   - `brake_vector<M> torque(const brake_situation<M, E, B>&, const contacts<d, N>&) const noexcept`, a
///     template over mechanisms: brake torques [N m] while at least one wall is touched. The cycle limits
///     them; a torque that does not oppose its brake releases it, except with a settled self-motion, where
///     magnitudes count.
///
/// Optional:
///   - `struct memory`, default-constructible, kept between cycles. torque() then has a third parameter
///     `memory&`. Changes are kept only if the cycle succeeds;
///   - `void released(memory&, double time) const noexcept`, called in each cycle that commands nothing (free
///     space, faults);
///   - `static constexpr bool needs_hand_force, needs_dynamics, needs_brake_lag`: requirements on the state,
///     the mechanism and the brakes, default false;
///   - `static constexpr bool needs_sensed_at`: requires contact::sensed_at; without it, a cycle returns
///     status::contact_invalid;
///   - `static constexpr bool needs_rising_time`: uses time differences. A cycle with a time that is not
///     later than the previous one returns status::time_not_rising, also in free space;
///   - `double margin(const B& brakes) const noexcept`: distance from a wall at which the law needs its
///     contact [m], >= 0. Scenes that support it (SeesAhead) provide the contact from there, with a depth < 0
///     until the touch. If more than max_contacts are within the margin, the law receives those that are
///     touched;
///   - `static constexpr int max_contacts`: maximum number of walls, default unlimited. A cycle that touches
///     more releases the brakes.
template <class L>
concept TorqueLaw = requires { requires L::commands_torques; } && std::default_initializable<law_memory<L>>;

/// A control law.
template <class L>
concept ControlLaw = ScalingLaw<L> || TorqueLaw<L>;

/// True if the law nulls the normal force at a contact that is being left.
template <class L>
inline constexpr bool nulls_normal_force = requires { requires L::nulls_normal_force; };
/// True if torques are limited before alpha is applied.
template <class L>
inline constexpr bool saturates_before_scaling = requires { requires L::saturates_before_scaling; };
/// True if the law needs the hand force.
template <class L>
inline constexpr bool needs_hand_force = requires { requires L::needs_hand_force; };
/// True if the law needs the inertia of the mechanism.
template <class L>
inline constexpr bool needs_dynamics = requires { requires L::needs_dynamics; };
/// True if the law needs the time constants of the brakes.
template <class L>
inline constexpr bool needs_brake_lag = requires { requires L::needs_brake_lag; };
/// True if the law needs contact::sensed_at.
template <class L>
inline constexpr bool needs_sensed_at = requires { requires L::needs_sensed_at; };
/// True if the law uses time differences.
template <class L>
inline constexpr bool needs_rising_time = requires { requires L::needs_rising_time; };
/// True if the law needs contacts of walls before they are touched.
template <class L, class B>
inline constexpr bool has_margin = requires(const L law, const B brakes) { law.margin(brakes); };
/// Maximum number of walls of the law.
template <class L>
inline constexpr int max_contacts = [] {
  if constexpr (requires { L::max_contacts; }) return L::max_contacts;
  else return std::numeric_limits<int>::max();
}();

}  // namespace passive_haptics
