/// Assignment of the channels of a Comedi card. Does not need libcomedi.
#pragma once

#include <passive_haptics/core/parameters.hpp>

#include <array>
#include <cstddef>
#include <string>

namespace example {

namespace ph = passive_haptics;

namespace detail {
inline constexpr ph::range card_index = ph::range::at_least(0).as("an index >= 0");
inline constexpr ph::range index_or_any = ph::range::at_least(-1).as("an index, or -1");
}  // namespace detail

/// Reference of an analog input.
enum class comedi_reference { ground, common, differential };

/// An analog output, connected to a brake by a current amplifier.
struct comedi_brake {
  int channel = 0;
  int range = 0;  ///< Index of a range in volts that includes 0 V, as in comedi_board_info -v.
  /// Gain of the amplifier [A/V]; no default.
  double amperes_per_volt = 0;
  /// Current that the range must reach, checked by open() [A]; 0: any range, currents beyond are limited.
  double max_current = 0;

  static constexpr auto members() {
    using p = comedi_brake;
    using ph::member;
    return ph::member_table(member("channel", &p::channel, "", detail::card_index),
                            member("range", &p::range, "", detail::card_index),
                            member("amperes_per_volt", &p::amperes_per_volt, "A/V",
                                   ph::range::positive.as("a finite number > 0, the amplifier's gain"))
                                .suspicious_below(1e-6)
                                .suspicious_above(1000),
                            member("max_current", &p::max_current, "A", ph::range::not_negative));
  }
};

/// Set-up of a counter by open().
enum class comedi_counter_setup {
  keep,           ///< None: the card always counts quadrature, or another program set it up.
  ni_quadrature,  ///< Quadrature x4 for National Instruments' counters, from the middle of the counter.
};

/// A counter, connected to an encoder.
struct comedi_encoder {
  int subdevice = -1;  ///< -1 for the first counter of the card.
  int channel = 0;     ///< 0 for National Instruments' counters.
  comedi_counter_setup setup = comedi_counter_setup::keep;
  int a = -1,
      b = -1;  ///< ni_quadrature: PFI terminals of the signals; -1 if fixed by the card.

  static constexpr auto members() {
    using p = comedi_encoder;
    using ph::member;
    return ph::member_table(member("subdevice", &p::subdevice, "", detail::index_or_any),
                            member("channel", &p::channel, "", detail::card_index),
                            ph::choice("setup", &p::setup, "keep, ni_quadrature"),
                            member("a", &p::a, "", detail::index_or_any),
                            member("b", &p::b, "", detail::index_or_any));
  }
};

namespace detail {

template <class Line, std::size_t Count>
constexpr std::array<Line, Count> lines_in_turn() {
  std::array<Line, Count> all{};
  for (std::size_t i = 0; i < Count; ++i) all[i].channel = static_cast<int>(i);
  return all;
}

inline std::string check_device_file(const std::string& device) {
  return device.empty() ? "device = \"\": expected a file like /dev/comedi0" : "";
}

/// Error text if a line equals a previous one: `same(line, other)`.
template <class Lines, class Same>
std::string check_distinct(const char* name, const Lines& lines, Same same) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (same(lines[i], lines[k]))
        return ph::detail::error_text(ph::detail::indexed(std::string(name).append("["), i, "].channel"),
                                      lines[i].channel,
                                      ph::detail::indexed("a channel other than that of [", k, "]"));
  return "";
}

}  // namespace detail

/// Channels of a comedi_port.
template <int Encoders, int Brakes>
struct comedi_port_parameters {
  std::string device = "/dev/comedi0";
  int output_subdevice = -1;  ///< -1 for the first analog output of the card.
  std::array<comedi_brake, static_cast<std::size_t>(Brakes)> brakes =
      detail::lines_in_turn<comedi_brake, static_cast<std::size_t>(Brakes)>();
  std::array<comedi_encoder, static_cast<std::size_t>(Encoders)> encoders =
      detail::lines_in_turn<comedi_encoder, static_cast<std::size_t>(Encoders)>();
  /// False: open() leaves the counters as they are. For a supervisor, which must not restart the loop's
  /// counters.
  bool start_counters = true;

  static constexpr auto members() {
    using p = comedi_port_parameters;
    using ph::member;
    return ph::member_table(member("device", &p::device),
                            member("output_subdevice", &p::output_subdevice, "", detail::index_or_any),
                            member("brakes", &p::brakes), member("encoders", &p::encoders));
  }
  /// Requires a device, and one use per channel.
  std::string rules() const {
    return ph::detail::first_error(
        detail::check_device_file(device),
        detail::check_distinct("brakes", brakes,
                               [](const auto& x, const auto& y) { return x.channel == y.channel; }),
        detail::check_distinct("encoders", encoders, [](const auto& x, const auto& y) {
          return x.subdevice == y.subdevice && x.channel == y.channel;
        }));
  }
};

/// Channels of a comedi_force_sensor.
template <int Channels>
struct comedi_force_sensor_parameters {
  std::string device = "/dev/comedi0";
  int subdevice = -1;  ///< -1 for the first analog input of the card.
  std::array<int, static_cast<std::size_t>(Channels)> channels = in_turn();
  int range = 0;  ///< Index of the range in volts, for all channels.
  comedi_reference reference = comedi_reference::ground;

  static constexpr auto members() {
    using p = comedi_force_sensor_parameters;
    using ph::member;
    return ph::member_table(member("device", &p::device),
                            member("subdevice", &p::subdevice, "", detail::index_or_any),
                            member("channels", &p::channels, "", detail::card_index),
                            member("range", &p::range, "", detail::card_index),
                            ph::choice("reference", &p::reference, "ground, common, differential"));
  }
  /// Requires a device.
  std::string rules() const { return detail::check_device_file(device); }

  static constexpr auto in_turn() {
    std::array<int, static_cast<std::size_t>(Channels)> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    return all;
  }
};

using ph::validate;

}  // namespace example
