/// Detected optional members of a mechanism, of brakes, of a law or of a state.
#pragma once

#include <passive_haptics/brake/at_rest/brake_bias_acceleration.hpp>
#include <passive_haptics/brake/brake_concepts.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/core/error_message.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace passive_haptics {

/// An optional member.
struct optional_member {
  std::string_view name;  ///< As in the code.
  bool found;             ///< True if the type has it in the required form.
};

/// All optional members of a type. A misspelt name or a function that is not const counts as absent;
/// `static_assert(describe<arm>().has("transmission"))` turns that into an error.
template <std::size_t N>
struct description {
  std::array<optional_member, N> members;  ///< In the order of the concept's list.

  /// True if the member was found. An unknown name is an error, see require_no_error().
  constexpr bool has(std::string_view name) const {
    for (const optional_member& m : members)
      if (m.name == name) return m.found;
    require_no_error(detail::error_text("optional member", name, "a name that describe() lists"));
    return false;
  }
};

/// Text such as "jacobian, pose; not found: transmission, ...".
template <std::size_t N>
std::string to_text(const description<N>& all) {
  std::string found, missing;
  for (const optional_member& m : all.members) {
    std::string& list = m.found ? found : missing;
    list.append(list.empty() ? "" : ", ").append(m.name);
  }
  return (found.empty() ? "none" : found).append(missing.empty() ? "" : "; not found: ").append(missing);
}

namespace detail {
template <class L>
concept names_max_contacts = requires { L::max_contacts; };
template <class L>
concept names_memory = requires { typename L::memory; };
template <class S>
concept names_hand_force = requires(const S state) { state.hand_force; };
template <class S>
concept names_hand_torque = requires(const S state) { state.hand_torque; };
}  // namespace detail

/// Optional members of a mechanism.
template <class M>
  requires detail::names_sizes<M>
constexpr description<9> describe() {
  return {{{{"jacobian", detail::has_exact_jacobian<M>},
            {"transmission", detail::has_exact_transmission<M>},
            {"pose", detail::has_pose<M>},
            {"mass_matrix", detail::has_mass_matrix<M>},
            {"bias_torque", detail::has_bias_torque<M>},
            {"bias_acceleration", detail::has_bias_acceleration<M>},
            {"brake_bias_acceleration", detail::has_brake_bias_acceleration<M>},
            {"inverse_jacobian", detail::has_inverse_jacobian<M>},
            {"inverse_transposed_jacobian", detail::has_inverse_transposed_jacobian<M>}}}};
}

/// Optional members of brakes.
template <class B>
  requires(detail::names_torque_limit<B> || detail::is_unlimited<B>)
constexpr description<6> describe() {
  return {{{{"torque_limit", detail::names_torque_limit<B>},
            {"torque_lower", detail::names_torque_lower<B>},
            {"torque_upper", detail::names_torque_upper<B>},
            {"rate_dead_band", detail::names_rate_dead_band<B>},
            {"torque_dead_band", detail::names_torque_dead_band<B>},
            {"time_constant", detail::names_time_constant<B>}}}};
}

/// Optional members of a law.
template <ControlLaw L>
constexpr description<9> describe() {
  return {{{{"needs_hand_force", needs_hand_force<L>},
            {"needs_dynamics", needs_dynamics<L>},
            {"needs_brake_lag", needs_brake_lag<L>},
            {"needs_sensed_at", needs_sensed_at<L>},
            {"needs_rising_time", needs_rising_time<L>},
            {"nulls_normal_force", nulls_normal_force<L>},
            {"saturates_before_scaling", saturates_before_scaling<L>},
            {"max_contacts", detail::names_max_contacts<L>},
            {"memory", detail::names_memory<L>}}}};
}

/// Optional members of a state.
template <class S>
  requires detail::has_time_in_seconds<S>
constexpr description<2> describe() {
  return {{{{"hand_force", detail::names_hand_force<S>}, {"hand_torque", detail::names_hand_torque<S>}}}};
}

/// Optional members of an object's type.
template <class X>
constexpr auto describe(const X&) {
  return passive_haptics::describe<X>();
}

}  // namespace passive_haptics
