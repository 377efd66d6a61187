/// The last good samples of a port and of a force sensor.
#pragma once

#include <passive_haptics/driver/checks/arrival_check.hpp>
#include <passive_haptics/driver/checks/encoder_check.hpp>
#include <passive_haptics/driver/checks/sample_check.hpp>
#include <passive_haptics/driver/checks/sensor_check.hpp>

#include <array>

namespace passive_haptics {

/// Encoders of a port: reads and checks samples, ignores bad ones.
template <int N>
class believed_encoders {
 public:
  /// late_after [s]: age at which a sample is bad. Throws std::invalid_argument for invalid limits.
  believed_encoders(double late_after, const encoder_limits& limits) : sample_(late_after), counts_(limits) {}

  /// Sets the width at which counters wrap; 0: never. Call it before the first sample.
  void set_counter_bits(int bits) noexcept { counts_.set_counter_bits(bits); }
  double wrap_time() const noexcept { return counts_.wrap_time(); }  ///< wrap_time() of these counters [s].

  /// Reads a sample at time `now` [s]; `free`: no brake holds. Returns its fault, or none.
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

  /// Encoder positions beyond counter wraps [counts].
  const typename encoder_check<N>::counts& position() const noexcept { return counts_.position(); }
  /// Time of that position [s]; 0 before the first good sample.
  double time() const noexcept { return time_; }
  const arrival_check& arrivals() const noexcept { return arrivals_; }  ///< Check for times of arrival.

 private:
  sample_check<N> sample_;
  encoder_check<N> counts_;
  arrival_check arrivals_;
  double time_ = 0;
};

/// Channels of a force sensor: reads and checks samples, ignores bad ones.
template <int N>
class believed_forces {
 public:
  /// late_after [s]: age at which a sample is bad. Throws std::invalid_argument for invalid limits.
  believed_forces(double late_after, const sensor_limits<N>& limits) : sample_(late_after), range_(limits) {}

  /// Reads a sample at time `now` [s]. Returns its fault, or none.
  template <class Sensor>
  fault_record read(Sensor& sensor, double now) noexcept {
    if constexpr (N == 0) return {};
    port_sample<N> sample;
    const port_status status = sensor.read(sample);
    fault_record found = sample_(status, sample, now, fault_source::force_sensor);
    // Forces need no homing
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
