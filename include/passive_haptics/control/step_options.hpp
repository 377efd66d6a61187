/// @file
/// Options of a control cycle and what it remembers.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/saturation.hpp>
#include <passive_haptics/force/approximation.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// Options of a step; made once, outside the loop.
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

/// What a step remembers; start a motion with a fresh one.
template <class L>
struct step_memory {
  [[no_unique_address]] law_memory<L> law = {};  ///< The law's own part.
  half_space_start start = {};                   ///< Where the next approximation begins.
};

}  // namespace passive_haptics
