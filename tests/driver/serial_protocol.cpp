// together
// No disturbance of the line makes a message that nobody sent, and the next whole frame is always found.
#include <gtest/gtest.h>
#include <serial/serial_protocol.hpp>

#include <random>
#include <vector>

namespace serial_protocol_tests {

namespace serial = example::serial;
using bytes = std::vector<std::uint8_t>;

constexpr std::uint64_t seed = 20040627;

constexpr std::array<std::uint8_t, 9> check_text{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
static_assert(serial::crc32(check_text) == 0xCBF4'3926u);

bool same(const serial::packet& a, const serial::packet& b) {
  return a.type == b.type && a.sequence == b.sequence && a.size == b.size && a.payload == b.payload;
}

struct stream {
  std::vector<serial::packet> packets;
  int damaged = 0;
};

stream decode(const bytes& line) {
  serial::decoder d;
  stream s;
  for (const std::uint8_t b : line) {
    const auto o = d.take(b);
    if (o == serial::outcome::packet) s.packets.push_back(d.last());
    s.damaged += o == serial::outcome::damaged;
  }
  return s;
}

void append(bytes& line, const bytes& more) { line.insert(line.end(), more.begin(), more.end()); }

bytes encoded(const serial::packet& p) {
  const auto f = serial::encode(p);
  return bytes(f.content().begin(), f.content().end());
}

class random_packets {
 public:
  std::uint32_t number() {
    // Extreme values and zeros as often as others: they are what stuffing is about
    const std::array<std::uint32_t, 6> special{0, 1, 0xFF, 0x100, 0xFFFF, 0xFFFF'FFFF};
    const auto n = static_cast<std::uint32_t>(bits_());
    return n % 3 == 0 ? special[(n >> 8) % special.size()] : n;
  }
  std::uint8_t channels() { return static_cast<std::uint8_t>(1 + bits_() % serial::max_channels); }
  serial::currents currents() {
    serial::currents m;
    m.brakes = channels();
    for (std::size_t i = 0; i < m.brakes; ++i) m.current[i] = static_cast<std::uint16_t>(number());
    return m;
  }
  serial::hello hello() {
    return {serial::protocol_version,
            channels(),
            channels(),
            static_cast<std::uint16_t>(number()),
            static_cast<std::uint16_t>(number()),
            static_cast<std::uint16_t>(number())};
  }
  serial::sample sample() {
    serial::sample m;
    m.encoders = channels();
    m.time = number();
    m.state = static_cast<std::uint8_t>(number());
    m.encoder_faults = static_cast<std::uint8_t>(number());
    m.brake_faults = static_cast<std::uint8_t>(number());
    for (std::size_t i = 0; i < m.encoders; ++i) m.count[i] = static_cast<std::int32_t>(number());
    return m;
  }
  serial::packet packet() {
    switch (bits_() % 5) {
      case 0: return pack(number(), currents());
      case 1: return pack(number(), hello());
      case 2: return serial::pack(number(), serial::message_type::ask);
      case 3: return serial::pack(number(), serial::message_type::release);
      default: return pack(number(), sample());
    }
  }
  std::mt19937_64& bits() { return bits_; }

 private:
  std::mt19937_64 bits_{seed};
};

TEST(serial_protocol, messages_arrive_as_they_were_sent) {
  random_packets random;
  const auto expect_round_trip = [&](const auto& m) {
    const std::uint32_t sequence = random.number();
    const auto s = decode(encoded(pack(sequence, m)));
    ASSERT_EQ(s.packets.size(), 1u);
    EXPECT_EQ(s.packets[0].sequence, sequence);
    auto back = std::decay_t<decltype(m)>();
    ASSERT_TRUE(unpack(s.packets[0], back));
    EXPECT_TRUE(back == m);
  };
  for (int k = 0; k < 2000; ++k) {
    expect_round_trip(random.currents());
    expect_round_trip(random.hello());
    expect_round_trip(random.sample());
  }
}

TEST(serial_protocol, a_frame_has_delimiters_at_its_ends_only_and_passes_for_one_message) {
  random_packets random;
  for (int k = 0; k < 5000; ++k) {
    const serial::packet p = random.packet();
    const bytes f = encoded(p);
    ASSERT_LE(f.size(), serial::max_frame);
    for (std::size_t i = 0; i < f.size(); ++i)
      ASSERT_EQ(f[i] == 0, i == 0 || i + 1 == f.size()) << "byte " << i << " of packet " << k;
    serial::currents c;
    serial::hello h;
    serial::sample s;
    ASSERT_EQ(unpack(p, c) + unpack(p, h) + unpack(p, s) + unpack(p, serial::message_type::ask) +
                  unpack(p, serial::message_type::release),
              1);
  }
}

TEST(serial_protocol, a_content_of_another_length_is_refused) {
  using enum serial::message_type;
  for (std::size_t size = 0; size <= serial::max_payload; ++size) {
    serial::packet p;
    p.size = static_cast<std::uint8_t>(size);
    p.payload[0] = serial::protocol_version;
    const auto takes = [&](serial::message_type type, auto&& message) {
      p.type = static_cast<std::uint8_t>(type);
      return unpack(p, message);
    };
    EXPECT_EQ(takes(currents, serial::currents()), size > 0 && size % 2 == 0 && size <= 16) << size;
    EXPECT_EQ(takes(hello, serial::hello()), size == 9) << size;
    EXPECT_EQ(takes(sample, serial::sample()), size > 7 && (size - 7) % 4 == 0 && size <= 39) << size;
    EXPECT_EQ(takes(release, release), size == 0) << size;
  }
  serial::packet other_version;
  other_version.type = static_cast<std::uint8_t>(hello);
  other_version.size = 20;
  other_version.payload[0] = 7;
  serial::hello h;
  EXPECT_TRUE(unpack(other_version, h));
  EXPECT_EQ(h.version, 7);
}

// A good frame, a disturbed one, a good one: both good ones come, and of the disturbed one nothing, or
// itself.
void expect_only_the_neighbours(const serial::packet& sent, const bytes& disturbed, const std::string& what) {
  static const serial::packet before = serial::pack(1, serial::currents{2, {111, 0}});
  static const serial::packet after = serial::pack(3, serial::currents{2, {0, 333}});
  bytes line = encoded(before);
  append(line, disturbed);
  append(line, encoded(after));
  const auto s = decode(line);
  ASSERT_GE(s.packets.size(), 2u) << what;
  EXPECT_TRUE(same(s.packets.front(), before)) << what;
  EXPECT_TRUE(same(s.packets.back(), after)) << what;
  for (std::size_t i = 1; i + 1 < s.packets.size(); ++i) EXPECT_TRUE(same(s.packets[i], sent)) << what;
  EXPECT_TRUE(s.packets.size() > 2 || s.damaged > 0) << what;
}

void flip(bytes& line, std::size_t bit) {
  line[bit / 8] = static_cast<std::uint8_t>(line[bit / 8] ^ 1u << bit % 8);
}

TEST(serial_protocol, no_flip_of_one_or_two_bits_makes_a_wrong_message) {
  const serial::packet p = serial::pack(2, serial::currents{2, {5000, 0}});
  const std::size_t size = 8 * encoded(p).size();
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i; j < size; ++j) {
      bytes f = encoded(p);
      flip(f, i);
      if (j != i) flip(f, j);
      expect_only_the_neighbours(p, f, "bits " + std::to_string(i) + " and " + std::to_string(j));
    }
}

TEST(serial_protocol, a_frame_cut_anywhere_takes_no_neighbour_along) {
  random_packets random;
  for (int k = 0; k < 100; ++k) {
    const serial::packet p = random.packet();
    const bytes f = encoded(p);
    for (std::size_t n = 2; n + 1 < f.size(); ++n) {
      const auto cut = f.begin() + static_cast<std::ptrdiff_t>(n);
      expect_only_the_neighbours(p, bytes(f.begin(), cut), "its first " + std::to_string(n) + " bytes");
      expect_only_the_neighbours(p, bytes(cut, f.end()), "without its first " + std::to_string(n) + " bytes");
      bytes hole = f;
      hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(n));
      expect_only_the_neighbours(p, hole, "without byte " + std::to_string(n));
    }
  }
}

TEST(serial_protocol, garbage_is_no_message_and_the_next_frame_comes) {
  random_packets random;
  for (int k = 0; k < 5000; ++k) {
    bytes garbage(1 + random.bits()() % 100);
    // Rich in delimiters, so that much of it looks like short frames
    for (auto& b : garbage) b = random.bits()() % 8 == 0 ? 0 : static_cast<std::uint8_t>(random.bits()());
    garbage[0] = 1;
    expect_only_the_neighbours(serial::packet(), garbage, "garbage " + std::to_string(k));
    if (HasFailure()) break;
  }
  bytes endless(100'000, 1);
  endless[0] = 0;
  expect_only_the_neighbours(serial::packet(), endless, "longer than any frame");
}

TEST(serial_protocol, listening_may_begin_anywhere) {
  random_packets random;
  bytes line;
  std::vector<serial::packet> sent;
  std::vector<std::size_t> ends;
  for (int k = 0; k < 20; ++k) {
    sent.push_back(random.packet());
    ends.push_back(line.size());
    append(line, encoded(sent.back()));
  }
  for (std::size_t begin = 0; begin < line.size(); ++begin) {
    const auto s = decode(bytes(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end()));
    std::size_t first = 0;
    while (first < ends.size() && ends[first] < begin) ++first;
    ASSERT_EQ(s.packets.size(), sent.size() - first) << begin;
    for (std::size_t i = 0; i < s.packets.size(); ++i) EXPECT_TRUE(same(s.packets[i], sent[first + i]));
    EXPECT_EQ(s.damaged, 0) << begin;
  }
}

}  // namespace serial_protocol_tests
