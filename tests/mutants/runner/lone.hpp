// Mutants that no switch can stand for: each is compiled into a few tests of its header.
#pragma once

#include "build.hpp"
#include "suites.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace mutants {

struct lone_verdict {
  bool compiles;
  verdict given;
};

class lone_judge {
 public:
  // light: quick to compile.
  lone_judge(const mutated_build& b, fs::path work, const std::vector<unit>& light)
      : build_(b), work_(std::move(work)), units_(b.units()), headers_of_(b.dependencies()) {
    for (const unit& u : light) light_.insert(u.object);
  }

  // reached: the objects that could not be made with its switch, which is so wherever it is instantiated.
  lone_verdict operator()(const source& s, const mutant& m, int number,
                          const std::set<std::string>& reached) const {
    const fs::path room = work_ / "alone" / std::to_string(number);
    fs::remove_all(room);
    write_text(room / "passive_haptics" / m.file, mutated_text(s, m));
    lone_verdict v{true, {}};
    for (const unit& u : units_for(m.file, reached)) {
      v.given.reached = true;
      const fs::path object = room / "test.o", program = room / "test";
      if (!build_.compile(u, "-I" + room.string(), object, room / "log"))
        return {is_asserted(room / "log"), {true, ending::failed, "compiler"}};
      if (is_static(u)) continue;
      if (run({"c++", object, "-o", program, "-lgtest_main", "-lgtest", "-lpthread"}, room / "log").how !=
          ending::passed)
        continue;  // a test of more than one file
      v.given.how = run({program, "--gtest_fail_fast"}, room / "log", {}, {300, 1200}).how;
      if (v.given.how != ending::passed) break;
    }
    fs::remove_all(room);
    return v;
  }

 private:
  static constexpr std::size_t most_units = 8;

  // A static assertion is a test; other errors make no mutant.
  static bool is_asserted(const fs::path& log) {
    return read_text(log).find("static assertion failed") != std::string::npos;
  }

  static bool is_static(const unit& u) { return u.source.parent_path().filename() == "static"; }

  // Those that are known to reach it come first, then those that include it by name, then by how little.
  std::vector<unit> units_for(const std::string& header, const std::set<std::string>& reached) const {
    std::vector<std::pair<std::tuple<bool, bool, std::size_t>, const unit*>> ordered;
    for (const unit& u : units_) {
      const auto found = headers_of_.find(u.object);
      if (!light_.contains(u.object) && !reached.contains(u.object)) continue;
      if (found == headers_of_.end() || !found->second.contains(header)) continue;
      const bool by_name = read_text(u.source).find("<passive_haptics/" + header + ">") != std::string::npos;
      ordered.push_back({{!reached.contains(u.object), !by_name && !is_static(u), found->second.size()}, &u});
    }
    std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<unit> chosen;
    for (const auto& [rank, u] : ordered) {
      if (chosen.size() < most_units) chosen.push_back(*u);
    }
    return chosen;
  }

  const mutated_build& build_;
  fs::path work_;
  std::vector<unit> units_;
  std::set<std::string> light_;                              // objects
  std::map<std::string, std::set<std::string>> headers_of_;  // of an object
};

}  // namespace mutants
