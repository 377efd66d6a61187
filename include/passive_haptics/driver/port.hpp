/// Hardware interface of a driver: a port to brakes and encoders, and a force sensor.
#pragma once

#include <passive_haptics/core/explain.hpp>
#include <passive_haptics/core/text.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>

namespace passive_haptics {

/// Result of a transfer.
enum class port_status {
  ok,          ///< A new sample was read; the currents were passed to the device.
  no_sample,   ///< No new sample. The last good one remains valid for a while.
  bad_sample,  ///< A damaged sample: incomplete, wrong checksum or length. The last good one remains valid
               ///< for a while.
  failed,      ///< The device is gone or rejects all transfers.
};

/// Text of a status.
constexpr std::string_view to_string(port_status s) {
  return detail::word_of(s, {"ok", "no new sample", "damaged sample", "device lost", "unknown port status"});
}

/// One reading of N channels: encoders [counts] or force channels [N or N m, in the sensor's frame].
template <int N>
struct port_sample {
  static constexpr auto channels = static_cast<std::size_t>(N);  ///< N
  double time = 0;                       ///< Sampling time [s], CLOCK_MONOTONIC (device_clock).
  std::uint32_t sequence = 0;            ///< Incremented with each sample by the device, modulo 2^32.
  std::array<double, channels> value{};  ///< As reported by the device; counts may be fractional.
  std::array<bool, channels> valid{};    ///< False for channels that the device reports as invalid.
};

/// An array with this value for each of N channels or brakes.
template <int N>
constexpr std::array<double, static_cast<std::size_t>(N)> same_for_each(double value) {
  std::array<double, static_cast<std::size_t>(N)> all{};
  all.fill(value);
  return all;
}

/// Currents of N brakes [A], each >= 0.
template <int N>
using brake_currents = std::array<double, static_cast<std::size_t>(N)>;

namespace detail {
template <class P>
concept names_port_sizes = requires {
  requires(std::integral_constant<int, P::encoder_count>::value >= 0);
  requires(std::integral_constant<int, P::brake_count>::value >= 0);
};
template <class P>
concept opens = requires(P port) {
  { port.open() } -> std::same_as<std::string>;
};
template <class P>
concept reads_encoders = requires(P port, port_sample<P::encoder_count>& sample) {
  { port.read(sample) } noexcept -> std::same_as<port_status>;
};
template <class P>
concept writes_currents = requires(P port, const brake_currents<P::brake_count>& currents) {
  { port.write(currents) } noexcept -> std::same_as<port_status>;
};
template <class P>
concept releases = requires(P port) {
  { port.release() } noexcept;
};
template <class S>
concept reads_forces = requires(S sensor, port_sample<S::channel_count>& sample) {
  { sensor.read(sample) } noexcept -> std::same_as<port_status>;
};
}  // namespace detail

/// Requirements of BrakePort, one message for each: `static_assert(is_port<P, explain>())`.
template <class P, bool Explain = false>
consteval bool is_port() {
  if constexpr (!detail::names_port_sizes<P>)
    static_assert(
        !Explain,
        "passive_haptics: a port needs `static constexpr int encoder_count, brake_count`, each >= 0.");
  else if constexpr (!detail::opens<P>)
    static_assert(!Explain, "passive_haptics: a port needs `std::string open()`.");
  else if constexpr (!detail::reads_encoders<P>)
    static_assert(!Explain,
                  "passive_haptics: a port needs `port_status read(port_sample<encoder_count>&) noexcept`.");
  else if constexpr (!detail::writes_currents<P>)
    static_assert(
        !Explain,
        "passive_haptics: a port needs `port_status write(const brake_currents<brake_count>&) noexcept`.");
  else if constexpr (!detail::releases<P>)
    static_assert(!Explain, "passive_haptics: a port needs `void release() noexcept`.");
  else return true;
  return Explain;
}

/// Access to the brakes and encoders of a device. Minimal complete definition:
///
///     static constexpr int encoder_count, brake_count;
///     std::string open();
///     port_status read(port_sample<encoder_count>&) noexcept;
///     port_status write(const brake_currents<brake_count>&) noexcept;
///     void release() noexcept;
///
///   - open: called once, before the loop. Returns an empty string if the device is ready, else what is
///     missing and what to do; then only release() is called.
///   - read: the latest sample, which counts only with status ok. Returns immediately. A port that dates the
///     sample itself must do so after latching the counts, so that a pause, in which a counter may have
///     wrapped (wrap_time), is detected.
///   - write: passes checked currents in [0, limit] to the device. Returns immediately.
///   - release: 0 A on all brakes, as fast as possible. May be called at any time, also before open(), twice
///     and after a failure; the destructor calls it. A port that still works can be written to again.
///
/// Optional, once open: `int counter_bits() const noexcept`, the width of counters that wrap, and `double
/// watchdog() const noexcept`, the time [s] after which the device releases the brakes without writes.
///
/// Laws: read, write and release neither allocate, throw, lock nor wait; if the kernel or a bus may make them
/// wait, use threaded_port<P>. A second P may be open in another process, for open(), write() and release()
/// (supervisor).
template <class P>
concept BrakePort = is_port<P>();

/// Width of the counters of a port [bits]; 0 if they never wrap.
template <BrakePort P>
constexpr int counter_bits(const P& port) noexcept {
  if constexpr (requires { port.counter_bits(); }) return port.counter_bits();
  else return 0;
}

/// Time for which the device holds without writes [s]; 0 for indefinitely.
template <BrakePort P>
constexpr double watchdog(const P& port) noexcept {
  if constexpr (requires { port.watchdog(); }) return port.watchdog();
  else return 0;
}

/// Requirements of ForceSensor in a message: `static_assert(is_force_sensor<S, explain>())`.
template <class S, bool Explain = false>
consteval bool is_force_sensor() {
  if constexpr (!detail::opens<S> || !detail::reads_forces<S>)
    static_assert(!Explain,
                  "passive_haptics: a force sensor needs `static constexpr int channel_count`, `std::string "
                  "open()` and `port_status read(port_sample<channel_count>&) noexcept`.");
  else return true;
  return Explain;
}

/// A force (and torque) sensor between last link and handle: `channel_count`, open and read as BrakePort.
template <class S>
concept ForceSensor = is_force_sensor<S>();

/// For devices without a force sensor.
struct no_force_sensor {
  static constexpr int channel_count = 0;                                 ///< None.
  std::string open() { return {}; }                                       ///< Always succeeds.
  port_status read(port_sample<0>&) noexcept { return port_status::ok; }  ///< Always ok.
};

}  // namespace passive_haptics
