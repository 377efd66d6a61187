/// @file
/// The simulated device of one mechanism.
#pragma once

#include <passive_haptics_python/any_simulation.hpp>
#include <passive_haptics_python/from_python.hpp>

#include <utility>

namespace passive_haptics_python {

/// simulated_device of mechanism M, whose brakes are of any model.
template <class M>
class simulation_of final : public any_simulation {
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  using device_type = ph::simulated_device<M, run_time_brake>;

 public:
  /// Of these arguments of a simulated_device.
  simulation_of(const M& mechanism, const ph::brake_models_of<M, run_time_brake>& brakes, double hand_mass,
                const ph::joint_vector<M>& q)
      : device_(mechanism, brakes, hand_mass, q) {}

  void advance(double dt, const numbers& capacity, const numbers& muscle_force) override {
    device_.advance(dt, sized<m>(capacity, "capacity", "brakes"),
                    sized<d>(muscle_force, "muscle_force", "task dimensions"));
  }
  void set_motion(const numbers& q, const numbers& qd) override {
    device_.set_motion(sized<n>(q, "q", "joints"), sized<n>(qd, "qd", "joints"));
  }
  numbers q() const override { return device_.q(); }
  numbers qd() const override { return device_.qd(); }
  numbers position() const override { return device_.position(); }
  numbers velocity() const override { return device_.velocity(); }
  numbers rates() const override { return device_.rates(); }
  numbers sensed_force() const override { return device_.sensed_force(); }
  numbers brake_torque() const override { return device_.brake_torque(); }
  numbers brake_force() const override { return device_.brake_force(); }
  const ph::energy_balance& energy() const override { return device_.energy(); }

  ph::contact_metrics follow_wall(any_controller& control, const shape_geometry& shape,
                                  const hand_values& hand, const ph::wall_following_parameters& parameters,
                                  following_observer& observer) override {
    const auto* wall = std::get_if<any_shape<d>>(&shape);
    if (wall == nullptr)
      refuse_value("shape has dimension " + std::to_string(5 - d) + ", expected " + std::to_string(d) +
                   ", the task dimension of the device");
    const ph::following_hand<double, d> of_hand(sized<d>(hand.direction, "direction", "task dimensions"),
                                                sized<d>(hand.start, "start", "task dimensions"),
                                                hand.parameters);
    state_values state;
    state.hand_force.emplace();
    const auto decide = [&](const ph::device_state<M>& s) {
      state.time = s.time;
      state.q = s.q;
      state.qd = s.qd;
      *state.hand_force = s.hand_force;
      decision now{{}, control.step(state)};
      now.capacity = sized<m>(now.result.capacity, "capacity", "brakes");
      return now;
    };
    return ph::follow_wall(device_, decide, *wall, of_hand, parameters, [&](const auto& sample) {
      observer.see({sample.time, sample.depth, sample.position.data(), sample.velocity.data(),
                    sample.rates.data(), sample.brake_torque.data(), sample.brake_power.data(),
                    sample.hand_force.data(), sample.brake_force.data(), &sample.control->result});
    });
  }

 private:
  // What follow_wall keeps of a cycle.
  struct decision {
    ph::brake_vector<M> capacity = ph::brake_vector<M>::Zero();
    result_values result;
  };

  device_type device_;
};

/// An array of as many models as the device has brakes; a ValueError for another number.
template <class M>
ph::brake_models_of<M, run_time_brake> models_for(const std::vector<run_time_brake>& brakes) {
  if (int(brakes.size()) != M::brake_count)
    refuse_value("number of brakes = " + std::to_string(brakes.size()) + ", expected " +
                 std::to_string(M::brake_count) + ", a model for each brake of the mechanism");
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return ph::brake_models_of<M, run_time_brake>{brakes[I]...};
  }(std::make_index_sequence<std::size_t(M::brake_count)>());
}

}  // namespace passive_haptics_python
