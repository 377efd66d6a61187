// Devices with their specimens, laws and effects.
#pragma once

#include "effect_run.hpp"
#include "rivals/bang_bang_control.hpp"
#include "rivals/coercive_force_approximation.hpp"
#include "rivals/single_degree_of_freedom_control.hpp"
#include "rivals/velocity_ratio_control.hpp"
#include "scene_run.hpp"

namespace experiments {

// Every law and every effect, with and without a force sensor.
template <class M>
scene_bench bench_of_all(const scene_device<M>& device) {
  std::vector<law_column<M>> laws;
  const auto add = [&](const char* name, const auto& law) {
    laws.push_back(column<M>(name, true, law));
    laws.push_back(column<M>(name, false, law));
  };
  add("velocity_direct_control", ph::velocity_direct_control());
  add("on_off_control", on_off_with_lead(device.brakes));
  add("direct_control", ph::direct_control());
  add("saturated_direct_control", ph::saturated_direct_control());
  add("no_direct_control", ph::no_direct_control());
  laws.push_back(column<M>("coercive_force_approximation", false, coercive_force_approximation()));
  laws.push_back(column<M>("bang_bang_control", false, bang_bang_control()));
  laws.push_back(column<M>("single_degree_of_freedom_control", true, single_degree_of_freedom_control()));
  laws.push_back(column<M>("velocity_ratio_control", true, velocity_ratio_control()));
  scene_bench bench = bench_of(device, laws);
  const auto effects = all_effects<M>();
  for (const auto& e : effects) bench.effects.push_back(e.row);
  bench.effect_laws = {{"direct_control", true}, {"direct_control", false}, {"no_direct_control", true}};
  bench.run_effect = [=](bool has_wall, std::size_t i, std::size_t j, const number_range& hands) {
    effect_figures worst;
    const auto add_hands = [&](const auto& control_of) {
      for (std::uint64_t k = hands.first; k <= hands.last; ++k)
        worst.add(follow_effect(device, effects[i], control_of, has_wall, k));
    };
    if (j == 0) add_hands(with_sensor{ph::direct_control()});
    if (j == 1) add_hands(without_sensor{ph::direct_control()});
    if (j == 2) add_hands(with_sensor{ph::no_direct_control()});
    return worst;
  };
  return bench;
}

}  // namespace experiments
