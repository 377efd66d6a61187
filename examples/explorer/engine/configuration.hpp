/// @file
/// All settings of a device, and their form as text.
#pragma once

#include "fields.hpp"
#include "laws.hpp"

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/plant/following_hand.hpp>

#include <string>
#include <utility>

namespace explorer {

/// Who moves the handle in a simulation.
enum class hand_kind {
  pointer,  ///< A spring to the pointer.
  along,    ///< A hand that moves along the wall by itself.
};
/// Where the desired force comes from.
enum class desired_kind {
  scene,  ///< From the wall that the handle touches.
  given,  ///< From the state.
};

/// What stands beside a wall's shape.
struct wall_settings {
  double stiffness = 1e7;  ///< [N/m], section 5.1.
  double rate = 0;         ///< Of the environment [Hz]; 0: each cycle. Section 5.2: 1000 and 20.

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
  double damping = 12;     ///< Of the handle's own velocity [N s/m].
  double strength = 3;     ///< Most force of the spring [N].
  double mass = 0.3;       ///< That moves with the handle [kg].

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = pointer_hand;
    return ph::member_table(ph::member("stiffness", &p::stiffness, "N/m", ph::range::not_negative),
                            ph::member("damping", &p::damping, "N s/m", ph::range::not_negative),
                            ph::member("strength", &p::strength, "N", ph::range::not_negative),
                            ph::member("mass", &p::mass, "kg", ph::range::not_negative));
  }
};

/// The hand along the wall: that of examples/03_wall_following.cpp, a hand that yields.
inline ph::following_hand_parameters<double> yielding_hand() {
  ph::following_hand_parameters<double> p;
  p.push = 1.75;
  p.normal_stiffness = 300;
  p.target_depth = 0.003;
  return p;
}

/// Settings of a device whose mechanism is described by E (device_of.hpp).
template <class E>
struct configuration {
  using M = typename E::mechanism;             ///< The mechanism.
  static constexpr int n = M::dof;             ///< Joints.
  static constexpr int d = M::task_dimension;  ///< Dimension of the task.
  static constexpr int m = M::brake_count;     ///< Brakes.

  /// Which joints have a brake, besides the table of the brakes.
  struct presence {
    ph::vector<double, m> present = ph::vector<double, m>::Ones();  ///< 1 or 0 for each brake.
    /// The table of core/parameters.hpp.
    static constexpr auto members() {
      return ph::member_table(ph::member("present", &presence::present, "",
                                         ph::range::between(0, 1).as("1 or 0 for each brake")));
    }
  };
  /// How far the hand along the wall goes.
  struct way {
    ph::vector<double, d> direction = ph::vector<double, d>::UnitX();  ///< In which it moves.
    double length = 0.12;  ///< Way [m] after which it begins anew.
    /// The table of core/parameters.hpp.
    static constexpr auto members() {
      return ph::member_table(ph::member("direction", &way::direction, "1", ph::range::direction),
                              ph::member("length", &way::length, "m", ph::range::positive));
    }
  };
  /// A wall ahead in the plane, a floor in space.
  static ph::vector<double, d> out_of_wall() {
    if constexpr (d == 3) return ph::vector<double, d>::UnitZ();
    else return -ph::vector<double, d>::UnitY();
  }
  /// The task of the design map.
  struct task {
    ph::vector<double, d> direction = ph::vector<double, d>::UnitX();  ///< In which the handle moves.
    ph::vector<double, d> normal = out_of_wall();                      ///< Of the wall, out of it.
    double push = 2;                                                   ///< Of the hand [N].
    /// The table of core/parameters.hpp.
    static constexpr auto members() {
      return ph::member_table(ph::member("direction", &task::direction, "1", ph::range::direction),
                              ph::member("normal", &task::normal, "1", ph::range::direction),
                              ph::member("push", &task::push, "N", ph::range::not_negative));
    }
  };
  /// What stands without a group.
  struct whole {
    std::string scene = E::scene;                              ///< The wall.
    desired_kind desired = desired_kind::scene;                ///< Where Fd comes from.
    hand_kind hand = hand_kind::pointer;                       ///< Who moves the handle.
    ph::vector<double, n> q = E::start();                      ///< Joint positions.
    ph::vector<double, n> qd = ph::vector<double, n>::Zero();  ///< Joint rates.
    ph::vector<double, d> Fh = ph::vector<double, d>::Zero();  ///< Hand force [N].
    ph::vector<double, d> Fd = ph::vector<double, d>::Zero();  ///< Desired force [N].
    double alpha = -1;                                         ///< Scale factor; < 0: that of the law.
    /// The table of core/parameters.hpp.
    static constexpr auto members() {
      using p = whole;
      return ph::member_table(
          ph::member("scene", &p::scene), ph::choice("desired", &p::desired, "scene, given"),
          ph::choice("hand", &p::hand, "pointer, along"),
          ph::member("q", &p::q, "rad or m", ph::range::between(-1e6, 1e6)),  // whose sine has a meaning
          ph::member("qd", &p::qd, "rad/s or m/s", ph::range::finite),
          ph::member("Fh", &p::Fh, "N", ph::range::finite), ph::member("Fd", &p::Fd, "N", ph::range::finite),
          ph::member("alpha", &p::alpha, "1", ph::range::between(-1, 1)));
    }
  };

