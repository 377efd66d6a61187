/// @file
/// All settings of a device, and their form as text.
#pragma once

#include "fields.hpp"
#include "kind.hpp"
#include "mechanisms.hpp"

#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/plant/following_hand.hpp>

#include <string>
#include <vector>

namespace explorer {

/// Who moves the handle in a simulation.
enum class hand_kind {
  pointer,  ///< A spring to the pointer.
  along,    ///< A hand that moves along the wall by itself.
};
/// The source of the desired force.
enum class desired_kind {
  scene,  ///< From the wall that the handle touches.
  given,  ///< From the state.
};

/// A wall, except its shape.
struct wall_settings {
  double stiffness = 1e7;  ///< [N/m], section 5.1.
  double rate = 0;         ///< Updates of it [Hz]; 0: each cycle. Section 5.2: 1000 and 20.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = wall_settings;
    return ph::member_table(ph::member("stiffness", &p::stiffness, "N/m", ph::range::not_negative),
                            ph::member("rate", &p::rate, "Hz", ph::range::not_negative));
  }
};

/// The hand that holds the handle: a mass on a spring to the pointer.
struct pointer_hand {
  double stiffness = 300;  ///< [N/m]
  double damping = 12;     ///< Against the handle's velocity [N s/m].
  double strength = 3;     ///< Most force of the spring [N].
  double mass = 0.3;       ///< Moves with the handle [kg].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = pointer_hand;
    return ph::member_table(ph::member("stiffness", &p::stiffness, "N/m", ph::range::not_negative),
                            ph::member("damping", &p::damping, "N s/m", ph::range::not_negative),
                            ph::member("strength", &p::strength, "N", ph::range::not_negative),
                            ph::member("mass", &p::mass, "kg", ph::range::not_negative));
  }
};

/// brake_parameters of m brakes, some of which may be absent.
struct brake_settings {
  std::vector<double> present;           ///< 1 or 0 for each brake.
  std::vector<double> torque_limit;      ///< As in brake_parameters, as all that follow.
  std::vector<double> rate_dead_band;    ///< As there.
  std::vector<double> torque_dead_band;  ///< As there.
  std::vector<double> time_constant;     ///< As there.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = brake_settings;
    return ph::member_table(
        ph::member("present", &p::present, "", ph::range::between(0, 1).as("1 or 0 for each brake")),
        ph::member("torque_limit", &p::torque_limit, "N m", ph::range::not_negative),
        ph::member("rate_dead_band", &p::rate_dead_band, "rad/s", ph::range::not_negative),
        ph::member("torque_dead_band", &p::torque_dead_band, "N m", ph::range::not_negative),
        ph::member("time_constant", &p::time_constant, "s", ph::range::not_negative));
  }
  /// True if there is a brake i.
  bool is_present(int i) const { return present[std::size_t(i)] >= 0.5; }
  /// The brakes as the controllers take them: absent ones are off.
  brake_numbers numbers() const;
};

/// The way of a hand that moves by itself.
struct hand_path {
  std::vector<double> direction;  ///< In which it moves.
  double length = 0.12;           ///< Way [m] after which it begins again.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = hand_path;
    return ph::member_table(ph::member("direction", &p::direction, "1", ph::range::direction),
                            ph::member("length", &p::length, "m", ph::range::positive));
  }
};

/// The task of the design map.
struct map_task {
  std::vector<double> direction;  ///< In which the handle moves.
  std::vector<double> normal;     ///< Out of the wall.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = map_task;
    return ph::member_table(ph::member("direction", &p::direction, "1", ph::range::direction),
                            ph::member("normal", &p::normal, "1", ph::range::direction));
  }
};

/// Settings without a group: the wall and the state.
struct state_settings {
  std::string scene;                           ///< The wall.
  desired_kind desired = desired_kind::scene;  ///< The source of Fd.
  hand_kind hand = hand_kind::pointer;         ///< Who moves the handle.
  std::vector<double> q, qd;                   ///< n joint positions and rates.
  std::vector<double> Fh, Fd;                  ///< d, hand force and desired force [N].
  double alpha = -1;                           ///< Scale factor; < 0: that of the law.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = state_settings;
    return ph::member_table(
        ph::member("scene", &p::scene), ph::choice("desired", &p::desired, "scene, given"),
        ph::choice("hand", &p::hand, "pointer, along"),
        ph::member("q", &p::q, "rad or m", ph::range::between(-1e6, 1e6)),  // whose sine has a meaning
        ph::member("qd", &p::qd, "rad/s or m/s", ph::range::finite),
        ph::member("Fh", &p::Fh, "N", ph::range::finite), ph::member("Fd", &p::Fd, "N", ph::range::finite),
        ph::member("alpha", &p::alpha, "1", ph::range::between(-1, 1)));
  }
};

/// All settings of a device.
struct configuration {
  const page_mechanism* about;                   ///< The mechanism.
  runtime::device_sizes sizes;                   ///< n, d and m.
  runtime::any_parameters mechanism;             ///< Lengths and masses.
  brake_settings brakes;                         ///< Limits, dead bands and lags.
  std::size_t law = 0;                           ///< The number of the law in the catalogue.
  std::vector<runtime::any_parameters> laws;     ///< Parameters of all laws.
  ph::approximation_parameters<double> options;  ///< For the approximation.
  wall_settings wall;                            ///< Except the shape.
  pointer_hand hand;                             ///< At the pointer.
  ph::following_hand_parameters<double> along;   ///< By itself.
  hand_path path;                                ///< Its way.
  map_task map;                                  ///< For the design map.
  state_settings state;                          ///< The rest.

  /// All default settings of a mechanism.
  explicit configuration(const page_mechanism& of);

  /// Those of the same mechanism under the same law.
  configuration defaults() const;
  /// All fields of these settings by address; of the laws those of the chosen one.
  field_list fields();
  /// Sets what these lines name. Throws std::invalid_argument if one is not known or not valid.
  void take(const settings& given);
  /// The mechanism itself. Throws std::invalid_argument.
  std::unique_ptr<runtime::any_mechanism> make_mechanism() const;
  /// The name of the law.
  const std::string& law_name() const { return catalogue().laws()[law].name; }
  /// A controller under the law, or with the given alpha if there is one.
  page_controller controller(const device_kind& kind, const scene_source& scene) const;
  /// A controller without a law: alpha = 1.
  page_controller controller_without_law(const device_kind& kind, const scene_source& scene) const;
  /// The scene of this wall.
  scene_source scene_of(const wall_shape& shape) const { return {&shape, wall.stiffness, wall.rate}; }
};

}  // namespace explorer
