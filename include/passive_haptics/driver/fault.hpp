/// Reasons for the release of the brakes.
#pragma once

#include <passive_haptics/core/text.hpp>

namespace passive_haptics {

/// Faults of a device, its samples, a command or the loop.
enum class fault {
  none,
  // of a transfer
  device_lost,          ///< The port reports that no further transfer is possible.
  sample_missing,       ///< No sample arrived.
  sample_damaged,       ///< Incomplete, or wrong checksum.
  sample_repeated,      ///< A sequence number was repeated.
  sample_out_of_order,  ///< Older than the previous sample.
  sample_late,          ///< Its time is too far in the past or future.
  device_restarted,     ///< The sequence number jumped: the motion in between is unknown.
  write_refused,        ///< The device rejected the currents.
  // of a channel
  channel_invalid,     ///< Reported by the device.
  value_not_finite,    ///< NaN or infinity.
  count_out_of_range,  ///< Outside the range of the encoder's counter.
  encoder_jump,        ///< Faster than the device can move.
  counter_wrapped,     ///< The pause since the last sample exceeds wrap_time().
  encoder_frozen,      ///< Unchanged while the others move.
  sensor_saturated,    ///< At the end of its range.
  current_not_valid,   ///< A command that is NaN, infinite or negative.
  // of the loop
  law_failed,       ///< The control law threw, or returned a fault.
  overruns,         ///< Too many successive cycles took too long.
  cycle_late,       ///< A cycle began far too late.
  clock_jump,       ///< The clock went back, or is not a number.
  suspended,        ///< The machine was suspended: the motion in between is unknown.
  supervisor_lost,  ///< The other process does not respond, or released the brakes.
  user,             ///< Requested by a signal or release().
};

/// Text of a fault.
constexpr std::string_view to_string(fault f) {
  switch (f) {
    case fault::none: return "no fault";
    case fault::device_lost: return "device lost";
    case fault::sample_missing: return "no sample";
    case fault::sample_damaged: return "damaged samples";
    case fault::sample_repeated: return "the same sample repeatedly";
    case fault::sample_out_of_order: return "samples out of order";
    case fault::sample_late: return "samples too late";
    case fault::device_restarted: return "the device restarted";
    case fault::write_refused: return "the device rejects currents";
    case fault::channel_invalid: return "reported invalid by the device";
    case fault::value_not_finite: return "NaN or infinity";
    case fault::count_out_of_range: return "a count beyond the range of its counter";
    case fault::encoder_jump: return "jumped";
    case fault::counter_wrapped: return "a counter may have wrapped unseen";
    case fault::encoder_frozen: return "frozen";
    case fault::sensor_saturated: return "saturated";
    case fault::current_not_valid: return "the commanded current is NaN, infinite or negative";
    case fault::law_failed: return "the control law failed";
    case fault::overruns: return "cycles took too long";
    case fault::cycle_late: return "a cycle began too late";
    case fault::clock_jump: return "the clock went back";
    case fault::suspended: return "the machine was suspended";
    case fault::supervisor_lost: return "the supervisor is lost, or released the brakes";
    case fault::user: return "as requested";
  }
  return "unknown fault";
}

/// Location of a fault.
enum class fault_source { loop, encoders, force_sensor, brakes };

/// A fault and its location.
struct fault_record {
  fault what = fault::none;                  ///< none for no fault.
  fault_source source = fault_source::loop;  ///< Location.
  int channel = -1;                          ///< From 0; -1 for no single channel.

  bool operator==(const fault_record&) const = default;  ///< True for equal faults at one location.
};

/// True if the fault cannot be bridged and releases the brakes immediately.
constexpr bool releases_immediately(const fault_record& i) noexcept {
  return i.what == fault::device_lost || i.what == fault::encoder_frozen ||
         i.what == fault::counter_wrapped ||
         (i.what == fault::device_restarted && i.source == fault_source::encoders);
}

/// True if a sample arrived but was rejected as damaged, invalid, out of range or a jump.
constexpr bool rejects_sample(fault f) noexcept {
  return f == fault::sample_damaged || f == fault::channel_invalid || f == fault::value_not_finite ||
         f == fault::count_out_of_range || f == fault::encoder_jump || f == fault::sensor_saturated;
}

/// True if the encoder position may be wrong after this fault, if it persists.
constexpr bool invalidates_position(fault f) noexcept {
  return f == fault::device_lost || f == fault::device_restarted || f == fault::sample_out_of_order ||
         f == fault::channel_invalid || f == fault::value_not_finite || f == fault::count_out_of_range ||
         f == fault::encoder_jump || f == fault::counter_wrapped || f == fault::encoder_frozen ||
         f == fault::suspended;
}

/// Text such as "encoder 2: jumped", channels from 1. Allocates.
inline std::string to_string(const fault_record& i) {
  std::string text(i.channel < 0 ? detail::word_of(i.source, {"", "encoders", "force sensor", "brakes", ""})
                                 : detail::word_of(i.source, {"", "encoder", "force channel", "brake", ""}));
  if (i.channel >= 0) text.append(" ").append(std::to_string(i.channel + 1));
  if (i.source != fault_source::loop) text.append(": ");
  return text.append(to_string(i.what));
}

}  // namespace passive_haptics
