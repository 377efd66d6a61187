#include <devices/mechanism_device.hpp>

std::unique_ptr<example::haptic_device> example::make_xy_table(const configuration& c) {
  return device_of(ph::xy_table<double>(c.xy_table), c);
}
