/// @file
/// Which channels of a Comedi card do what. Needs no libcomedi.
#pragma once

#include <passive_haptics/core/validate.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace example {

namespace ph = passive_haptics;

/// What an analog input is measured against.
enum class comedi_reference { ground, common, differential };

/// An analog output, through a current amplifier to a brake.
struct comedi_brake {
  int channel = 0;
  int range = 0;  ///< Index of one that holds 0 V and is in volts, as comedi_board_info -v lists them.
  /// Of the amplifier [A/V]; there is no default.
  double amperes_per_volt = 0;
  /// What the range must reach [A]: open() checks it. 0: whatever it reaches, currents beyond are clamped.
  double largest_current = 0;
};

/// How open() sets up a counter.
enum class comedi_counter_setup {
  keep,           ///< Not at all: the card always counts quadrature, or another program set it up.
  ni_quadrature,  ///< Quadrature x4 as of National Instruments' counters, from the middle of the counter.
};

/// A counter, at an encoder.
struct comedi_encoder {
  int subdevice = -1;  ///< -1 for the first counter of the card.
  int channel = 0;     ///< 0 of National Instruments' counters.
  comedi_counter_setup setup = comedi_counter_setup::keep;
  int a = -1,
      b = -1;  ///< ni_quadrature: the PFI terminals of the encoder's signals; -1 where the card fixes them.
};

namespace detail {

/// Channels 0, 1, 2...
template <class Line, std::size_t Count>
constexpr std::array<Line, Count> lines_in_turn() {
  std::array<Line, Count> all{};
  for (std::size_t i = 0; i < Count; ++i) all[i].channel = static_cast<int>(i);
  return all;
}

inline std::string check_index(const std::string& name, int value, int smallest) {
  return value >= smallest
             ? ""
             : ph::detail::error_text(name, value, smallest < 0 ? "an index, or -1" : "an index >= 0");
}

inline std::string check_device_file(const std::string& device) {
  return device.empty() ? "device is empty, expected a file like /dev/comedi0" : "";
}

/// Whether line i of `lines` is one of those before: `same(line, other)`.
template <class Lines, class Same>
std::string check_distinct(const std::string& name, const Lines& lines, std::size_t i, Same same) {
  for (std::size_t k = 0; k < i; ++k)
    if (same(lines[i], lines[k]))
      return ph::detail::error_text(name, lines[i].channel,
                                    ph::detail::indexed("a channel other than that of [", k, "]"));
  return "";
}

}  // namespace detail

/// The channels of a comedi_port.
template <int Encoders, int Brakes>
struct comedi_port_parameters {
  std::string device = "/dev/comedi0";
  int output_subdevice = -1;  ///< -1 for the first analog output of the card.
  std::array<comedi_brake, static_cast<std::size_t>(Brakes)> brakes =
      detail::lines_in_turn<comedi_brake, static_cast<std::size_t>(Brakes)>();
  std::array<comedi_encoder, static_cast<std::size_t>(Encoders)> encoders =
      detail::lines_in_turn<comedi_encoder, static_cast<std::size_t>(Encoders)>();
  /// False: open() leaves every counter as it is. For a supervisor, which must not restart what the loop
  /// reads.
  bool start_counters = true;
};

/// What is wrong with the parameters, whatever the card; empty if nothing.
template <int Encoders, int Brakes>
std::string validate(const comedi_port_parameters<Encoders, Brakes>& p) {
  std::string text = ph::detail::first_error(detail::check_device_file(p.device),
                                             detail::check_index("output_subdevice", p.output_subdevice, -1));
  for (std::size_t i = 0; i < p.brakes.size() && text.empty(); ++i) {
    const auto& b = p.brakes[i];
    const std::string name = ph::detail::indexed("brakes[", i, "].");
    text = ph::detail::first_error(
        detail::check_index(name + "channel", b.channel, 0), detail::check_index(name + "range", b.range, 0),
        ph::detail::check_positive(name + "amperes_per_volt [A/V], the amplifier's gain", b.amperes_per_volt),
        ph::detail::check_not_negative(name + "largest_current [A]", b.largest_current),
        detail::check_distinct(name + "channel", p.brakes, i,
                               [](const auto& x, const auto& y) { return x.channel == y.channel; }));
  }
  for (std::size_t i = 0; i < p.encoders.size() && text.empty(); ++i) {
    const auto& e = p.encoders[i];
    const std::string name = ph::detail::indexed("encoders[", i, "].");
    text = ph::detail::first_error(
        detail::check_index(name + "subdevice", e.subdevice, -1),
        detail::check_index(name + "channel", e.channel, 0), detail::check_index(name + "a", e.a, -1),
        detail::check_index(name + "b", e.b, -1),
        detail::check_distinct(name + "channel", p.encoders, i, [](const auto& x, const auto& y) {
          return x.subdevice == y.subdevice && x.channel == y.channel;
        }));
  }
  return text;
}

/// The channels of a comedi_force_sensor.
template <int Channels>
struct comedi_force_sensor_parameters {
  std::string device = "/dev/comedi0";
  int subdevice = -1;  ///< -1 for the first analog input of the card.
  std::array<int, static_cast<std::size_t>(Channels)> channels = in_turn();
  int range = 0;  ///< Index, of all channels; in volts.
  comedi_reference reference = comedi_reference::ground;

  static constexpr auto in_turn() {
    std::array<int, static_cast<std::size_t>(Channels)> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    return all;
  }
};

/// What is wrong with the parameters, whatever the card; empty if nothing.
template <int Channels>
std::string validate(const comedi_force_sensor_parameters<Channels>& p) {
  std::string text = ph::detail::first_error(detail::check_device_file(p.device),
                                             detail::check_index("subdevice", p.subdevice, -1),
                                             detail::check_index("range", p.range, 0));
  for (std::size_t i = 0; i < p.channels.size() && text.empty(); ++i)
    text = detail::check_index(ph::detail::indexed("channels[", i, "]"), p.channels[i], 0);
  return text;
}

}  // namespace example
