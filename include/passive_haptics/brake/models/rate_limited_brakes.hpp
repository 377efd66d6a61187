/// @file
/// Brakes whose torque limit depends on their rate, in a control cycle.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/core/nth.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace passive_haptics {

/// The brakes of mechanism M for a controller, where each can give no more than its model says at its rate
/// (torque_limit_at), nor more than its torque_limit: eddy currents give nothing at rest. For the
/// brakes' type of a controller or a step; laws see switchable_brakes<M> with the limits of the moment. A
/// brake that can give nothing at its rate is off in that cycle: the others display what they can without it.
template <class M, BrakeModel Model>
class rate_limited_brakes : switchable_brakes<M> {
  using base = switchable_brakes<M>;
  static_assert(std::is_same_v<typename Model::scalar, typename M::scalar>,
                "passive_haptics: a brake model must have the mechanism's scalar.");

 public:
  using base::rate_dead_band;    ///< As in brake_parameters.
  using base::time_constant;     ///< As in brake_parameters.
  using base::torque_dead_band;  ///< As in brake_parameters.
  using base::torque_limit;      ///< As in brake_parameters.
  using base::torque_lower;      ///< As in switchable_brakes.
  using base::torque_upper;      ///< As in switchable_brakes.

  using base::make_negative;  ///< As in switchable_brakes.
  using base::make_positive;  ///< As in switchable_brakes.
  using base::switch_off;     ///< As in switchable_brakes.
  using base::switch_on;      ///< As in switchable_brakes.

  std::array<Model, std::size_t(M::brake_count)> models = {};  ///< One for each brake.

  /// With all default values.
  rate_limited_brakes() = default;
  /// As these brakes, with the models' default values.
  rate_limited_brakes(const brakes_of<M>& brakes) : base(brakes) {}
  /// As these brakes, of which some may be off, with the models' default values.
  rate_limited_brakes(const base& brakes) : base(brakes) {}
  /// As these brakes, each limited by its model. Throws std::invalid_argument if a parameter of a model is
  /// invalid.
  rate_limited_brakes(const base& brakes, const decltype(models)& each) : base(brakes), models(each) {
    if constexpr (Parameters<Model>) require_no_error(check_value("models", each, "", range::anything));
  }

  /// What they are at these rates [rad/s or m/s]: a limit that is not finite or negative is 0.
  switchable_brakes<M> at(const brake_vector<M>& rates) const noexcept {
    base now = *this;
    for (int i = 0; i < M::brake_count; ++i)
      now.torque_limit[i] = valid_command(nth(models, i).torque_limit_at(rates[i]), now.torque_limit[i]);
    return now;
  }
};

}  // namespace passive_haptics
