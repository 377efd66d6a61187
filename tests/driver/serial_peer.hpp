// The firmware on the other end of a pseudo-terminal, and a line that can be disturbed.
#pragma once

#include "eventually.hpp"

#include <firmware/brake_controller.hpp>
#include <firmware/host_board.hpp>
#include <passive_haptics/driver/clock.hpp>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

namespace serial = example::serial;
using bytes = std::vector<std::uint8_t>;

// Why there is no line for a test; empty if there is one.
inline std::string missing_pseudo_terminal() {
  const bool there = !firmware::pseudo_terminal().path().empty();
  return there ? "" : "no pseudo-terminal to be had: is devpts mounted at /dev/pts?";
}

inline bytes encoded(const serial::packet& p) {
  const auto f = serial::encode(p);
  return bytes(f.content().begin(), f.content().end());
}

// Its time is the test's own: it passes in tick() alone.
class serial_peer {
 public:
  explicit serial_peer(const firmware::settings& s = {})
      : board(line),
        controller(board, s),
        settings_(s),
        probe_(::open(line.path().c_str(), O_RDWR | O_NOCTTY)) {}
  ~serial_peer() { close_probe(); }

  const std::string& path() const { return line.path(); }

  // What has come from the host, to the controller.
  void hear() {
    std::array<std::uint8_t, 512> buffer;
    for (std::size_t n; (n = line.read(buffer)) > 0;) {
      heard.insert(heard.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
      if (deaf) continue;
      for (const std::uint8_t b : std::span(buffer).first(n)) controller.receive(b, now);
    }
  }
  // A period passes, and a sample goes out.
  void tick() {
    now += settings_.period;
    board.advance(1e-6 * settings_.period);
    controller.tick(now);
  }
  void send(const bytes& b) { line.write(b); }

  // Bytes that the host's end of the line has not read yet.
  int waiting() const {
    int n = 0;
    return ioctl(probe_, FIONREAD, &n) == 0 ? n : -1;
  }
  bool arrived(std::size_t n) const {
    return eventually([&] { return waiting() == static_cast<int>(n); });
  }
  void hang_up() {
    close_probe();
    line.hang_up();
  }

  // Opens a port while the peer lives on in another thread.
  template <class Port>
  std::string open(Port& port) {
    return open(port, [this] {
      hear();
      tick();
    });
  }
  template <class Port>
  std::string open(Port& port, const std::function<void()>& live) {
    return beside(live, [&] { return port.open(); });
  }

  firmware::pseudo_terminal line;
  firmware::host_board board;
  firmware::brake_controller<firmware::host_board> controller;
  std::uint32_t now = 0;  // [us]
  bool deaf = false;
  bytes heard;

 private:
  firmware::settings settings_;
  int probe_;

  void close_probe() {
    if (probe_ >= 0) ::close(probe_);
    probe_ = -1;
  }
};
