/// @file
/// Functions of a device that are compiled once for each kind of mechanism (runtime/mechanism_of_kind.hpp).
#pragma once

#include "scene.hpp"

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/step_options.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/runtime/any_mechanism.hpp>
#include <passive_haptics/runtime/any_parameters.hpp>
#include <passive_haptics/runtime/any_plant.hpp>
#include <passive_haptics/runtime/brake_numbers.hpp>

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace explorer {

using runtime::brake_numbers;
using runtime::joint_numbers;
using numbers = std::span<const double>;  ///< n, m or d of them.

/// The brakes of a pose.
struct pose_brakes {
  joint_numbers rates;                           ///< [rad/s or m/s]
  joint_numbers signs;                           ///< s
  std::array<place, runtime::max_joints> E;      ///< Velocity of the handle for each rate [m/rad or 1].
  std::array<place, runtime::max_joints> force;  ///< Force for each torque [N per N m]; 0 if there is none.
  bool has_forces = false;                       ///< False at a singular pose, and for n > d.

  pose_brakes() {
    E.fill(place::Zero());
    force.fill(place::Zero());
  }
};

/// Brakes against a wall; see passive_haptics::displayable().
struct displayed_at_most {
  bool is_known = false;                                ///< False at an undefined pose.
  ph::display_class display = ph::display_class::none;  ///< As there.
  double angle = 0;                                     ///< [rad]
  double max_force = 0;                                 ///< [N]
  double max_approximated_force = 0;                    ///< [N]
};

/// A controller of one wall.
struct page_controller {
  std::function<runtime::cycle_record(const runtime::state_view&)> decide;  ///< One cycle.
  bool cuts_each_brake = false;  ///< At a torque limit; else all brakes are scaled by one factor.
};

/// A mechanism of any kind. Vectors of the task have z = 0 in the plane.
class device_kind {
 public:
  virtual ~device_kind() = default;
  /// Rates, signs and forces of the brakes under a hand force [N].
  virtual pose_brakes brakes_at(numbers q, numbers qd, const place& Fh,
                                const brake_numbers& brakes) const = 0;
  /// The least joint rates that move the handle with v [m/s]; none at an undefined pose.
  virtual joint_numbers rates_for(numbers q, const place& v) const = 0;
  /// The force at the handle that does what these brake torques [N m] do; 0 if there is none.
  virtual place force_of(numbers q, numbers torque) const = 0;
  /// The force of such torques once the self-motion has settled: those brakes are at rest that leave the
  /// others the least power. Of n = d as force_of().
  virtual place settled_force(numbers q, numbers qd, numbers torque, const brake_numbers& brakes) const = 0;
  /// See passive_haptics::displayable(), of a handle that moves with v.
  virtual displayed_at_most displayable(numbers q, const place& v, const place& normal,
                                        const brake_numbers& brakes) const = 0;
  /// The controller of a law of the catalogue, or of constant_scale.
  virtual page_controller controller(const std::string& law, const runtime::any_parameters& parameters,
                                     const brake_numbers& brakes, const scene_source& scene,
                                     const ph::step_options<double>& options) const = 0;
  /// The simulated device, with a mass of the hand [kg].
  virtual std::unique_ptr<runtime::any_plant> plant(const std::vector<runtime::run_time_brake>& brakes,
                                                    double hand_mass, numbers q) const = 0;
};

/// A constant alpha: the law of the slider.
struct constant_scale {
  static constexpr bool needs_hand_force = true;  ///< As direct_control, which it stands for.
  double alpha = 1;                               ///< The scale factor.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    return ph::member_table(ph::member("alpha", &constant_scale::alpha, "1", ph::range::between(0, 1)));
  }
  /// alpha
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    return T(alpha);
  }
};

// One source each; nullptr for a mechanism of another kind.
std::unique_ptr<device_kind> two_brakes(const runtime::any_mechanism& mechanism);
std::unique_ptr<device_kind> four_brakes(const runtime::any_mechanism& mechanism);
std::unique_ptr<device_kind> self_motion(const runtime::any_mechanism& mechanism);
std::unique_ptr<device_kind> in_space(const runtime::any_mechanism& mechanism);

/// The functions of a mechanism of the page.
inline std::unique_ptr<device_kind> kind_of(const runtime::any_mechanism& mechanism) {
  for (const auto make : {two_brakes, four_brakes, self_motion, in_space})
    if (auto made = make(mechanism)) return made;
  return nullptr;
}

}  // namespace explorer
