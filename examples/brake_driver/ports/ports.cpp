#include <ports/net_ft.hpp>
#include <ports/ports.hpp>
#include <serial/serial_port.hpp>

#if PASSIVE_HAPTICS_COMEDI
#include <comedi/comedi_force_sensor.hpp>
#include <comedi/comedi_port.hpp>
#endif

#include <stdexcept>

namespace example {
namespace {

[[noreturn, maybe_unused]] void without_comedi() {
  throw std::invalid_argument(
      "this program was built without Comedi; install libcomedi-dev and build it again, or choose another "
      "type");
}

}  // namespace

any_brake_port<axes, axes> make_port(const configuration& c, haptic_device& device, port_use use) {
  if (c.port == "simulated") return device.simulated_port();
  if (c.port == "serial") {
    serial_port_parameters p = c.serial;
    p.release_only = use == port_use::release;
    return any_brake_port<axes, axes>::of<serial_port<axes, axes>>(p);
  }
#if PASSIVE_HAPTICS_COMEDI
  auto p = c.comedi;
  p.start_counters = use == port_use::control;
  return any_brake_port<axes, axes>::of<comedi_port<axes, axes>>(p);
#else
  without_comedi();
#endif
}

any_force_sensor make_sensor(const configuration& c, haptic_device& device) {
  if (c.sensor == "simulated") return device.simulated_sensor();
  if (c.sensor == "none") return any_force_sensor::none();
  if (c.sensor == "net_ft") return any_force_sensor::of<net_ft>(c.net_ft);
#if PASSIVE_HAPTICS_COMEDI
  return any_force_sensor::of<comedi_force_sensor<2>>(c.comedi_sensor);
#else
  without_comedi();
#endif
}

}  // namespace example
