// How long the stress tests run and from which seed:
//   PASSIVE_HAPTICS_STRESS=full      minutes to an hour, as `tests/run stress` does; else seconds
//   PASSIVE_HAPTICS_STRESS_SEED=7    instead of the fixed seed: to repeat a failure at once, or to search
//   elsewhere
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace stress {

// Cases of a short and of a full run.
inline std::uint64_t effort(std::uint64_t few, std::uint64_t many) {
  const char* asked = std::getenv("PASSIVE_HAPTICS_STRESS");
  return asked != nullptr && std::strcmp(asked, "full") == 0 ? many : few;
}

// The seed of the first case, printed; the next has the next.
inline std::uint64_t first_seed() {
  const char* asked = std::getenv("PASSIVE_HAPTICS_STRESS_SEED");
  const std::uint64_t seed = asked == nullptr ? 20040627 : std::strtoull(asked, nullptr, 10);
  std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  return seed;
}

}  // namespace stress
