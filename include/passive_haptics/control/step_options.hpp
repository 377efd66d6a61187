/// Options of a control cycle: approximation and torque limits.
#pragma once

#include <passive_haptics/control/saturation.hpp>
#include <passive_haptics/force/approximation.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Options of a step. All ScalingLaws use them. A TorqueLaw receives them in brake_situation::options:
/// on_off_control uses them, and velocity_direct_control if it approximates forces (n > d). They apply to one
/// wall; forces of several walls have no maximum angle. Construct them outside the loop.
template <class T>
struct step_options {
  step_options() = default;  ///< Default approximation_parameters and saturation::keep_direction.
  /// Throws std::invalid_argument if validate(approximation) returns an error.
  explicit step_options(const approximation_parameters<T>& approximation,
                        saturation on_limit = saturation::keep_direction)
      : min_cosine(std::max(T(0), std::cos(require_valid(approximation).max_approximation_angle))),
        limits(on_limit) {}

  T min_cosine = T(0.0174524064372835128L);        ///< Cosine of max_approximation_angle; 0: no maximum.
  saturation limits = saturation::keep_direction;  ///< Handling of torque limits.
};

}  // namespace passive_haptics
