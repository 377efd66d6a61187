/// @file
/// What a driver requires of hardware: a port to brakes and encoders, and a force sensor.
#pragma once

#include <passive_haptics/core/explain.hpp>
#include <passive_haptics/core/text.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>

namespace passive_haptics {

/// How a transfer ended.
enum class port_status {
  ok,          ///< A new sample was read; the currents were handed to the device.
  no_sample,   ///< Nothing new came. For a while the last good sample stands in.
  bad_sample,  ///< What came is damaged: cut off, a wrong checksum or length. The last good one stands in.
  failed,      ///< The device is gone or refuses; no further transfer can be expected.
};

/// The status in words.
constexpr std::string_view to_string(port_status s) {
  return detail::word_of(s, {"ok", "no new sample", "damaged sample", "device lost", "unknown port status"});
}

/// One reading of N channels: encoders [counts] or force channels [N or N m, in the sensor's frame].
template <int N>
struct port_sample {
  static constexpr auto channels = static_cast<std::size_t>(N);  ///< N
  double time = 0;                       ///< When it was taken [s], CLOCK_MONOTONIC (device_clock).
  std::uint32_t sequence = 0;            ///< One more with each sample that the device takes, modulo 2^32.
  std::array<double, channels> value{};  ///< As the device reports them; counts need not be whole.
  /// False where the device itself says that a channel is not to be trusted.
  std::array<bool, channels> valid{};
};

/// An array with one number for each of N channels or brakes.
template <int N>
constexpr std::array<double, static_cast<std::size_t>(N)> same_for_each(double value) {
  std::array<double, static_cast<std::size_t>(N)> all{};
  all.fill(value);
  return all;
}

/// Currents for N brakes [A], each >= 0.
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

/// The requirements of BrakePort, one message for each: `static_assert(is_port<P, explain>())`.
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

/// The way to the brakes and encoders of a device. A minimal one has
///
///     static constexpr int encoder_count, brake_count;
///     std::string open();
///     port_status read(port_sample<encoder_count>&) noexcept;
///     port_status write(const brake_currents<brake_count>&) noexcept;
///     void release() noexcept;
///
///   - open: called once, before the loop. Empty if the device is ready. Else it says what is missing, by
///     name, and what to do; then nothing but release() is called.
///   - read: the latest sample. Returns at once, whether there is a new one or not. The sample counts only
///     with ok. If the port itself dates it, then after the counts were latched: a pause in between is then
///     seen, and with it that a counter may have wrapped (wrap_time).
///   - write: hands over currents in [0, limit], already checked. Returns at once.
///   - release: 0 A on all brakes, as fast as the device can. It may be called at any time, also before
///     open(), twice and after a failure; the destructor calls it. A port that is still there can be written
///     to again.
///
/// Once it is open, a port whose counters wrap also has `int counter_bits() const noexcept`, their width; and
/// one to a device that lets go by itself where nobody writes any more has `double watchdog() const
/// noexcept`, after how long [s].
///
/// Laws: read, write and release neither allocate, throw, lock nor wait. Where the kernel or a bus may make
/// them wait, they are called by a thread: threaded_port<P> keeps the law for any P. A second P may be open
/// to the same device in another process, of which only open(), write() and release() are called
/// (supervisor).
template <class P>
concept BrakePort = is_port<P>();

/// Width of the counters behind a port [bits]; 0 where they never wrap.
template <BrakePort P>
constexpr int counter_bits(const P& port) noexcept {
  if constexpr (requires { port.counter_bits(); }) return port.counter_bits();
  else return 0;
}

/// How long a device behind a port holds without being written to [s]; 0 where it does so for ever.
template <BrakePort P>
constexpr double watchdog(const P& port) noexcept {
  if constexpr (requires { port.watchdog(); }) return port.watchdog();
  else return 0;
}

/// The requirements of ForceSensor in a message: `static_assert(is_force_sensor<S, explain>())`.
template <class S, bool Explain = false>
consteval bool is_force_sensor() {
  if constexpr (!detail::opens<S> || !detail::reads_forces<S>)
    static_assert(!Explain,
                  "passive_haptics: a force sensor needs `static constexpr int channel_count`, `std::string "
                  "open()` and `port_status read(port_sample<channel_count>&) noexcept`.");
  else return true;
  return Explain;
}

/// A force (and torque) sensor between last link and handle: `channel_count`, and open and read as of a
/// BrakePort.
template <class S>
concept ForceSensor = is_force_sensor<S>();

/// For a device without a force sensor.
struct no_force_sensor {
  static constexpr int channel_count = 0;  ///< None.
  /// Nothing is missing.
  std::string open() { return {}; }
  /// Always good.
  port_status read(port_sample<0>&) noexcept { return port_status::ok; }
};

}  // namespace passive_haptics
