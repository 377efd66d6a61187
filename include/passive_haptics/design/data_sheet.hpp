/// @file
/// The data sheets of a device's parts, and what they come to on the axes of a mechanism.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <array>
#include <numbers>

namespace passive_haptics {

/// A brake and its gear, as their data sheets state them: on the brake's own shaft.
struct brake_data {
  double torque_limit = brake_parameters<double, 1>().torque_limit[0];  ///< Rated torque [N m].
  double residual_torque = 0;  ///< Drag torque without current [N m].
  /// In which the torque rises to 63 % after a step of the current [s].
  double time_constant = brake_parameters<double, 1>().time_constant[0];
  /// In which the torque falls to 37 % [s]; remanence makes it the longer one.
  double fall_time_constant = brake_parameters<double, 1>().time_constant[0];
  double rotor_inertia = 0;  ///< Of what turns with the shaft [kg m^2]; 0 if mass_matrix has it.
  /// Turns of the shaft for each turn of the mechanism's brake axis [1]; for a sliding axis 1 / radius of the
  /// drum [1/m]. Torques are multiplied by it, the inertia by its square; a gear without losses.
  double gear_ratio = 1;

  static constexpr const char* type_name = "a brake";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = brake_data;
    return member_table(member("torque_limit", &p::torque_limit, "N m", range::not_negative),
                        member("residual_torque", &p::residual_torque, "N m", range::not_negative),
                        member("time_constant", &p::time_constant, "s", range::not_negative),
                        member("fall_time_constant", &p::fall_time_constant, "s", range::not_negative),
                        member("rotor_inertia", &p::rotor_inertia, "kg m^2", range::not_negative),
                        member("gear_ratio", &p::gear_ratio, "1 or 1/m", range::positive));
  }
};

/// An encoder and what drives it.
struct encoder_data {
  double counts_per_turn = 8192;  ///< With all edges counted, four for each line [1]; inf: an ideal encoder.
  /// Turns of the encoder for each turn of its axis, see encoder_axes [1]; for a sliding axis [1/m]. That of
  /// the brake, if the encoder is on the brake's shaft.
  double gear_ratio = 1;

  static constexpr const char* type_name = "an encoder";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = encoder_data;
    constexpr range counts{.lower = 0, .open_above = false};
    return member_table(
        member("counts_per_turn", &p::counts_per_turn, "1",
               counts.as("a number > 0, or inf for an ideal encoder; a controller needs one on each axis")),
        member("gear_ratio", &p::gear_ratio, "1 or 1/m", range::positive));
  }
};

/// A hand that holds the handle and pushes.
struct hand_data {
  double mass = 0.5;     ///< What moves with the handle [kg].
  double push = 2;       ///< Into the wall at its surface [N].
  double stiffness = 0;  ///< By which the push falls with the depth [N/m],
  double damping = 20;   ///< and with the speed into the wall [N s/m].

  static constexpr const char* type_name = "a hand";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = hand_data;
    return member_table(member("mass", &p::mass, "kg", range::not_negative),
                        member("push", &p::push, "N", range::finite),
                        member("stiffness", &p::stiffness, "N/m", range::not_negative),
                        member("damping", &p::damping, "N s/m", range::not_negative));
  }
};

/// The parts that a device of mechanism M is to be built of, and the hand that is to use it.
template <class M>
struct data_sheet {
  std::array<brake_data, std::size_t(M::brake_count)> brakes;  ///< On the brakes' axes, in their order.
  std::array<encoder_data, std::size_t(encoder_axes<M>::count)> encoders;  ///< On the encoder_axes.
  double control_rate = 1000;                                              ///< Of the control cycle [Hz].
  double scene_rate = 1000;  ///< Of the virtual environment [Hz].
  double rate_corner = 50;   ///< First-order low-pass of the differenced positions [Hz].
  hand_data hand;            ///< Who holds the handle.

  static constexpr const char* type_name = "a data sheet";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = data_sheet;
    return member_table(member("brakes", &p::brakes), member("encoders", &p::encoders),
                        member("control_rate", &p::control_rate, "Hz", range::positive),
                        member("scene_rate", &p::scene_rate, "Hz", range::positive),
                        member("rate_corner", &p::rate_corner, "Hz", range::positive),
                        member("hand", &p::hand));
  }
};

namespace detail {

// f(brake_data) of each brake.
template <class M, class F>
brake_vector<M> of_each_brake(const data_sheet<M>& parts, const F& f) {
  brake_vector<M> values;
  for (int i = 0; i < M::brake_count; ++i)
    values[i] = static_cast<typename M::scalar>(f(parts.brakes[std::size_t(i)]));
  return values;
}

}  // namespace detail

/// Limits and rises on the brakes' axes: gear_ratio times torque_limit [N m, or N of a slide].
template <class M>
brakes_of<M> axis_brakes_of(const data_sheet<M>& parts) {
  brakes_of<M> brakes;
  brakes.torque_limit =
      detail::of_each_brake(parts, [](const brake_data& b) { return b.gear_ratio * b.torque_limit; });
  brakes.time_constant = detail::of_each_brake(parts, [](const brake_data& b) { return b.time_constant; });
  return brakes;
}

/// Residual torques on the brakes' axes: gear_ratio times residual_torque [N m, or N of a slide].
template <class M>
brake_vector<M> axis_residual_of(const data_sheet<M>& parts) {
  return detail::of_each_brake(parts, [](const brake_data& b) { return b.gear_ratio * b.residual_torque; });
}

/// Inertias of the rotors on the brakes' axes: gear_ratio^2 times rotor_inertia [kg m^2, or kg of a slide].
template <class M>
brake_vector<M> axis_inertia_of(const data_sheet<M>& parts) {
  return detail::of_each_brake(
      parts, [](const brake_data& b) { return b.gear_ratio * b.gear_ratio * b.rotor_inertia; });
}

/// One count of each encoder on its axis, 2 pi / (counts_per_turn gear_ratio) [rad, or m of a slide].
template <class M>
vector<typename M::scalar, encoder_axes<M>::count> axis_resolution_of(const data_sheet<M>& parts) {
  vector<typename M::scalar, encoder_axes<M>::count> resolution;
  for (int i = 0; i < encoder_axes<M>::count; ++i) {
    const encoder_data& part = parts.encoders[std::size_t(i)];
    resolution[i] =
        static_cast<typename M::scalar>(2 * std::numbers::pi / part.counts_per_turn / part.gear_ratio);
  }
  return resolution;
}

}  // namespace passive_haptics
