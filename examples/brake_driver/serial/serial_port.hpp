/// Brakes and encoders of a microcontroller on a serial line (serial_protocol.hpp).
#pragma once

#include <serial/serial_line.hpp>
#include <serial/serial_port_parameters.hpp>

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/device_clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace example {

/// A BrakePort for a threaded_port: read() and write() take a few system calls each. On a pseudo-terminal
/// they wait for a kernel worker even in non-blocking mode, up to 0.5 s on a busy machine. The loop only
/// accesses memory and does not wait.
///
/// Samples have the device's sequence and time (device_clock); a channel is invalid if the device reports a
/// fault of its encoder.
///
///   - read: `ok` with the latest complete sample; `bad_sample` if there was only damaged data (a wrong
///     checksum, an incomplete frame, another number of encoders); `failed` if the port is gone, or the
///     device reports that written currents are not on the brakes: a brake fault, its watchdog, a release by
///     another process, a restart. This is checked once the first currents after a release had the watchdog's
///     time to arrive.
///   - write: `no_sample` if there was no room for the whole frame; the device drops a partial frame. Pending
///     output is then discarded, because late currents are wrong. `failed` if the port is gone.
///   - release: discards pending output, and sends the release three times against disturbances. If all are
///     lost, the device's watchdog releases the brakes. Safe in a signal handler.
template <int Encoders, int Brakes>
  requires(Encoders >= 1 && Encoders <= int{serial::max_channels} && Brakes >= 1 &&
           Brakes <= int{serial::max_channels})
class serial_port {
 public:
  static constexpr int encoder_count = Encoders;  ///< Maximum channels of a sample.
  static constexpr int brake_count = Brakes;      ///< Maximum number of currents.
  static constexpr int release_copies = 3;        ///< Frames per release().

  /// Line errors since open().
  struct statistics {
    unsigned long samples = 0;  ///< Complete samples, including those replaced in a read().
    unsigned long damaged = 0;  ///< Invalid frames.
    unsigned long unsent = 0;   ///< Currents without room.
  };

  /// For a device with so many encoders and brakes; other channels of a sample are 0. Throws
  /// std::invalid_argument with the text of validate(p).
  explicit serial_port(const serial_port_parameters& p, int encoders = Encoders, int brakes = Brakes)
      : parameters_(ph::require_valid(p)), encoders_(encoders), brakes_(brakes) {}
  ~serial_port() { release(); }
  serial_port(serial_port&&) noexcept = default;

  /// Opens the port, releases the brakes, and requests the device's hello.
  std::string open() {
    using enum serial_line::use;
    if (const std::string text =
            line_.open(parameters_.device, parameters_.baud, parameters_.release_only ? beside : alone);
        !text.empty())
      return text;
    lost_ = false;
    hello_.current_limit = std::numeric_limits<std::uint16_t>::max();  // limited by the device
    if (parameters_.release_only) return "";
    line_.discard_input();  // old samples
    release();
    const std::string text = greet();
    if (text.empty()) return "";
    line_.close();  // another process may drive it
    return "serial port " + parameters_.device + ": " + text;
  }

  /// See above; limited by the kernel's buffer of 4 KiB.
  ph::port_status read(ph::port_sample<Encoders>& to) noexcept {
    const double now = ph::monotonic_seconds();
    bool fresh = false, damaged = false;
    take([&](serial::outcome o) {
      serial::sample m;
      const bool is_sample = o == serial::outcome::packet && unpack(decoder_.last(), m);
      if (is_sample && m.encoders == encoders_) {
        fresh = true;
        newest_ = m;
        to.sequence = decoder_.last().sequence;
        to.time = clock_.to_host(m.time, now);
        ++statistics_.samples;
      } else if (is_sample || o == serial::outcome::damaged) {
        damaged = true;
        ++statistics_.damaged;
      }
    });
    if (lost_) return ph::port_status::failed;
    if (!fresh) return damaged ? ph::port_status::bad_sample : ph::port_status::no_sample;
    for (std::size_t i = 0; i < to.channels; ++i) {
      to.value[i] = newest_.count[i];
      to.valid[i] = i >= newest_.encoders || ((newest_.encoder_faults >> i) & 1) == 0;
    }
    return refused(now) ? ph::port_status::failed : ph::port_status::ok;
  }

  /// See above. Rounds to serial::current_unit, limits to the device's limit, and sends NaN as 0.
  ph::port_status write(const ph::brake_currents<Brakes>& currents) noexcept {
    if (lost_ || !line_.is_open()) return ph::port_status::failed;
    serial::currents m;
    m.brakes = static_cast<std::uint8_t>(brakes_);
    for (std::size_t i = 0; i < m.brakes; ++i) {
      const double units = std::round(currents[i] / serial::current_unit);
      m.current[i] = units > 0 ? static_cast<std::uint16_t>(std::min<double>(units, hello_.current_limit))
                               : std::uint16_t{0};
    }
    if (!armed_) armed_since_ = ph::monotonic_seconds();
    armed_ = true;
    switch (line_.write(serial::encode(serial::pack(sequence_++, m)).content())) {
      case serial_line::transfer::done: return ph::port_status::ok;
      case serial_line::transfer::nothing:
        line_.discard_output();
        ++statistics_.unsent;
        return ph::port_status::no_sample;
      default: lost_ = true; return ph::port_status::failed;
    }
  }

  void release() noexcept {
    armed_ = false;
    if (!line_.is_open()) return;
    line_.discard_output();
    for (int i = 0; i < release_copies; ++i)
      line_.write(serial::encode(serial::pack(sequence_++, serial::message_type::release)).content());
  }

  /// 32 bits.
  static constexpr int counter_bits() noexcept { return 32; }
  /// Watchdog of the device [s]; 0 before its hello.
  double watchdog() const noexcept { return 1e-3 * hello_.watchdog; }
  const serial::hello& device() const { return hello_; }
  /// The latest sample, with the reason for a failed read().
  const serial::sample& newest() const { return newest_; }
  const statistics& line_statistics() const { return statistics_; }

 private:
  serial_port_parameters parameters_;
  int encoders_, brakes_;
  serial_line line_;
  serial::decoder decoder_;
  serial::hello hello_;
  serial::sample newest_;
  ph::device_clock clock_;
  statistics statistics_;
  bool lost_ = false, armed_ = false;
  double armed_since_ = 0;  // time of the first currents after a release [s]
  std::uint32_t sequence_ = 0;

  // Decodes the received bytes, calls f(outcome) at each end of a frame, and returns the number of bytes.
  template <class F>
  std::size_t take(F&& f) noexcept {
    constexpr std::size_t max_bytes = 4096;
    std::array<std::uint8_t, 512> bytes;
    std::size_t all = 0, count = 0;
    lost_ = lost_ || !line_.is_open();
    while (!lost_ && all < max_bytes) {
      const auto ended = line_.read(bytes, count);
      lost_ = ended == serial_line::transfer::lost;
      if (ended != serial_line::transfer::done) break;
      all += count;
      for (const std::uint8_t b : std::span(bytes).first(count))
        if (const auto o = decoder_.take(b); o != serial::outcome::nothing) f(o);
    }
    return all;
  }

  // True if written currents had time to arrive, but are not on the brakes.
  bool refused(double now) const noexcept {
    const bool on = (newest_.state & serial::sample::active) != 0 && newest_.brake_faults == 0;
    return armed_ && !on && now - armed_since_ > 1e-3 * hello_.watchdog;
  }

  // Requests the hello until it arrives.
  std::string greet() {
    constexpr double again = 0.1;  // [s]
    const double end = ph::monotonic_seconds() + parameters_.open_timeout;
    bool answered = false;
    std::size_t bytes = 0, packets = 0;
    for (double now; !answered && !lost_ && (now = ph::monotonic_seconds()) < end;) {
      line_.write(serial::encode(serial::pack(sequence_++, serial::message_type::ask)).content());
      const double next = std::min(now + again, end);
      for (; !answered && !lost_ && (now = ph::monotonic_seconds()) < next;) {
        line_.wait(next - now);
        bytes += take([&](serial::outcome o) {
          packets += o == serial::outcome::packet;
          answered = answered || (o == serial::outcome::packet && unpack(decoder_.last(), hello_));
        });
      }
    }
    if (lost_) return "the device was disconnected before it sent its name; connect it again";
    return answered ? error_of_hello(hello_, encoders_, brakes_)
                    : error_of_silence(parameters_, bytes, packets);
  }
};

}  // namespace example
