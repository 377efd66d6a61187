/// A serial port of the operating system: raw bytes, both ways, without waiting.
#pragma once

#include <file_descriptor.hpp>

#include <passive_haptics/core/parameters.hpp>

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// Supported rates [bit/s].
inline constexpr std::array<std::pair<int, speed_t>, 14> baud_rates{{{9600, B9600},
                                                                     {19200, B19200},
                                                                     {38400, B38400},
                                                                     {57600, B57600},
                                                                     {115200, B115200},
                                                                     {230400, B230400},
                                                                     {460800, B460800},
                                                                     {500000, B500000},
                                                                     {921600, B921600},
                                                                     {1000000, B1000000},
                                                                     {1500000, B1500000},
                                                                     {2000000, B2000000},
                                                                     {3000000, B3000000},
                                                                     {4000000, B4000000}}};

/// Error text of a rate, empty if there is none.
inline std::string check_baud(std::string_view name, int baud) {
  std::string rates;
  for (const auto& [rate, code] : baud_rates) {
    if (rate == baud) return "";
    rates += (rates.empty() ? "" : ", ") + std::to_string(rate);
  }
  return ph::detail::error_text(name, baud, "one of " + rates);
}

/// A serial line. Only open() allocates; nothing waits except close(), while the kernel sends pending bytes.
class serial_line {
 public:
  enum class transfer {
    done,     ///< All bytes, or for read() at least one.
    nothing,  ///< No byte received; no room for all bytes, some of which may have been sent.
    lost,     ///< The port is gone.
  };

  enum class use {
    alone,   ///< Only reader: no other process can open the line until it is closed.
    beside,  ///< Occasional writer next to the reader, opened before it.
  };

  serial_line() = default;
  serial_line(serial_line&&) noexcept = default;
  serial_line& operator=(serial_line&&) noexcept = default;
  ~serial_line() { close(); }

  /// Opens it raw, 8 data bits, no parity, 1 stop bit, no flow control. Returns an error with a remedy, or an
  /// empty string.
  std::string open(const std::string& path, int baud, use u) {
    close();
    fd_ = file_descriptor(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!fd_.is_open()) return "serial port " + path + ": " + refusal(errno);
    std::string text = lock(u);
    if (text.empty()) text = set_up(baud);
    if (text.empty()) return "";
    close();
    return "serial port " + path + ": " + text;
  }

  bool is_open() const noexcept { return fd_.is_open(); }

  /// Reads the received bytes, as far as there is room. One system call.
  transfer read(std::span<std::uint8_t> to, std::size_t& count) noexcept {
    count = 0;
    for (;;) {
      const auto n = ::read(fd_.get(), to.data(), to.size());
      if (n > 0) {
        count = static_cast<std::size_t>(n);
        return transfer::done;
      }
      if (n == 0) return transfer::lost;  // hung up: with VMIN = 1 an empty line gives EAGAIN
      if (errno == EINTR) continue;
      return errno == EAGAIN ? transfer::nothing : transfer::lost;
    }
  }

  /// Writes all bytes, or as many as there is room for. One system call.
  transfer write(std::span<const std::uint8_t> bytes) noexcept {
    for (;;) {
      const auto n = ::write(fd_.get(), bytes.data(), bytes.size());
      if (n == static_cast<ssize_t>(bytes.size())) return transfer::done;
      if (n >= 0) return transfer::nothing;
      if (errno == EINTR) continue;
      return errno == EAGAIN ? transfer::nothing : transfer::lost;
    }
  }

  void discard_output() noexcept { tcflush(fd_.get(), TCOFLUSH); }
  void discard_input() noexcept { tcflush(fd_.get(), TCIFLUSH); }

  /// Waits for input, at most `timeout` [s].
  void wait(double timeout) const noexcept { fd_.wait(timeout); }

  void close() noexcept {
    if (alone_) ioctl(fd_.get(), TIOCNXCL);  // a pseudo-terminal would keep the flag
    alone_ = false;
    fd_.close();
  }

 private:
  file_descriptor fd_;
  bool alone_ = false;

  static std::string refusal(int error) {
    switch (error) {
      case ENOENT: return "no such file; plug the device in, or find its name by `ls /dev/serial/by-id`";
      case EACCES:
        return "no permission; add the user to the group that owns it (dialout in Debian) by `sudo usermod "
               "-aG dialout "
               "$USER` and log in again";
      case EWOULDBLOCK:
      case EBUSY: return "another program drives it; end that program (`fuser -v` with this file names it)";
      case ENXIO:
      case ENODEV:
      case EIO: return "no device belongs to this file; plug the device in";
      default: return std::strerror(error);
    }
  }

  // TIOCEXCL is for programs without this lock and does not affect root; flock ends with the process
  std::string lock(use u) {
    if (flock(fd_.get(), (u == use::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) return refusal(errno);
    if (u == use::beside) flock(fd_.get(), LOCK_UN);
    else alone_ = ioctl(fd_.get(), TIOCEXCL) == 0;
    return "";
  }

  std::string set_up(int baud) {
    if (const std::string text = check_baud("baud [bit/s]", baud); !text.empty()) return text;
    termios settings;
    if (tcgetattr(fd_.get(), &settings) != 0)
      return "not a serial port; find its name by `ls /dev/serial/by-id`";
    cfmakeraw(&settings);
    settings.c_cflag |= CLOCAL | CREAD;
    settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
    settings.c_cc[VMIN] = 1;
    settings.c_cc[VTIME] = 0;
    for (const auto& [rate, code] : baud_rates)
      if (rate == baud) cfsetspeed(&settings, code);
    termios result;
    if (tcsetattr(fd_.get(), TCSANOW, &settings) != 0 || tcgetattr(fd_.get(), &result) != 0)
      return std::string("cannot be set up: ") + std::strerror(errno);
    if (cfgetospeed(&result) != cfgetospeed(&settings))
      return ph::detail::error_text("baud [bit/s]", baud, "a rate that this port supports");
    // An FTDI chip keeps what it received for 16 ms unless low latency is set; a line that cannot do it
    // refuses, and that is all right.
    serial_struct driver;
    if (ioctl(fd_.get(), TIOCGSERIAL, &driver) == 0) {
      driver.flags |= int(ASYNC_LOW_LATENCY);
      ioctl(fd_.get(), TIOCSSERIAL, &driver);
    }
    return "";
  }
};

}  // namespace example
