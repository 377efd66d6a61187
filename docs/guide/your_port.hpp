#pragma once

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/device_clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace ph = passive_haptics;

struct board_sample {
  std::uint32_t sequence, time;  // time: when the counts were latched, on the board's clock [us]
  std::int32_t counts[2];
};

// A board at a UDP port of this machine, which sends a board_sample each millisecond and takes two floats
// [A].
class udp_board {
 public:
  static constexpr int encoder_count = 2, brake_count = 2;

  explicit udp_board(std::uint16_t port = 7000) : port_(port) {}
  udp_board(udp_board&& other) noexcept
      : port_(other.port_), socket_(std::exchange(other.socket_, -1)), clock_(other.clock_) {}
  ~udp_board() {
    release();
    if (socket_ >= 0) close(socket_);
  }

  std::string open() {
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const sockaddr_in board{AF_INET, htons(port_), {htonl(INADDR_LOOPBACK)}, {}};
    const bool there = connect(socket_, reinterpret_cast<const sockaddr*>(&board), sizeof board) == 0 &&
                       write({}) == ph::port_status::ok;  // it sends to whom it last heard
    return there ? "" : std::string("no board at this UDP port: ").append(std::strerror(errno));
  }

  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    board_sample latest{}, next{};
    ssize_t size = -1;
    for (ssize_t n; (n = recv(socket_, &next, sizeof next, MSG_TRUNC)) >= 0; size = n) latest = next;
    if (errno != EAGAIN) return ph::port_status::failed;
    if (size < 0) return ph::port_status::no_sample;
    if (size != sizeof latest) return ph::port_status::bad_sample;
    const double first = latest.counts[0], second = latest.counts[1];
    const double taken = clock_.to_host(latest.time, ph::monotonic_seconds());
    sample = {taken, latest.sequence, {first, second}, {true, true}};
    return ph::port_status::ok;
  }

  ph::port_status write(const ph::brake_currents<2>& currents) noexcept {
    const float amperes[] = {static_cast<float>(currents[0]), static_cast<float>(currents[1])};
    if (send(socket_, amperes, sizeof amperes, 0) == sizeof amperes) return ph::port_status::ok;
    return errno == EAGAIN ? ph::port_status::no_sample : ph::port_status::failed;
  }

  void release() noexcept { write({}); }
  int counter_bits() const noexcept { return 32; }  // of the counters, which wrap

 private:
  std::uint16_t port_;
  int socket_ = -1;
  ph::device_clock clock_;
};

static_assert(ph::is_port<udp_board, ph::explain>());
