#include <devices/haptic_device.hpp>

std::unique_ptr<example::haptic_device> example::make_device(const configuration& c) {
  if (c.mechanism == "xy_table") return make_xy_table(c);
  if (c.mechanism == "five_bar") return make_five_bar(c);
  return make_tendon_two_link(c);
}
