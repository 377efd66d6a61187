/// @file
/// A device by names and numbers: everything that its controller is made of.
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
  std::string name;           ///< In the catalogue.
  any_parameters parameters;  ///< As its defaults.
};

/// A wall by names and numbers.
struct wall_description {
  /// The shape; if it is made of another one, as an offset is, that next.
  std::vector<named_parameters> shapes;
  double stiffness = 1e7;                ///< [N/m]
  std::optional<any_parameters> motion;  ///< A wall_motion of its dimension; none of a wall that stays.
};

/// The entry of this name. Throws std::invalid_argument if there is none.
template <class Entry>
const Entry& entry_of(const std::vector<Entry>& all, const std::string& name) {
  if (const Entry* found = find(all, name)) return *found;
  throw std::invalid_argument("passive_haptics: name = \"" + name + "\", expected one of the catalogue");
}

/// The shape of a wall from the given one of its shapes on, 0 for all of it; none behind the last one. Throws
/// std::invalid_argument where a constructor does, or if the catalogue lacks a shape.
template <int D>
std::optional<any_shape<D>> make_shape(const catalogue& all, const wall_description& w, std::size_t from) {
  std::optional<any_shape<D>> made;
  for (std::size_t i = w.shapes.size(); i-- > from;) {
    const auto& shape = entry_of(all.shapes<D>(), w.shapes[i].name);
    if (!shape.make)
      throw std::invalid_argument("passive_haptics: of = \"" + shape.name +
                                  "\", expected a shape with an inside");
    made = shape.make(w.shapes[i].parameters, made ? &*made : nullptr);
  }
  return made;
}

/// A wall of D dimensions. Throws as make_shape does.
template <int D>
any_wall<D> make_wall(const catalogue& all, const wall_description& w) {
  const auto of = make_shape<D>(all, w, 1);
  const named_parameters& outer = w.shapes.at(0);
  return entry_of(all.shapes<D>(), outer.name).make_wall(outer.parameters, of ? &*of : nullptr, w.stiffness);
}

/// Options of a cycle, as step_options has them.
struct cycle_options {
  approximation_parameters<double> approximation;  ///< See there.
  saturation limits = saturation::keep_direction;  ///< At a torque limit.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = cycle_options;
    return member_table(member("approximation", &p::approximation),
                        choice("limits", &p::limits, "keep_direction, clamp_each"));
  }
  /// Those of a controller. The default angle needs no cosine, which another libm rounds in another way.
  step_options<double> for_controller() const {
    step_options<double> made;
    if (approximation.max_approximation_angle != approximation_parameters<double>().max_approximation_angle)
      made = step_options<double>(approximation);
    made.limits = limits;
    return made;
  }
};

/// A device by names and numbers. The default is the paper's, in front of no wall.
struct device_description {
  named_parameters mechanism{"tendon_two_link", {}};  ///< Of a device file.
  brake_numbers brakes;                               ///< As many as the mechanism has.
  std::vector<named_parameters> brake_models;         ///< Of a simulation: one for each brake, or none.
  named_parameters law;                               ///< Compiled for the mechanism.
  cycle_options options;                              ///< Of a cycle.
  std::vector<wall_description> walls;                ///< Numbered from 0 in a scene.
  std::vector<named_parameters> effects;              ///< Of the device's dimension.
  hold_parameters scene;         ///< The scene is sampled so often; with a period of 0 in each cycle.
  bool has_force_sensor = true;  ///< Else no state has a hand force.
  std::string remarks;           ///< A line for each value that is allowed but unusual.

  /// Throws std::invalid_argument where a constructor does, or if `all` lacks a name; so do the others.
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
