/// Range check of a force sensor.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/fault.hpp>
#include <passive_haptics/driver/port.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Limits of a force sensor with N channels.
template <int N>
struct sensor_limits {
  /// Saturation at +-range, in the unit of the sensor [N or N m]; infinite: never.
  std::array<double, static_cast<std::size_t>(N)> range =
      same_for_each<N>(std::numeric_limits<double>::infinity());

  static constexpr auto members() {
    using p = sensor_limits;
    return member_table(
        member("range", &p::range, "", passive_haptics::range{.lower = 0, .open_above = false}));
  }
};

/// Checks the values of good samples.
template <int N>
class sensor_check {
 public:
  /// Throws std::invalid_argument with the text of validate(limits).
  explicit sensor_check(const sensor_limits<N>& limits) : limits_(require_valid(limits)) {}

  /// Returns sensor_saturated, or none.
  fault_record operator()(const port_sample<N>& sample) const noexcept {
    for (std::size_t i = 0; i < limits_.range.size(); ++i)
      if (!(std::abs(sample.value[i]) < limits_.range[i]))
        return {fault::sensor_saturated, fault_source::force_sensor, static_cast<int>(i)};
    return {};
  }

 private:
  sensor_limits<N> limits_;
};

}  // namespace passive_haptics
