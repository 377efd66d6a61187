// Controllers of any law, with and without a force sensor.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

#include <functional>

namespace experiments {

namespace ph = passive_haptics;

// A controller of any law, or none; runs are compiled once for all of them.
template <class M>
using any_control = std::function<ph::step_result<M>(const ph::device_state<M>&)>;

// Laws on a device with and without a force sensor.
template <class Law>
struct with_sensor {
  explicit with_sensor(Law l) : law(l) {}
  Law law;
  auto operator()(const auto& mechanism, const auto& brakes, auto scene) const {
    return ph::controller(mechanism, brakes, scene, law);
  }
};
template <class Law>
struct without_sensor {
  explicit without_sensor(Law l) : law(l) {}
  Law law;
  auto operator()(const auto& mechanism, const auto& brakes, auto scene) const {
    return ph::sensorless_controller(mechanism, brakes, scene, law);
  }
};

}  // namespace experiments
