/// @file
/// The last good samples of a port and of a force sensor: what is believed of them.
#pragma once

#include <passive_haptics/driver/checks/arrival_check.hpp>
#include <passive_haptics/driver/checks/encoder_check.hpp>
#include <passive_haptics/driver/checks/sample_check.hpp>
#include <passive_haptics/driver/checks/sensor_check.hpp>

#include <array>

namespace passive_haptics {

/// The encoders of a port: each sample is read and checked; a bad one changes nothing.
template <int N>
class believed_encoders {
 public:
  /// late_after [s]: the age at which a sample is bad. Throws std::invalid_argument with the text of
  /// validate(limits).
  believed_encoders(double late_after, const encoder_limits& limits) : sample_(late_after), counts_(limits) {}

  /// Counters of this width wrap; 0: they never do. Before the first sample.
  void set_counter_bits(int bits) noexcept { counts_.set_counter_bits(bits); }
  /// wrap_time() of these counters [s].
  double wrap_time() const noexcept { return counts_.wrap_time(); }

  /// Reads a sample at time `now` [s]; `free` says that no brake holds. What is wrong with the sample, or
  /// none.
  template <class Port>
  fault_record read(Port& port, double now, bool free) noexcept {
    port_sample<N> sample;
    const port_status status = port.read(sample);
    fault_record found = sample_(status, sample, now, fault_source::encoders);
    if (found.what == fault::none) found = counts_(sample, free);
    if (found.what != fault::none) return found;
    time_ = sample.time;
    arrivals_.add(sample.time);
    return {};
  }

  /// Where the encoders are, past every wrap of their counters [counts].
  const typename encoder_check<N>::counts& position() const noexcept { return counts_.position(); }
  /// When that was [s]; 0 before the first good sample.
  double time() const noexcept { return time_; }
  /// Whether the times look like those of arrival.
  const arrival_check& arrivals() const noexcept { return arrivals_; }

 private:
  sample_check<N> sample_;
  encoder_check<N> counts_;
  arrival_check arrivals_;
  double time_ = 0;
};

/// The channels of a force sensor: each sample is read and checked; a bad one changes nothing.
template <int N>
class believed_forces {
 public:
  /// late_after [s]: the age at which a sample is bad. Throws std::invalid_argument with the text of
  /// validate(limits).
  believed_forces(double late_after, const sensor_limits<N>& limits) : sample_(late_after), range_(limits) {}

  /// Reads a sample at time `now` [s]. What is wrong with the sample, or none.
  template <class Sensor>
  fault_record read(Sensor& sensor, double now) noexcept {
    if constexpr (N == 0) return {};
    port_sample<N> sample;
    const port_status status = sensor.read(sample);
    fault_record found = sample_(status, sample, now, fault_source::force_sensor);
    // A force has no home to lose
    if (found.what == fault::device_restarted) sample_.reset();
    if (found.what == fault::none) found = range_(sample);
    if (found.what == fault::none) reading_ = sample.value;
    return found;
  }

  /// The last good reading.
  const std::array<double, static_cast<std::size_t>(N)>& reading() const noexcept { return reading_; }

 private:
  sample_check<N> sample_;
  sensor_check<N> range_;
  std::array<double, static_cast<std::size_t>(N)> reading_{};
};

}  // namespace passive_haptics
