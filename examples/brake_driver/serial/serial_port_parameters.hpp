/// Parameters of a device on a serial line, and errors for a missing device.
#pragma once

#include <serial/serial_line.hpp>
#include <serial/serial_protocol.hpp>

#include <cmath>

namespace example {

struct serial_port_parameters {
  std::string device = "/dev/ttyACM0";  ///< Names in /dev/serial/by-id do not depend on the socket.
  int baud = 1'000'000;                 ///< [bit/s]; USB boards without a UART ignore it.
  double open_timeout = 3;              ///< Timeout of the hello [s]; boards that reset on open need 2 s.
  /// For a supervisor: open() neither requests, releases nor reads, so it does not disturb the controlling
  /// process; writing is allowed. Open it before the controlling port, which locks the line.
  bool release_only = false;

  static constexpr auto members() {
    using p = serial_port_parameters;
    using ph::member, ph::range;
    return ph::member_table(
        member("device", &p::device), member("baud", &p::baud, "bit/s"),
        member("open_timeout", &p::open_timeout, "s", range::positive).suspicious_above(600));
  }
  /// Requires a device and a supported rate.
  std::string rules() const {
    if (device.empty()) return "device = \"\": expected the file of a serial port, as /dev/ttyACM0";
    return check_baud("baud [bit/s]", baud);
  }
};
using ph::validate;

/// Error text for a device without a hello, after `bytes` bytes with so many complete frames.
inline std::string error_of_silence(const serial_port_parameters& p, std::size_t bytes, std::size_t frames) {
  const std::string start = "no answer in " + std::to_string(std::lround(1e3 * p.open_timeout)) + " ms; ";
  if (bytes == 0)
    return start + "no byte was received; check the power of the board, its firmware and the port";
  if (frames == 0)
    return start + std::to_string(bytes) +
           " bytes were received, but no whole frame; check that baud = " + std::to_string(p.baud) +
           " is that of the firmware, and check the port";
  return start + "samples were received, but no answer; check the line to the device";
}

/// Error text of a hello, empty if there is none.
inline std::string error_of_hello(const serial::hello& h, int encoders, int brakes) {
  const auto counted = [](int n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  if (h.version != serial::protocol_version)
    return "protocol version of the device = " + std::to_string(h.version) + ": expected " +
           std::to_string(serial::protocol_version) + "; flash the firmware that came with this program";
  if (h.encoders != encoders || h.brakes != brakes)
    return "the device has " + counted(h.encoders, "encoder") + " and " + counted(h.brakes, "brake") +
           ": expected " + counted(encoders, "encoder") + " and " + counted(brakes, "brake") +
           "; flash firmware with these settings, or configure another device";
  return "";
}

}  // namespace example
