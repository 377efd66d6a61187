/// @file
/// Two questions about a desired force: is it passive, and can it be displayed?
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>

#include <string_view>

namespace passive_haptics {

/// Where the desired force lies by power (section 2).
enum class power_class {
  none,       ///< No force is desired.
  active,     ///< Fd . v > 0: only a motor could do it.
  passive_1,  ///< Every brake alone is passive: s_i td_i <= 0, for n > d by the settled signs.
  passive_2,  ///< Passive in total, but some brake would have to drive.
};

/// How the desired force is displayed. An outward-moving contact can be active and yet be displayed
/// approximately: direct control lives there.
enum class display_class {
  none,         ///< No producible force has a component along the desired one.
  approximate,  ///< The nearest producible force, scaled so that its component along Fd is |Fd|.
  exact,        ///< Fd itself.
};

/// The class in words.
constexpr std::string_view to_string(power_class c) {
  switch (c) {
    case power_class::none: return "none";
    case power_class::active: return "active";
    case power_class::passive_1: return "passive I";
    case power_class::passive_2: return "passive II";
  }
  return "unknown power class";
}

/// The class in words.
constexpr std::string_view to_string(display_class c) {
  switch (c) {
    case display_class::none: return "none";
    case display_class::approximate: return "approximate";
    case display_class::exact: return "exact";
  }
  return "unknown display class";
}

/// True where some force is displayed.
constexpr bool is_displayed(display_class c) {
  return c == display_class::exact || c == display_class::approximate;
}

/// True if every brake alone can produce its part: s_i t_i <= 0 for torques t = E^T F. Then F is in the cone.
template <class T, int Brakes>
bool producible(const vector<T, Brakes>& s, const vector<T, Brakes>& t) {
  bool all = true;
  unrolled<Brakes>([&](auto i) { all &= s[i] * t[i] <= T(0); });
  return all;
}

/// Power [W] that torques t [N m] give to axes with rates w [rad/s]: the sum of t_i w_i. By virtual work it
/// is F . v of the force that they make.
/// @equation{1}
template <class T, int N>
T mechanical_power(const vector<T, N>& t, const vector<T, N>& w) {
  return t.dot(w);
}

/// Power class from the power of the desired force, of which the sign matters, and whether every brake alone
/// is passive.
template <class T>
power_class classify_power(T power, bool producible_alone) {
  return select(power > T(0), power_class::active,
                select(producible_alone, power_class::passive_1, power_class::passive_2));
}

}  // namespace passive_haptics
