// Which mutants are looked at: some of each operator in each folder, by a seed.
#pragma once

#include "switches.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <random>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

// brake, force, ..., core/linear
inline std::string stage_of(const std::string& file) {
  return file.substr(0, file.find('/', file.starts_with("core/") ? 5 : 0));
}

// file | original line | mutated line
inline std::string key_of(const mutant& m) {
  return m.file + " | " + m.original_line + " | " + m.mutated_line;
}

// Those in whose "file | operator" the regular expression finds something.
inline std::vector<mutant> those_of(const std::vector<mutant>& all, const std::string& expression) {
  const std::regex wanted(expression);
  std::vector<mutant> some;
  std::ranges::copy_if(all, std::back_inserter(some),
                       [&](const mutant& m) { return std::regex_search(m.file + " | " + m.name, wanted); });
  return some;
}

// Of the seed and the mutant alone, so that a change of the code draws no others than those it makes.
inline std::uint64_t lot_of(const mutant& m, std::uint64_t seed) {
  const std::string text = std::to_string(seed) + ' ' + key_of(m);
  std::seed_seq sequence(text.begin(), text.end());
  return std::mt19937_64(sequence)();
}

// count mutants, or all if there are fewer: operators and stages take turns, so that none dominates.
inline std::vector<mutant> drawn(const std::vector<mutant>& all, std::uint64_t seed, std::size_t count) {
  using lots = std::vector<std::pair<std::uint64_t, const mutant*>>;
  std::map<std::pair<std::string, std::string>, lots> cells;
  for (const mutant& m : all) cells[{m.name, stage_of(m.file)}].emplace_back(lot_of(m, seed), &m);
  std::size_t most = 0;
  for (auto& [key, cell] : cells) {
    std::ranges::stable_sort(cell, {}, &lots::value_type::first);
    most = std::max(most, cell.size());
  }
  std::vector<mutant> chosen;
  for (std::size_t turn = 0; turn < most; ++turn) {
    for (const auto& cell : cells) {
      if (chosen.size() == count) return chosen;
      if (turn >= cell.second.size()) continue;
      const mutant& next = *cell.second[turn].second;
      if (std::all_of(chosen.begin(), chosen.end(), [&](const mutant& m) { return fit(m, next); }))
        chosen.push_back(next);
    }
  }
  return chosen;
}

}  // namespace mutants
