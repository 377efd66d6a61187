/// A simulated bench: one brake on an axis that a motor rotates, behind counts, readings and currents.
#pragma once

#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/driver/port.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <utility>

namespace example {

namespace ph = passive_haptics;

struct simulated_bench_parameters {
  double period = 1e-3;                             // of the loop [s]
  double time_step = 1e-4;                          // of the simulation [s]
  double resolution = 2 * std::numbers::pi / 8192;  // of the encoder [rad]
  double noise = 0.005;                             // of the torque sensor, standard deviation [N m]
  std::uint64_t seed = 1;                           // of that noise
};

/// The axis rotates at rate(t) [rad/s], independent of the brake; command_of(I) [N m] is the brake's command
/// for a current. Each wait() advances its clock by a period.
template <ph::BrakeModel Model>
class simulated_bench {
 public:
  using function = std::function<double(double)>;

  simulated_bench(const Model& brake, function command_of, function rate,
                  const simulated_bench_parameters& p = {})
      : brake_(brake),
        command_of_(std::move(command_of)),
        rate_(std::move(rate)),
        p_(p),
        bits_(ph::random_bits(p.seed, 0)) {}

  /// Waits for the next period; returns its time [s].
  double wait() {
    const auto steps = static_cast<int>(std::lround(p_.period / p_.time_step));
    for (int i = 0; i < steps; ++i) {
      const double rate = rate_(time());
      const auto commanded = brake_.advance(p_.time_step, command_of_(current_), rate, state_);
      const auto residual = residual_of(brake_);
      torque_ = (rate > 0 ? 1 : -1) * (commanded.strength + residual.strength) +
                (commanded.drag + residual.drag) * rate;
      position_ += p_.time_step * rate;
      ++ticks_;
    }
    return time();
  }
  double time() const { return p_.time_step * static_cast<double>(ticks_); }
  double counts() const { return std::floor(position_ / p_.resolution); }
  double reading() { return torque_ + p_.noise * ph::normal_number(bits_); }
  void set(double current) { current_ = current; }

 private:
  Model brake_;
  typename Model::state state_ = {};
  function command_of_, rate_;
  simulated_bench_parameters p_;
  std::mt19937_64 bits_;
  double current_ = 0, torque_ = 0, position_ = 0;
  long ticks_ = 0;
};

/// BrakePort of a bench with one brake and one encoder.
template <class Bench>
struct simulated_bench_port {
  static constexpr int encoder_count = 1, brake_count = 1;
  Bench* bench;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<1>& sample) noexcept {
    sample = {bench->time(), ++sequence, {bench->counts()}, {true}};
    return ph::port_status::ok;
  }
  ph::port_status write(const ph::brake_currents<1>& currents) noexcept {
    bench->set(currents[0]);
    return ph::port_status::ok;
  }
  void release() noexcept { bench->set(0); }
};

/// Its torque sensor.
template <class Bench>
struct simulated_torque_sensor {
  static constexpr int channel_count = 1;
  Bench* bench;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<1>& sample) noexcept {
    sample = {bench->time(), ++sequence, {bench->reading()}, {true}};
    return ph::port_status::ok;
  }
};

}  // namespace example
