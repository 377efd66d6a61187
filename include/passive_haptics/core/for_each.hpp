/// @file
/// A function for each element of a tuple.
#pragma once

#include <boost/hana/basic_tuple.hpp>

namespace passive_haptics::detail {

/// f(x) for each x of a hana::basic_tuple, in their order. As hana::for_each, whose header would bring most
/// of Hana with it: a twentieth of what compiling Eigen costs.
template <class Tuple, class F>
constexpr void for_each(Tuple& xs, F&& f) {
  boost::hana::unpack_impl<boost::hana::basic_tuple_tag>::apply(xs, [&](auto&... x) { (f(x), ...); });
}

}  // namespace passive_haptics::detail
