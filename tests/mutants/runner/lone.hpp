// Mutants that no switch can stand for: each is compiled into a few tests of its header.
#pragma once

#include "build.hpp"
#include "suites.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

struct lone_verdict {
  bool compiles;
  verdict given;
};

class lone_judge {
 public:
  lone_judge(const mutated_build& b, fs::path work, std::vector<unit> units)
      : build_(b), work_(std::move(work)), units_(std::move(units)), headers_of_(b.dependencies()) {}

  // first: the object that could not be made with its switch, which says most of it.
  lone_verdict operator()(const source& s, const mutant& m, int number, const std::string& first) const {
    const fs::path room = work_ / "alone" / std::to_string(number);
    fs::remove_all(room);
    write_text(room / "passive_haptics" / m.file, mutated_text(s, m));
    lone_verdict v{true, {}};
    for (const unit& u : units_for(m.file, first)) {
      v.given.reached = true;
      const fs::path object = room / "test.o", program = room / "test";
      if (!build_.compile(u, "-I" + room.string(), object, room / "log"))
        return {false, {true, ending::failed, "compiler"}};
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
  static constexpr std::size_t most_units = 4;

  static bool is_static(const unit& u) { return u.source.parent_path().filename() == "static"; }

  // Those that include it by name come first, then those that include little.
  std::vector<unit> units_for(const std::string& header, const std::string& first) const {
    std::vector<std::pair<std::pair<bool, std::size_t>, const unit*>> ordered;
    for (const unit& u : units_) {
      const auto found = headers_of_.find(u.object);
      if (found == headers_of_.end() || !found->second.contains(header)) continue;
      const bool by_name = read_text(u.source).find("<passive_haptics/" + header + ">") != std::string::npos;
      ordered.push_back({{!by_name && !is_static(u), found->second.size()}, &u});
    }
    std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<unit> chosen;
    for (const unit& u : build_.units()) {
      if (u.object == first) chosen.push_back(u);
    }
    for (const auto& [rank, u] : ordered) {
      if (chosen.size() < most_units && u->object != first) chosen.push_back(*u);
    }
    return chosen;
  }

  const mutated_build& build_;
  fs::path work_;
  std::vector<unit> units_;
  std::map<std::string, std::set<std::string>> headers_of_;  // of an object
};

}  // namespace mutants
