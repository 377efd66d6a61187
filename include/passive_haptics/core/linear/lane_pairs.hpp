/// @file
/// Two lanes: of each what the other one has.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>

#include <utility>

namespace passive_haptics {

/// (x_0 + x_1, y_0 + y_1), added crosswise.
template <class T>
lanes<T, 2> horizontal_add(const lanes<T, 2>& x, const lanes<T, 2>& y) {
  if constexpr (lanes<T, 2>::width != 2)
    return lanes<T, 2>([&](int i) PASSIVE_HAPTICS_INLINE { return i == 0 ? x[0] + x[1] : y[0] + y[1]; });
  else
    return lanes<T, 2>::each([&](auto k) PASSIVE_HAPTICS_INLINE {
      return __builtin_shufflevector(x.p[k], y.p[k], 0, 2) + __builtin_shufflevector(x.p[k], y.p[k], 1, 3);
    });
}

/// (x_1, x_0): of each of two what the other one has. x: lanes or a mask.
template <class X>
[[gnu::always_inline]] inline X swapped(X x) {
  if constexpr (X::width == 1) std::swap(x.p[0], x.p[1]);
  else if constexpr (X::width * sizeof(x.p[0][0]) == 8)
    x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 2, 3, 0, 1);
  else if constexpr (X::width == 2) x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 1, 0);
  else x.p[0] = __builtin_shufflevector(x.p[0], x.p[0], 1, 0, 2, 3);
  return x;
}

/// The first truth of two alone.
template <class T>
[[gnu::always_inline]] inline lane_mask<T, 2> first_only(lane_mask<T, 2> x) {
  using truths = typename detail::truths_of<T>::type;
  if constexpr (x.width == 1) x.p[1] = x.p[1] & !x.p[0];
  else if constexpr (x.width == 2) x.p[0] &= ~(swapped(x).p[0] & truths{0, 0, -1, -1});
  else x.p[0] &= ~(swapped(x).p[0] & truths{0, -1, 0, 0});
  return x;
}

}  // namespace passive_haptics
