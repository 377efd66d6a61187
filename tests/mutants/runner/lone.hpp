// Mutants that no switch can stand for: each is compiled into a few tests of its header.
#pragma once

#include "build.hpp"
#include "suites.hpp"

#include <algorithm>
#include <map>
#include <regex>
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

// What a test of compile_fail expects of the compiler, a regular expression; nothing of another file.
inline std::string expected_by(const std::string& test) {
  const std::string begin = "// expect: ";
  return test.starts_with(begin) ? test.substr(begin.size(), test.find('\n') - begin.size()) : "";
}

class lone_judge {
 public:
  // light: quick to compile.
  lone_judge(const mutated_build& b, fs::path work, std::vector<unit> light, std::vector<unit> heavy)
      : build_(b),
        work_(std::move(work)),
        light_(std::move(light)),
        heavy_(std::move(heavy)),
        headers_of_(b.dependencies()) {}

  // reached: the objects that could not be made with its switch, which is so wherever it is instantiated.
  lone_verdict operator()(const source& s, const mutant& m, int number,
                          const std::set<std::string>& reached) const {
    const fs::path room = work_ / "alone" / std::to_string(number);
    fs::remove_all(room);
    write_text(room / "passive_haptics" / m.file, mutated_text(s, m));
    std::vector<unit> chosen = units_for(light_, 12, m.file, reached);
    for (unit& u : units_for(heavy_, 8, m.file, reached)) chosen.push_back(std::move(u));
    lone_verdict v{true, {}};
    for (const unit& u : chosen) {
      v.given.reached = true;
      const fs::path object = room / "test.o", program = room / "test";
      if (!build_.compile(u, "-I" + room.string(), object, room / "log"))
        return {is_asserted(room / "log"), {true, ending::failed, "compiler"}};
      if (is_static(u)) continue;
      if (run({"c++", object, "-o", program, "-lgtest_main", "-lgtest", "-lpthread"}, room / "log").how !=
          ending::passed)
        continue;  // a test of more than one file
      v.given.how = run_apart({program, "--gtest_fail_fast"}, room / "log", {}, {300, 1200}).how;
      if (v.given.how != ending::passed) return v;
    }
    for (const fs::path& wrong_use : wrong_uses_of(s)) {
      v.given.reached = true;
      if (!build_.is_refused(wrong_use, room, room / "log"))
        return {true, {true, ending::failed, "compile_fail"}};
    }
    fs::remove_all(room);
    return v;
  }

 private:
  // A static assertion is a test; other errors make no mutant.
  static bool is_asserted(const fs::path& log) {
    return read_text(log).find("static assertion failed") != std::string::npos;
  }

  static bool is_static(const unit& u) { return u.source.parent_path().filename() == "static"; }

  // Whether a test lies in the folder of a header's stage or room: tests/unit/scene, tests/unit/mesh/full.
  static bool is_beside(const unit& u, const std::string& header) {
    fs::path folder = u.source.parent_path();
    if (folder.filename() == "full") folder = folder.parent_path();
    return ('/' + header).find('/' + folder.filename().string() + '/') != std::string::npos;
  }

  // Those that are known to reach it come first, then those that include it by name, then those beside it,
  // then by how little they include.
  std::vector<unit> units_for(const std::vector<unit>& some, std::size_t most, const std::string& header,
                              const std::set<std::string>& reached) const {
    std::vector<std::pair<std::tuple<bool, bool, bool, std::size_t>, const unit*>> ordered;
    for (const unit& u : some) {
      const auto found = headers_of_.find(u.object);
      if (found == headers_of_.end() || !found->second.contains(header)) continue;
      const bool by_name = read_text(u.source).find("<passive_haptics/" + header + ">") != std::string::npos;
      ordered.push_back({{!reached.contains(u.object), !by_name && !is_static(u), !is_beside(u, header),
                          found->second.size()},
                         &u});
    }
    std::sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<unit> chosen;
    for (const auto& [rank, u] : ordered) {
      if (chosen.size() < most) chosen.push_back(*u);
    }
    return chosen;
  }

  // The tests of compile_fail that expect a message of this header.
  std::vector<fs::path> wrong_uses_of(const source& s) const {
    static const std::regex seam("\"\\s*\"");  // of a text in two lines
    const std::string messages = std::regex_replace(s.text, seam, "");
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(build_.tree() / "tests/compile_fail")) {
      if (const std::string words = expected_by(read_text(entry));
          !words.empty() && std::regex_search(messages, std::regex(words)))
        all.push_back(entry);
    }
    return all;
  }

  const mutated_build& build_;
  fs::path work_;
  std::vector<unit> light_, heavy_;
  std::map<std::string, std::set<std::string>> headers_of_;  // of an object
};

}  // namespace mutants
