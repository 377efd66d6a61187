#include "port_fixture.hpp"

#include <passive_haptics/testing/brake_port_properties.hpp>

namespace {

struct at_the_double {
  using port = ::port;
  static constexpr double resolution = 0.5 * 20 / 65535;

  at_the_double() { comedi_double::plug_in(); }

  port make() { return port(parameters()); }
  port make_releasing() {
    auto p = parameters();
    p.start_counters = false;
    return port(p);
  }
  std::string open(port& p) { return p.open(); }
  void live() {}
  std::array<double, 2> currents() { return {current(0), current(1)}; }

 private:
  static double current(std::size_t i) {
    const lsampl_t sample = plugged.subdevices[1].value[i];
    return sample == zero ? 0 : 0.5 * (-10 + 20.0 * sample / 65535);
  }
};

}  // namespace

namespace passive_haptics::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(comedi_port, brake_port_properties, at_the_double);
}  // namespace passive_haptics::testing
