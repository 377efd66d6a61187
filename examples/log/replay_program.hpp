/// @file
/// The program replay: for the library's mechanisms, and in a line for one of yours.
#pragma once

#include <log/replay.hpp>

#include <python/include/passive_haptics_python/any_shape.hpp>

#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/design/plausibility.hpp>

#include <algorithm>
#include <concepts>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace example {

using passive_haptics_python::any_shape;

/// Options of a replay.
struct replay_options {
  std::string mechanism, wall, law = "direct_control", input;
  std::vector<std::string> parameters;
  double stiffness = 1e7, limit = 1, dead_band = 0.02;
  std::filesystem::path directory = ".";
};

/// Runs one for a mechanism.
using replay_job = std::function<replay_summary(const replay_options&, log_reader&, std::ostream&,
                                                const std::function<void(std::size_t)>& progress)>;

/// The whole program for these mechanisms; its exit status. The first one is the default; without an input it
/// reads `made_up`, if there is one.
int replay_program(int argc, char** argv, const std::vector<std::pair<std::string, replay_job>>& mechanisms,
                   const std::string& made_up = "");

/// The wall "plane:0,0.225,0,-1" or the like. Throws std::invalid_argument.
template <int D>
ph::wall<any_shape<D>> wall_of(const replay_options& options);
extern template ph::wall<any_shape<2>> wall_of<2>(const replay_options&);
extern template ph::wall<any_shape<3>> wall_of<3>(const replay_options&);

/// The values of "length_1=0.2", by name. Throws std::invalid_argument.
std::map<std::string, std::string> values_by_name(const std::vector<std::string>& texts);
/// One finite number. Throws std::invalid_argument.
double parameter_number(const std::string& name, const std::string& text);

/// Takes what is named like a member of these parameters, or of one within; adds its names to `known`.
template <ph::Parameters P>
void take_parameters(P& parameters, std::map<std::string, std::string>& given, std::string& known) {
  ph::for_each_member(parameters, [&](const auto& member, auto& value) {
    using V = std::remove_cvref_t<decltype(value)>;
    if constexpr (ph::Parameters<V>) {
      take_parameters(value, given, known);
    } else if constexpr (std::is_arithmetic_v<V> || std::is_enum_v<V>) {
      known.append(known.empty() ? "" : ", ").append(member.name);
      const auto found = given.extract(member.name);
      if (!found) return;
      if constexpr (std::is_enum_v<V>) {
        const auto words = ph::choices_of(member);
        const auto word = std::find(words.begin(), words.end(), found.mapped());
        if (word == words.end())
          throw std::invalid_argument("--parameter: '" + found.mapped() + "', expected one of " +
                                      member.choices);
        value = static_cast<V>(word - words.begin());
      } else {
        value = static_cast<V>(parameter_number(found.key(), found.mapped()));
      }
    }
  });
}

/// The paper's law, or none: chosen at run time, for one controller less of the compiler.
struct direct_control_or_not {
  static constexpr bool needs_hand_force = true, nulls_normal_force = true;
  bool on = true;

  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    return on ? ph::direct_control().scale(c) : T(1);
  }
};

/// A controller of any law, for one replay less of the compiler.
template <ph::Mechanism M>
struct any_controller {
  using result_type = ph::step_result<M>;
  M driven;
  std::function<result_type(const ph::device_state<M>&)> control;

  const M& mechanism() const { return driven; }
  result_type operator()(const ph::device_state<M>& state) { return control(state); }
};

/// No parameters.
struct no_parameters {
  static constexpr auto members() { return ph::member_table(); }
};

/// Those that are named, the others at their defaults. Throws std::invalid_argument.
template <ph::Parameters P>
P parameters_of(const replay_options& options) {
  P parameters;
  auto given = values_by_name(options.parameters);
  std::string known;
  take_parameters(parameters, given, known);
  if (given.empty()) return parameters;
  throw std::invalid_argument("--parameter: '" + given.begin()->first + "', expected " +
                              (known.empty() ? "none" : "one of " + known));
}

/// The job of a mechanism that is made of parameters P; without them, as M().
template <ph::Mechanism M, ph::Parameters P = no_parameters>
replay_job replay_of() {
  return [](const replay_options& options, log_reader& log, std::ostream& out,
            const std::function<void(std::size_t)>& progress) {
    const P parameters = parameters_of<P>(options);
    const M mechanism = [&] {
      if constexpr (std::same_as<P, no_parameters>) return M();
      else return M(parameters);
    }();
    ph::brakes_of<M> brakes;
    brakes.torque_limit.setConstant(options.limit);
    brakes.rate_dead_band.setConstant(options.dead_band);
    const auto scene = ph::scene(wall_of<M::task_dimension>(options));
    std::cerr << ph::plausibility(mechanism, brakes, scene);
    const auto under = [&](const auto& law) {
      any_controller<M> control{mechanism, ph::controller(mechanism, brakes, scene, law)};
      return replay(log, out, control, options.law != "no_direct_control", progress);
    };
    if constexpr (ph::Dynamics<M>) {
      if (options.law == "velocity_direct_control") return under(ph::velocity_direct_control());
    }
    if (options.law == "velocity_direct_control")
      throw std::invalid_argument(
          "--law: velocity_direct_control, expected another one: this mechanism has no mass_matrix");
    if (options.law == "saturated_direct_control") return under(ph::saturated_direct_control());
    return under(direct_control_or_not{options.law == "direct_control"});
  };
}

}  // namespace example
