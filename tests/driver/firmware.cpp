// together
// Whatever comes over the line, the firmware holds the limit and lets go in time. Time is the test's own.
#include <gtest/gtest.h>
#include <firmware/brake_controller.hpp>

#include <random>
#include <vector>

namespace firmware_tests {

namespace serial = example::serial;

struct board {
  std::array<std::uint16_t, serial::max_channels> current{};
  std::array<std::int32_t, serial::max_channels> count{};
  std::uint8_t bad_encoders = 0, bad_brakes = 0;
  std::uint16_t largest = 0;
  serial::decoder host;
  std::vector<serial::packet> sent;

  void set_current(std::size_t i, std::uint16_t c) {
    current[i] = c;
    largest = std::max(largest, c);
  }
  std::int32_t read_encoder(std::size_t i) { return count[i]; }
  std::uint8_t encoder_faults() { return bad_encoders; }
  std::uint8_t brake_faults() { return bad_brakes; }
  void send(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t b : bytes)
      if (host.take(b) == serial::outcome::packet) sent.push_back(host.last());
  }
  bool at_rest() const { return current == std::array<std::uint16_t, serial::max_channels>{}; }
};

constexpr firmware::settings usual{};
constexpr std::uint32_t watchdog = 1000u * usual.watchdog;  // [us]

struct device {
  board b;
  firmware::brake_controller<board> controller;
  std::uint32_t sequence = 0;

  explicit device(const firmware::settings& s = usual) : controller(b, s) {}
  void take(std::span<const std::uint8_t> bytes, std::uint32_t now) {
    for (const std::uint8_t x : bytes) controller.receive(x, now);
  }
  void take(const serial::packet& p, std::uint32_t now) { take(serial::encode(p).content(), now); }
  void brake(std::uint32_t now, serial::currents m = {2, {1000, 2000}}) { take(pack(sequence++, m), now); }
  void release(std::uint32_t now) { take(serial::pack(sequence++, serial::message_type::release), now); }
  serial::sample sampled(std::uint32_t now) {
    b.sent.clear();
    controller.tick(now);
    serial::sample m;
    EXPECT_EQ(b.sent.size(), 1u);
    EXPECT_TRUE(!b.sent.empty() && unpack(b.sent.back(), m));
    return m;
  }
};

TEST(firmware, starts_at_0_A_and_applies_currents) {
  device d;
  EXPECT_TRUE(d.b.at_rest());
  EXPECT_EQ(d.sampled(0).state, 0);
  d.brake(10);
  EXPECT_EQ(d.b.current[0], 1000);
  EXPECT_EQ(d.b.current[1], 2000);
  EXPECT_EQ(d.sampled(20).state, serial::sample::active);
}

TEST(firmware, tells_who_it_is) {
  device d({.encoders = 3, .brakes = 4, .current_limit = 77, .watchdog = 15, .period = 500});
  d.take(serial::pack(0, serial::message_type::ask), 0);
  ASSERT_EQ(d.b.sent.size(), 1u);
  serial::hello h;
  ASSERT_TRUE(unpack(d.b.sent[0], h));
  EXPECT_TRUE(h == (serial::hello{serial::protocol_version, 3, 4, 77, 15, 500}));
}

