/// A board on the host: simulated brakes and encoders, and a pseudo-terminal as serial line.
#pragma once

#include <firmware/simulated_axes.hpp>

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <cstdint>
#include <span>
#include <string>

namespace firmware {

/// The device's end of a pseudo-terminal; a host opens the other end as a serial port.
class pseudo_terminal {
 public:
  /// The path is empty if no pseudo-terminal is available.
  pseudo_terminal() : device_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    const char* name =
        device_ >= 0 && grantpt(device_) == 0 && unlockpt(device_) == 0 ? ptsname(device_) : nullptr;
    if (name == nullptr) return;
    path_ = name;
    // Kept open and raw, so that it is a serial port before a host opens it and after the host has gone.
    host_ = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings;
    if (tcgetattr(host_, &settings) == 0) {
      cfmakeraw(&settings);
      tcsetattr(host_, TCSANOW, &settings);
    }
  }
  ~pseudo_terminal() { hang_up(); }
  pseudo_terminal(const pseudo_terminal&) = delete;
  pseudo_terminal& operator=(const pseudo_terminal&) = delete;

  /// Path for the host.
  const std::string& path() const { return path_; }

  /// Reads the received bytes without waiting; returns their number.
  std::size_t read(std::span<std::uint8_t> to) {
    const auto n = ::read(device_, to.data(), to.size());
    return n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  /// Sends to the host without waiting; drops bytes without room.
  void write(std::span<const std::uint8_t> bytes) {
    if (::write(device_, bytes.data(), bytes.size()) < 0) return;
  }
  /// As if unplugged.
  void hang_up() {
    for (int* fd : {&host_, &device_}) {
      if (*fd >= 0) ::close(*fd);
      *fd = -1;
    }
  }

 private:
  int device_, host_ = -1;
  std::string path_;
};

/// Simulated axes behind a pseudo-terminal.
class host_board : public simulated_axes {
 public:
  /// Sends through this line, which must live longer.
  explicit host_board(pseudo_terminal& line) : line_(line) {}

  std::uint8_t encoder_faults() { return encoder_faults_; }
  std::uint8_t brake_faults() { return brake_faults_; }
  void send(std::span<const std::uint8_t> bytes) { line_.write(bytes); }

  /// Reports these faults from now on.
  void set_faults(std::uint8_t encoders, std::uint8_t brakes) {
    encoder_faults_ = encoders;
    brake_faults_ = brakes;
  }

 private:
  pseudo_terminal& line_;
  std::uint8_t encoder_faults_ = 0, brake_faults_ = 0;
};

}  // namespace firmware
