// The copy of the repository whose include/ is mutated, and its compiler.
#pragma once

#include "../generator/switches.hpp"
#include "process.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

namespace fs = std::filesystem;

// A file of the tests and how it is compiled.
struct unit {
  fs::path source;
  std::string object, command;
};

using sources =
    std::map<std::string, std::unique_ptr<source>>;  // by their paths below include/passive_haptics

inline sources read_headers(const fs::path& repository) {
  sources all;
  const fs::path root = repository / "include/passive_haptics";
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string path = fs::relative(entry, root);
    if (entry.is_regular_file()) all.emplace(path, std::make_unique<source>(path, read_text(entry)));
  }
  return all;
}

class mutated_build {
 public:
  mutated_build(fs::path repository, fs::path work, unsigned jobs)
      : repository_(std::move(repository)), work_(std::move(work)), jobs_(jobs) {
    constexpr auto newer = fs::copy_options::recursive | fs::copy_options::update_existing;
    fs::create_directories(tree());
    for (const char* part :
         {"CMakeLists.txt", "CMakePresets.json", "benchmarks", "tests", "examples", "docs"})
      fs::copy(repository_ / part, tree() / part, newer);
    write_text(tree() / "include/passive_haptics_mutants/active.hpp",
               read_text(repository_ / "tests/mutants/active.hpp"));
  }

  fs::path tree() const { return work_ / "tree"; }
  fs::path directory() const { return work_ / "build"; }
  fs::path header(const std::string& path) const { return fs::path("include/passive_haptics") / path; }

  // Writes include/ with these mutants behind switches. fewer: what has been compiled need not be again.
  void write(const sources& headers, const std::map<int, mutant>& chosen, bool fewer = false) const {
    std::map<std::string, std::map<int, mutant>> of_file;
    for (const auto& [number, m] : chosen) of_file[m.file].emplace(number, m);
    for (const auto& [path, s] : headers) {
      const auto found = of_file.find(path);
      std::string text = found == of_file.end() ? s->text : with_switches(*s, found->second);
      // The tables of parameters are made at run time, so that their numbers can have switches
      const std::string table = "inline constexpr auto members_of";
      if (const auto at = text.find(table); at != std::string::npos)
        text.replace(at, table.size(), "inline const auto members_of");
      const fs::path target = tree() / header(path);
      const auto before = fewer ? fs::last_write_time(target) : fs::file_time_type();
      write_text(target, text);
      if (fewer) fs::last_write_time(target, before);
    }
  }

  bool configure() const {
    return run({"cmake", "-S", tree(), "-B", directory(), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -w -D_GLIBCXX_ASSERTIONS", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                "-DPASSIVE_HAPTICS_BUILD_TESTS=ON", "-DPASSIVE_HAPTICS_STRESS_TESTS=ON",
                "-DPASSIVE_HAPTICS_INSTALL=OFF"},
               work_ / "configure.log")
               .how == ending::passed;
  }

  // Builds what it can of the targets.
  bool make(const std::vector<std::string>& targets) const {
    std::vector<std::string> command{"nice", "cmake", "--build", directory(), "--"};
    command.insert(command.end(), {"-k", "0", "-j", std::to_string(jobs_)});
    command.insert(command.end(), targets.begin(), targets.end());
    return run(command, work_ / "make.log").how == ending::passed;
  }

  // All that is compiled.
  std::vector<unit> units() const {
    std::vector<unit> all;
    std::istringstream in(read_text(directory() / "compile_commands.json"));
    std::string command;
    for (std::string line; std::getline(in, line);) {
      if (const std::string text = value_of(line, "command"); !text.empty()) command = text;
      if (const std::string text = value_of(line, "file"); !text.empty())
        all.push_back({text, between(command, " -o ", " "), command});
    }
    return all;
  }

  // A unit compiled otherwise: options before its own; else only looked at.
  bool compile(const unit& u, const std::string& options, const std::string& object,
               const fs::path& log) const {
    std::string command = u.command;
    command.insert(command.find(' '), ' ' + options);
    const std::string output = " -o " + u.object;
    command.replace(command.find(output), output.size(), object.empty() ? " -fsyntax-only" : " -o " + object);
    return run({"nice", "sh", "-c", "cd " + directory().string() + " && exec " + command}, log).how ==
           ending::passed;
  }

