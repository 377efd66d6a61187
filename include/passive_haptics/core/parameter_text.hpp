/// Text of parameters, remarks on unusual values, and detection of implausible ones.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace passive_haptics {

/// Names of an enumeration's values in order; empty for other members.
inline std::vector<std::string_view> choices_of(const member_description& member) {
  constexpr std::string_view comma = ", ";
  std::vector<std::string_view> all;
  for (std::string_view rest = member.choices; !rest.empty();) {
    const std::size_t end = rest.find(comma);
    all.push_back(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + comma.size());
  }
  return all;
}

/// Usual range of values in this unit for a desktop device, with the likely mistake.
constexpr range usual_range(std::string_view unit) {
  constexpr double farthest = 5, two_turns = 4 * std::numbers::pi;  // [m], [rad]
  if (unit == "m") return range::between(-farthest, farthest).as("within 5 m: millimetres?");
  if (unit == "N/m") return range::between(100, 1e9).as("100 to 1e9: N/mm?");
  if (unit == "rad") return range::between(-two_turns, two_turns).as("within two turns: degrees?");
  return range::anything;
}

/// Plausible magnitudes of a member, from its table, or from its unit if the table has no bound. Units give
/// no lower bound for members that may be negative, such as vector components near 0.
constexpr range plausible_magnitude(const member_description& member) {
  struct magnitudes {
    std::string_view unit;
    double min, max;
  };
  constexpr magnitudes of_units[] = {{"m", 1e-9, 100},   {"rad", 0, 2 * std::numbers::pi},
                                     {"kg", 1e-9, 1000}, {"kg m^2", 1e-15, 1000},
                                     {"s", 1e-9, 3600},  {"m/s", 1e-9, 100},
                                     {"rad/s", 0, 1e4},  {"m/s^2", 1e-9, 100},
                                     {"N", 1e-9, 1e6},   {"N m", 1e-12, 1e4},
                                     {"A", 1e-6, 1000},  {"A/s", 1e-6, 1e6},
                                     {"N/m", 1e-6, 1e15}};
  range plausible = range::between(member.min_magnitude, member.max_magnitude);
  for (const magnitudes& of : of_units) {
    if (of.unit != member.unit) continue;
    if (member.min_magnitude == 0 && member.hard.lower >= 0 && !member.hard.is_direction)
      plausible.lower = of.min;
    if (member.max_magnitude == range::infinity) plausible.upper = of.max;
  }
  return plausible;
}

namespace detail {

// "; this looks like degrees: in radians it is 1.5708" for angles, else empty.
template <class T>
std::string in_radians(const member_description& about, T x) {
  if (std::string_view(about.unit) != "rad") return "";
  return indexed("; this looks like degrees: in radians it is ",
                 static_cast<double>(x) * (std::numbers::pi / 180), "");
}

// A line about an unusual value. A value of 0 gets none because it is the same in every unit.
template <class T>
std::string remark_on(std::string what, std::string_view unit, T x) {
  const range usual = usual_range(unit);
  if (x == T(0) || !range::finite.contains(x) || usual.contains(x)) return "";
  return what.append(" = ").append(value_text(x)).append(", usually ").append(to_text(usual)).append("\n");
}

template <class T>
std::string text_of(const member_description& about, const T& value) {
  if constexpr (std::is_enum_v<T>) return std::string(choices_of(about).at(static_cast<std::size_t>(value)));
  else if constexpr (std::is_arithmetic_v<T>) return value_text(value);
  else return std::string("\"").append(value).append("\"");
}

template <class F>
struct value_visitor {
  F value;  // receives (member, name and unit, x)
};

// Calls f(member, name and unit, x) for each scalar.
template <Parameters P, class F>
void for_each_value(const P& p, F f) {
  const auto named = [&](const member_description& about, const place& at, const auto& x) {
    f(about, at.text(about.unit), x);
  };
  value_visitor<decltype(named)> visitor{named};
  visit(p, nullptr, visitor);
}

}  // namespace detail

/// Calls f(member, text) for each value outside plausible_magnitude(), with a text such as "largest[0] [A] =
/// 1e9: expected at most 1000". Skips 0 and infinities within the member's range. Users may confirm them.
template <Parameters P, class F>
void for_each_suspicious(const P& p, F&& f) {
  detail::for_each_value(
      p, [&]<class T>(const member_description& about, const std::string& name, const T& x) {
        if constexpr (std::is_arithmetic_v<T>) {
          const range plausible = plausible_magnitude(about);
          const double size = std::abs(static_cast<double>(x));
          if (size == 0 || (std::isinf(size) && about.hard.contains(x))) return;
          if (size < plausible.lower)
            f(about, detail::error_text(name, x, "at least " + detail::number_text(plausible.lower)));
          if (size > plausible.upper)
            f(about,
              detail::error_text(
                  name, x, "at most " + detail::number_text(plausible.upper) + detail::in_radians(about, x)));
        }
      });
}

/// One line per value, with six digits: "length_1 [m] = 0.15".
template <Parameters P>
std::string to_text(const P& p) {
  std::string text;
  detail::for_each_value(p, [&](const member_description& about, const std::string& name, const auto& x) {
    text.append(name).append(" = ").append(detail::text_of(about, x)).append("\n");
  });
  return text;
}

/// One line per value that may have been meant in another unit, "length_1 [m] = 150, usually within 5 m:
/// millimetres?", and per 0 with an effect, "torque_limit[1] [N m] = 0: the brake is off". Each line starts
/// with `part`. Remarks are not errors; see usual_range().
template <Parameters P>
std::string remarks(const P& p, const std::string& part = "") {
  std::string text;
  const auto add = [&]<class T>(const member_description& about, const std::string& name, const T& x) {
    if constexpr (std::is_arithmetic_v<T>) {
      text.append(detail::remark_on(part + name, about.unit, x));
      if (x == T(0) && *about.at_zero != '\0')
        text.append(part).append(name).append(" = 0: ").append(about.at_zero).append("\n");
    }
  };
  detail::for_each_value(p, add);
  return text;
}

}  // namespace passive_haptics
