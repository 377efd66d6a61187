// Devices with their specimens and laws.
#pragma once

#include "laws.hpp"
#include "scene_run.hpp"

#include <catalogue/laws.hpp>

#include <tuple>

namespace experiments {

// Every law of the catalogue, with and without a force sensor if they do not need it.
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
  return bench_of(device, laws);
}

}  // namespace experiments
