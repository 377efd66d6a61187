/// @file
/// A board that is no board: brakes and encoders simulated, the serial line a pseudo-terminal.
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

/// The device's end of a pseudo-terminal; the other end is a file that a host opens as a serial port.
class pseudo_terminal {
 public:
  /// Empty path if the system has none left.
  pseudo_terminal() : device_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    const char* name =
        device_ >= 0 && grantpt(device_) == 0 && unlockpt(device_) == 0 ? ptsname(device_) : nullptr;
    if (name == nullptr) return;
    path_ = name;
    // Kept open and raw, so that it is a serial port already before a host comes, and still one when the host
    // has gone.
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

  /// What the host opens.
  const std::string& path() const { return path_; }

  /// Takes what has come from the host, without waiting; returns how many bytes.
  std::size_t read(std::span<std::uint8_t> to) {
    const auto n = ::read(device_, to.data(), to.size());
    return n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  /// Sends to the host, without waiting; drops what has no room.
  void write(std::span<const std::uint8_t> bytes) {
    if (::write(device_, bytes.data(), bytes.size()) < 0) return;
  }
  /// As if the plug were pulled.
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
  /// Sends through this line, which must live as long.
  explicit host_board(pseudo_terminal& line) : line_(line) {}

  std::uint8_t encoder_faults() { return encoder_faults_; }
  std::uint8_t brake_faults() { return brake_faults_; }
  void send(std::span<const std::uint8_t> bytes) { line_.write(bytes); }

  /// From now on it reports these.
  void set_faults(std::uint8_t encoders, std::uint8_t brakes) {
    encoder_faults_ = encoders;
    brake_faults_ = brakes;
  }

 private:
  pseudo_terminal& line_;
  std::uint8_t encoder_faults_ = 0, brake_faults_ = 0;
};

}  // namespace firmware
