/// @file
/// The stages of a cycle under a TorqueLaw: what the law wants, made what the brakes can do.
#pragma once

#include <passive_haptics/control/account.hpp>
#include <passive_haptics/control/extensions/generator_form.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

namespace passive_haptics {

namespace detail {
// Stands for a law that is never asked.
struct no_law {
  template <class T, int D>
  T scale(const contact_situation<T, D>&) const noexcept;
};
}  // namespace detail

/// Fd of the wall that asks for most. A TorqueLaw sees all walls by itself.
template <class M, class B, TorqueLaw L, int D, int N>
  requires(N > 1)
auto desired(const cycle_parts<M, B, L>&, const contacts<D, N>& touched) {
  using T = typename M::scalar;
  if (touched.empty()) return desired_force<T, D>{vector<T, D>::Zero(), T(0), vector<T, D>::Zero()};
  return force_of<T>(touched[governing_contact(touched)]);
}

/// A force that a TorqueLaw commands, and what the law will remember if the cycle ends well.
template <class T, int D, int Brakes, class Memory>
struct commanded_force : approximated_force<T, D, Brakes> {
  [[no_unique_address]] Memory memory;  ///< The law's.
};

/// The torques that the law wants. A brake that would have to drive is released.
template <class M, class B, TorqueLaw L, class Now, class T, int D>
auto displayed(const cycle_parts<M, B, L>& with, const Now& now, const desired_force<T, D>&,
               const auto& touched, step_memory<L>& memory) {
  static_assert(!needs_dynamics<L> || Dynamics<M>,
                "passive_haptics: this law needs a mechanism that models Dynamics: give it mass_matrix, "
                "bias_torque and bias_acceleration (mechanism/dynamics.hpp), or take direct_control.");
  commanded_force<T, D, M::brake_count, law_memory<L>> Fc{{display_class::exact}, memory.law};
  brake_vector<M> wanted;
  if constexpr (requires { typename L::memory; }) {
    static_assert(
        requires { with.law.torque(now, touched, Fc.memory); },
        "passive_haptics: torque() of this law takes brakes_of<M> alone; let it take a brake_situation<M, "
        "E, B> of any brakes B, or give the step brakes_of<M>.");
    wanted = with.law.torque(now, touched, Fc.memory);
  } else {
    wanted = with.law.torque(now, touched);
  }
  if (all_finite(wanted)) Fc.torque = (now.s.array() * wanted.array() > T(0)).select(T(0), wanted);
  else Fc.torque = wanted;  // a fault of the law, also where it would be released
  return Fc;
}

/// The law has scaled its torques itself.
template <class M, class B, TorqueLaw L, class Now, class T, int D, int Brakes>
T scale(const cycle_parts<M, B, L>&, const Now&, const desired_force<T, D>&,
        const approximated_force<T, D, Brakes>&) {
  return T(1);
}

/// Each torque within its limit: the law has chosen each.
template <class M, class B, TorqueLaw L, class T, int Brakes>
saturated_torque<T, Brakes> limited(const cycle_parts<M, B, L>& with, const vector<T, Brakes>& t) {
  if constexpr (LimitedBrakes<B, T, Brakes>)
    return saturate(t, with.brakes.torque_limit, saturation::clamp_each);
  else return {t, false};
}

/// The account: of the force F = G t that the law's torques make before the limits. At a singular pose that
/// is the part of it that the pose can tell. Display is exact where F is Fd, approximate where it has a
/// component along Fd.
template <class Answer, class M, class B, TorqueLaw L, class Now, int D, int N, class T, int Brakes,
          class Memory>
Answer account(const cycle_parts<M, B, L>& with, const Now& now, const contacts<D, N>& touched,
               const desired_force<T, D>& Fd, commanded_force<T, D, Brakes, Memory> Fc, T alpha,
               const approximated_force<T, D, Brakes>& Fc_scaled, const saturated_torque<T, Brakes>& td,
               const brake_vector<M>& t, step_memory<L>& memory) {
  using detail::no_law;
  constexpr no_law none;
  const cycle_parts<M, B, no_law> as_scaled{with.mechanism, with.brakes, none, with.brake_jacobian,
                                            with.options};
  step_memory<no_law> nothing;
  bool could = false;
  if constexpr (requires(Answer answer) { answer.torque; }) {
    could = displayed(as_scaled, now, Fd, touched, nothing).display == display_class::exact;
    Fc.force = force_map_of(now).G * Fc.torque;
    Fc.cosine_squared = cosine_squared(Fc.force, Fd.direction);
    const T off = (Fc.force - Fd.magnitude * Fd.direction).norm();
    Fc.display = off <= rounding_tolerance<T>(D + Brakes) * Fd.magnitude ? display_class::exact
                 : Fc.cosine_squared > T(0)                              ? display_class::approximate
                                                                         : display_class::none;
  }
  Answer answer = check_contacts<T>(touched) == status::ok
                      ? account<Answer>(as_scaled, now, touched, Fd, approximated_force<T, D, Brakes>(Fc),
                                        alpha, Fc_scaled, td, t, nothing)
                      : released<Answer>(status::contact_not_finite);
  if (answer.outcome != status::ok) {
    tell_released(with.law, now.time, memory);
    return answer;
  }
  memory.law = Fc.memory;
  if constexpr (requires { answer.power; }) answer.power = classify_power(Fd.direction.dot(now.v), could);
  return answer;
}

}  // namespace passive_haptics
