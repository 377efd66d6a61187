/// Parameter tables: each struct describes its members once, and checks, texts and files follow from it.
#pragma once

#include <passive_haptics/core/error_message.hpp>
#include <passive_haptics/core/range.hpp>
#include <passive_haptics/core/text.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace passive_haptics {

/// Type-independent description of a member.
struct member_description {
  const char* name;                        ///< Name as in the code.
  const char* unit;                        ///< "m", "1" for a ratio, "" if there is none.
  range hard;                              ///< A value outside this range is an error.
  const char* choices = "";                ///< Names of an enumeration's values, from 0: "left, right".
  double min_magnitude = 0;                ///< Smaller magnitudes, except 0, are suspicious.
  double max_magnitude = range::infinity;  ///< Greater magnitudes are suspicious; see plausible_magnitude().
  const char* at_zero = "";                ///< Effect of a value of 0, for remarks(): "the brake is off".
};

/// A member of P. For a vector or array, the ranges apply to each element.
template <class P, class V>
struct member : member_description {
  V P::* pointer;  ///< Pointer to the member.

  /// Name, unit and range. Without a range every number is valid.
  constexpr member(const char* called, V P::* where, const char* in = "",
                   const range& within = range::anything)
      : member_description{called, in, within}, pointer(where) {}

  /// Returns a copy for which larger magnitudes require confirmation by the user.
  constexpr member suspicious_above(double magnitude) const {
    member same = *this;
    same.max_magnitude = magnitude;
    return same;
  }
  /// Returns a copy for which smaller magnitudes, except 0, require confirmation by the user.
  constexpr member suspicious_below(double magnitude) const {
    member same = *this;
    same.min_magnitude = magnitude;
    return same;
  }
  /// Returns a copy that gets a remark with this effect if its value is 0.
  constexpr member remark_at_zero(const char* effect) const {
    member same = *this;
    same.at_zero = effect;
    return same;
  }
};

/// A member of enumeration type, with the names of its values.
template <class P, class V>
constexpr member<P, V> choice(const char* called, V P::* where, const char* among) {
  member<P, V> m(called, where);
  m.choices = among;
  return m;
}

namespace detail {

template <std::size_t Index, class Member>
struct listed_member {
  Member value;
};
template <class Numbers, class... Members>
struct member_list;
template <std::size_t... Index, class... Members>
struct member_list<std::index_sequence<Index...>, Members...> : listed_member<Index, Members>... {
  template <class F>
  constexpr void operator()(F&& f) const {
    (f(this->listed_member<Index, Members>::value), ...);
  }
};

}  // namespace detail

/// Returns the table of a parameter struct, for its
///
///     static constexpr auto members() { using p = ...; return member_table(member("mass", &p::mass, "kg",
///     ...), ...); }
///
/// A member may be a number, a vector or matrix, an array, another such struct, an enumeration, a bool or a
/// std::string. Conditions that no range can express, such as a sum, are checked in `error_message rules()
/// const`, which may assume that the members are valid. With `static constexpr const char* type_name = "a
/// ball"`, errors report the type of the struct.
template <class... Members>
constexpr auto member_table(const Members&... members) {
  // A Hana tuple is slower to compile; for a closure, g++ and clang++ use different layouts
  return detail::member_list<std::index_sequence_for<Members...>, Members...>{{members}...};
}

/// A parameter struct with a table `members()`.
template <class P>
concept Parameters = requires { P::members(); };

/// Its table.
template <Parameters P>
inline constexpr auto members_of = P::members();

/// Calls f(member, value) for each member, in the order of the table.
template <class P, class F>
  requires Parameters<std::remove_const_t<P>>
constexpr void for_each_member(P& p, F&& f) {
  members_of<std::remove_const_t<P>>([&](const auto& m) { f(m, p.*m.pointer); });
}

namespace detail {

// Path of a value: "brakes[1].table[2].current of a curve".
struct place {
  const place* outer = nullptr;
  const char* name = "";
  const char* type_name = "";
  int row = -1, column = -1;  // in a vector or matrix

