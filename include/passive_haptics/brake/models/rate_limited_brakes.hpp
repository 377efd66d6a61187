/// Brakes with rate-dependent torque limits, for a control cycle.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/core/nth.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace passive_haptics {

/// Brakes of mechanism M, limited to their torque_limit and to the torque_limit_at of their models;
/// eddy-current brakes, for example, produce no torque at rest. For a controller or a step; laws see
/// switchable_brakes<M> with the current limits. A brake with a limit of 0 is off in that cycle.
template <class M, BrakeModel Model>
class rate_limited_brakes : switchable_brakes<M> {
  using base = switchable_brakes<M>;
  static_assert(std::is_same_v<typename Model::scalar, typename M::scalar>,
                "passive_haptics: a brake model must have the mechanism's scalar.");

 public:
  /// As in switchable_brakes.
  /// @{
  using base::rate_dead_band;
  using base::time_constant;
  using base::torque_dead_band;
  using base::torque_limit;
  using base::torque_lower;
  using base::torque_upper;

  using base::make_negative;
  using base::make_positive;
  using base::switch_off;
  using base::switch_on;
  /// @}

  std::array<Model, std::size_t(M::brake_count)> models = {};  ///< One model per brake.

  rate_limited_brakes() = default;                                   ///< Default brakes and models.
  rate_limited_brakes(const brakes_of<M>& brakes) : base(brakes) {}  ///< These brakes, with default models.
  /// These brakes, some of which may be off, with default models.
  rate_limited_brakes(const base& brakes) : base(brakes) {}
  /// These brakes with these models. Throws std::invalid_argument if a parameter of a model is invalid.
  rate_limited_brakes(const base& brakes, const decltype(models)& each) : base(brakes), models(each) {
    if constexpr (Parameters<Model>) require_no_error(check_value("models", each, "", range::anything));
  }

  /// The brakes at these rates [rad/s or m/s]. Limits that are negative or not finite become 0.
  switchable_brakes<M> at(const brake_vector<M>& rates) const noexcept {
    base now = *this;
    for (int i = 0; i < M::brake_count; ++i)
      now.torque_limit[i] = valid_command(nth(models, i).torque_limit_at(rates[i]), now.torque_limit[i]);
    return now;
  }
};

}  // namespace passive_haptics
