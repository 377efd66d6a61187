/// @file
/// Brakes whose torque limit depends on their rate, in a control cycle.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/brake_model.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace passive_haptics {

/// The brakes of mechanism M as a controller knows them, where each can give no more than its model says at
/// its rate (torque_limit_at), nor more than its torque_limit: eddy currents give nothing at rest. For the
/// brakes' type of a controller or a step; laws see brakes_of<M> with the limits of the moment. A limit of 0
/// cuts all brakes to 0 unless the options say saturation::clamp_each (a TorqueLaw always does).
template <class M, BrakeModel Model>
class rate_limited_brakes : brakes_of<M> {
  static_assert(std::is_same_v<typename Model::scalar, typename M::scalar>,
                "passive_haptics: a brake model must have the mechanism's scalar.");

 public:
  using brakes_of<M>::torque_limit;      ///< As in brake_parameters.
  using brakes_of<M>::rate_dead_band;    ///< As in brake_parameters.
  using brakes_of<M>::torque_dead_band;  ///< As in brake_parameters.
  using brakes_of<M>::time_constant;     ///< As in brake_parameters.

  std::array<Model, std::size_t(M::brake_count)> models = {};  ///< One for each brake.

  /// With all default values.
  rate_limited_brakes() = default;
  /// As these brakes, with the models' default values.
  rate_limited_brakes(const brakes_of<M>& brakes) : brakes_of<M>(brakes) {}
  /// As these brakes, each limited by its model.
  rate_limited_brakes(const brakes_of<M>& brakes, const decltype(models)& each)
      : brakes_of<M>(brakes), models(each) {}

  /// What they are at these rates [rad/s or m/s]: a limit that is not finite or negative is 0.
  brakes_of<M> at(const brake_vector<M>& rates) const noexcept {
    brakes_of<M> now = *this;
    for (int i = 0; i < M::brake_count; ++i)
      now.torque_limit[i] =
          valid_command(models[static_cast<std::size_t>(i)].torque_limit_at(rates[i]), now.torque_limit[i]);
    return now;
  }
};

}  // namespace passive_haptics
