// Chains of three and four joints.
#include "chains.hpp"

bool reference::run_chain(const std::string& device, const std::string& law, const std::string& mode,
                          const std::string& in, const std::string& to) {
  const auto with = [&](const auto& mechanism) { return run_law(mechanism, law, mode, in, to); };
  if (device == "planar_chain_3") return with(ph::serial_chain<double, 3, 2>(geometry<3, 2>()));
  if (device == "planar_chain_4") return with(ph::serial_chain<double, 4, 2>(geometry<4, 2>()));
  if (device == "spatial_chain_3") return with(ph::serial_chain<double, 3, 3>(geometry<3, 3>()));
  if (device == "planar_chain_3_with_inertia")
    return with(ph::serial_chain_with_inertia<double, 3, 2>(geometry<3, 2>(), inertia<3, 2>()));
  if (device == "planar_chain_4_with_inertia")
    return with(ph::serial_chain_with_inertia<double, 4, 2>(geometry<4, 2>(), inertia<4, 2>()));
  if (device == "spatial_chain_3_with_inertia")
    return with(ph::serial_chain_with_inertia<double, 3, 3>(geometry<3, 3>(), inertia<3, 3>()));
  return false;
}
