/// @file
/// Numbers one at a time or a pack of them: what a formula that serves both makes of its scalar.
#pragma once

namespace passive_haptics {
namespace detail {
// A single number. core/scalar/pack.hpp has that of packs.
template <class T>
struct scalar_parts {
  using number = T;
  using truth = bool;
  template <class X>
  using choice = X;
};

// a where it is true, else b: of numbers, registers or packs.
template <class Truth, class X>
[[gnu::always_inline]] constexpr X one_of(Truth where, X a, X b) {
  if constexpr (requires { where ? a : b; }) return where ? a : b;
  else return select(where, a, b);
}
}  // namespace detail

/// T, or of a pack the type of each of its numbers: parameters are single numbers in either case.
template <class T>
using number_of = typename detail::scalar_parts<T>::number;
/// What comparing two T gives: bool, or a truth for each number of a pack.
template <class T>
using truth_of = typename detail::scalar_parts<T>::truth;
/// An enumerator of X that numbers T decide: X, or one for each number of a pack.
template <class T, class X>
using choice_of = typename detail::scalar_parts<T>::template choice<X>;

/// True if it is false.
constexpr bool none(bool where) { return !where; }

/// What says of itself `static constexpr bool branch_free = true`: a mechanism, shape or law whose functions
/// are templates over the scalar without a branch, so that they take packs (control/batch).
template <class X>
concept BranchFree = requires { requires X::branch_free; };

}  // namespace passive_haptics
