// What became of the mutants, and which of those that survive are argued to change nothing.
#pragma once

#include "../generator/draw.hpp"
#include "suites.hpp"

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
  int drawn = 0, failed = 0, crashed = 0, late = 0, argued = 0, survived = 0;
};

inline void count(tally& t, const judged_mutant& m, bool argued) {
  ++t.drawn;
  switch (m.given.how) {
    case ending::failed: ++t.failed; break;
    case ending::crashed: ++t.crashed; break;
    case ending::late: ++t.late; break;
    case ending::passed: ++(argued ? t.argued : t.survived);
  }
}

inline void print(std::ostream& out, const std::string& name, const tally& t) {
  out << std::left << std::setw(20) << name << std::right;
  for (const int number : {t.drawn, t.failed, t.crashed, t.late, t.argued, t.survived})
    out << std::setw(10) << number;
  out << '\n';
}

// Prints all; true if enough are killed or argued, and few enough argued.
inline bool print_table(std::ostream& out, const std::vector<judged_mutant>& all,
                        const std::map<std::string, std::string>& argued) {
  std::map<std::string, tally> by_operator, by_stage;
  tally sum;
  for (const judged_mutant& m : all) {
    const bool is_argued = argued.contains(key_of(m.what));
    count(by_operator[m.what.name], m, is_argued);
    count(by_stage[stage_of(m.what.file)], m, is_argued);
    count(sum, m, is_argued);
    if (m.given.how != ending::passed || is_argued) continue;
    out << m.what.file << ':' << m.what.line << ": " << m.what.name
        << (m.given.reached ? "" : ", not reached") << '\n'
        << "  - " << m.what.original_line << "\n  + " << m.what.mutated_line << '\n';
  }
  out << "\n                         drawn    failed   crashed      late    argued  survived\n";
  for (const auto& [name, t] : by_operator) print(out, name, t);
  out << '\n';
  for (const auto& [name, t] : by_stage) print(out, name, t);
  out << '\n';
  print(out, "all", sum);
  const double killed = 100.0 * (sum.failed + sum.crashed + sum.late) / sum.drawn,
               argued_share = 100.0 * sum.argued / sum.drawn;
  out << std::fixed << std::setprecision(1) << killed << " % killed, " << argued_share << " % argued\n";
  return killed + argued_share >= 97 && argued_share <= 3;
}

}  // namespace mutants
