/// Percentiles of measured samples.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace passive_haptics::testing {

/// Nearest-rank percentile of ascending samples, at least one; share in (0, 1], 0.5 for the median.
template <class T>
T percentile(const std::vector<T>& ascending, double share) {
  assert(!ascending.empty() && std::is_sorted(ascending.begin(), ascending.end()));
  // Rounded down slightly, since 0.999 * 1000 is 999
  const double rank = std::ceil(share * static_cast<double>(ascending.size()) * (1 - 1e-12));
  return ascending[std::clamp(static_cast<std::size_t>(rank), std::size_t{1}, ascending.size()) - 1];
}

/// Ascending copy.
template <class T>
std::vector<T> sorted(std::vector<T> samples) {
  std::sort(samples.begin(), samples.end());
  return samples;
}

}  // namespace passive_haptics::testing
