/// @file
/// Where the value of a parameter may lie.
#pragma once

#include <passive_haptics/core/text.hpp>

#include <limits>
#include <string>
#include <type_traits>

namespace passive_haptics {

/// An interval of numbers in a parameter's unit. An open end at infinity means that the number is finite.
struct range {
  static constexpr double infinity = std::numeric_limits<double>::infinity();  ///< No end.

  double lower = -infinity;   ///< The lower end.
  double upper = infinity;    ///< The upper end.
  bool open_below = true;     ///< Whether the lower end itself is outside.
  bool open_above = true;     ///< Whether the upper end itself is outside.
  bool is_checked = true;     ///< False: everything is inside, a NaN, too.
  bool is_direction = false;  ///< It is the length of a vector that lies inside.
  const char* words = "";     ///< What is expected, where the ends do not say it best.

  static const range anything;      ///< Of which nothing is said.
  static const range finite;        ///< Any finite number.
  static const range positive;      ///< Finite and > 0.
  static const range not_negative;  ///< Finite and >= 0.
  static const range direction;     ///< Of a vector: finite and not zero.

  /// Lower and upper end are inside.
  static constexpr range between(double lower, double upper) { return {lower, upper, false, false}; }
  /// Finite and no less than this.
  static constexpr range at_least(double lower) { return {lower, infinity, false, true}; }

  /// The range, described by these words in messages.
  constexpr range as(const char* expected) const {
    range same = *this;
    same.words = expected;
    return same;
  }

  /// Whether a number lies inside; a NaN lies nowhere.
  template <class T>
  constexpr bool contains(T x) const {
    using bound = std::conditional_t<std::is_floating_point_v<T>, T, double>;
    if (!is_checked) return true;
    const auto value = static_cast<bound>(x), least = static_cast<bound>(lower),
               highest = static_cast<bound>(upper);
    return (open_below ? value > least : value >= least) && (open_above ? value < highest : value <= highest);
  }
};

inline constexpr range range::anything{.is_checked = false};
inline constexpr range range::finite{};
inline constexpr range range::positive{.lower = 0};
inline constexpr range range::not_negative{.lower = 0, .open_below = false};
inline constexpr range range::direction{.lower = 0, .is_direction = true, .words = "a direction"};

/// What is expected: "a finite number > 0", "a whole number >= 1", "0.004 to 10".
inline std::string to_text(const range& r, bool whole_numbers = false) {
  using detail::number_text;
  if (*r.words != '\0') return r.words;
  if (!r.is_checked) return "anything";
  const bool from = r.lower > -range::infinity, to = r.upper < range::infinity;
  if (from && to && !r.open_below && !r.open_above)
    return number_text(r.lower).append(" to ").append(number_text(r.upper));
  std::string text = whole_numbers ? "a whole number" : r.open_above || to ? "a finite number" : "a number";
  if (from) text.append(r.open_below ? " > " : " >= ").append(number_text(r.lower));
  if (to) text.append(from ? " and" : "").append(r.open_above ? " < " : " <= ").append(number_text(r.upper));
  if (!to && !r.open_above) text.append(", or inf");
  return text;
}

}  // namespace passive_haptics