  typename E::parameters mechanism = {};                          ///< Lengths and masses.
  ph::brakes_of<M> brakes = {};                                   ///< Limits, dead bands and lags.
  presence on = {};                                               ///< Which brakes there are.
  law_kind law = law_kind::direct_control;                        ///< The law.
  law_settings law_tables = {};                                   ///< Its parameters.
  ph::approximation_parameters<double> options = {};              ///< Of the approximation.
  wall_settings wall = {};                                        ///< Beside the shape.
  pointer_hand hand = {};                                         ///< At the pointer.
  ph::following_hand_parameters<double> along = yielding_hand();  ///< By itself.
  way path = {};                                                  ///< Of that hand.
  task map = {};                                                  ///< Of the design map.
  whole top = {};                                                 ///< The rest.

  /// Calls f(prefix, group, table) for each table, of the law that of the chosen one.
  template <class F>
  void for_each_table(F&& f) {
    f("mechanism.", "mechanism", mechanism);
    f("brakes.", "brakes", on);
    f("brakes.", "brakes", brakes);
    law_tables.visit(law, [&](auto& table) { f("law.", "law", table); });
    f("options.", "options", options);
    f("", "scene", top);
    f("scene.", "scene", wall);
    f("hand.", "hand", hand);
    f("hand.along.", "hand", along);
    f("hand.path.", "hand", path);
    f("map.", "map", map);
  }

  /// All fields of these settings, by address.
  field_list fields() {
    field_list all;
    for_each_table(
        [&](const char* prefix, const char* group, auto& table) { add_fields(all, table, prefix, group); });
    return all;
  }

  /// Takes all lines; throws std::invalid_argument where one is not known or not valid.
  void take(const settings& given) {
    if (const std::string* id = given.find("law")) law = law_of(*id);
    const field_list all = fields();
    read(all, given);
    check_names(all, given);
    for_each_table([](const char*, const char*, const auto& table) { ph::require_valid(table); });
    static_cast<void>(shape_of<d>(top.scene));
  }

  /// The brakes as the controllers take them: those that are not there are off.
  ph::switchable_brakes<M> switchable() const {
    ph::switchable_brakes<M> all(brakes);
    for (int i = 0; i < m; ++i)
      if (!is_present(i)) all.switch_off(i);
    return all;
  }
  /// Whether there is a brake i.
  bool is_present(int i) const { return on.present[i] >= 0.5; }
  /// Options of a step. The default needs no cosine, which another libm rounds in another way.
  ph::step_options<double> step() const {
    const ph::approximation_parameters<double> usual;
    return options.max_approximation_angle == usual.max_approximation_angle
               ? ph::step_options<double>()
               : ph::step_options<double>(options);
  }
  /// The scene of the walls.
  explorer_scene<d> walls() const {
    return {wall_or_force<d>(shape_of<d>(top.scene), wall.stiffness), wall.rate > 0 ? 1 / wall.rate : 0};
  }
  /// A controller that scales forces by the given alpha if there is one, else under the law.
  std::unique_ptr<any_control<M>> control(const M& model, explorer_scene<d> scene) const {
    if (top.alpha < 0) return control(model, law, std::move(scene));
    configuration scaled = *this;
    scaled.law_tables.given_scale = top.alpha;
    return scaled.control(model, law_kind::no_direct_control, std::move(scene));
  }
  /// A controller of the law in this scene.
  std::unique_ptr<any_control<M>> control(const M& model, law_kind chosen, explorer_scene<d> scene) const {
    return make_control<M>(chosen, law_tables, model, switchable(), std::move(scene), step());
  }

 private:
  void check_names(const field_list& all, const settings& given) {
    field_list of_laws;  // those of another law may stand there, too
    for (const law_description& l : laws)
      law_tables.visit(l.kind, [&](auto& table) { add_fields(of_laws, table, "law.", "law"); });
    for (const auto& line : given.lines()) {
      const std::string& name = line.first;
      if (name != "mechanism" && name != "law" && find(all, name) == nullptr &&
          find(of_laws, name) == nullptr)
        refuse("setting", name, "a name of the device's form");
    }
  }
};

}  // namespace explorer
