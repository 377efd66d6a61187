// The rival laws of the paper's device.
#include "reference.hpp"

#include <passive_haptics/control/laws/rivals/bang_bang_control.hpp>
#include <passive_haptics/control/laws/rivals/coercive_force_approximation.hpp>
#include <passive_haptics/control/laws/rivals/single_degree_of_freedom_control.hpp>
#include <passive_haptics/control/laws/rivals/velocity_ratio_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

bool reference::run_rival(const std::string& device, const std::string& law, const std::string& mode,
                          const std::string& in, const std::string& to) {
  if (device != "tendon_two_link") return false;
  const auto with = [&](const auto& of) {
    return run(ph::tendon_two_link<double>(), of, mode, in, to), true;
  };
  if (law == "no_direct_control") return with(ph::no_direct_control());
  if (law == "on_off_control") return with(ph::on_off_control());
  if (law == "bang_bang_control") return with(ph::bang_bang_control());
  if (law == "coercive_force_approximation") return with(ph::coercive_force_approximation());
  if (law == "single_degree_of_freedom_control") return with(ph::single_degree_of_freedom_control());
  if (law == "velocity_ratio_control") return with(ph::velocity_ratio_control());
  return false;
}
