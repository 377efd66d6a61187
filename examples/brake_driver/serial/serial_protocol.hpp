/// Messages between a host and a brake controller on a serial line, in frames of serial_framing.hpp.
/// Specified in docs/guide/ports.md.
#pragma once

#include <serial/serial_framing.hpp>

namespace example::serial {

inline constexpr std::uint8_t protocol_version = 1;
inline constexpr std::size_t max_channels = 8;        ///< Maximum brakes and encoders of a device.
inline constexpr double current_unit = 1e-4;          ///< Unit of currents [A].
inline constexpr std::uint16_t max_current = 0xFFFF;  ///< Maximum in a message [current_unit].

/// First byte of a packet; the high bit marks the device.
enum class message_type : std::uint8_t {
  ask = 0x01,       ///< Host: requests the hello. No content.
  currents = 0x02,  ///< Host: currents until further notice or the watchdog.
  release = 0x03,   ///< Host: 0 A. No content.
  hello = 0x81,     ///< Device: answer to `ask`.
  sample = 0x82,    ///< Device: encoders and state, once per period.
};

struct currents {
  std::uint8_t brakes = 0;                            ///< Number of currents.
  std::array<std::uint16_t, max_channels> current{};  ///< [current_unit]
  bool operator==(const currents&) const = default;
};

/// Properties of a device.
struct hello {
  std::uint8_t version = protocol_version;  ///< First in all versions of this message.
  std::uint8_t encoders = 0;                ///< How many.
  std::uint8_t brakes = 0;                  ///< How many.
  std::uint16_t current_limit = 0;          ///< Limit of currents [current_unit].
  std::uint16_t watchdog = 0;               ///< Time without currents until 0 A [ms].
  std::uint16_t period = 0;                 ///< Period of samples [us].
  bool operator==(const hello&) const = default;
};

/// Encoders and state.
struct sample {
  static constexpr std::uint8_t active = 1;   ///< In `state`: currents are applied; else 0 A.
  static constexpr std::uint8_t tripped = 2;  ///< In `state`: the watchdog tripped, without a release since.
  static constexpr std::uint8_t limited = 4;  ///< In `state`: the last currents were limited.

  std::uint8_t encoders = 0;        ///< Number of encoders.
  std::uint32_t time = 0;           ///< Latching time of the counts, device clock, modulo 2^32 [us].
  std::uint8_t state = 0;           ///< The bits above.
  std::uint8_t encoder_faults = 0;  ///< Bit i: counts of encoder i are invalid.
  std::uint8_t brake_faults = 0;    ///< Bit i: brake i does not receive its current.
  std::array<std::int32_t, max_channels> count{};  ///< Modulo 2^32.
  bool operator==(const sample&) const = default;
};

namespace detail {
inline constexpr std::size_t hello_size = 9, sample_head = 7;

constexpr packet packed(message_type type, std::uint32_t sequence) {
  packet p;
  p.type = static_cast<std::uint8_t>(type);
  p.sequence = sequence;
  return p;
}
constexpr bool is(const packet& p, message_type type) { return p.type == static_cast<std::uint8_t>(type); }
// Number of values of `bytes` bytes after `head` bytes; 0 for a fraction.
constexpr std::uint8_t values(const packet& p, std::size_t head, std::size_t bytes) {
  const bool whole = p.size > head && (p.size - head) % bytes == 0 && (p.size - head) / bytes <= max_channels;
  return whole ? static_cast<std::uint8_t>((p.size - head) / bytes) : std::uint8_t{0};
}
}  // namespace detail

/// A message without content: `ask` or `release`.
constexpr packet pack(std::uint32_t sequence, message_type type) { return detail::packed(type, sequence); }

constexpr packet pack(std::uint32_t sequence, const currents& m) {
  packet p = detail::packed(message_type::currents, sequence);
  byte_writer out(p.payload);
  for (std::size_t i = 0; i < m.brakes && i < max_channels; ++i) out.put(m.current[i], 2);
  p.size = static_cast<std::uint8_t>(out.size());
  return p;
}

constexpr packet pack(std::uint32_t sequence, const hello& m) {
  packet p = detail::packed(message_type::hello, sequence);
  byte_writer out(p.payload);
  out.put(m.version, 1);
  out.put(m.encoders, 1);
  out.put(m.brakes, 1);
  out.put(m.current_limit, 2);
  out.put(m.watchdog, 2);
  out.put(m.period, 2);
  p.size = static_cast<std::uint8_t>(out.size());
  return p;
}

constexpr packet pack(std::uint32_t sequence, const sample& m) {
  packet p = detail::packed(message_type::sample, sequence);
  byte_writer out(p.payload);
  out.put(m.time, 4);
  out.put(m.state, 1);
  out.put(m.encoder_faults, 1);
  out.put(m.brake_faults, 1);
  for (std::size_t i = 0; i < m.encoders && i < max_channels; ++i)
    out.put(static_cast<std::uint32_t>(m.count[i]), 4);
  p.size = static_cast<std::uint8_t>(out.size());
  return p;
}

/// True for this message without content.
constexpr bool unpack(const packet& p, message_type type) { return detail::is(p, type) && p.size == 0; }

/// Decodes currents; false for other messages.
constexpr bool unpack(const packet& p, currents& m) {
  const std::uint8_t n = detail::values(p, 0, 2);
  if (!detail::is(p, message_type::currents) || n == 0) return false;
  m = {};
  m.brakes = n;
  byte_reader in(p.content());
  for (std::size_t i = 0; i < n; ++i) m.current[i] = static_cast<std::uint16_t>(in.get(2));
  return true;
}

/// Decodes a hello; only the version if that differs. False for other messages.
constexpr bool unpack(const packet& p, hello& m) {
  if (!detail::is(p, message_type::hello) || p.size == 0) return false;
  byte_reader in(p.content());
  m = {};
  m.version = static_cast<std::uint8_t>(in.get(1));
  if (m.version != protocol_version) return true;
  m.encoders = static_cast<std::uint8_t>(in.get(1));
  m.brakes = static_cast<std::uint8_t>(in.get(1));
  m.current_limit = static_cast<std::uint16_t>(in.get(2));
  m.watchdog = static_cast<std::uint16_t>(in.get(2));
  m.period = static_cast<std::uint16_t>(in.get(2));
  return p.size == detail::hello_size;
}

/// Decodes a sample; false for other messages.
constexpr bool unpack(const packet& p, sample& m) {
  const std::uint8_t n = detail::values(p, detail::sample_head, 4);
  if (!detail::is(p, message_type::sample) || n == 0) return false;
  m = {};
  m.encoders = n;
  byte_reader in(p.content());
  m.time = in.get(4);
  m.state = static_cast<std::uint8_t>(in.get(1));
  m.encoder_faults = static_cast<std::uint8_t>(in.get(1));
  m.brake_faults = static_cast<std::uint8_t>(in.get(1));
  for (std::size_t i = 0; i < n; ++i) m.count[i] = static_cast<std::int32_t>(in.get(4));
  return true;
}

}  // namespace example::serial
