/// Torque of a brake over its current.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace passive_haptics {

/// A measured point of a brake.
struct current_torque {
  double current = 0;  ///< [A]
  double torque = 0;   ///< [N m]; [N] for a sliding brake.
};

/// Torque of one brake for rising current, measured cold,
///
///     torque = residual_torque + torque_per_ampere current,   or a table with linear interpolation,
///
/// and its corrections. Read N instead of N m for sliding brakes. The defaults are placeholders.
struct brake_curve {
  static constexpr int max_points = 16;  ///< Of a table.

  double residual_torque = 0;    ///< Torque without current [N m].
  double torque_per_ampere = 1;  ///< Slope of the straight line [N m/A]; 1 with a table.
  double current_limit = 1;      ///< Maximum current [A].
  /// Replaces the line if points > 0: both values increase, from 0 A and residual_torque. Unused entries are
  /// 0.
  std::array<current_torque, static_cast<std::size_t>(max_points)> table{};
  int points = 0;         ///< 0 for the straight line, else 2 to max_points.
  double hysteresis = 0;  ///< Distance between falling and rising branch, remanence [N m].
  /// Share of the torque, without the residual torque, lost per kelvin above the reference [1/K].
  double loss_per_kelvin = 0;
  double reference_temperature = 293.15;  ///< Of the measured curve, lowest of the device [K].
  double max_temperature = 353.15;        ///< Higher readings are limited to this [K].

  static constexpr auto members() {
    using p = brake_curve;
    return member_table(
        member("residual_torque", &p::residual_torque, "N m", range::not_negative),
        member("torque_per_ampere", &p::torque_per_ampere, "N m/A", range::positive)
            .suspicious_below(1e-6)
            .suspicious_above(1e4),
        member("current_limit", &p::current_limit, "A", range::positive),
        member("points", &p::points, "",
               range::between(0, max_points).as("0 for a straight line, or 2 to 16")),
        member("hysteresis", &p::hysteresis, "N m", range::not_negative),
        member("loss_per_kelvin", &p::loss_per_kelvin, "1/K", range::not_negative).suspicious_above(0.1),
        member("reference_temperature", &p::reference_temperature, "K", range::positive)
            .suspicious_above(1000),
        member("max_temperature", &p::max_temperature, "K", range::positive).suspicious_above(1000));
  }
  /// Requires an increasing table without unused entries, and some torque at max_temperature.
  std::string rules() const;
};

namespace detail {

// Rejects values that would be ignored: entries beyond `points`, and a slope with a table
inline std::string check_brake_points(const brake_curve& p) {
  int given = brake_curve::max_points;
  for (; given > p.points; --given) {
    const current_torque& last = nth(p.table, given - 1);
    if (last.current != 0 || last.torque != 0) break;
  }
  if (given > p.points)
    return error_text("points", p.points,
                      indexed(indexed("", given, ", as the last entry of the table that is not 0 is table["),
                              given - 1, "]; set points, or set the unused entries to 0"));
  if (p.points == 0 || p.torque_per_ampere == brake_curve().torque_per_ampere) return {};
  return error_text("torque_per_ampere [N m/A]", p.torque_per_ampere,
                    "its default, 1, as the table is used instead; remove one of the two");
}

inline std::string check_brake_table(const brake_curve& p) {
  const auto named = [](int i, const char* member) { return indexed("table[", i, "]").append(member); };
  if (p.points == 1) return error_text("points", p.points, "0 for a straight line, or 2 to 16");
  if (std::string text = check_brake_points(p); !text.empty() || p.points == 0) return text;
  for (int i = 0; i < p.points; ++i) {
    const current_torque at = nth(p.table, i);
    std::string text = first_error(check_value(named(i, ".current").c_str(), at.current, "A", range::finite),
                                   check_value(named(i, ".torque").c_str(), at.torque, "N m", range::finite));
    if (!text.empty()) return text;
    if (i == 0) continue;
    const current_torque before = nth(p.table, i - 1);
    if (!(at.current > before.current))
      return error_text(named(i, ".current [A]"), at.current, "more than in the point before it");
    if (!(at.torque > before.torque))
      return error_text(named(i, ".torque [N m]"), at.torque, "more than in the point before it");
  }
  const double last = nth(p.table, p.points - 1).current;
  if (p.table[0].current != 0) return error_text("table[0].current [A]", p.table[0].current, "0");
  if (p.table[0].torque != p.residual_torque)
    return error_text("table[0].torque [N m]", p.table[0].torque, "the residual_torque");
  if (p.current_limit > last)
    return error_text("current_limit [A]", p.current_limit, "at most the last current of the table");
  return {};
}

// Remaining share of the torque; 1 if the temperature is unknown
inline double hot_share(const brake_curve& p, double temperature) noexcept {
  if (!std::isfinite(temperature)) return 1;
  const double above = std::min(temperature, p.max_temperature) - p.reference_temperature;
  return 1 - p.loss_per_kelvin * std::max(above, 0.0);
}

// Interpolates on the first piece of the table with an upper end From >= value, or the last one
template <double current_torque::* From, double current_torque::* To>
double on_table(const brake_curve& p, double value) noexcept {
  std::size_t i = 1;
  while (i + 1 < static_cast<std::size_t>(p.points) && p.table[i].*From < value) ++i;
  const current_torque &low = p.table[i - 1], &high = p.table[i];
  return low.*To + (value - low.*From) * ((high.*To - low.*To) / (high.*From - low.*From));
}

}  // namespace detail

inline std::string brake_curve::rules() const {
  if (std::string text = detail::check_brake_table(*this); !text.empty()) return text;
  if (max_temperature < reference_temperature)
    return detail::error_text("max_temperature [K]", max_temperature, "at least reference_temperature");
  if (detail::hot_share(*this, max_temperature) > 0) return {};
  return detail::error_text("loss_per_kelvin [1/K]", loss_per_kelvin,
                            "less than 1 / (max_temperature - reference_temperature)");
}

/// Temperature of a brake without a sensor [K].
inline constexpr double unknown_temperature = std::numeric_limits<double>::quiet_NaN();

/// Torque [N m] of a current [A] on the rising branch. Low or unknown temperatures [K] count as the
/// reference.
inline double torque_of_current(const brake_curve& p, double current,
                                double temperature = unknown_temperature) noexcept {
  double made = p.torque_per_ampere * current;
  if (p.points > 0)
    made =
        detail::on_table<&current_torque::current, &current_torque::torque>(p, current) - p.residual_torque;
  return p.residual_torque + detail::hot_share(p, temperature) * made;
}

/// Current [A] in [0, current_limit] for a torque [N m] on the rising branch; 0 up to the residual torque and
/// for NaN. Unknown temperatures count as the reference, the coldest: the torque then never exceeds the
/// command.
inline double current_of_torque(const brake_curve& p, double torque,
                                double temperature = unknown_temperature) noexcept {
  if (!(torque > p.residual_torque)) return 0;
  const double made = (torque - p.residual_torque) / detail::hot_share(p, temperature);
  double current = made / p.torque_per_ampere;
  if (p.points > 0)
    current =
        detail::on_table<&current_torque::torque, &current_torque::current>(p, p.residual_torque + made);
  return std::clamp(current, 0.0, p.current_limit);
}

}  // namespace passive_haptics
