/// @file
/// Where a device on a serial line is, and what there is to say if it is not there.
#pragma once

#include <serial/serial_line.hpp>
#include <serial/serial_protocol.hpp>

#include <cmath>

namespace example {

/// Where the device is.
struct serial_port_parameters {
  std::string device = "/dev/ttyACM0";  ///< A name under /dev/serial/by-id stays the same at another socket.
  int baud = 1'000'000;                 ///< [bit/s]; USB boards without a UART ignore it.
  double open_timeout = 3;  ///< For a hello [s]; boards that opening the port resets take 2 s to start.
  /// For a supervisor: open() neither requests nor releases nor reads, so the process that drives the device
  /// notices nothing; it may write. It comes before that of the port that drives it, which is refused to all
  /// who come later.
  bool release_only = false;

  /// The table of passive_haptics/core/parameters.hpp: what a configuration may say.
  static constexpr auto members() {
    using p = serial_port_parameters;
    using ph::member, ph::range;
    return ph::member_table(
        member("device", &p::device), member("baud", &p::baud, "bit/s"),
        member("open_timeout", &p::open_timeout, "s", range::positive).suspicious_above(600));
  }
  /// It has a device, at a rate that serial ports have.
  std::string rules() const {
    if (device.empty()) return "device is empty, expected the file of a serial port, as /dev/ttyACM0";
    return check_baud("baud [bit/s]", baud);
  }
};
using ph::validate;

/// The message for a device that sends no name but `bytes` bytes came with so many whole frames in them.
inline std::string error_of_silence(const serial_port_parameters& p, std::size_t bytes, std::size_t frames) {
  const std::string start = "no answer in " + std::to_string(std::lround(1e3 * p.open_timeout)) + " ms; ";
  if (bytes == 0)
    return start + "not a byte came: is the board powered, is its firmware running, is it this port?";
  if (frames == 0)
    return start + std::to_string(bytes) +
           " bytes came, with no whole frame in them: is baud = " + std::to_string(p.baud) +
           " that of the firmware, is it this port?";
  return start + "samples came: the way to the device is cut, check the line";
}

/// What is wrong with the device that sent a hello; empty if nothing.
inline std::string error_of_hello(const serial::hello& h, int encoders, int brakes) {
  const auto counted = [](int n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  if (h.version != serial::protocol_version)
    return "the device speaks version " + std::to_string(h.version) + " of the protocol, expected " +
           std::to_string(serial::protocol_version) + "; flash the firmware that came with this program";
  if (h.encoders != encoders || h.brakes != brakes)
    return "the device has " + counted(h.encoders, "encoder") + " and " + counted(h.brakes, "brake") +
           ", expected " + counted(encoders, "encoder") + " and " + counted(brakes, "brake") +
           "; flash firmware with these settings, or configure another device";
  return "";
}

}  // namespace example
