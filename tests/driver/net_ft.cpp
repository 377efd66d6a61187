// together
// A force sensor over the loopback interface, with all that a network does to datagrams.
#include "eventually.hpp"
#include "loopback_socket.hpp"

#include <gtest/gtest.h>
#include <ports/net_ft.hpp>

#include <limits>
#include <memory>
#include <vector>

namespace net_ft_tests {

namespace ph = passive_haptics;
using example::net_ft;
using ph::port_status;
using bytes = std::vector<std::uint8_t>;
using reading = ph::port_sample<6>;

static_assert(ph::ForceSensor<net_ft>);

bytes record(std::uint32_t sequence, std::uint32_t status = 0,
             const std::array<std::int32_t, 6>& counts = {1'000'000, -2'000'000, 3, 4, 500'000, -6}) {
  bytes b;
  const auto put = [&](std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) b.push_back(static_cast<std::uint8_t>(word >> shift));
  };
  put(sequence);
  put(7 * sequence);
  put(status);
  for (const std::int32_t c : counts) put(static_cast<std::uint32_t>(c));
  return b;
}

// A sensor that sends when the test says so.
struct sensor : loopback_socket {
  using loopback_socket::loopback_socket;

  // Notes the requests that came, and who asks.
  void hear() {
    std::array<std::uint8_t, 64> buffer;
    for (ssize_t n; (n = receive(buffer.data(), buffer.size())) >= 0;)
      requests.emplace_back(buffer.begin(), buffer.begin() + n);
  }
  void send(const bytes& b) { send(b, peer()); }
  void send(const bytes& b, const sockaddr_in& to) {
    EXPECT_EQ(loopback_socket::send(b.data(), b.size(), to), static_cast<ssize_t>(b.size()));
  }

