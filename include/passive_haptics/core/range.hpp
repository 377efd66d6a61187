/// Valid range of a parameter.
#pragma once

#include <passive_haptics/core/text.hpp>

#include <limits>
#include <string>
#include <type_traits>

namespace passive_haptics {

/// An interval in the unit of a parameter. An open end at infinity means that the number must be finite.
struct range {
  static constexpr double infinity = std::numeric_limits<double>::infinity();  ///< Infinity, for no bound.

  double lower = -infinity;   ///< Lower end.
  double upper = infinity;    ///< Upper end.
  bool open_below = true;     ///< True if `lower` is excluded.
  bool open_above = true;     ///< True if `upper` is excluded.
  bool is_checked = true;     ///< If false, every value is valid, including NaN.
  bool is_direction = false;  ///< The range applies to the length of a vector.
  const char* words = "";     ///< Text for messages; generated if empty.

  static const range anything;      ///< No restriction.
  static const range finite;        ///< Any finite number.
  static const range positive;      ///< Finite and > 0.
  static const range not_negative;  ///< Finite and >= 0.
  static const range direction;     ///< For a vector: finite and not zero.

  /// The closed interval.
  static constexpr range between(double lower, double upper) { return {lower, upper, false, false}; }
  /// Finite numbers that are not smaller than this.
  static constexpr range at_least(double lower) { return {lower, infinity, false, true}; }

  /// Returns a copy with this text for messages.
  constexpr range as(const char* expected) const {
    range same = *this;
    same.words = expected;
    return same;
  }

  /// True if x is in the range; false for NaN.
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

/// Text of the range: "a finite number > 0", "a whole number >= 1", "0.004 to 10".
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
