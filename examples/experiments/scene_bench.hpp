// Devices with their specimens, laws and effects.
#pragma once

#include "effect_run.hpp"
#include "laws.hpp"
#include "scene_run.hpp"

#include <catalogue/laws.hpp>

#include <tuple>

namespace experiments {

// Every law of the catalogue and every effect, with and without a force sensor if they do not need it.
template <class M>
scene_bench bench_of_all(const scene_device<M>& device) {
  std::vector<law_column<M>> laws;
  const auto add = [&](const std::string& name, bool has_sensor, const auto& law) {
    laws.push_back(column<M>(name, has_sensor, with_lead(law, device.brakes)));
  };
  const auto add_both = [&]<class Law>(const ph::runtime::named_law<Law>& named) {
    add(named.name, true, Law());
    add(named.name, false, Law());
  };
  std::apply([&](const auto&... named) { (add_both(named), ...); }, example::laws);
  for_laws<law::coercive, law::bang_bang>([&](const auto& name, const auto& l) { add(name, false, l); });
  for_laws<law::single_degree_of_freedom, law::velocity_ratio>(
      [&](const auto& name, const auto& l) { add(name, true, l); });
  scene_bench bench = bench_of(device, laws);
  const auto effects = all_effects<M>();
  for (const auto& e : effects) bench.effects.push_back(e.row);
  bench.effect_laws = {{"direct_control", true}, {"direct_control", false}, {"no_direct_control", true}};
  bench.run_effect = [=](bool has_wall, std::size_t i, std::size_t j, std::uint64_t hands) {
    effect_figures worst;
    const auto add_hands = [&](const auto& control_of) {
      for (std::uint64_t k = 0; k < hands; ++k)
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
