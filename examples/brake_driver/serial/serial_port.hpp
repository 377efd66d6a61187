/// @file
/// Brakes and encoders behind a microcontroller on a serial line, which speaks serial_protocol.hpp.
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

/// A BrakePort for a threaded_port: read() and write() take a few system calls each. At a pseudo-terminal
/// the kernel makes them wait for a worker of its own, even if the port is set not to wait; on a busy machine
/// this worker gets no processor (0.5 s were seen). The loop cannot wait for it, as it touches memory alone.
///
/// Samples carry the device's sequence and time (device_clock); a channel is invalid where the device reports
/// a fault of its encoder.
///
///   - read: `ok` with the newest whole sample of all that came; `bad_sample` if there was none but damage (a
///     wrong checksum, a frame cut off, one of another number of encoders); `failed` if the port is gone, or
///     if currents were written and the device says that they are not on the brakes: a brake's fault, its
///     watchdog, a release by somebody else, a restart. That is looked at once the first currents after a
///     release had its watchdog's time to arrive.
///   - write: `no_sample` if the operating system had no room for the whole frame; half of one may be out,
///     which the device drops when the next begins. What waits is thrown away then: currents that are late
///     are wrong. `failed` if the port is gone.
///   - release: throws away what waits, and sends the release three times, so that one disturbance does not
///     take all. If it gets lost nevertheless the device's watchdog does the same. Safe in a signal handler.
template <int Encoders, int Brakes>
  requires(Encoders >= 1 && Encoders <= int{serial::max_channels} && Brakes >= 1 &&
           Brakes <= int{serial::max_channels})
class serial_port {
 public:
  static constexpr int encoder_count = Encoders;  ///< Channels of a sample, at most.
  static constexpr int brake_count = Brakes;      ///< Currents, at most.
  static constexpr int release_copies = 3;        ///< Frames of one release().

  /// What went wrong on the line, since open().
  struct statistics {
    unsigned long samples = 0;  ///< Whole samples, also those that a newer one of the same read() replaced.
    unsigned long damaged = 0;  ///< Frames that were none.
    unsigned long unsent = 0;   ///< Currents that had no room.
  };

  /// To a device with so many encoders and brakes; further channels of a sample are 0. Throws
  /// std::invalid_argument with the text of validate(p).
  explicit serial_port(const serial_port_parameters& p, int encoders = Encoders, int brakes = Brakes)
      : parameters_(ph::require_valid(p)), encoders_(encoders), brakes_(brakes) {}
  ~serial_port() { release(); }
  serial_port(serial_port&&) noexcept = default;

  /// Opens the port, releases the brakes, and requests the name of the device.
  std::string open() {
    using enum serial_line::use;
    if (const std::string text =
            line_.open(parameters_.device, parameters_.baud, parameters_.release_only ? beside : alone);
        !text.empty())
      return text;
    lost_ = false;
    hello_.current_limit = std::numeric_limits<std::uint16_t>::max();  // the device cuts at its own
    if (parameters_.release_only) return "";
    line_.discard_input();  // samples of before
    release();
    const std::string text = greet();
    if (text.empty()) return "";
    line_.close();  // somebody else may drive it
    return "serial port " + parameters_.device + ": " + text;
  }

  /// See above; bounded by the 4 KiB that the kernel keeps.
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

  /// See above. Rounds to serial::current_unit, cuts at the device's limit, and takes what is no number for
  /// 0.
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

  /// See above.
  void release() noexcept {
    armed_ = false;
    if (!line_.is_open()) return;
    line_.discard_output();
    for (int i = 0; i < release_copies; ++i)
      line_.write(serial::encode(serial::pack(sequence_++, serial::message_type::release)).content());
  }

  /// Counts are of 32 bits.
  static constexpr int counter_bits() noexcept { return 32; }
  /// Of the device; 0 before it said so [s].
  double watchdog() const noexcept { return 1e-3 * hello_.watchdog; }
  /// What the device said of itself; of its limits.
  const serial::hello& device() const { return hello_; }
  /// The newest sample as it came: what read() refused, and why.
  const serial::sample& newest() const { return newest_; }
  /// What went wrong on the line.
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
  double armed_since_ = 0;  // the first currents after a release [s]
  std::uint32_t sequence_ = 0;

  // Feeds what came to the decoder, calls f(outcome) where a frame ends, and returns how many bytes that
  // were.
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

  // Currents were written, they had time to arrive, and the device does not have them on its brakes.
  bool refused(double now) const noexcept {
    const bool on = (newest_.state & serial::sample::active) != 0 && newest_.brake_faults == 0;
    return armed_ && !on && now - armed_since_ > 1e-3 * hello_.watchdog;
  }

  // Requests it until a name comes.
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
    if (lost_) return "the device went away before it sent its name";
    return answered ? error_of_hello(hello_, encoders_, brakes_)
                    : error_of_silence(parameters_, bytes, packets);
  }
};

}  // namespace example