  std::string text() const {
    std::string all = outer == nullptr ? "" : outer->text();
    if (!all.empty() && *name != '\0') all.append(".");
    all.append(name);
    if (row < 0) return all;
    if (column < 0) return indexed(all.append("["), row, "]");
    return indexed(indexed(all.append("("), row, ", "), column, ")");
  }
  // With bars around a length, the type of its struct and the unit.
  std::string text(const char* unit, const char* bars = "") const {
    std::string all = std::string(bars).append(text()).append(bars);
    if (*type_name != '\0') all.append(" of ").append(type_name);
    if (*unit != '\0') all.append(" [").append(unit).append("]");
    return all;
  }
};

template <class P>
constexpr const char* owner_of() {
  if constexpr (requires { P::type_name; }) return P::type_name;
  else return "";
}

// Does not overflow or underflow before the length does.
template <class Vector>
auto length_of(const Vector& direction) {
  std::remove_cvref_t<decltype(direction[0])> length = 0;
  for (const auto x : direction) length = std::hypot(length, x);
  return length;
}

// Calls to.value(member, place, x) for each number, bool, enumeration or text. If the visitor has them, also
// calls to.length() with the length of a direction, and to.whole(place, p) after all members of a struct.
template <Parameters P, class Visitor>
void visit(const P& p, const place* at, Visitor& to);

template <class V, class Visitor>
void visit_member(const member_description& about, place at, const V& value, Visitor& to) {
  if constexpr (Parameters<V>) {
    visit(value, &at, to);
  } else if constexpr (requires { requires V::ColsAtCompileTime != 1; }) {
    for (at.row = 0; at.row < static_cast<int>(value.rows()); ++at.row)
      for (at.column = 0; at.column < static_cast<int>(value.cols()); ++at.column)
        to.value(about, at, value(at.row, at.column));
  } else if constexpr (requires { value.begin(); } && !requires { value.c_str(); }) {
    at.row = 0;
    for (const auto& element : value) {
      if constexpr (requires { element.size(); })
        visit_member(about, place{&at, "", at.type_name}, element, to);
      else visit_member(about, at, element, to);
      ++at.row;
    }
    if constexpr (requires { to.length(about, at, typename V::value_type()); })
      if (about.hard.is_direction) to.length(about, place{at.outer, at.name, at.type_name}, length_of(value));
  } else {
    to.value(about, at, value);
  }
}

template <Parameters P, class Visitor>
void visit(const P& p, const place* at, Visitor& to) {
  for_each_member(p, [&](const member_description& about, const auto& value) {
    visit_member(about, place{at, about.name, owner_of<P>()}, value, to);
  });
  if constexpr (requires { to.whole(at, p); }) to.whole(at, p);
}

// Range check without texts, for a control cycle.
struct range_check {
  bool valid = true;

  template <class T>
  void value(const member_description& about, const place&, const T& x) {
    if constexpr (std::is_arithmetic_v<T>)
      valid = valid && (about.hard.is_direction || about.hard.contains(x));
  }
  template <std::floating_point T>
  void length(const member_description& about, const place&, const T& x) {
    valid = valid && about.hard.contains(x);
  }
};

struct checker {
  error_message error = {};

  template <class T>
  void value(const member_description& about, const place& at, const T& x) {
    if constexpr (std::is_arithmetic_v<T>) {
      if (!error.empty() || about.hard.is_direction || about.hard.contains(x)) return;
      error = error_of(about.name, [&] {
        return error_text(at.text(about.unit), x, to_text(about.hard, std::is_integral_v<T>));
      });
    }
  }
  template <std::floating_point T>
  void length(const member_description& about, const place& at, const T& x) {
    if (!error.empty() || about.hard.contains(x)) return;
    error = error_of(about.name, [&] { return error_text(at.text("", "|"), x, to_text(about.hard)); });
  }
  template <class P>
    requires requires(const P& p) { p.rules(); }
  void whole(const place* at, const P& p) {
    if (!error.empty()) return;
    error = p.rules();
    if (!error.empty() && at != nullptr)
      error = error_of(error, [&] { return at->text().append(".").append(error); });
  }
};

}  // namespace detail

/// True if each parameter is in its range: validate() without rules(). Does not allocate or throw.
template <Parameters P>
bool is_in_range(const P& p) {
  detail::range_check check;
  detail::visit(p, nullptr, check);
  return check.valid;
}

/// Returns the first error, "length_1 [m] = -1: expected a finite number > 0", or an empty one.
template <Parameters P>
error_message validate(const P& p) {
  detail::checker check;
  detail::visit(p, nullptr, check);
  return check.error;
}

/// Returns the error of a number, vector, matrix or array, or an empty one. type_name: the type in the text.
template <class V>
error_message check_value(const char* name, const V& value, const char* unit, const range& hard,
                          const char* type_name = "") {
  detail::checker check;
  detail::visit_member(member_description{name, unit, hard},
                       detail::place{.name = name, .type_name = type_name}, value, check);
  return check.error;
}

/// Returns the parameters if they are valid; otherwise see require_no_error().
template <class P>
const P& require_valid(const P& parameters) {
  require_no_error(validate(parameters));
  return parameters;
}

}  // namespace passive_haptics