TEST(firmware, samples_tell_counts_time_and_faults_and_are_numbered) {
  device d;
  d.b.count = {-5, 2'000'000'000};
  d.b.bad_encoders = 2;
  d.b.bad_brakes = 1;
  const auto m = d.sampled(0xFFFF'FFF0);
  EXPECT_EQ(m.encoders, 2);
  EXPECT_EQ(m.time, 0xFFFF'FFF0);
  EXPECT_EQ(m.count[0], -5);
  EXPECT_EQ(m.count[1], 2'000'000'000);
  EXPECT_EQ(m.encoder_faults, 2);
  EXPECT_EQ(m.brake_faults, 1);
  const std::uint32_t first = d.b.sent.back().sequence;
  d.sampled(1000);
  EXPECT_EQ(d.b.sent.back().sequence, first + 1);
}

TEST(firmware, silence_ends_in_0_A_within_the_watchdogs_time_and_a_period) {
  for (std::uint32_t phase = 0; phase < usual.period; phase += 37) {
    for (const std::uint32_t start : {0u, 0xFFFF'FFFFu - 10'000u}) {  // also across the wrap of the clock
      device d;
      const std::uint32_t fed = start + phase;
      d.brake(fed);
      std::uint32_t t = start + usual.period;
      for (; !d.b.at_rest(); t += usual.period) {
        ASSERT_LT(t - fed, watchdog + usual.period) << "phase " << phase;
        d.controller.tick(t);
      }
      EXPECT_GE(t - usual.period - fed, watchdog) << "not before its time";
      EXPECT_EQ(d.sampled(t).state, serial::sample::tripped);
    }
  }
}

TEST(firmware, currents_in_time_keep_it_active) {
  device d;
  for (std::uint32_t t = 0; t < 1'000'000; t += usual.period) {
    if (t % (watchdog - usual.period) == 0) d.brake(t);
    d.controller.tick(t);
    ASSERT_EQ(d.controller.now_in(), firmware::state::active) << t;
  }
}

// Bytes that are no currents, often enough that a fooled watchdog would stay fed.
template <class F>
void expect_starved(F&& disturb) {
  device d;
  d.brake(0);
  for (std::uint32_t t = 0; t < 2 * watchdog; t += 100) {
    disturb(d, t);
    if (t % usual.period == 0) d.controller.tick(t);
    ASSERT_EQ(d.b.at_rest(), t >= watchdog) << t << " us";
  }
  EXPECT_EQ(d.controller.now_in(), firmware::state::tripped);
}

TEST(firmware, is_fed_by_nothing_but_whole_currents_for_its_brakes) {
  std::mt19937_64 random(20040627);
  expect_starved([&](device& d, std::uint32_t t) {
    for (int k = 0; k < 20; ++k)
      d.controller.receive(random() % 8 == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(random()), t);
  });
  auto f = serial::encode(serial::pack(1, serial::currents{2, {1000, 2000}}));
  for (std::size_t n = 0; n < f.size - 1; ++n)  // half frames
    expect_starved([&](device& d, std::uint32_t t) { d.take(f.content().first(n), t); });
  f.byte[f.size - 3] ^= 0x55;  // in its checksum
  expect_starved([&](device& d, std::uint32_t t) { d.take(f.content(), t); });
  serial::packet unknown;
  unknown.type = 0x7F;
  for (const serial::packet& p :
       {serial::pack(1, serial::currents{3, {1, 2, 3}}), serial::pack(1, serial::currents{1, {1}}),
        serial::pack(1, serial::message_type::ask), pack(1, serial::sample{.encoders = 2}), unknown})
    expect_starved([&](device& d, std::uint32_t t) { d.take(p, t); });
}

TEST(firmware, stays_tripped_until_a_release_and_then_currents) {
  device d;
  d.brake(0);
  d.brake(watchdog);
  EXPECT_EQ(d.controller.now_in(), firmware::state::tripped) << "also before the next tick";
  for (std::uint32_t t = watchdog; t < 10 * watchdog; t += 1000) {
    d.brake(t);
    d.controller.tick(t);
    ASSERT_TRUE(d.b.at_rest()) << t;
  }
  d.release(10 * watchdog);
  EXPECT_TRUE(d.b.at_rest());
  EXPECT_EQ(d.sampled(10 * watchdog).state, 0);
  d.brake(10 * watchdog + 5);
  EXPECT_EQ(d.b.current[1], 2000);
}

TEST(firmware, a_release_lets_go_at_once_and_does_not_trip) {
  device d;
  d.brake(0);
  d.release(10);
  EXPECT_TRUE(d.b.at_rest());
  for (std::uint32_t t = 0; t < 10 * watchdog; t += 1000) EXPECT_EQ(d.sampled(t).state, 0);
  d.release(10 * watchdog);
  EXPECT_TRUE(d.b.at_rest());
}

TEST(firmware, cuts_currents_at_its_limit_and_says_so) {
  device d;
  d.brake(0, {2, {usual.current_limit + 1, 0xFFFF}});
  EXPECT_EQ(d.b.current[0], usual.current_limit);
  EXPECT_EQ(d.b.current[1], usual.current_limit);
  EXPECT_EQ(d.sampled(0).state, serial::sample::active | serial::sample::limited);
  d.brake(1, {2, {usual.current_limit, 0}});
  EXPECT_EQ(d.sampled(1).state, serial::sample::active);
}

TEST(firmware, holds_limit_and_watchdog_under_any_stream) {
  std::mt19937_64 random(20040627);
  device d;
  std::uint32_t t = 0xFFF0'0000, last_sent = t;
  int applied = 0, trips = 0;
  for (int k = 0; k < 100'000; ++k) {
    t += static_cast<std::uint32_t>(random() % (random() % 50 == 0 ? 30'000 : 700));
    const auto before = d.controller.now_in();
    switch (random() % 6) {
      case 0:
        d.brake(t, {2, {static_cast<std::uint16_t>(random()), static_cast<std::uint16_t>(random())}});
        last_sent = t;
        break;
      case 1:
        if (random() % 20 == 0) d.release(t);
        else d.controller.tick(t);
        break;
      case 2: d.controller.receive(static_cast<std::uint8_t>(random() % 4), t); break;
      default: d.controller.tick(t);
    }
    const auto after = d.controller.now_in();
    ASSERT_TRUE(d.b.at_rest() || after == firmware::state::active);
    ASSERT_TRUE(d.b.at_rest() || t - last_sent < watchdog);
    applied += !d.b.at_rest();
    trips += before == firmware::state::active && after == firmware::state::tripped;
    d.b.sent.clear();
  }
  EXPECT_LE(d.b.largest, usual.current_limit);
  EXPECT_GT(applied, 300);
  EXPECT_GT(trips, 30);
}

}  // namespace firmware_tests
