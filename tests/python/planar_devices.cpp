// The devices in the plane that are no chains, and the delta.
#include "reference.hpp"

#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

bool reference::run_planar(const std::string& device, const std::string& law, const std::string& mode,
                           const std::string& in, const std::string& to) {
  const auto with = [&](const auto& mechanism) { return run_law(mechanism, law, mode, in, to); };
  if (device == "tendon_two_link") return with(ph::tendon_two_link<double>());
  if (device == "two_link") return with(ph::two_link<double>());
  if (device == "xy_table") return with(ph::xy_table<double>());
  if (device == "five_bar") return with(ph::five_bar<double, 2>());
  if (device == "five_bar_with_four_brakes") return with(ph::five_bar<double, 4>());
  if (device == "delta") return with(ph::delta<double>());
  return false;
}
