/// @file
/// Ports of which only the configuration file knows what they are.
#pragma once

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <memory>
#include <string>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// Any BrakePort with so many encoders and brakes.
template <int Encoders, int Brakes>
class any_brake_port {
 public:
  static constexpr int encoder_count = Encoders, brake_count = Brakes;

  /// A Port made of these arguments.
  template <class Port, class... Arguments>
  static any_brake_port of(Arguments&&... arguments) {
    return any_brake_port(std::make_unique<model<Port>>(std::forward<Arguments>(arguments)...));
  }

  std::string open() { return port_->open(); }
  ph::port_status read(ph::port_sample<Encoders>& sample) noexcept { return port_->read(sample); }
  ph::port_status write(const ph::brake_currents<Brakes>& currents) noexcept {
    return port_->write(currents);
  }
  void release() noexcept { port_->release(); }
  int counter_bits() const noexcept { return port_->counter_bits(); }
  double watchdog() const noexcept { return port_->watchdog(); }

 private:
  struct interface {
    virtual ~interface() = default;
    virtual std::string open() = 0;
    virtual ph::port_status read(ph::port_sample<Encoders>&) noexcept = 0;
    virtual ph::port_status write(const ph::brake_currents<Brakes>&) noexcept = 0;
    virtual void release() noexcept = 0;
    virtual int counter_bits() const noexcept = 0;
    virtual double watchdog() const noexcept = 0;
  };
  template <class Port>
  struct model final : interface {
    template <class... Arguments>
    explicit model(Arguments&&... arguments) : port(std::forward<Arguments>(arguments)...) {}
    std::string open() override { return port.open(); }
    ph::port_status read(ph::port_sample<Encoders>& sample) noexcept override { return port.read(sample); }
    ph::port_status write(const ph::brake_currents<Brakes>& currents) noexcept override {
      return port.write(currents);
    }
    void release() noexcept override { port.release(); }
    int counter_bits() const noexcept override { return ph::counter_bits(port); }
    double watchdog() const noexcept override { return ph::watchdog(port); }
    Port port;
  };
  explicit any_brake_port(std::unique_ptr<interface> port) : port_(std::move(port)) {}

  std::unique_ptr<interface> port_;
};

/// Any ForceSensor with up to six channels; those that it lacks read 0.
class any_force_sensor {
 public:
  static constexpr int channel_count = 6;

  /// A Sensor made of these arguments.
  template <class Sensor, class... Arguments>
  static any_force_sensor of(Arguments&&... arguments) {
    return any_force_sensor(std::make_unique<model<Sensor>>(std::forward<Arguments>(arguments)...));
  }
  /// None: no force, ever.
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
    static constexpr int channels = Sensor::channel_count;
    static_assert(channels <= 6);
    template <class... Arguments>
    explicit model(Arguments&&... arguments) : sensor(std::forward<Arguments>(arguments)...) {}
    std::string open() override { return sensor.open(); }
    ph::port_status read(ph::port_sample<6>& sample) noexcept override {
      ph::port_sample<channels> own;
      const ph::port_status status = sensor.read(own);
      sample.time = own.time;
      sample.sequence = own.sequence;
      sample.valid.fill(true);
      for (std::size_t i = 0; i < own.value.size(); ++i) {
        sample.value[i] = own.value[i];
        sample.valid[i] = own.valid[i];
      }
      return status;
    }
    Sensor sensor;
  };
  explicit any_force_sensor(std::unique_ptr<interface> sensor) : sensor_(std::move(sensor)) {}

  std::unique_ptr<interface> sensor_;
  std::uint32_t sequence_ = 0;
};

}  // namespace example
