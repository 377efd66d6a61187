/// Shortfall of several demands for a set of brakes at rest.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// Unmet shares of several demands.
template <class T>
struct settled_shortfall {
  T first = std::numeric_limits<T>::infinity();  ///< Demands with priority.
  T others = first;                              ///< Other demands.
  T force = first;                               ///< |F| [N]

  /// Shortfall of the forces `met` (contact_forces_result) for the first `count` demands.
  template <class Met, class Demands>
  static settled_shortfall of(const Met& met, const Demands& demands, int count) {
    T left[2] = {}, wanted = T(0);
    for (int j = 0; j < count; ++j) {
      const auto at = static_cast<std::size_t>(j);
      T& level = left[demands[at].has_priority ? 0 : 1];
      level = std::hypot(level, demands[at].force - met.displayed[at]);
      wanted = std::hypot(wanted, demands[at].force);
    }
    const T whole = wanted > T(0) ? wanted : T(1);
    return {left[0] / whole, left[1] / whole, met.force.norm()};
  }

  /// Lexicographic comparison with a gain.
  bool is_less_than(const settled_shortfall& b, T gain) const {
    if (!(std::abs(first - b.first) <= gain)) return first < b.first;
    if (!(std::abs(others - b.others) <= gain)) return others < b.others;
    return force < b.force * (T(1) - gain);
  }
};

}  // namespace passive_haptics
