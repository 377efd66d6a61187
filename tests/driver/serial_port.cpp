// together
// A port to the firmware over a pseudo-terminal, with all that a line does to what it carries.

#include <gtest/gtest.h>
#include <serial/serial_port.hpp>

#include "serial_peer.hpp"

#include <sys/wait.h>
#include <csignal>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

namespace serial_port_tests {

namespace ph = passive_haptics;
using ph::port_status;
using port = example::serial_port<2, 2>;
using reading = ph::port_sample<2>;

static_assert(ph::BrakePort<port>);
static_assert(ph::BrakePort<example::serial_port<1, 8>>);

example::serial_port_parameters at(const std::string& path, double timeout = 20) {
  example::serial_port_parameters p;
  p.device = path;
  p.open_timeout = timeout;
  return p;
}

struct serial_port : ::testing::Test {
  void SetUp() override {
    if (const std::string missing = missing_pseudo_terminal(); !missing.empty()) GTEST_SKIP() << missing;
  }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A peer and a port that has opened it and read all.
struct connected {
  serial_peer peer;
  port host;
  reading last;

  explicit connected(
      const firmware::settings& s = {},
      const std::function<void(const std::string&)>& before_open = [](auto&) {})
      : peer(s), host(at(peer.path())) {
    before_open(peer.path());
    EXPECT_EQ(peer.open(host), "");
    EXPECT_TRUE(comes_to_release());
    drain();
  }
  bool comes_to_release() {
    return eventually([&] {
      peer.hear();
      return peer.controller.now_in() == firmware::state::released;
    });
  }
  // All that was sent before this sample has come, too.
  void drain() {
    serial::sample m;
    m.encoders = 2;
    peer.send(encoded(pack(0xFFFF'FFFF, m)));
    EXPECT_TRUE(
        eventually([&] { return host.read(last) == port_status::ok && last.sequence == 0xFFFF'FFFF; }));
  }
  // The device as it goes on, until the port reads this.
  bool until(port_status wanted, const std::function<void()>& also = [] {}) {
    return eventually([&] {
      also();
      peer.hear();
      peer.tick();
      return host.read(last) == wanted;
    });
  }
  // These bytes, all there before the read.
  port_status read_of(const bytes& b) {
    EXPECT_EQ(peer.waiting(), 0);
    peer.send(b);
    EXPECT_TRUE(peer.arrived(b.size()));
    return host.read(last);
  }
  bool currents_arrive(const ph::brake_currents<2>& i, std::uint16_t first, std::uint16_t second) {
    return eventually([&] {
      host.write(i);
      peer.hear();
      return peer.board.current(0) == first && peer.board.current(1) == second;
    });
  }
};

bytes sample_frame(std::uint32_t sequence, std::uint32_t time, std::int32_t count) {
  serial::sample m;
  m.encoders = 2;
  m.time = time;
  m.count = {count, -count};
  return encoded(pack(sequence, m));
}

TEST_F(serial_port, parameters_are_checked_by_name) {
  EXPECT_EQ(validate(example::serial_port_parameters()), "");
  EXPECT_TRUE(has(validate(at("")), "device"));
  auto p = at("/dev/null");
  p.baud = 12345;
  EXPECT_TRUE(has(validate(p), "baud [bit/s] = 12345: expected one of 9600"));
  EXPECT_THROW(port{p}, std::invalid_argument);
  EXPECT_TRUE(has(validate(at("x", std::numeric_limits<double>::quiet_NaN())), "open_timeout [s] = nan"));
}

TEST_F(serial_port, that_cannot_be_opened_is_named) {
  port missing(at("/dev/no_such_port"));
  reading r;
  EXPECT_EQ(missing.read(r), port_status::failed);
  EXPECT_EQ(missing.write({}), port_status::failed);
  EXPECT_EQ(missing.open(),
            "serial port /dev/no_such_port: no such file; plug the device in, or find its name by `ls "
            "/dev/serial/by-id`");
  EXPECT_TRUE(has(port(at("/dev/null")).open(), "not a serial port"));
  const uid_t user = geteuid();
  if (user == 0 && seteuid(65534) != 0) GTEST_SKIP() << "root may open any file";
  EXPECT_TRUE(has(port(at("/etc/shadow")).open(), "dialout"));
  EXPECT_EQ(seteuid(user), 0);
}

TEST_F(serial_port, silence_is_told_from_noise_and_from_a_line_that_is_cut_one_way) {
  serial_peer peer;
  port silent(at(peer.path(), 0.3));
  EXPECT_TRUE(has(peer.open(silent, [] {}), "no answer in 300 ms; no byte was received"));
  port noisy(at(peer.path(), 0.3));
  EXPECT_TRUE(has(peer.open(noisy, [&] { peer.send({0, 7, 0, 9, 9}); }),
                  "no whole frame; check that baud = 1000000"));
  port cut(at(peer.path(), 0.3));
  EXPECT_TRUE(has(peer.open(cut, [&] { peer.tick(); }), "check the line to the device"));
}

TEST_F(serial_port, another_version_of_the_protocol_and_another_device_are_named) {
  serial_peer peer({.encoders = 2, .brakes = 1});
  port p(at(peer.path()));
  serial::hello h;
  h.version = 9;
  EXPECT_TRUE(has(peer.open(p, [&] { peer.send(encoded(pack(0, h))); }),
                  "protocol version of the device = 9: expected 1"));
  port q(at(peer.path()));
  EXPECT_TRUE(has(peer.open(q), "the device has 2 encoders and 1 brake: expected 2 encoders and 2 brakes"));
}

TEST_F(serial_port, a_device_that_goes_away_while_it_is_asked_is_no_time_out) {
  serial_peer peer;
  peer.deaf = true;
  port p(at(peer.path()));
  EXPECT_TRUE(has(peer.open(p,
                            [&] {
                              if (peer.heard.empty()) peer.hear();
                              else peer.hang_up();
                            }),
                  "was disconnected"));
}

TEST_F(serial_port, an_answer_among_noise_is_found) {
  serial_peer peer;
  port p(at(peer.path()));
  EXPECT_EQ(peer.open(p,
                      [&] {
                        peer.send({1, 2, 3, 0, 4});
                        peer.hear();
                        peer.tick();
                      }),
            "");
  EXPECT_EQ(p.device().current_limit, firmware::settings().current_limit);
}

TEST_F(serial_port, reads_the_newest_of_all_that_came) {
  connected c;
  const double before = ph::monotonic_seconds();
  bytes all;
  for (std::uint32_t k = 1; k <= 5; ++k) {
    const bytes f = sample_frame(1000 + k, 5'000'000 + 1000 * k, static_cast<std::int32_t>(10 * k));
    all.insert(all.end(), f.begin(), f.end());
  }
  EXPECT_EQ(c.read_of(all), port_status::ok);
  EXPECT_EQ(c.last.sequence, 1005u);
  EXPECT_EQ(c.last.value, (std::array<double, 2>{50, -50}));
  EXPECT_EQ(c.last.valid, (std::array<bool, 2>{true, true}));
  EXPECT_GE(c.last.time, before);
  EXPECT_LE(c.last.time, ph::monotonic_seconds());
  EXPECT_EQ(c.host.read(c.last), port_status::no_sample);
}

TEST_F(serial_port, a_wrong_checksum_is_a_bad_sample) {
  connected c;
  bytes bad = sample_frame(1, 1000, 1);
  bad[bad.size() - 3] ^= 1;
  EXPECT_EQ(c.read_of(bad), port_status::bad_sample);
  EXPECT_EQ(c.host.line_statistics().damaged, 1u);
  const bytes good = sample_frame(2, 2000, 1);
  bad.insert(bad.end(), good.begin(), good.end());
  EXPECT_EQ(c.read_of(bad), port_status::ok) << "a good one came with it";
  EXPECT_EQ(c.last.sequence, 2u);
  EXPECT_EQ(c.host.line_statistics().damaged, 2u);
}

TEST_F(serial_port, what_is_no_whole_sample_of_its_encoders_is_a_bad_sample) {
  connected c;
  const bytes whole = sample_frame(1, 1000, 1), begin(whole.begin(), whole.begin() + 12),
              rest(whole.begin() + 12, whole.end());
  EXPECT_EQ(c.read_of(begin), port_status::no_sample);
  EXPECT_EQ(c.read_of(rest), port_status::ok) << "in two parts";
  EXPECT_EQ(c.read_of(begin), port_status::no_sample);
  EXPECT_EQ(c.read_of({0}), port_status::bad_sample) << "once the next begins";
  EXPECT_EQ(c.read_of(sample_frame(2, 2000, 1)), port_status::ok);
  EXPECT_EQ(c.read_of({1, 2, 3, 0}), port_status::bad_sample);
  EXPECT_EQ(c.read_of(bytes(300, 0)), port_status::no_sample) << "a line that idles low";
  EXPECT_EQ(c.read_of(encoded(pack(1, serial::sample{.encoders = 3}))), port_status::bad_sample);
}

TEST_F(serial_port, an_encoders_fault_is_its_own) {
  connected c;
  serial::sample m;
  m.encoders = 2;
  m.encoder_faults = 2;
  EXPECT_EQ(c.read_of(encoded(pack(1, m))), port_status::ok);
  EXPECT_EQ(c.last.valid, (std::array<bool, 2>{true, false}));
}

TEST_F(serial_port, currents_arrive_rounded_cut_at_the_limit_and_never_below_0) {
  connected c;
  EXPECT_TRUE(c.currents_arrive({0.1234, 0.00006}, 1234, 1));
  EXPECT_TRUE(c.currents_arrive({0.6, 1e300}, 5000, 5000)) << "the device's limit is 0.5 A";
  EXPECT_TRUE(c.currents_arrive({0.1, 0.1}, 1000, 1000));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(c.currents_arrive({nan, -0.3}, 0, 0));
}

TEST_F(serial_port, release_outlives_noise_on_one_of_its_frames) {
  connected c;
  EXPECT_TRUE(c.currents_arrive({0.1, 0.1}, 1000, 1000));
  c.peer.hear();
  c.peer.heard.clear();
  c.peer.deaf = true;
  c.host.release();
  const std::size_t frame = encoded(serial::pack(0, serial::message_type::release)).size();
  EXPECT_TRUE(eventually([&] {
    c.peer.hear();
    return c.peer.heard.size() >= port::release_copies * frame;
  }));
  c.peer.heard[3] ^= 0x10;
  for (const std::uint8_t b : c.peer.heard) c.peer.controller.receive(b, c.peer.now);
  EXPECT_EQ(c.peer.controller.now_in(), firmware::state::released);
}

// Writes until the kernel has no room.
template <int Brakes>
void fill(example::serial_port<2, Brakes>& p) {
  ph::brake_currents<Brakes> currents{};
  currents[0] = 0.0321;
  int k = 0;
  while (p.write(currents) != port_status::no_sample && k < 100'000) ++k;
  EXPECT_LT(k, 100'000) << "the line is never full";
}

// Frames of 18 bytes do not come out even with the kernel's buffers. What the device hears after 20 times a
// full line and then others: whole frames, in order, and the latest.
TEST_F(serial_port, a_short_write_is_no_sample_and_leaves_no_wrong_frame) {
  serial_peer peer({.brakes = 3});
  example::serial_port<2, 3> host(at(peer.path()));
  EXPECT_EQ(peer.open(host), "");
  for (int k = 0; k < 20; ++k) fill(host);
  EXPECT_EQ(host.line_statistics().unsent, 20u);
  std::uint32_t last = 0;
  serial::decoder decoder;
  bool latest = false;
  int cut = 0;
  EXPECT_TRUE(eventually([&] {
    host.write({0.4});
    peer.heard.clear();
    peer.hear();
    for (const std::uint8_t b : peer.heard) {
      const auto o = decoder.take(b);
      cut += o == serial::outcome::damaged;
      if (o != serial::outcome::packet || unpack(decoder.last(), serial::message_type::release)) continue;
      serial::currents m;
      EXPECT_TRUE(unpack(decoder.last(), m));
      latest = m == serial::currents{3, {4000}};
      EXPECT_TRUE(latest || (m == serial::currents{3, {321}}));
      EXPECT_GT(decoder.last().sequence, last);
      last = decoder.last().sequence;
    }
    return latest;
  }));
  EXPECT_GT(cut, 0) << "no write was ever short";
}

TEST_F(serial_port, a_release_gets_through_a_full_line) {
  connected c;
  fill(c.host);
  EXPECT_EQ(c.host.write({0.1, 0.1}), port_status::ok) << "those that had no room make room";
  fill(c.host);
  c.host.release();
  EXPECT_TRUE(c.comes_to_release());
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  c.peer.hear();
  EXPECT_EQ(c.peer.controller.now_in(), firmware::state::released) << "nothing comes behind it";
}

TEST_F(serial_port, a_port_that_is_pulled_out_has_failed_and_stays_so) {
  for (const bool reads_first : {true, false}) {
    connected c;
    c.peer.hang_up();
    EXPECT_TRUE(eventually(
        [&] { return (reads_first ? c.host.read(c.last) : c.host.write({})) == port_status::failed; }));
    EXPECT_EQ(c.host.write({}), port_status::failed);
    EXPECT_EQ(c.host.read(c.last), port_status::failed);
    c.host.release();
    c.host.release();
  }
}

TEST_F(serial_port, a_tripped_watchdog_fails_until_a_release) {
  connected c;
  EXPECT_TRUE(c.currents_arrive({0.1, 0.1}, 1000, 1000));
  EXPECT_TRUE(c.until(port_status::ok, [&] { c.host.write({0.1, 0.1}); }));
  c.peer.deaf = true;  // the way to the device is cut, its samples still come
  EXPECT_TRUE(c.until(port_status::failed));
  EXPECT_EQ(c.host.newest().state, serial::sample::tripped);
  EXPECT_EQ(c.peer.board.current(0), 0);
  c.peer.deaf = false;
  c.host.release();
  EXPECT_TRUE(c.until(port_status::ok));
  EXPECT_TRUE(c.currents_arrive({0.2, 0.2}, 2000, 2000));
}

TEST_F(serial_port, currents_that_never_arrive_are_a_failure) {
  connected c;
  c.peer.deaf = true;
  EXPECT_EQ(c.host.write({0.1, 0.1}), port_status::ok);
  EXPECT_TRUE(c.until(port_status::failed));
  EXPECT_EQ(c.host.newest().state, 0) << "the device was never active";
}

TEST_F(serial_port, a_brakes_fault_is_a_failure_while_it_is_used) {
  connected c;
  c.peer.board.set_faults(0, 1);
  EXPECT_TRUE(c.until(port_status::ok)) << "encoders can be read with amplifiers off";
  EXPECT_TRUE(c.until(port_status::failed, [&] { c.host.write({0.1, 0.1}); }));
  EXPECT_EQ(c.host.newest().brake_faults, 1);
}

TEST_F(serial_port, a_supervisors_port_releases_and_takes_no_sample) {
  std::optional<port> supervisor;
  connected c({}, [&](const std::string& path) {
    auto p = at(path);
    p.release_only = true;
    supervisor.emplace(p);
    EXPECT_EQ(supervisor->open(), "");
  });
  EXPECT_TRUE(c.currents_arrive({0.1, 0.1}, 1000, 1000));
  c.peer.tick();
  EXPECT_TRUE(eventually([&] { return c.peer.waiting() > 0; }));
  const int waiting = c.peer.waiting();
  supervisor->release();
  EXPECT_EQ(c.peer.waiting(), waiting);
  EXPECT_TRUE(c.comes_to_release());
  EXPECT_EQ(c.host.read(c.last), port_status::ok);
  EXPECT_TRUE(c.until(port_status::failed)) << "its currents are no longer on the brakes";
}

TEST_F(serial_port, a_second_driver_is_refused_and_takes_no_byte) {
  connected c;
  c.peer.tick();
  EXPECT_TRUE(eventually([&] { return c.peer.waiting() > 0; }));
  const int waiting = c.peer.waiting();
  for (const bool release_only : {false, true}) {
    auto p = at(c.peer.path());
    p.release_only = release_only;
    port second(p);
    EXPECT_TRUE(has(second.open(), c.peer.path() + ": another program drives it")) << release_only;
    second.release();
  }
  EXPECT_EQ(c.peer.waiting(), waiting);
  EXPECT_EQ(c.host.read(c.last), port_status::ok);
  c.peer.heard.clear();
  c.peer.hear();
  EXPECT_TRUE(c.peer.heard.empty()) << "nor did the device hear anything";
}

TEST_F(serial_port, is_free_again_when_its_driver_has_closed_it) {
  serial_peer peer;
  const int other = ::open(peer.path().c_str(), O_RDWR | O_NOCTTY);
  const auto exclusive = [&] {
    int held = -1;
    return ioctl(other, TIOCGEXCL, &held) == 0 ? held : -1;
  };
  {
    port first(at(peer.path()));
    EXPECT_EQ(peer.open(first), "");
    EXPECT_EQ(exclusive(), 1);
    port moved(std::move(first));
    EXPECT_EQ(exclusive(), 1);
  }
  EXPECT_EQ(exclusive(), 0) << "a pseudo-terminal would remember it";
  close(other);
}

}  // namespace serial_port_tests
