// What a solver adds to the comparison: one row for each problem that it solves.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace peers {

inline constexpr unsigned seed = 4;
inline constexpr const char* ours = "passive_haptics";  // times are compared with this solver's

// What of a row's solutions is measured, each with its worst value.
using errors = std::vector<std::pair<std::string, double>>;

struct row {
  std::string problem;  // rows of one problem are compared
  std::string solver;
  std::function<errors()> check;  // throws std::runtime_error where the solver disagrees
  std::function<void(benchmark::State&)> run;
};

// Filled before main by the sources that are built: one a peer, those that were found.
inline std::vector<row>& rows() {
  static std::vector<row> all;
  return all;
}

}  // namespace peers
