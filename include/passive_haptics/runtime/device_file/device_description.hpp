/// A device by names and numbers: all that its controller needs.
#pragma once

#include <passive_haptics/runtime/catalogue.hpp>
#include <passive_haptics/runtime/wall_motion.hpp>
#include <passive_haptics/scene/held_scene.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// An entry of a catalogue, and its parameters.
struct named_parameters {
  std::string name;           ///< Name in the catalogue.
  any_parameters parameters;  ///< Its parameters.
};

/// A wall by names and numbers.
struct wall_description {
  /// The shape, followed by the shapes that it is made from (as an offset).
  std::vector<named_parameters> shapes;
  double stiffness = 1e7;                ///< [N/m]
  std::optional<any_parameters> motion;  ///< wall_motion of its dimension; empty for a wall at rest.
};

/// The entry with this name. Throws std::invalid_argument if there is none.
template <class Entry>
const Entry& entry_of(const std::vector<Entry>& all, const std::string& name) {
  if (const Entry* found = find(all, name)) return *found;
  throw std::invalid_argument("passive_haptics: name = \"" + name + "\": expected one of the catalogue");
}

/// The shape of a wall from element `from` of its shapes on, 0 for all of it; empty after the last one.
/// Throws std::invalid_argument as a constructor, or if the catalogue lacks a shape.
template <int D>
std::optional<any_shape<D>> make_shape(const catalogue& all, const wall_description& w, std::size_t from) {
  std::optional<any_shape<D>> made;
  for (std::size_t i = w.shapes.size(); i-- > from;) {
    const auto& shape = entry_of(all.shapes<D>(), w.shapes[i].name);
    if (!shape.make)
      throw std::invalid_argument("passive_haptics: of = \"" + shape.name +
                                  "\": expected a shape with an inside");
    made = shape.make(w.shapes[i].parameters, made ? &*made : nullptr);
  }
  return made;
}

/// Makes a wall of D dimensions. Throws as make_shape.
template <int D>
any_wall<D> make_wall(const catalogue& all, const wall_description& w) {
  const auto of = make_shape<D>(all, w, 1);
  const named_parameters& outer = w.shapes.at(0);
  return entry_of(all.shapes<D>(), outer.name).make_wall(outer.parameters, of ? &*of : nullptr, w.stiffness);
}

/// Options of a cycle, as step_options.
struct cycle_options {
  approximation_parameters<double> approximation;  ///< As there.
  saturation limits = saturation::keep_direction;  ///< At a torque limit.

  static constexpr auto members() {
    using p = cycle_options;
    return member_table(member("approximation", &p::approximation),
                        choice("limits", &p::limits, "keep_direction, clamp_each"));
  }
  /// Options of a controller. The default angle avoids a cosine, which libraries round differently.
  step_options<double> for_controller() const {
    step_options<double> made;
    if (approximation.max_approximation_angle != approximation_parameters<double>().max_approximation_angle)
      made = step_options<double>(approximation);
    made.limits = limits;
    return made;
  }
};

/// A device by names and numbers. The default is the paper's, without walls.
struct device_description {
  named_parameters mechanism{"tendon_two_link", {}};  ///< Mechanism.
  brake_numbers brakes;                               ///< As many as the mechanism has.
  std::vector<named_parameters> brake_models;         ///< For a simulation: one per brake, or none.
  named_parameters law;                               ///< Law, compiled for the mechanism.
  cycle_options options;                              ///< Options of a cycle.
  std::vector<wall_description> walls;                ///< Walls, numbered from 0 in a scene.
  std::vector<named_parameters> effects;              ///< Effects of the device's dimension.
  hold_parameters scene;                              ///< Sampling period; 0 samples in each cycle.
  bool has_force_sensor = true;                       ///< False if no state has a hand force.
  std::string remarks;                                ///< One line per allowed but unusual value.

  /// Throws std::invalid_argument as a constructor, or if `all` lacks a name, like the other functions.
  std::unique_ptr<any_mechanism> make_mechanism(const catalogue& all) const {
    return entry_of(all.mechanisms(), mechanism.name).make(mechanism.parameters);
  }
  /// A world of the walls, with the effects. Defined in definitions.hpp.
  scene_variant make_scene(const catalogue& all) const;
  /// A controller of this mechanism in this scene.
  std::unique_ptr<any_controller> make_controller(const catalogue& all, const any_mechanism& of) const {
    return all.make_controller(of, entry_of(all.laws(), law.name),
                               {brakes, make_scene(all), law.parameters, options.for_controller()});
  }
};

}  // namespace passive_haptics::runtime
