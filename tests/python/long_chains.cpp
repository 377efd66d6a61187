// Chains of six and seven joints.
#include "chains.hpp"

bool reference::run_long_chain(const std::string& device, const std::string& law, const std::string& mode,
                               const std::string& in, const std::string& to) {
  const auto with = [&](const auto& mechanism) { return run_law(mechanism, law, mode, in, to); };
  if (device == "spatial_chain_6") return with(ph::serial_chain<double, 6, 3>(geometry<6, 3>()));
  if (device == "spatial_chain_7") return with(ph::serial_chain<double, 7, 3>(geometry<7, 3>()));
  return false;
}
