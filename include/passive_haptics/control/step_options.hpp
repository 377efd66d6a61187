/// @file
/// The options of a control cycle: the largest angle of an approximation, and what gives way at a torque
/// limit.
#pragma once

#include <passive_haptics/control/saturation.hpp>
#include <passive_haptics/force/approximation.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Options of a step; made once, outside the loop. Every ScalingLaw obeys them. A TorqueLaw gets them
/// (brake_situation::options); on_off_control obeys them, and velocity_direct_control if it approximates
/// forces (n > d). The others choose the torque of each brake themselves. Both options are those of one wall:
/// forces of several walls are met together, within all limits and without a cut-off.
template <class T>
struct step_options {
  /// The defaults of approximation_parameters; torques keep their direction at a limit.
  step_options() = default;
  /// Throws std::invalid_argument with the text of validate(approximation).
  explicit step_options(const approximation_parameters<T>& approximation,
                        saturation on_limit = saturation::keep_direction)
      : min_cosine(std::max(T(0), std::cos(require_valid(approximation).max_approximation_angle))),
        limits(on_limit) {}

  T min_cosine = T(0.0174524064372835128L);        ///< Cosine of max_approximation_angle; 0: no cut-off.
  saturation limits = saturation::keep_direction;  ///< What gives way at a torque limit.
};

}  // namespace passive_haptics
