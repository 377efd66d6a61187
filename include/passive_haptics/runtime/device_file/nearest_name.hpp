/// Suggestions for misspelt names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace passive_haptics::runtime {

/// Number of letters to add, remove, replace or exchange with a neighbour to turn one word into the other.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    next[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j + 1] + 1, next[j] + 1, row[j] + (a[i] == b[j] ? 0 : 1)});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
    }
    before.swap(row);
    row.swap(next);
  }
  return row.back();
}

/// `one of "five_bar", "delta"`.
template <class Names>
std::string one_of(const Names& names) {
  std::string all;
  for (const auto& name : names) all.append(all.empty() ? "\"" : ", \"").append(name).append("\"");
  return names.size() == 1 ? all : "one of " + all;
}

/// "; did you mean "five_bar"?" for a name that begins with the word or differs by a third of its letters.
template <class Names>
std::string did_you_mean(std::string_view word, const Names& names) {
  constexpr std::size_t max_length = 50;  // no name is longer; the cost is the product of both lengths
  if (word.empty() || word.size() > max_length) return "";
  std::string_view nearest;
  std::size_t smallest = max_length;
  for (const auto& name : names) {
    const std::string_view one(name);
    const bool begins = word.size() > 2 && one.starts_with(word);
    const std::size_t distance = begins ? 1 : edit_distance(word, one);
    if (distance >= smallest || distance > std::max<std::size_t>(1, one.size() / 3)) continue;
    smallest = distance;
    nearest = one;
  }
  return nearest.empty() ? "" : std::string("; did you mean \"").append(nearest).append("\"?");
}

}  // namespace passive_haptics::runtime
