// together
#include "../../docs/guide/your_port.hpp"
#include "loopback_socket.hpp"
#include "serial_peer.hpp"

#include <passive_haptics/driver/thread/threaded_port.hpp>
#include <passive_haptics/testing/brake_port_properties.hpp>
#include <serial/serial_port.hpp>

#include <gtest/gtest.h>

namespace port_properties_tests {

// The firmware on a pseudo-terminal.
struct at_a_serial_line {
  using port = example::serial_port<2, 2>;
  static constexpr double resolution = serial::current_unit;

  static std::string missing() { return missing_pseudo_terminal(); }
  port make() { return port({.device = peer.path()}); }
  port make_releasing() { return port({.device = peer.path(), .release_only = true}); }
  template <class Port>
  std::string open(Port& p) {
    return peer.open(p);
  }
  void live() {
    peer.hear();
    peer.tick();
  }
  std::array<double, 2> currents() {
    return {serial::current_unit * peer.board.current(0), serial::current_unit * peer.board.current(1)};
  }

  serial_peer peer;
};

// A socket in place of the guide's board.
struct at_a_socket {
  using port = udp_board;
  static constexpr double resolution = 1e-6;

  port make() { return port(static_cast<std::uint16_t>(listening.port())); }
  port make_releasing() { return make(); }
  template <class Port>
  std::string open(Port& p) {
    return p.open();
  }
  void live() {
    float amperes[2];
    while (listening.receive(amperes, sizeof amperes) == sizeof amperes) has = {amperes[0], amperes[1]};
    ++sample.sequence;
    sample.time += 1000;
    listening.send(&sample, sizeof sample);
  }
  std::array<double, 2> currents() { return has; }

  loopback_socket listening;
  board_sample sample{};
  std::array<double, 2> has{};
};

// By a thread, which takes its time; not the supervisor's.
struct by_a_thread : at_a_serial_line {
  using port = ph::threaded_port<at_a_serial_line::port>;

  port make() { return port(at_a_serial_line::make()); }
  void live() {
    at_a_serial_line::live();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
};

}  // namespace port_properties_tests

namespace passive_haptics::testing {
using namespace port_properties_tests;
INSTANTIATE_TYPED_TEST_SUITE_P(serial_port, brake_port_properties, at_a_serial_line);
INSTANTIATE_TYPED_TEST_SUITE_P(udp_board, brake_port_properties, at_a_socket);
INSTANTIATE_TYPED_TEST_SUITE_P(threaded_serial_port, brake_port_properties, by_a_thread);
}  // namespace passive_haptics::testing