  std::vector<bytes> requests;
};

const bytes start{0x12, 0x34, 0, 2, 0, 0, 0, 0}, stop{0x12, 0x34, 0, 0, 0, 0, 0, 0};

example::net_ft_parameters at(int port, double timeout = 20) {
  example::net_ft_parameters p;
  p.host = "127.0.0.1";
  p.port = port;
  p.counts_per_torque = 500'000;
  p.open_timeout = timeout;
  p.silence = 0.02;
  return p;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

template <class F>
std::string open_beside(net_ft& host, F&& f) {
  return beside(f, [&] { return host.open(); });
}

std::string open_at(net_ft& host, sensor& peer) {
  return open_beside(host, [&] {
    peer.hear();
    if (!peer.requests.empty()) peer.send(record(0));
  });
}

// A sensor and its open reader, which has read all.
struct connected {
  sensor peer;
  net_ft host;
  reading last;

  connected() : host(at(peer.port())) {
    EXPECT_EQ(open_at(host, peer), "");
    while (host.read(last) == port_status::ok) {
    }
  }
  // Datagrams over loopback are there when send returns.
  port_status read_of(const std::vector<bytes>& datagrams) {
    for (const bytes& d : datagrams) peer.send(d);
    return host.read(last);
  }
};

TEST(net_ft, parameters_are_checked_by_name) {
  const auto error = [](auto&& change) {
    auto p = at(1);
    change(p);
    return validate(p);
  };
  EXPECT_EQ(error([](auto&) {}), "");
  EXPECT_EQ(error([](auto& p) { p.port = 0; }), "port = 0: expected 1 to 65535");
  EXPECT_TRUE(has(error([](auto& p) { p.counts_per_force = 0; }), "counts_per_force [1/N] = 0"));
  EXPECT_TRUE(has(error([](auto& p) { p.silence = -1; }), "silence [s] = -1"));
  EXPECT_TRUE(has(error([](auto& p) { p.host = ""; }), "host"));
  EXPECT_THROW(net_ft{at(0)}, std::invalid_argument);
}

TEST(net_ft, asks_for_records_without_end_and_to_stop_when_it_goes) {
  sensor peer;
  {
    net_ft host(at(peer.port()));
    EXPECT_EQ(open_at(host, peer), "");
    EXPECT_EQ(peer.requests[0], start);
  }
  EXPECT_TRUE(eventually([&] {
    peer.hear();
    return peer.requests.back() == stop;
  }));
}

TEST(net_ft, a_name_that_nobody_knows_is_named) {
  auto p = at(1);
  p.host = "no such host";
  net_ft host(p);
  reading r;
  EXPECT_EQ(host.read(r), port_status::failed) << "before it is open";
  EXPECT_TRUE(has(host.open(), "force sensor no such host:1: the name cannot be looked up"));
}

TEST(net_ft, silence_refusal_and_somebody_else_are_told_apart) {
  sensor peer;
  net_ft silent(at(peer.port(), 0.2));
  EXPECT_TRUE(has(silent.open(), "no record in 200 ms; check its power and cable"));
  peer.hear();
  EXPECT_GE(peer.requests.size(), 1u);
  EXPECT_LE(peer.requests.size(), 3u) << "asks now and then, not in a loop";

  net_ft other(at(peer.port(), 0.3));
  EXPECT_TRUE(has(open_beside(other,
                              [&] {
                                peer.hear();
                                peer.send({1, 2, 3});
                              }),
                  "the host sends no RDT records"));

  const int free_port = sensor().port();
  EXPECT_TRUE(has(net_ft(at(free_port, 0.2)).open(), "the host rejects the port"));
}

TEST(net_ft, reads_forces_and_torques_in_their_units) {
  connected c;
  const double before = ph::monotonic_seconds();
  EXPECT_EQ(c.read_of({record(41, 0, {1'500'000, -2'000'000, 0, 500'000, -1'000'000, 1})}), port_status::ok);
  EXPECT_EQ(c.last.value, (std::array<double, 6>{1.5, -2, 0, 1, -2, 2e-6}));
  EXPECT_EQ(c.last.valid, (std::array<bool, 6>{true, true, true, true, true, true}));
  EXPECT_EQ(c.last.sequence, 41u);
  EXPECT_GE(c.last.time, before);
  EXPECT_LE(c.last.time, ph::monotonic_seconds());
  constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min(),
                         high = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(c.read_of({record(42, 0, {low, high, -1, 0, 1, -2})}), port_status::ok);
  EXPECT_EQ(c.last.value, (std::array<double, 6>{low / 1e6, high / 1e6, -1e-6, 0, 2e-6, -4e-6}));
}

TEST(net_ft, the_newest_of_all_that_came_counts_also_when_they_overtake_each_other) {
  connected c;
  EXPECT_EQ(c.read_of({record(1), record(2), record(3)}), port_status::ok);
  EXPECT_EQ(c.last.sequence, 3u);
  EXPECT_EQ(c.host.read(c.last), port_status::no_sample);
  EXPECT_EQ(c.read_of({record(4), record(6), record(5)}), port_status::ok);
  EXPECT_EQ(c.last.sequence, 6u);
  EXPECT_EQ(c.read_of({record(0xFFFF'FFFF), record(0), record(0xFFFF'FFFE)}), port_status::ok);
  EXPECT_EQ(c.last.sequence, 0u) << "across the wrap";
  EXPECT_EQ(c.read_of({record(0xFFFF'FFFF)}), port_status::ok);
  EXPECT_EQ(c.last.sequence, 0xFFFF'FFFF) << "late, and told so";
}

TEST(net_ft, datagrams_of_another_length_are_bad_samples) {
  connected c;
  for (std::size_t size = 0; size <= 80; ++size) {
    if (size == 36) continue;
    bytes b = record(9);
    b.resize(size);
    EXPECT_EQ(c.read_of({b}), port_status::bad_sample) << size;
  }
  EXPECT_EQ(c.read_of({bytes(1400, 0xAB), record(2), {1}}), port_status::ok) << "a good one came with them";
  EXPECT_EQ(c.last.sequence, 2u);
}

TEST(net_ft, any_bit_of_the_status_but_the_latched_threshold_invalidates_all_channels) {
  connected c;
  std::uint32_t sequence = 1;
  for (int bit = 0; bit < 32; ++bit) {
    for (const std::uint32_t summary : {0u, 0x8000'0000u}) {
      EXPECT_EQ(c.read_of({record(++sequence, 1u << bit | summary)}), port_status::ok);
      for (const bool valid : c.last.valid) EXPECT_EQ(valid, bit == 16) << "bit " << bit;
      EXPECT_EQ(c.host.status(), 1u << bit | summary);
    }
  }
  EXPECT_EQ(c.read_of({record(++sequence, 0x8003'0000u)}), port_status::ok);
  EXPECT_FALSE(c.last.valid[0]) << "latched threshold and saturation";
  EXPECT_EQ(c.read_of({record(++sequence)}), port_status::ok);
  EXPECT_TRUE(c.last.valid[0]);
}

TEST(net_ft, a_sensor_that_fell_silent_is_asked_again_and_comes_back) {
  connected c;
  c.peer.requests.clear();
  EXPECT_TRUE(eventually([&] {
    EXPECT_EQ(c.host.read(c.last), port_status::no_sample);
    c.peer.hear();
    return !c.peer.requests.empty();
  }));
  EXPECT_EQ(c.peer.requests[0], start);
  EXPECT_EQ(c.read_of({record(5)}), port_status::ok);
}

TEST(net_ft, a_sensor_that_was_switched_off_and_on_is_found_again) {
  std::unique_ptr<sensor> peer = std::make_unique<sensor>();
  const int port = peer->port();
  net_ft host(at(port));
  EXPECT_EQ(open_at(host, *peer), "");
  peer.reset();
  reading r;
  // Its host answers now that nobody listens
  const double end = ph::monotonic_seconds() + 0.1;
  while (ph::monotonic_seconds() < end) EXPECT_NE(host.read(r), port_status::failed);
  peer = std::make_unique<sensor>(port);
  EXPECT_TRUE(eventually([&] {
    peer->hear();
    if (!peer->requests.empty()) peer->send(record(0));
    return host.read(r) == port_status::ok;
  }));
  EXPECT_EQ(r.sequence, 0u);
}

TEST(net_ft, somebody_elses_datagrams_are_not_heard) {
  connected c;
  sensor other;
  other.send(record(99), c.peer.peer());
  EXPECT_EQ(c.host.read(c.last), port_status::no_sample);
}

TEST(net_ft, a_flood_does_not_hold_the_reader) {
  connected c;
  for (std::uint32_t k = 1; k <= 100'000; ++k) c.peer.send(record(k));  // what does not fit is lost
  int reads = 0;
  while (c.host.read(c.last) == port_status::ok) ++reads;
  EXPECT_LE(reads, 100'000 / net_ft::max_datagrams + 1);
}

}  // namespace net_ft_tests
