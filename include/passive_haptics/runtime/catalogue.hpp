/// Mechanisms, laws, shapes and brake models by name, and the code compiled for them. examples/catalogue
/// registers those of the library; a program adds its own with one line each.
#pragma once

#include <passive_haptics/runtime/any_controller.hpp>
#include <passive_haptics/runtime/any_mechanism.hpp>
#include <passive_haptics/runtime/any_plant.hpp>
#include <passive_haptics/runtime/any_shape.hpp>
#include <passive_haptics/runtime/braked_wall.hpp>
#include <passive_haptics/runtime/urdf_mechanism.hpp>
#include <passive_haptics/scene/world/any_wall.hpp>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// A law by name.
struct law_entry {
  std::string name;               ///< As in a device file.
  any_parameters defaults;        ///< Parameters.
  bool needs_hand_force = false;  ///< As in the law, like the next two.
  bool needs_dynamics = false;    ///< As in the law.
  bool takes_one_wall = false;    ///< Receives only the strongest contact.
  bool displays_effects = false;  ///< For devices with n = m = d (takes_effects).
  std::type_index type;           ///< Type of the law.
};

/// A mechanism by name.
struct mechanism_entry {
  std::string name;          ///< As in a device file.
  any_parameters defaults;   ///< Parameters.
  device_sizes sizes;        ///< n, d and m.
  bool has_inertia = false;  ///< Models Dynamics.
  /// Makes the mechanism. Throws std::invalid_argument as its constructor.
  std::function<std::unique_ptr<any_mechanism>(const any_parameters&)> make;
};

/// A shape by name.
template <int D>
struct shape_entry {
  std::string name;          ///< As in a device file.
  any_parameters defaults;   ///< Parameters.
  bool takes_shape = false;  ///< Made from another shape, as an offset; others receive nullptr.
  /// Makes the shape. Throws std::invalid_argument as its constructor. Empty for walls that are not a Shape.
  std::function<any_shape<D>(const any_parameters&, const any_shape<D>* of)> make;
  /// Makes a wall of it with this stiffness [N/m], in the same way.
  std::function<any_wall<D>(const any_parameters&, const any_shape<D>* of, double stiffness)> make_wall;
};

/// An effect by name.
template <int D>
struct effect_entry {
  std::string name;         ///< As in a device file.
  any_parameters defaults;  ///< Parameters.
  /// Makes the effect. Throws std::invalid_argument as its constructor.
  std::function<any_effect<D>(const any_parameters&)> make;
};

/// A brake model by name.
struct brake_model_entry {
  std::string name;                                           ///< As in a device file.
  any_parameters defaults;                                    ///< Parameters.
  std::function<run_time_brake(const any_parameters&)> make;  ///< Makes the model.
};

/// A law type with its name.
template <ControlLaw L>
struct named_law {
  const char* name;  ///< As in a device file.
};

/// All named types, and controllers compiled for kinds of mechanisms. Fill it before threads start.
class catalogue {
 public:
  /// All mechanisms in order of registration.
  const std::vector<mechanism_entry>& mechanisms() const { return mechanisms_; }
  /// All laws, in the order of preference.
  const std::vector<law_entry>& laws() const { return laws_; }
  /// All brake models.
  const std::vector<brake_model_entry>& brake_models() const { return brake_models_; }
  /// The shapes of D dimensions.
  template <int D>
  const std::vector<shape_entry<D>>& shapes() const {
    if constexpr (D == 2) return shapes_in_the_plane_;
    else return shapes_in_space_;
  }

  /// The effects of D dimensions.
  template <int D>
  const std::vector<effect_entry<D>>& effects() const {
    if constexpr (D == 2) return effects_in_the_plane_;
    else return effects_in_space_;
  }

  /// Adds a mechanism with parameters P, or none.
  template <DifferentiableMechanism M, Parameters P = no_parameters>
  void add_mechanism(std::string name) {
    mechanisms_.push_back({std::move(name),
                           any_parameters(P()),
                           {M::dof, M::task_dimension, M::brake_count},
                           Dynamics<M>,
                           [](const any_parameters& p) -> std::unique_ptr<any_mechanism> {
                             if constexpr (std::is_same_v<P, no_parameters>)
                               return std::make_unique<mechanism_model<M>>(M());
                             else return std::make_unique<mechanism_model<M>>(M(p.as<P>()));
                           }});
  }
  /// Adds laws.
  template <class... L>
  void add_laws(const named_law<L>&... laws) {
    (laws_.push_back({laws.name, any_parameters(law_parameters<L>()), needs_hand_force<L>, needs_dynamics<L>,
                      saturates_before_scaling<L>, displays_effects<L>, typeid(L)}),
     ...);
  }
  /// Adds a shape with parameters P.
  template <Shape S, Parameters P>
  void add_shape(std::string name) {
    constexpr int D = S::dimension;
    add_shape<D>({std::move(name), any_parameters(P()), false,
                  [](const any_parameters& p, const any_shape<D>*) { return any_shape<D>(S(p.as<P>())); },
                  [](const any_parameters& p, const any_shape<D>*, double stiffness) {
                    return any_wall<D>(wall(S(p.as<P>()), stiffness));
                  }});
  }
  /// Adds a shape by an entry.
  template <int D>
  void add_shape(shape_entry<D> entry) {
    if constexpr (D == 2) shapes_in_the_plane_.push_back(std::move(entry));
    else shapes_in_space_.push_back(std::move(entry));
  }
  /// Adds an effect with parameters P, for devices with D = n = d.
  template <int D, class E, Parameters P>
  void add_effect(std::string name) {
    effect_entry<D> entry{std::move(name), any_parameters(P()),
                          [](const any_parameters& p) { return any_effect<D>(E(p.as<P>())); }};
    if constexpr (D == 2) effects_in_the_plane_.push_back(std::move(entry));
    else effects_in_space_.push_back(std::move(entry));
  }
  /// Adds a brake model that is its own parameter struct.
  template <BrakeModel Model>
  void add_brake_model(std::string name) {
    brake_models_.push_back({std::move(name), any_parameters(Model()), [](const any_parameters& p) {
                               return run_time_brake(require_valid(p.as<Model>()));
                             }});
  }
  /// A reader of URDFs, for a program that is built with a library for them.
  void add_urdf_reader(runtime::urdf_reader reader) { urdf_reader_ = std::move(reader); }
  /// That reader; empty if there is none.
  const runtime::urdf_reader& urdf_reader() const { return urdf_reader_; }

