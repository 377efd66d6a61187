// A device that goes away while it is open.
#include "guest.hpp"

#include <passive_haptics/driver/safe_port.hpp>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace guest {
namespace {

// What comedi_config does, with and without -r.
bool configure(bool attach) {
  comedi_devconfig card{};
  std::strcpy(card.board_name, "comedi_test");
  const int file = open(configured_by_hand, O_RDWR | O_CLOEXEC);
  const int result = ioctl(file, COMEDI_DEVCONFIG, attach ? &card : nullptr);
  close(file);
  return result == 0;
}

outcome module_stays() {
  port outputs(port_parameters());
  if (const auto text = outputs.open(); !text.empty()) return wrong(text);
  const long result = syscall(SYS_delete_module, "comedi_test", O_NONBLOCK);
  if (result == 0 || errno != EWOULDBLOCK) return wrong("rmmod: " + std::string(std::strerror(errno)));
  const std::string said = std::strerror(errno);
  return outputs.write({1, 1}) == ph::port_status::ok ? outcome{"", "rmmod: " + said}
                                                      : wrong("it no longer writes");
}

outcome detached() {
  if (!configure(true)) return wrong("comedi_config");
  port outputs(port_parameters(configured_by_hand));
  sensor inputs(sensor_parameters(configured_by_hand));
  if (const auto text = outputs.open() + inputs.open(); !text.empty()) return wrong(text);
  if (outputs.write({1, 1}) != ph::port_status::ok || !near(voltages(inputs), 2))
    return wrong("it does not work at all");
  if (!configure(false))
    return wrong("the kernel refuses comedi_config -r: " + std::string(std::strerror(errno)));
  ph::port_sample<2> sample;
  const bool failed =
      outputs.write({1, 1}) == ph::port_status::failed && inputs.read(sample) == ph::port_status::failed;
  const std::string said = comedi_strerror(comedi_errno());
  outputs.release();
  outputs.release();
  return failed ? outcome{"", "comedi_config -r is permitted; then: " + said}
                : wrong("a transfer did not fail");
}

outcome safe_port_is_released() {
  if (!configure(true)) return wrong("comedi_config");
  ph::safe_port<port, sensor> device(port(port_parameters(configured_by_hand)),
                                     sensor(sensor_parameters(configured_by_hand)));
  if (const auto text = device.open(); !text.empty()) return wrong(text);
  device.read(ph::monotonic_seconds());
  if (!device.activate()) return wrong("not activated: " + to_string(device.pending_fault()));
  device.write({1, 1});
  configure(false);
  const auto state = device.read(ph::monotonic_seconds());
  if (state != ph::port_state::released || device.reason().what != ph::fault::device_lost)
    return wrong(text(to_string(state), ", ", to_string(device.reason())));
  device.write({1, 1});
  return !device.applied_is_known() ? outcome{"", to_string(device.reason()) + ", in the same cycle"}
                                    : wrong("it says to know what flows");
}

outcome attached_again() {
  if (!configure(true)) return wrong("comedi_config");
  port outputs(port_parameters(configured_by_hand));
  if (const auto text = outputs.open(); !text.empty()) return wrong(text);
  configure(false);
  if (outputs.write({1, 1}) != ph::port_status::failed) return wrong("it still writes");
  if (!configure(true)) return wrong("comedi_config");
  sensor inputs(sensor_parameters(configured_by_hand));
  if (const auto text = inputs.open(); !text.empty()) return wrong(text);
  if (!near(voltages(inputs), 0)) return wrong("it does not begin at 0 V");
  const auto written = outputs.write({1, 1});
  outputs.release();
  const bool released = near(voltages(inputs), 0);
  configure(false);
  return released
             ? outcome{"", text("it begins at 0 V; a write through the old handle: ", to_string(written))}
             : wrong("not 0 V after release()");
}

}  // namespace

std::vector<check> lost_device_checks() {
  return {{"a module stays while its device is open", module_stays},
          {"a device that is gone fails each transfer", detached},
          {"a safe_port whose device is gone is released", safe_port_is_released},
          {"a device that came back obeys a release through the old handle", attached_again}};
}

}  // namespace guest
