/// @file
/// Why a driver releases the brakes.
#pragma once

#include <passive_haptics/core/text.hpp>

namespace passive_haptics {

/// What can be wrong with a device, its samples, a command or the loop.
enum class fault {
  none,
  // of a transfer
  device_lost,          ///< The port says that no further transfer can be expected.
  sample_missing,       ///< Nothing came.
  sample_damaged,       ///< Cut off, or a wrong checksum.
  sample_repeated,      ///< A sequence number came twice.
  sample_out_of_order,  ///< An older one than the last.
  sample_late,          ///< Its time is too long ago, or ahead.
  device_restarted,     ///< The sequence number jumped: what the device did meanwhile is unknown.
  write_refused,        ///< The device took no currents.
  // of a channel
  channel_invalid,     ///< The device itself says so.
  value_not_finite,    ///< NaN or infinity.
  count_out_of_range,  ///< A count that the counter of an encoder does not have.
  encoder_jump,        ///< Faster than the device can move.
  counter_wrapped,     ///< The pause since the last sample is so long that a counter may have wrapped unseen.
  encoder_frozen,      ///< Does not change while the others move.
  sensor_saturated,    ///< At the end of its range.
  current_not_valid,   ///< A command that is NaN, infinite or negative.
  // of the loop
  law_failed,       ///< The control law threw, or its result is a fault.
  overruns,         ///< Too many cycles in a row took too long.
  cycle_late,       ///< A cycle began far too late: the machine or the process stood still.
  clock_jump,       ///< The clock went back, or is no number.
  suspended,        ///< The machine was suspended: what the device did meanwhile is unknown.
  supervisor_lost,  ///< The other process does not respond, or released the brakes itself.
  user,             ///< Requested: a signal, or a call of release().
};

/// The fault in words.
constexpr std::string_view to_string(fault f) {
  switch (f) {
    case fault::none: return "no fault";
    case fault::device_lost: return "device lost";
    case fault::sample_missing: return "no sample";
    case fault::sample_damaged: return "damaged samples";
    case fault::sample_repeated: return "the same sample again and again";
    case fault::sample_out_of_order: return "samples out of order";
    case fault::sample_late: return "samples too late";
    case fault::device_restarted: return "the device restarted";
    case fault::write_refused: return "the device takes no currents";
    case fault::channel_invalid: return "invalid, says the device";
    case fault::value_not_finite: return "NaN or infinity";
    case fault::count_out_of_range: return "a count beyond the range of its counter";
    case fault::encoder_jump: return "jumped";
    case fault::counter_wrapped: return "a counter may have wrapped unseen";
    case fault::encoder_frozen: return "frozen";
    case fault::sensor_saturated: return "saturated";
    case fault::current_not_valid: return "the commanded current is NaN, infinite or negative";
    case fault::law_failed: return "the control law failed";
    case fault::overruns: return "cycles took too long";
    case fault::cycle_late: return "a cycle began far too late";
    case fault::clock_jump: return "the clock went back";
    case fault::suspended: return "the machine was suspended";
    case fault::supervisor_lost: return "the supervisor is lost, or released the brakes";
    case fault::user: return "as requested";
  }
  return "unknown fault";
}

/// Where a fault is.
enum class fault_source { loop, encoders, force_sensor, brakes };

/// A fault, and where.
struct fault_record {
  fault what = fault::none;                  ///< none: nothing is wrong.
  fault_source source = fault_source::loop;  ///< Where.
  int channel = -1;                          ///< From 0; -1 where it is of no single one.

  /// Whether two faults are of one kind at one place.
  bool operator==(const fault_record&) const = default;
};

/// Whether nothing can stand in for what is lost: the brakes are released at once.
constexpr bool releases_immediately(const fault_record& i) noexcept {
  return i.what == fault::device_lost || i.what == fault::encoder_frozen ||
         i.what == fault::counter_wrapped ||
         (i.what == fault::device_restarted && i.source == fault_source::encoders);
}

/// True if a sample arrived but its content is rejected: it is damaged, invalid, out of range or a jump.
constexpr bool rejects_sample(fault f) noexcept {
  return f == fault::sample_damaged || f == fault::channel_invalid || f == fault::value_not_finite ||
         f == fault::count_out_of_range || f == fault::encoder_jump || f == fault::sensor_saturated;
}

/// Whether the encoders may have lost their way, if it lasts.
constexpr bool invalidates_position(fault f) noexcept {
  return f == fault::device_lost || f == fault::device_restarted || f == fault::sample_out_of_order ||
         f == fault::channel_invalid || f == fault::value_not_finite || f == fault::count_out_of_range ||
         f == fault::encoder_jump || f == fault::counter_wrapped || f == fault::encoder_frozen ||
         f == fault::suspended;
}

/// The fault_record in words: "encoder 2: jumped", channels from 1. Allocates: not for the loop.
inline std::string to_string(const fault_record& i) {
  std::string text(i.channel < 0 ? detail::word_of(i.source, {"", "encoders", "force sensor", "brakes", ""})
                                 : detail::word_of(i.source, {"", "encoder", "force channel", "brake", ""}));
  if (i.channel >= 0) text.append(" ").append(std::to_string(i.channel + 1));
  if (i.source != fault_source::loop) text.append(": ");
  return text.append(to_string(i.what));
}

}  // namespace passive_haptics
