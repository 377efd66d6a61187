// Which mutants are looked at: some of each operator in each folder, by a seed.
#pragma once

#include "switches.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

// brake, force, ..., core/linear
inline std::string stage_of(const std::string& file) {
  return file.substr(0, file.find('/', file.starts_with("core/") ? 5 : 0));
}

// count mutants, or all if there are fewer: operators and stages take turns, so that none dominates.
inline std::vector<mutant> drawn(const std::vector<mutant>& all, std::uint64_t seed, std::size_t count) {
  std::map<std::pair<std::string, std::string>, std::vector<mutant>> cells;
  for (const mutant& m : all) cells[{m.name, stage_of(m.file)}].push_back(m);
  std::mt19937_64 random(seed);
  std::size_t most = 0;
  for (auto& [key, cell] : cells) {
    // Not std::shuffle, whose order is each library's own
    for (std::size_t i = cell.size(); i > 1; --i) std::swap(cell[i - 1], cell[random() % i]);
    most = std::max(most, cell.size());
  }
  std::vector<mutant> chosen;
  for (std::size_t turn = 0; turn < most; ++turn) {
    for (const auto& cell : cells) {
      if (chosen.size() == count) return chosen;
      if (turn >= cell.second.size()) continue;
      const mutant& next = cell.second[turn];
      if (std::all_of(chosen.begin(), chosen.end(), [&](const mutant& m) { return fit(m, next); }))
        chosen.push_back(next);
    }
  }
  return chosen;
}

}  // namespace mutants
