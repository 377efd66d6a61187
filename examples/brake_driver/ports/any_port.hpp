/// Ports and sensors chosen by the configuration file.
#pragma once

#include <devices/driven_mechanism.hpp>

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace example {

namespace detail {

// Reads a sample of a device with fewer channels; missing channels read 0.
template <class Device, int Own, int All>
ph::port_status read_filled_up(Device& device, ph::port_sample<All>& sample) noexcept {
  static_assert(Own <= All);
  ph::port_sample<Own> own;
  const ph::port_status status = device.read(own);
  sample.time = own.time;
  sample.sequence = own.sequence;
  sample.valid.fill(true);
  std::ranges::copy(own.value, sample.value.begin());
  std::ranges::copy(own.valid, sample.valid.begin());
  return status;
}

}  // namespace detail

/// Any BrakePort with up to eight encoders and brakes.
class any_brake_port {
 public:
  static constexpr int encoder_count = max_axes, brake_count = max_axes;

  /// A Port constructed from these arguments.
  template <class Port, class... Arguments>
  static any_brake_port of(Arguments&&... arguments) {
    return any_brake_port(std::make_unique<model<Port>>(std::forward<Arguments>(arguments)...));
  }

  std::string open() { return port_->open(); }
  ph::port_status read(ph::port_sample<max_axes>& sample) noexcept { return port_->read(sample); }
  ph::port_status write(const ph::brake_currents<max_axes>& currents) noexcept {
    return port_->write(currents);
  }
  void release() noexcept { port_->release(); }
  int counter_bits() const noexcept { return port_->counter_bits(); }
  double watchdog() const noexcept { return port_->watchdog(); }

 private:
  struct interface {
    virtual ~interface() = default;
    virtual std::string open() = 0;
    virtual ph::port_status read(ph::port_sample<max_axes>&) noexcept = 0;
    virtual ph::port_status write(const ph::brake_currents<max_axes>&) noexcept = 0;
    virtual void release() noexcept = 0;
    virtual int counter_bits() const noexcept = 0;
    virtual double watchdog() const noexcept = 0;
  };
  template <class Port>
  struct model final : interface {
    template <class... Arguments>
    explicit model(Arguments&&... arguments) : port(std::forward<Arguments>(arguments)...) {}
    std::string open() override { return port.open(); }
    ph::port_status read(ph::port_sample<max_axes>& sample) noexcept override {
      return detail::read_filled_up<Port, Port::encoder_count>(port, sample);
    }
    ph::port_status write(const ph::brake_currents<max_axes>& currents) noexcept override {
      ph::brake_currents<Port::brake_count> own;
      std::copy_n(currents.begin(), own.size(), own.begin());
      return port.write(own);
    }
    void release() noexcept override { port.release(); }
    int counter_bits() const noexcept override { return ph::counter_bits(port); }
    double watchdog() const noexcept override { return ph::watchdog(port); }
    Port port;
  };
  explicit any_brake_port(std::unique_ptr<interface> port) : port_(std::move(port)) {}

  std::unique_ptr<interface> port_;
};

/// Any ForceSensor with up to six channels.
class any_force_sensor {
 public:
  static constexpr int channel_count = 6;

  /// A Sensor constructed from these arguments.
  template <class Sensor, class... Arguments>
  static any_force_sensor of(Arguments&&... arguments) {
    return any_force_sensor(std::make_unique<model<Sensor>>(std::forward<Arguments>(arguments)...));
  }
  static any_force_sensor none() { return any_force_sensor(nullptr); }

  std::string open() { return sensor_ == nullptr ? "" : sensor_->open(); }
  ph::port_status read(ph::port_sample<6>& sample) noexcept {
    if (sensor_ != nullptr) return sensor_->read(sample);
    sample.valid.fill(true);
    sample.sequence = ++sequence_;
    sample.time = ph::monotonic_seconds();
    return ph::port_status::ok;
  }

 private:
  struct interface {
    virtual ~interface() = default;
    virtual std::string open() = 0;
    virtual ph::port_status read(ph::port_sample<6>&) noexcept = 0;
  };
  template <class Sensor>
  struct model final : interface {
    template <class... Arguments>
    explicit model(Arguments&&... arguments) : sensor(std::forward<Arguments>(arguments)...) {}
    std::string open() override { return sensor.open(); }
    ph::port_status read(ph::port_sample<6>& sample) noexcept override {
      return detail::read_filled_up<Sensor, Sensor::channel_count>(sensor, sample);
    }
    Sensor sensor;
  };
  explicit any_force_sensor(std::unique_ptr<interface> sensor) : sensor_(std::move(sensor)) {}

  std::unique_ptr<interface> sensor_;
  std::uint32_t sequence_ = 0;
};

}  // namespace example
