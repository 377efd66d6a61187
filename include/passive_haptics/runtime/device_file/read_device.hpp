/// Reading of the sections [mechanism], [brakes], [[brakes.model]], [law], [[walls]], [[effects]] and [scene]
/// of a device file, and of type = "none" in [sensor]. Keys are the names of parameters, `type` is the name
/// in the catalogue. A program reads other sections from the same toml_section. Defined in definitions.hpp.
#pragma once

#include <passive_haptics/runtime/device_file/device_description.hpp>
#include <passive_haptics/runtime/device_file/toml_section.hpp>

#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Reads the parts of a device. Call its functions in order; a program may set members of `device` in
/// between. All throw std::invalid_argument with file, line, key, value and expectation.
class device_reader {
 public:
  device_description device;  ///< The parts read so far.

  /// An open file and the catalogue for its names. The caller calls finish().
  device_reader(toml_section file, const catalogue& all) : file_(std::move(file)), all_(all) {}

  /// Reads [mechanism]. With `urdf` its parameters are those of a chain of that file, and other keys of the
  /// section replace them.
  void read_mechanism();
  /// Reads [brakes] and [[brakes.model]]. Existing brakes of `device` are the defaults.
  void read_brakes();
  /// Reads [[walls]], [[effects]] and [scene]. Without the first two there is the paper's wall, or a floor
  /// for spatial devices; `walls = []` means no wall.
  void read_scene();
  /// Detects type = "none" in [sensor].
  void read_sensor();
  /// Reads [law]. The default type is the first law of the catalogue that the device can use, with effects
  /// the first that displays them. The default `lead` of a law is the lag of the slowest brake.
  void read_law();

 private:
  const mechanism_entry& mechanism() const { return *find(all_.mechanisms(), device.mechanism.name); }
  void read_urdf(toml_section& from);
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

/// Reads all these parts of an open file; the caller calls finish(). Throws as device_reader.
device_description read_device(const toml_section& file, const catalogue& all);

}  // namespace passive_haptics::runtime
