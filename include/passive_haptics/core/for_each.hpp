/// Iteration over the elements of a tuple.
#pragma once

#include <boost/hana/basic_tuple.hpp>

namespace passive_haptics::detail {

/// Calls f(x) for each element of a hana::basic_tuple. hana::for_each would include most of Hana.
template <class Tuple, class F>
constexpr void for_each(Tuple& xs, F&& f) {
  boost::hana::unpack_impl<boost::hana::basic_tuple_tag>::apply(xs, [&](auto&... x) { (f(x), ...); });
}

}  // namespace passive_haptics::detail
