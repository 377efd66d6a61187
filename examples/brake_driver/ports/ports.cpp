#include <ports/net_ft.hpp>
#include <ports/ports.hpp>
#include <serial/serial_port.hpp>

#include <passive_haptics/driver/thread/threaded_port.hpp>

#if PASSIVE_HAPTICS_COMEDI
#include <comedi/comedi_force_sensor.hpp>
#include <comedi/comedi_port.hpp>
#endif

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

namespace example {
namespace {

[[noreturn, maybe_unused]] void without_comedi() {
  throw std::invalid_argument(
      "this program was built without Comedi; install libcomedi-dev and build it again, or choose another "
      "type");
}

#if PASSIVE_HAPTICS_COMEDI
// Each look reads the card, so slow cards limit the rate.
ph::polling_parameters a_reading_twice_a_cycle(const configuration& c) {
  return {std::max(1e-6, c.loop.period / 2)};
}
#endif

// A thread calls the loop's port, since it may wait; the supervisor's port may wait itself.
template <class Port>
any_brake_port port_for(port_use use, Port port, const ph::polling_parameters& polling = {}) {
  if (use == port_use::release) return any_brake_port::of<Port>(std::move(port));
  return any_brake_port::of<ph::threaded_port<Port>>(std::move(port), polling);
}

template <class Sensor>
any_force_sensor sensor_for(Sensor sensor, const ph::polling_parameters& polling = {}) {
  return any_force_sensor::of<ph::threaded_sensor<Sensor>>(std::move(sensor), polling);
}

}  // namespace

any_brake_port make_port(const configuration& c, haptic_device& device, port_use use) {
  if (c.port == "simulated") return device.simulated_port();
  if (c.port == "serial") {
    serial_port_parameters p = c.serial;
    p.release_only = use == port_use::release;
    return port_for(use, serial_port<max_axes, max_axes>(p, c.mechanism.encoders(), c.mechanism.brakes()));
  }
#if PASSIVE_HAPTICS_COMEDI
  return std::visit(
      [&]<int N>(comedi_port_parameters<N, N> p) {
        p.start_counters = use == port_use::control;
        return port_for(use, comedi_port<N, N>(p), a_reading_twice_a_cycle(c));
      },
      c.comedi);
#else
  without_comedi();
#endif
}

any_force_sensor make_sensor(const configuration& c, haptic_device& device) {
  if (c.sensor == "simulated") return device.simulated_sensor();
  if (c.sensor == "none") return any_force_sensor::none();
  if (c.sensor == "net_ft") return sensor_for(net_ft(c.net_ft));
#if PASSIVE_HAPTICS_COMEDI
  return std::visit(
      [&]<int N>(const comedi_force_sensor_parameters<N>& p) {
        return sensor_for(comedi_force_sensor<N>(p), a_reading_twice_a_cycle(c));
      },
      c.comedi_sensor);
#else
  without_comedi();
#endif
}

}  // namespace example
