// What open() says of a card that is not as expected.
#include "guest.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace guest {
namespace {

// That a port says this when it opens.
template <class Port = port>
outcome says(const typename Port::parameters& p, const std::string& expected) {
  const std::string said = Port(p).open();
  return said.find(expected) == std::string::npos ? wrong("it says '" + said + "'") : outcome{"", said};
}

outcome missing_file() {
  return says(port_parameters("/dev/comedi7"), "device = /dev/comedi7 does not exist");
}
outcome not_comedi() {
  return says(port_parameters("/dev/null"), "device = /dev/null is not a Comedi device");
}
outcome without_driver() { return says(port_parameters(configured_by_hand), " belongs to no card"); }

outcome without_permission() {
  chmod(self_configured, 0600);
  const pid_t child = fork();
  if (child == 0) {
    if (setuid(1000) != 0) _exit(2);
    _exit(says(port_parameters(), " may not be opened by this user").error.empty() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0 ? outcome{} : wrong(text("status ", status));
}

outcome wrong_subdevice() {
  auto p = port_parameters();
  p.output_subdevice = 0;
  return says(p,
              "output_subdevice = 0: expected a subdevice of /dev/comedi1 that is an analog output, as 1 is");
}
outcome wrong_channel() {
  auto p = port_parameters();
  p.brakes[1].channel = 8;
  return says(p, "brakes[1].channel = 8: expected less than 8");
}
outcome wrong_range() {
  auto p = port_parameters();
  p.brakes[0].range = 2;
  return says(p, "has: 0 (-10 to 10 V), 1 (-5 to 5 V)");
}
outcome no_counter() {
  example::comedi_port<1, 1>::parameters p;
  p.device = self_configured;
  p.brakes[0].amperes_per_volt = 1;
  return says<example::comedi_port<1, 1>>(p, "has no subdevice that is a counter");
}

}  // namespace

std::vector<check> opening_checks() {
  return {{"a device file that is missing is named", missing_file},
          {"a file that is no Comedi device is named", not_comedi},
          {"a device without a driver is named", without_driver},
          {"a user without permission is told so", without_permission},
          {"a subdevice of the wrong type is named", wrong_subdevice},
          {"a channel that the card lacks is named", wrong_channel},
          {"a range that the card lacks is named", wrong_range},
          {"a card without counters is named", no_counter}};
}

}  // namespace guest
