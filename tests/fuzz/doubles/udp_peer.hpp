// In place of examples/common/udp_peer.hpp: datagrams that a fuzzer hands over.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <sys/types.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

class udp_peer {
 public:
  static constexpr ssize_t nothing = -1, broken = -2;
  inline static std::deque<std::vector<std::uint8_t>> datagrams;  // that have come

  std::string open(const std::string&, int) { return {}; }
  void send(std::span<const std::uint8_t>) noexcept {}
  ssize_t receive(std::span<std::uint8_t> to) noexcept {
    if (datagrams.empty()) return nothing;
    const auto one = std::move(datagrams.front());
    datagrams.pop_front();
    std::copy_n(one.begin(), std::min(one.size(), to.size()), to.begin());
    return static_cast<ssize_t>(one.size());
  }
  bool refused() noexcept { return false; }
  void wait(double) const noexcept {}
  void close() noexcept {}
};

}  // namespace example
