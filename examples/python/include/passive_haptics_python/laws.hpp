/// @file
/// Control laws in Python.
#pragma once

#include <passive_haptics_python/values.hpp>

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>

#include <utility>

namespace passive_haptics_python {

/// The base class of all laws.
struct law {
  /// As of a base class.
  virtual ~law() = default;
};

/// A law without parameters.
template <class L>
struct no_law_parameters {
  /// The table.
  static constexpr auto members() { return ph::member_table(); }
};

namespace detail {

// The struct with a law's table: the law itself, its member, or none.
template <class L>
auto law_table() {
  if constexpr (ph::Parameters<L>) return L();
  else if constexpr (requires(const L l) { l.parameters(); }) return L().parameters();
  else if constexpr (requires(const L l) { l.parameters; }) return L().parameters;
  else return no_law_parameters<L>();
}

}  // namespace detail

/// The struct with the table of law L.
template <class L>
using law_parameters = decltype(detail::law_table<L>());

/// Law L as Python has it.
template <class L>
using law_value = table_value<law, law_parameters<L>>;

/// The law of these parameters.
template <class L>
L made_law(const law_parameters<L>& p) {
  if constexpr (ph::Parameters<L>) return p;
  else if constexpr (std::is_same_v<law_parameters<L>, no_law_parameters<L>>) return L();
  else if constexpr (std::is_constructible_v<L, const law_parameters<L>&>) return L(p);
  else {
    L made;
    made.parameters = p;
    return made;
  }
}

/// Some laws.
template <class... L>
struct law_list {};

/// What recommended_law returns for a mechanism with a force sensor.
template <class M>
using recommended_law_of =
    decltype(ph::recommended_law(std::declval<const M&>(), std::declval<const ph::brakes_of<M>&>()));

/// The laws of a mechanism that names no others: the paper's, its saturated form and the recommended one.
template <class M>
using usual_laws = law_list<ph::direct_control, ph::saturated_direct_control, recommended_law_of<M>>;

}  // namespace passive_haptics_python
