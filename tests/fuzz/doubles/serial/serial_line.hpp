// In place of examples/brake_driver/serial/serial_line.hpp: a line in memory, whose other end a fuzzer holds.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace example {

namespace ph = passive_haptics;

inline std::string check_baud(std::string_view, int) { return {}; }

class serial_line {
 public:
  enum class transfer { done, nothing, lost };
  enum class use { alone, beside };
  inline static std::deque<std::uint8_t> to_host, to_device;  // on their way
  inline static std::size_t room = 0;                         // towards the device [bytes]
  inline static std::function<void()> waited;                 // what happens while the host waits

  std::string open(const std::string&, int, use) {
    open_ = true;
    return {};
  }
  bool is_open() const noexcept { return open_; }
  transfer read(std::span<std::uint8_t> to, std::size_t& count) noexcept {
    count = std::min(to.size(), to_host.size());
    if (count == 0) return transfer::nothing;
    const auto end = to_host.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(to_host.begin(), end, to.begin());
    to_host.erase(to_host.begin(), end);
    return transfer::done;
  }
  transfer write(std::span<const std::uint8_t> bytes) noexcept {
    const std::size_t some = std::min(bytes.size(), room - std::min(room, to_device.size()));
    to_device.insert(to_device.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(some));
    return some == bytes.size() ? transfer::done : transfer::nothing;
  }
  void discard_output() noexcept { to_device.clear(); }
  void discard_input() noexcept { to_host.clear(); }
  void wait(double) const noexcept { waited(); }
  void close() noexcept { open_ = false; }

 private:
  bool open_ = false;
};

}  // namespace example
