/// Simulated devices with a mechanism and brakes chosen at run time.
#pragma once

#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/runtime/cycle_record.hpp>
#include <passive_haptics/runtime/run_time_brake.hpp>

#include <vector>

namespace passive_haptics::runtime {

/// A simulated_device behind virtual functions, with its units.
class any_plant {
 public:
  virtual ~any_plant() = default;
  /// Advances by dt [s] under m capacities and d components of the muscle force.
  virtual void advance(double dt, std::span<const double> capacity, std::span<const double> muscle_force) = 0;
  /// Sets n joint positions and rates.
  virtual void set_motion(std::span<const double> q, std::span<const double> qd) = 0;
  virtual joint_numbers q() const = 0;               ///< n
  virtual joint_numbers qd() const = 0;              ///< n
  virtual joint_numbers rates() const = 0;           ///< m
  virtual joint_numbers brake_torque() const = 0;    ///< m
  virtual joint_numbers brake_power() const = 0;     ///< m
  virtual task_numbers position() const = 0;         ///< d
  virtual task_numbers velocity() const = 0;         ///< d
  virtual task_numbers sensed_force() const = 0;     ///< d
  virtual task_numbers brake_force() const = 0;      ///< d
  virtual double min_mass() const = 0;               ///< As simulated_device [kg].
  virtual const energy_balance& energy() const = 0;  ///< Since the last set_motion.
};

/// Compiled once per kind of mechanism.
template <class M>
class plant_of final : public any_plant {
 public:
  /// A simulated_device at rest at q. Throws std::invalid_argument as there, or for another number of brakes.
  plant_of(const M& mechanism, const std::vector<run_time_brake>& brakes, double hand_mass,
           std::span<const double> q)
      : device_(mechanism, models_from(brakes), hand_mass, joint_vector<M>(q.data())) {}

  void advance(double dt, std::span<const double> capacity, std::span<const double> muscle_force) override {
    device_.advance(dt, brake_vector<M>(capacity.data()), task_vector<M>(muscle_force.data()));
  }
  void set_motion(std::span<const double> q, std::span<const double> qd) override {
    device_.set_motion(joint_vector<M>(q.data()), joint_vector<M>(qd.data()));
  }
  joint_numbers q() const override { return joint_numbers(device_.q()); }
  joint_numbers qd() const override { return joint_numbers(device_.qd()); }
  joint_numbers rates() const override { return joint_numbers(device_.rates()); }
  joint_numbers brake_torque() const override { return joint_numbers(device_.brake_torque()); }
  joint_numbers brake_power() const override { return joint_numbers(device_.brake_power()); }
  task_numbers position() const override { return task_numbers(device_.position()); }
  task_numbers velocity() const override { return task_numbers(device_.velocity()); }
  task_numbers sensed_force() const override { return task_numbers(device_.sensed_force()); }
  task_numbers brake_force() const override { return task_numbers(device_.brake_force()); }
  double min_mass() const override { return device_.min_mass(); }
  const energy_balance& energy() const override { return device_.energy(); }

  simulated_device<M, run_time_brake>& device() { return device_; }  ///< The device.

 private:
  static brake_models_of<M, run_time_brake> models_from(const std::vector<run_time_brake>& brakes) {
    require_count("brake models", std::ssize(brakes), M::brake_count);
    return [&]<std::size_t... Index>(std::index_sequence<Index...>) {
      return brake_models_of<M, run_time_brake>{brakes[Index]...};
    }(std::make_index_sequence<static_cast<std::size_t>(M::brake_count)>());
  }

  simulated_device<M, run_time_brake> device_;
};

}  // namespace passive_haptics::runtime
