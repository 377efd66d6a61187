// What became of the mutants, and which are argued to change nothing.
#pragma once

#include "../generator/draw.hpp"
#include "suites.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace mutants {

// The keys in lines of text, and what follows each behind another " | ", as an argument.
inline std::map<std::string, std::string> keys_in(const std::string& text) {
  std::map<std::string, std::string> keys;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.starts_with("#")) continue;
    std::size_t end = 0;
    for (int bar = 0; bar < 3 && end != std::string::npos; ++bar)
      end = line.find(" | ", end + (bar > 0 ? 3 : 0));
    keys.emplace(line.substr(0, end), end == std::string::npos ? "" : line.substr(end + 3));
  }
  return keys;
}

// Arguments about code that is no longer there.
inline std::map<std::string, std::string> stale(std::map<std::string, std::string> argued,
                                                const std::vector<mutant>& all) {
  for (const mutant& m : all) argued.erase(key_of(m));
  return argued;
}

struct judged_mutant {
  mutant what;
  verdict given;
};

struct tally {
  int drawn = 0, failed = 0, crashed = 0, late = 0, survived = 0;
};

inline void count(tally& t, const judged_mutant& m) {
  ++t.drawn;
  switch (m.given.how) {
    case ending::failed: ++t.failed; break;
    case ending::crashed: ++t.crashed; break;
    case ending::late: ++t.late; break;
    case ending::passed: ++t.survived;
  }
}

inline void print(std::ostream& out, const std::string& name, const tally& t) {
  out << std::left << std::setw(20) << name << std::right;
  for (const int number : {t.drawn, t.failed, t.crashed, t.late, t.survived}) out << std::setw(10) << number;
  out << '\n';
}

inline void print(std::ostream& out, const judged_mutant& m) {
  out << m.what.file << ':' << m.what.line << ": " << m.what.name << (m.given.reached ? "" : ", not reached")
      << '\n'
      << "  - " << m.what.original_line << "\n  + " << m.what.mutated_line << '\n';
}

// Prints the survivors, or those that are killed, and how many there are of each kind; returns how many of a
// hundred are killed.
inline double print_table(std::ostream& out, const std::vector<judged_mutant>& all,
                          bool killed_are_listed = false) {
  std::map<std::string, tally> by_operator, by_stage;
  tally sum;
  for (const judged_mutant& m : all) {
    count(by_operator[m.what.name], m);
    count(by_stage[stage_of(m.what.file)], m);
    count(sum, m);
    if ((m.given.how != ending::passed) == killed_are_listed) print(out, m);
  }
  out << "\n                         drawn    failed   crashed      late  survived\n";
  for (const auto& [name, t] : by_operator) print(out, name, t);
  out << '\n';
  for (const auto& [name, t] : by_stage) print(out, name, t);
  out << '\n';
  print(out, "all", sum);
  const double killed = 100.0 * (sum.failed + sum.crashed + sum.late) / std::max(sum.drawn, 1);
  out << std::fixed << std::setprecision(1) << killed << " % killed\n";
  return killed;
}

}  // namespace mutants
