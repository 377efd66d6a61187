/// @file
/// Reads the sections [mechanism], [brakes], [[brakes.model]], [law], [[walls]], [[effects]] and [scene] of a
/// device file, and type = "none" of [sensor]. Keys are the names of the parameters (core/parameters.hpp),
/// and `type` is the name in the catalogue. A program reads other sections from the same toml_section.
/// Defined in definitions.hpp, which one source of a program includes.
#pragma once

#include <passive_haptics/runtime/device_file/device_description.hpp>
#include <passive_haptics/runtime/device_file/toml_section.hpp>

#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Reads the parts of a device. Call its functions in their order; a program that knows more about the device
/// sets members of `device` in between. All of them throw std::invalid_argument with file, line, key, value
/// and expectation.
class device_reader {
 public:
  device_description device;  ///< As far as it is read.

  /// Of an open file, with finish() left to the caller, and of what its names mean.
  device_reader(toml_section file, const catalogue& all) : file_(std::move(file)), all_(all) {}

  /// Reads [mechanism].
  void read_mechanism();
  /// Reads [brakes] and [[brakes.model]]. The brakes of `device` are the defaults, if it has any.
  void read_brakes();
  /// Reads [[walls]], [[effects]] and [scene]. Without the first two there is the paper's wall, in space a
  /// floor; `walls = []` is none.
  void read_scene();
  /// Reads whether [sensor] has type = "none".
  void read_sensor();
  /// Reads [law]. Without a type it is the first law of the catalogue that the device can have, with effects
  /// the first that displays them: of the library's the recommended one (control/laws/recommended_law.hpp)
  /// and direct_control. Unless the file has it, the `lead` of a law is the lag of the slowest brake.
  void read_law();

 private:
  const mechanism_entry& mechanism() const { return *find(all_.mechanisms(), device.mechanism.name); }
  template <int D>
  void read_scene_in();
  template <int D>
  void read_wall(toml_section& from);
  template <int D>
  void read_shape(toml_section& from, std::vector<named_parameters>& shapes);
  std::string missing(const law_entry& law, const any_mechanism& made) const;
  void require_possible(toml_section& from, const law_entry& law, const any_mechanism& made);

  toml_section file_;
  const catalogue& all_;
};

/// All these parts of an open file, with finish() left to the caller. Throws as a device_reader does.
device_description read_device(const toml_section& file, const catalogue& all);

}  // namespace passive_haptics::runtime
