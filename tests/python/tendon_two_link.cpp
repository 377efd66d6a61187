// The other laws of the paper's device, and its brakes that are switched.
#include "reference.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

namespace reference {
namespace {

// Cycles in which one brake works one way, and the other one is off from the middle on.
bool run_switched(const std::string& in, const std::string& to) {
  using arm = ph::tendon_two_link<double>;
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

bool reference::run_tendon(const std::string& device, const std::string& law, const std::string& mode,
                           const std::string& in, const std::string& to) {
  if (device != "tendon_two_link") return false;
  const auto with = [&](const auto& of) {
    return run(ph::tendon_two_link<double>(), of, mode, in, to), true;
  };
  if (law == "switched") return run_switched(in, to);
  if (law == "no_direct_control") return with(ph::no_direct_control());
  if (law == "on_off_control") return with(ph::on_off_control());
  return false;
}
