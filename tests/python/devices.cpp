// The devices with which the package is compared: the paper's under each law and with switched brakes, one in
// space, and one with self-motion.
#include "chains.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

namespace reference {
namespace {

using arm = ph::tendon_two_link<double>;

// Cycles in which one brake works one way, and the other one is off from the middle on.
bool run_switched(const std::string& in, const std::string& to) {
  const task<arm> given(in);
  doubles_out out(to);
  ph::switchable_brakes<arm> brakes(given.brakes);
  brakes.make_negative(0);
  ph::controller control(arm(), brakes, given.scene(), ph::direct_control());
  for (std::size_t i = 0; i < given.states.size(); ++i) {
    if (i == given.states.size() / 2) {
      brakes.switch_off(1);
      control.set_brakes(brakes);
    }
    out.add_result(control(given.states[i]));
  }
  return true;
}

}  // namespace
}  // namespace reference

bool reference::run_device(const std::string& device, const std::string& law, const std::string& mode,
                           const std::string& in, const std::string& to) {
  if (device == "tendon_two_link" && law == "switched") return run_switched(in, to);
  if (device == "tendon_two_link" && law == "no_direct_control")
    return run(arm(), ph::no_direct_control(), mode, in, to), true;
  if (device == "tendon_two_link" && law == "on_off_control")
    return run(arm(), ph::on_off_control(), mode, in, to), true;
  if (device == "tendon_two_link") return run_law(arm(), law, mode, in, to);
  if (device == "delta") return run_law(ph::delta<double>(), law, mode, in, to);
  if (device == "planar_chain_3")
    return run_law(ph::serial_chain<double, 3, 2>(geometry<3, 2>()), law, mode, in, to);
  return false;
}
