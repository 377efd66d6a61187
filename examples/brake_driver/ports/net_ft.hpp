/// An ATI Net F/T force/torque sensor, read over the network (raw data transfer, RDT).
#pragma once

#include <udp_peer.hpp>

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace example {

/// Address and scale of the sensor; the scale is on its web page "Configurations".
struct net_ft_parameters {
  std::string host = "192.168.1.1";      ///< Name or address; the manufacturer's default.
  int port = 49152;                      ///< UDP.
  double counts_per_force = 1'000'000;   ///< [1/N]; set the sensor's force unit to N.
  double counts_per_torque = 1'000'000;  ///< [1/(N m)]; set the sensor's torque unit to N m.
  double open_timeout = 1;               ///< For the first record [s].
  double silence = 0.1;  ///< Time without a record after which records are requested again [s].

  static constexpr auto members() {
    using p = net_ft_parameters;
    using ph::member, ph::range;
    return ph::member_table(
        member("host", &p::host), member("port", &p::port, "", range::between(1, 65535)),
        member("counts_per_force", &p::counts_per_force, "1/N", range::positive)
            .suspicious_below(1e-3)
            .suspicious_above(1e12),
        member("counts_per_torque", &p::counts_per_torque, "1/(N m)", range::positive)
            .suspicious_below(1e-3)
            .suspicious_above(1e12),
        member("open_timeout", &p::open_timeout, "s", range::positive).suspicious_above(600),
        member("silence", &p::silence, "s", range::positive).suspicious_above(60));
  }
  /// Requires a host.
  std::string rules() const {
    return host.empty() ? "host = \"\": expected a name or an address, as 192.168.1.1" : "";
  }
};
using ph::validate;

/// A record of RDT: 36 bytes, big-endian.
struct rdt_record {
  static constexpr std::size_t size = 36;  ///< [bytes]

  std::uint32_t sequence = 0;            ///< Number of the record.
  std::uint32_t ft_sequence = 0;         ///< Number of the measurement.
  std::uint32_t status = 0;              ///< 0 without faults.
  std::array<std::int32_t, 6> counts{};  ///< Fx, Fy, Fz, Tx, Ty, Tz.

  /// Decodes these bytes.
  static rdt_record from(std::span<const std::uint8_t, size> bytes) {
    const auto word = [&](std::size_t i) {
      std::uint32_t value = 0;
      for (std::size_t k = 0; k < 4; ++k) value = value << 8 | bytes[4 * i + k];
      return value;
    };
    rdt_record r{word(0), word(1), word(2), {}};
    for (std::size_t i = 0; i < r.counts.size(); ++i) r.counts[i] = static_cast<std::int32_t>(word(3 + i));
    return r;
  }

  /// True if the counts are valid: no bit of the status is set (bit 17 is saturation, others are failures of
  /// the electronics) except bit 16, a user-defined threshold that was exceeded, and bit 31, which
  /// accompanies all others.
  bool trusted() const { return status == 0 || (status & 0x7FFF'FFFFu) == 0x0001'0000u; }
};

/// A ForceSensor for a threaded_sensor: reading an empty socket returns immediately, but another request may
/// make the kernel allocate memory or look up a route. The loop only accesses memory and does not wait.
///
/// Forces [N] and torques [N m] in the sensor's frame. Samples have the record's sequence and the time of
/// their read, because the sensor sends no time; that suffices to detect old forces, and no rates are
/// computed from it.
///
/// read: `ok` with the record of the highest sequence received; all channels are invalid unless
/// rdt_record::trusted().
///   `bad_sample` if only datagrams of another length were received. `no_sample` without datagrams, also
///   if the network or the sensor rejects requests: after an unplugged cable or a power failure, records
///   are requested again every `silence` seconds. `failed` if the socket is broken or not open. At most
///   max_datagrams + 1 system calls and a send.
/// Only open() allocates, waits or looks up a name.
class net_ft {
 public:
  static constexpr int channel_count = 6;    ///< Fx, Fy, Fz, Tx, Ty, Tz.
  static constexpr int max_datagrams = 256;  ///< Maximum per read(): 36 ms at the sensor's maximum rate.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit net_ft(const net_ft_parameters& p) : parameters_(ph::require_valid(p)) {}
  /// Requests the end of transmission.
  ~net_ft() { ask(stop); }
  net_ft(net_ft&&) noexcept = default;

  /// Looks up the host, requests records and waits for the first.
  std::string open() {
    const std::string name =
        "force sensor " + parameters_.host + ":" + std::to_string(parameters_.port) + ": ";
    if (const std::string text = peer_.open(parameters_.host, parameters_.port); !text.empty())
      return name + text;
    const double end = ph::monotonic_seconds() + parameters_.open_timeout;
    bool other = false, refused = false;
    for (double now; (now = ph::monotonic_seconds()) < end;) {
      constexpr double again = 0.1;  // [s]
      if (now - asked_ >= again) ask(start);
      peer_.wait(std::min(again, end - now));
      ph::port_sample<channel_count> first;
      const auto status = read(first);
      if (status == ph::port_status::ok) return "";
      other = other || status == ph::port_status::bad_sample;
      refused = refused || peer_.refused();
    }
    const std::string waited =
        "no record in " + std::to_string(std::lround(1e3 * parameters_.open_timeout)) + " ms; ";
    if (other)
      return name + waited +
             "the host sends no RDT records; check that it is a Net F/T and that RDT is enabled";
    if (refused)
      return name + waited + "the host rejects the port; enable RDT on its web page, and check the port";
    return name + waited + "check its power and cable, and that this computer is in its subnet (`ping " +
           parameters_.host + "`)";
  }

  ph::port_status read(ph::port_sample<channel_count>& to) noexcept {
    std::array<std::uint8_t, rdt_record::size> bytes;
    rdt_record newest;
    bool fresh = false, damaged = false;
    for (int i = 0; i < max_datagrams; ++i) {
      const auto got = peer_.receive(bytes);
      if (got == udp_peer::broken) return ph::port_status::failed;
      if (got == udp_peer::nothing) break;
      if (got != rdt_record::size) {
        damaged = true;
        continue;
      }
      const auto r = rdt_record::from(bytes);
      if (!fresh || static_cast<std::int32_t>(r.sequence - newest.sequence) > 0) newest = r;
      fresh = true;
    }
    const double now = ph::monotonic_seconds();
    if (!fresh) {
      if (now - heard_ > parameters_.silence && now - asked_ > parameters_.silence) ask(start);
      return damaged ? ph::port_status::bad_sample : ph::port_status::no_sample;
    }
    heard_ = now;
    to.time = now;
    to.sequence = newest.sequence;
    for (std::size_t i = 0; i < to.channels; ++i) {
      to.value[i] = newest.counts[i] / (i < 3 ? parameters_.counts_per_force : parameters_.counts_per_torque);
      to.valid[i] = newest.trusted();
    }
    status_ = newest.status;
    return ph::port_status::ok;
  }

  /// The status word of the newest record, for a message.
  std::uint32_t status() const { return status_; }

 private:
  static constexpr std::uint8_t stop = 0,
                                start = 2;  // RDT commands; start: at the rate on its web page

  net_ft_parameters parameters_;
  udp_peer peer_;
  double heard_ = 0, asked_ = 0;  // the latest record, the latest request [s]
  std::uint32_t status_ = 0;

  void ask(std::uint8_t command) noexcept {
    // Header 0x1234, command, number of records: 0 is unlimited
    const std::array<std::uint8_t, 8> request{0x12, 0x34, 0, command, 0, 0, 0, 0};
    peer_.send(request);
    asked_ = ph::monotonic_seconds();
  }
};

}  // namespace example
