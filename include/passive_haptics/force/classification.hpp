/// Power class and display class of a desired force.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>

#include <string_view>

namespace passive_haptics {

/// Power class of the desired force (section 2).
enum class power_class {
  none,       ///< No desired force.
  active,     ///< Fd . v > 0: requires a motor.
  passive_1,  ///< Each brake is passive: s_i td_i <= 0, for n > d by the settled signs.
  passive_2,  ///< Passive in total, but some brake would have to drive.
};

/// How the desired force is displayed. An active force at an outward-moving contact may still be displayed
/// approximately; direct control relies on this.
enum class display_class {
  none,         ///< No producible force has a component along the desired one.
  approximate,  ///< The nearest producible force, scaled so that its component along Fd is |Fd|.
  exact,        ///< Fd itself.
};

/// Text of the class.
constexpr std::string_view to_string(power_class c) {
  switch (c) {
    case power_class::none: return "none";
    case power_class::active: return "active";
    case power_class::passive_1: return "passive I";
    case power_class::passive_2: return "passive II";
  }
  return "unknown power class";
}

/// Text of the class.
constexpr std::string_view to_string(display_class c) {
  switch (c) {
    case display_class::none: return "none";
    case display_class::approximate: return "approximate";
    case display_class::exact: return "exact";
  }
  return "unknown display class";
}

/// True if a force is displayed.
constexpr bool is_displayed(display_class c) {
  return c == display_class::exact || c == display_class::approximate;
}

/// True if each brake can produce its torque: s_i t_i <= 0 for t = E^T F. F is then in the cone.
template <class T, int Brakes>
bool producible(const vector<T, Brakes>& s, const vector<T, Brakes>& t) {
  bool all = true;
  unrolled<Brakes>([&](auto i) { all &= s[i] * t[i] <= T(0); });
  return all;
}

/// Power [W] of torques t [N m] at rates w [rad/s]: the sum of t_i w_i. By virtual work it equals F . v.
/// @equation{1}
template <class T, int N>
T mechanical_power(const vector<T, N>& t, const vector<T, N>& w) {
  return t.dot(w);
}

/// Power class from the power of the desired force and whether each brake is passive.
template <class T>
power_class classify_power(T power, bool producible_alone) {
  return select(power > T(0), power_class::active,
                select(producible_alone, power_class::passive_1, power_class::passive_2));
}

}  // namespace passive_haptics