  /// Compiles controllers under these laws, and the plant, for all mechanisms of M's kind: 5 to 20 s per law.
  template <DifferentiableMechanism M, class... L>
  void compile_for(const named_law<L>&...) {
    using H = held_mechanism<M>;
    (compile_controllers<H, L>(), ...);
    if constexpr (Dynamics<H>)
      plants_[typeid(H)] = [](const void* of, const std::vector<run_time_brake>& brakes, double hand_mass,
                              std::span<const double> q) -> std::unique_ptr<any_plant> {
        return std::make_unique<plant_of<H>>(*static_cast<const H*>(of), brakes, hand_mass, q);
      };
    if constexpr (Dynamics<H> && H::dof == H::task_dimension)
      wall_makers_[typeid(H)] = [](const void* of, const brake_numbers& brakes, const wall_touch& touch) {
        return wall_at(*static_cast<const H*>(of), brakes, touch);
      };
  }

  /// True if controllers of this law are compiled for this mechanism.
  bool is_compiled(const any_mechanism& mechanism, const law_entry& law) const {
    return controllers_.contains({mechanism.held().first, law.type});
  }
  /// Makes a controller. Requires is_compiled() and a device that meets the needs of the law. Throws
  /// std::invalid_argument as controller_of.
  std::unique_ptr<any_controller> make_controller(const any_mechanism& mechanism, const law_entry& law,
                                                  const controller_parts& parts) const {
    const auto [type, of] = mechanism.held();
    return controllers_.at({type, law.type})(of, parts);
  }
  /// Makes a simulated device; nullptr if none is compiled. Throws std::invalid_argument as plant_of.
  std::unique_ptr<any_plant> make_plant(const any_mechanism& mechanism,
                                        const std::vector<run_time_brake>& brakes, double hand_mass,
                                        std::span<const double> q) const {
    const auto [type, of] = mechanism.held();
    const auto found = plants_.find(type);
    if (!mechanism.has_inertia() || found == plants_.end()) return nullptr;
    return found->second(of, brakes, hand_mass, q);
  }
  /// Returns the wall that these brakes can render at a touch; empty for a mechanism without inertia, or with
  /// more joints than task dimensions. Throws std::invalid_argument as wall_at.
  std::optional<braked_wall> braked_wall_at(const any_mechanism& mechanism, const brake_numbers& brakes,
                                            const wall_touch& touch) const {
    const auto [type, of] = mechanism.held();
    const auto found = wall_makers_.find(type);
    if (!mechanism.has_inertia() || found == wall_makers_.end()) return std::nullopt;
    return found->second(of, brakes, touch);
  }

 private:
  using controller_maker = std::unique_ptr<any_controller> (*)(const void*, const controller_parts&);
  using plant_maker = std::unique_ptr<any_plant> (*)(const void*, const std::vector<run_time_brake>&, double,
                                                     std::span<const double>);
  using wall_maker = braked_wall (*)(const void*, const brake_numbers&, const wall_touch&);

  template <class H, class L>
  void compile_controllers() {
    if constexpr (!needs_dynamics<L> || Dynamics<H>)
      controllers_[{typeid(H), typeid(L)}] = [](const void* of, const controller_parts& parts) {
        return runtime::make_controller<L>(*static_cast<const H*>(of), parts);
      };
  }

  std::vector<mechanism_entry> mechanisms_;
  std::vector<law_entry> laws_;
  std::vector<shape_entry<2>> shapes_in_the_plane_;
  std::vector<shape_entry<3>> shapes_in_space_;
  std::vector<effect_entry<2>> effects_in_the_plane_;
  std::vector<effect_entry<3>> effects_in_space_;
  std::vector<brake_model_entry> brake_models_;
  runtime::urdf_reader urdf_reader_;
  std::map<std::pair<std::type_index, std::type_index>, controller_maker> controllers_;
  std::map<std::type_index, plant_maker> plants_;
  std::map<std::type_index, wall_maker> wall_makers_;
};

/// The entry with this name, or nullptr.
template <class Entry>
const Entry* find(const std::vector<Entry>& all, std::string_view name) {
  for (const Entry& one : all)
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace passive_haptics::runtime
