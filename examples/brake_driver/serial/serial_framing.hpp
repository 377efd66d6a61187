/// Frames on a serial line: a checksum, and unique delimiters. Shared by host and firmware; needs no heap,
/// exceptions or operating system. Specified in docs/guide/ports.md.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace example::serial {

inline constexpr std::size_t max_payload = 48;   ///< [bytes]
inline constexpr std::size_t header_size = 5;    ///< Type and sequence [bytes].
inline constexpr std::size_t checksum_size = 4;  ///< [bytes]
inline constexpr std::size_t max_body = header_size + max_payload + checksum_size;  ///< [bytes]
inline constexpr std::size_t max_frame =
    max_body + 3;  ///< A delimiter, one byte of COBS, a delimiter [bytes].
static_assert(max_body < 254, "COBS then needs one byte more, for any content");

/// CRC-32 of IEEE 802.3: polynomial 0x04C11DB7, reflected, initial value and final inversion 0xFFFFFFFF.
/// "123456789" gives 0xCBF43926.
constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  // Four bits at a time: 64 bytes of table suit a microcontroller.
  constexpr auto table = [] {
    std::array<std::uint32_t, 16> t{};
    for (std::uint32_t i = 0; i < t.size(); ++i) {
      t[i] = i;
      for (int k = 0; k < 4; ++k) t[i] = (t[i] >> 1) ^ ((t[i] & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return t;
  }();
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const std::uint8_t b : bytes) {
    crc = (crc >> 4) ^ table[(crc ^ b) & 15u];
    crc = (crc >> 4) ^ table[(crc ^ (std::uint32_t{b} >> 4)) & 15u];
  }
  return ~crc;
}

/// Appends little-endian integers to bytes; drops what does not fit.
class byte_writer {
 public:
  constexpr explicit byte_writer(std::span<std::uint8_t> to) : to_(to) {}
  /// Appends the lowest `bytes` bytes of a value.
  constexpr void put(std::uint32_t value, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes && size_ < to_.size(); ++i)
      to_[size_++] = static_cast<std::uint8_t>(value >> (8 * i));
  }
  /// Written so far [bytes].
  constexpr std::size_t size() const { return size_; }

 private:
  std::span<std::uint8_t> to_;
  std::size_t size_ = 0;
};

/// Reads little-endian integers from bytes; 0 after their end.
class byte_reader {
 public:
  constexpr explicit byte_reader(std::span<const std::uint8_t> from) : from_(from) {}
  /// The next `bytes` bytes.
  constexpr std::uint32_t get(std::size_t bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes && at_ < from_.size(); ++i)
      value |= std::uint32_t{from_[at_++]} << (8 * i);
    return value;
  }

 private:
  std::span<const std::uint8_t> from_;
  std::size_t at_ = 0;
};

/// Content of a frame.
struct packet {
  std::uint8_t type = 0;       ///< See message_type.
  std::uint32_t sequence = 0;  ///< Incremented with each packet of a sender, modulo 2^32.
  std::uint8_t size = 0;       ///< Size of the payload [bytes], at most max_payload.
  std::array<std::uint8_t, max_payload> payload{};  ///< The first `size` bytes are used.

  constexpr std::span<const std::uint8_t> content() const { return std::span(payload).first(size); }
};

/// A packet as sent.
struct frame {
  std::array<std::uint8_t, max_frame> byte{};  ///< The first `size` bytes are used.
  std::size_t size = 0;                        ///< [bytes]

  constexpr std::span<const std::uint8_t> content() const { return std::span(byte).first(size); }
};

/// 0x00, COBS(type, sequence, payload, CRC-32), 0x00. The first delimiter separates it from preceding noise
/// or an incomplete frame.
constexpr frame encode(const packet& p) {
  std::array<std::uint8_t, max_body> body{};
  byte_writer out(body);
  out.put(p.type, 1);
  out.put(p.sequence, 4);
  for (const std::uint8_t b : p.content()) out.put(b, 1);
  out.put(crc32(std::span<const std::uint8_t>(body).first(out.size())), checksum_size);

  frame f;
  std::size_t code = 1;  // place of the distance to the next 0 of the body
  f.size = 2;
  for (const std::uint8_t b : std::span(body).first(out.size())) {
    if (b == 0) {
      f.byte[code] = static_cast<std::uint8_t>(f.size - code);
      code = f.size;
    } else {
      f.byte[f.size] = b;
    }
    ++f.size;
  }
  f.byte[code] = static_cast<std::uint8_t>(f.size - code);
  ++f.size;  // the delimiter
  return f;
}

enum class outcome : std::uint8_t {
  nothing,  ///< No frame ended.
  packet,   ///< A complete packet: decoder::last().
  damaged,  ///< Invalid data between two delimiters.
};

/// Finds packets in a stream of bytes that may start and be damaged anywhere; resynchronises at the next
/// delimiter.
class decoder {
 public:
  /// Processes the next byte in constant time; a delimiter takes time proportional to the frame.
  constexpr outcome take(std::uint8_t b) {
    if (b == 0) {
      const std::size_t size = size_;
      size_ = 0;
      const bool whole = synchronised_;
      synchronised_ = true;
      // Before the first delimiter there may be the rest of an earlier frame, which is no damage.
      return !whole || size == 0 ? outcome::nothing : finish(size) ? outcome::packet : outcome::damaged;
    }
    if (size_ < stuffed_.size()) stuffed_[size_] = b;
    if (size_ <= stuffed_.size()) ++size_;  // one more than fits: too long
    return outcome::nothing;
  }

  constexpr const packet& last() const { return last_; }

 private:
  std::array<std::uint8_t, max_body + 1> stuffed_{};
  std::size_t size_ = 0;
  bool synchronised_ = false;
  packet last_;

  constexpr bool finish(std::size_t size) {
    if (size > stuffed_.size()) return false;
    std::array<std::uint8_t, max_body + 1> body{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < size;) {
      const std::size_t next = i + stuffed_[i];
      if (next > size) return false;
      for (++i; i < next; ++i) body[n++] = stuffed_[i];
      if (i < size) body[n++] = 0;
    }
    if (n < header_size + checksum_size || n > max_body) return false;
    const auto checked = std::span<const std::uint8_t>(body).first(n - checksum_size);
    if (byte_reader(std::span<const std::uint8_t>(body).subspan(checked.size())).get(4) != crc32(checked))
      return false;
    byte_reader in(checked);
    last_ = {};
    last_.type = static_cast<std::uint8_t>(in.get(1));
    last_.sequence = in.get(4);
    last_.size = static_cast<std::uint8_t>(checked.size() - header_size);
    for (std::size_t i = 0; i < last_.size; ++i) last_.payload[i] = checked[header_size + i];
    return true;
  }
};

}  // namespace example::serial
