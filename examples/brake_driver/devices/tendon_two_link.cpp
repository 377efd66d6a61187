#include <devices/mechanism_device.hpp>

std::unique_ptr<example::haptic_device> example::make_tendon_two_link(const configuration& c) {
  return device_of(ph::tendon_two_link<double>(c.tendon_two_link), c);
}
