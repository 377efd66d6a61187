// The tests of a build: what each costs and which mutants it reaches; and whether they notice one.
#pragma once

#include "../active.hpp"
#include "process.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

namespace fs = std::filesystem;

struct test_case {
  std::string program, name;
  double cpu = 0;            // [s]
  std::string reached = {};  // a mark for each mutant
  bool reaches(int mutant) const { return reached[static_cast<std::size_t>(mutant)] != 0; }
};

struct verdict {
  bool reached = false;
  ending how = ending::passed;
  std::string by = {};  // the program that noticed it
};

namespace detail {

inline std::vector<test_case> tests_of(const fs::path& program, const fs::path& log) {
  std::vector<test_case> all;
  run({program.string(), "--gtest_list_tests"}, log);
  std::istringstream in(read_text(log));
  std::string suite;
  for (std::string line; std::getline(in, line);) {
    std::string name = line.substr(0, line.find('#'));
    name.erase(name.find_last_not_of(' ') + 1);
    if (!name.starts_with("  ")) suite = name;
    else all.push_back({program.string(), suite + name.substr(2)});
  }
  return all;
}

inline deadline deadline_of(double cpu) {
  const auto most = static_cast<unsigned>(std::max(10.0, 10 * cpu));
  return {most, 10 * most};
}

// Such a program waits for clocks and other processes: a busy machine makes it fail.
inline bool measures_time(const std::string& program) {
  const std::string name = fs::path(program).filename();
  return name.starts_with("driver_") || name.starts_with("realtime_");
}

}  // namespace detail

// The tests of these programs that pass without a mutant, each in a process of its own.
inline std::vector<test_case> measured_tests(const std::vector<fs::path>& programs, const fs::path& work,
                                             unsigned jobs) {
  std::vector<test_case> all;
  for (const fs::path& program : programs) {
    for (auto& test : detail::tests_of(program, work / "list.log")) all.push_back(std::move(test));
  }
  std::vector<char> passed(all.size());
  in_parallel(all.size(), jobs, [&](std::size_t i, unsigned worker) {
    const fs::path marks = work / ("marks." + std::to_string(worker));
    std::ofstream(marks) << std::string(passive_haptics_mutants::capacity, '\0');
    const ended e = run_apart({all[i].program, "--gtest_filter=" + all[i].name},
                              work / ("measure." + std::to_string(worker) + ".log"),
                              {{"PASSIVE_HAPTICS_MUTANTS_REACHED", marks.string()}});
    all[i].cpu = e.cpu;
    all[i].reached = read_text(marks);
    passed[i] = e.how == ending::passed;
    if (!passed[i])
      std::cerr << "left out, fails without a mutant: " + all[i].program + ' ' + all[i].name + '\n';
  });
  std::vector<test_case> good;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (passed[i]) good.push_back(std::move(all[i]));
  }
  return good;
}

// Runs what reaches a mutant, the cheapest program first, until one fails.
inline verdict judged(int mutant, const std::vector<test_case>& tests, const fs::path& log) {
  struct selection {
    std::string filter = {};
    double cpu = 0;
  };
  std::map<std::string, selection> of_program;
  for (const test_case& test : tests) {
    if (!test.reaches(mutant)) continue;
    selection& chosen = of_program[test.program];
    chosen.filter += test.name + ':';
    chosen.cpu += test.cpu;
  }
  std::vector<std::pair<std::string, selection>> ordered(of_program.begin(), of_program.end());
  std::sort(ordered.begin(), ordered.end(),
            [](const auto& a, const auto& b) { return a.second.cpu < b.second.cpu; });
  for (const auto& [program, chosen] : ordered) {
    const fs::path flags = log.string() + ".flags";
    write_text(flags, "--gtest_filter=" + chosen.filter + '\n');
    ending how = ending::failed;
    for (int tries = detail::measures_time(program) ? 3 : 1; tries > 0 && how != ending::passed; --tries)
      how = run_apart({program, "--gtest_flagfile=" + flags.string(), "--gtest_fail_fast"}, log,
                      {{"PASSIVE_HAPTICS_MUTANT", std::to_string(mutant)}}, detail::deadline_of(chosen.cpu))
                .how;
    if (how != ending::passed) return {true, how, fs::path(program).filename()};
  }
  return {!ordered.empty()};
}

}  // namespace mutants
