/// Brakes of a device of any size.
#pragma once

#include <passive_haptics/brake/models/switchable_brakes.hpp>

#include <algorithm>
#include <vector>

namespace passive_haptics::runtime {

/// switchable_brake_parameters for any number of brakes, with equal members.
struct brake_numbers {
  std::vector<double> torque_limit;      ///< m [N m], as there.
  std::vector<double> torque_lower;      ///< m [N m], as there.
  std::vector<double> torque_upper;      ///< m [N m], as there.
  std::vector<double> rate_dead_band;    ///< m [rad/s], as there.
  std::vector<double> torque_dead_band;  ///< m [N m], as there.
  std::vector<double> time_constant;     ///< m [s], as there.

  /// `count` brakes with default values, all on.
  explicit brake_numbers(int count = 0) {
    const switchable_brake_parameters<double, 1> usual;
    for_each([&](auto here, auto there) {
      (this->*here).assign(static_cast<std::size_t>(count), (usual.*there)[0]);
    });
  }

  static constexpr auto members() {
    using p = brake_numbers;
    return member_table(
        member("torque_limit", &p::torque_limit, "N m", range::not_negative)
            .remark_at_zero("the brake is off"),
        member("torque_lower", &p::torque_lower, "N m", lower_torques),
        member("torque_upper", &p::torque_upper, "N m", upper_torques),
        member("rate_dead_band", &p::rate_dead_band, "rad/s", range::not_negative),
        member("torque_dead_band", &p::torque_dead_band, "N m", range::not_negative),
        member("time_constant", &p::time_constant, "s", range::not_negative).suspicious_above(1));
  }

  /// True if all brakes work both ways.
  bool has_no_bounds() const {
    constexpr double unbounded = switchable_brake_parameters<double, 1>::unbounded;
    const auto are_all = [](const std::vector<double>& bounds, double x) {
      return std::count(bounds.begin(), bounds.end(), x) == std::ssize(bounds);
    };
    return are_all(torque_lower, -unbounded) && are_all(torque_upper, unbounded);
  }

  /// As brakes of type B with m brakes: switchable, or brake_parameters without bounds.
  template <class B>
  B as() const {
    B b;
    b.torque_limit = decltype(b.torque_limit)(torque_limit.data());
    b.rate_dead_band = decltype(b.torque_limit)(rate_dead_band.data());
    b.torque_dead_band = decltype(b.torque_limit)(torque_dead_band.data());
    b.time_constant = decltype(b.torque_limit)(time_constant.data());
    if constexpr (requires { b.torque_lower; }) {
      b.torque_lower = decltype(b.torque_limit)(torque_lower.data());
      b.torque_upper = decltype(b.torque_limit)(torque_upper.data());
    }
    return b;
  }

 private:
  template <class F>
  static void for_each(F f) {
    using here = brake_numbers;
    using there = switchable_brake_parameters<double, 1>;
    f(&here::torque_limit, &there::torque_limit);
    f(&here::torque_lower, &there::torque_lower);
    f(&here::torque_upper, &there::torque_upper);
    f(&here::rate_dead_band, &there::rate_dead_band);
    f(&here::torque_dead_band, &there::torque_dead_band);
    f(&here::time_constant, &there::time_constant);
  }
};

}  // namespace passive_haptics::runtime
