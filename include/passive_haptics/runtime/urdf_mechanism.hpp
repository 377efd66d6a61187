/// @file
/// A serial chain of a URDF by names and numbers, for programs that read a device file.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/runtime/any_parameters.hpp>

#include <functional>
#include <string>

namespace passive_haptics::runtime {

/// A chain of a URDF, as [mechanism] of a device file describes it.
struct urdf_source {
  std::string urdf;  ///< Path of the file.
  std::string base;  ///< Its link that does not move.
  std::string tip;   ///< Its link that carries the handle.
  /// The handle in the frame of that link.
  vector<double, 3> tool = vector<double, 3>::Zero();
  bool balanced = false;  ///< Inertias that no rigid body has are balanced instead of rejected.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = urdf_source;
    return member_table(member("urdf", &p::urdf), member("base", &p::base), member("tip", &p::tip),
                        member("tool", &p::tool, "m", range::finite), member("balanced", &p::balanced));
  }
};

/// A mechanism of a catalogue with the parameters of such a chain.
struct urdf_mechanism {
  std::string name;           ///< In the catalogue.
  any_parameters parameters;  ///< Of that mechanism.
  std::string remarks;        ///< A line for each part of the file that is not in them as it is there.
};

/// Reads such a chain for a mechanism of this name in the catalogue, or for the one that fits if the name is
/// empty. Throws std::invalid_argument.
using urdf_reader = std::function<urdf_mechanism(const urdf_source& from, const std::string& name)>;

}  // namespace passive_haptics::runtime