  // Whether the compiler says of a wrong use what its test expects, with the headers in `first` before
  // others.
  bool is_refused(const fs::path& test, const fs::path& first, const fs::path& log) const {
    const std::string eigen = between(units().front().command, "-isystem ", " ");
    return run({"nice", "cmake", "-D", "compiler=c++", "-D", "source=" + test.string(), "-D",
                "includes=" + first.string() + ';' + (tree() / "include").string() + ';' + eigen, "-P",
                tree() / "tests/compile_fail/check.cmake"},
               log)
               .how == ending::passed;
  }

  // The headers that each object has read, by their paths below include/passive_haptics.
  std::map<std::string, std::set<std::string>> dependencies() const {
    run({"ninja", "-C", directory(), "-t", "deps"}, work_ / "deps.log");
    std::istringstream in(read_text(work_ / "deps.log"));
    std::map<std::string, std::set<std::string>> all;
    std::string object;
    const std::string ours = "/include/passive_haptics/";
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with(" ")) object = line.substr(0, line.find(':'));
      else if (const auto at = line.find(ours); at != std::string::npos)
        all[object].insert(line.substr(at + ours.size()));
    }
    return all;
  }

 private:
  static std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const auto at = text.find(before);
    if (at == std::string::npos) return {};
    const auto begin = at + before.size();
    return text.substr(begin, text.find(after, begin) - begin);
  }

  // Of a line of JSON: "name": "value"
  static std::string value_of(const std::string& line, const std::string& name) {
    const std::string key = '"' + name + "\": \"";
    const auto at = line.find(key);
    if (at == std::string::npos) return {};
    std::string value;
    for (auto i = at + key.size(); line[i] != '"'; ++i) value += line[i] == '\\' ? line[++i] : line[i];
    return value;
  }

  fs::path repository_, work_;
  unsigned jobs_;
};

// The objects that ninja could not make, and what the compiler said of each.
inline std::map<std::string, std::string> failures_in(const std::string& log) {
  const std::string failed = "FAILED: ";
  std::map<std::string, std::string> all;
  std::istringstream in(log);
  std::string object;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("[")) object.clear();
    if (line.starts_with(failed))
      object = line.substr(failed.size(), line.find(' ', failed.size()) - failed.size());
    if (!object.empty()) all[object] += line + '\n';
  }
  return all;
}

// Lines of headers in a compiler's errors, and in its notes.
struct blamed_lines {
  std::set<std::pair<std::string, long>> errors, notes;
};

inline blamed_lines blamed_in(const std::string& log) {
  static const std::string ours = "/include/passive_haptics/";
  blamed_lines found;
  std::istringstream in(log);
  for (std::string line; std::getline(in, line);) {
    const auto at = line.find(ours), colon = line.find(".hpp:", at);
    if (at == std::string::npos || colon == std::string::npos) continue;
    const std::string path = line.substr(at + ours.size(), colon + 4 - at - ours.size());
    (line.find(" error: ") != std::string::npos ? found.errors : found.notes)
        .emplace(path, std::atol(line.c_str() + colon + 5));
  }
  return found;
}

// The switches where a compiler found errors. If there are none, those where its notes point, or which have
// made a function that they point to a function of run time. If there are none of these either, those in
// constants of classes that the compiler names: what a concept asks of a constant is told without its line.
// Else those in the headers of the errors.
inline std::set<int> numbers_in_errors(const std::string& log, const sources& headers,
                                       const std::map<int, mutant>& chosen) {
  const blamed_lines blamed = blamed_in(log);
  std::set<int> in_errors, in_notes, in_constants, beside_errors;
  for (const auto& [number, m] : chosen) {
    const source& s = *headers.at(m.file);
    for (long line = m.line; line <= s.line_at(m.end); ++line) {
      if (blamed.errors.contains({m.file, line})) in_errors.insert(number);
      if (blamed.notes.contains({m.file, line})) in_notes.insert(number);
    }
    for (const int k : detail::constexprs_around(s, m)) {
      if (blamed.notes.contains({m.file, s.line_at(s[k].begin)})) in_notes.insert(number);
    }
    // What is declared of another type is refused where it is used
    for (const auto& [file, line] : blamed.errors) {
      if (file == m.file) beside_errors.insert(number);
    }
    const std::string name = fs::path(m.file).stem();
    if (m.original_line.starts_with("static constexpr") && log.find("::" + name) != std::string::npos)
      in_constants.insert(number);
  }
  for (const std::set<int>* found : {&in_errors, &in_notes, &in_constants}) {
    if (!found->empty()) return *found;
  }
  return beside_errors;
}

}  // namespace mutants
