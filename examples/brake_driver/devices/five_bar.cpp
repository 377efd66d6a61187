#include <devices/mechanism_device.hpp>

std::unique_ptr<example::haptic_device> example::make_five_bar(const configuration& c) {
  return device_of(ph::five_bar<double>(c.five_bar), c);
}
