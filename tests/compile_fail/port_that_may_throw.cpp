// expect: passive_haptics: a port needs `port_status read.port_sample<encoder_count>&. noexcept`
#include <passive_haptics/driver/safe_port.hpp>

namespace ph = passive_haptics;

struct port {
  static constexpr int encoder_count = 2, brake_count = 2;
  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>&) { return ph::port_status::ok; }
  ph::port_status write(const ph::brake_currents<2>&) { return ph::port_status::ok; }
  void release() {}
};

int main() { ph::safe_port<port> safe(port{}); }
