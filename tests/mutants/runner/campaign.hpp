// A run over one draw: the mutants behind switches, then those that have to be compiled alone.
#pragma once

#include "build.hpp"
#include "lone.hpp"
#include "suites.hpp"
#include "table.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <mutex>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

struct options {
  std::uint64_t seed = 20040627;
  std::size_t count = 400;
  std::string of = {};
  unsigned jobs = 2;
  bool again = false;   // what was killed before need not be killed again
  bool argued = false;  // those alone that are argued to change nothing
  fs::path repository = fs::current_path(), work = fs::current_path() / "build/mutants";
};

inline bool is_mutated(const std::string& path) {
  static const std::set<std::string> stages{"brake", "force", "control", "scene", "driver", "core/linear"};
  return stages.contains(stage_of(path));
}

inline std::vector<mutant> all_mutants(const sources& headers) {
  std::vector<mutant> all;
  for (const auto& [path, s] : headers) {
    if (!is_mutated(path)) continue;
    const auto some = mutants_of(*s);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

// A run over one draw.
class campaign {
 public:
  campaign(const options& o, const sources& headers, std::vector<mutant> drawn)
      : o_(o), headers_(headers), build_(o.repository, o.work, o.jobs), drawn_(std::move(drawn)) {
    if (!o.again) {
      for (const char* name : {"dropped", "failed", "crashed", "late"}) fs::remove(list(name));
    }
    given_.resize(drawn_.size());
    done_.resize(drawn_.size());
    const auto dropped = keys_in(read_text(list("dropped")));
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      const auto found = dropped.find(key_of(drawn_[i]));
      if (found != dropped.end()) failed_in_.emplace(static_cast<int>(i), words_of(found->second));
      else if (drawn_[i].how != form::compiled) switched_.emplace(static_cast<int>(i), drawn_[i]);
    }
    for (const ending how : {ending::failed, ending::crashed, ending::late}) {
      const auto killed = keys_in(read_text(list(word_of(how))));
      for (std::size_t i = 0; i < drawn_.size(); ++i) {
        if (!killed.contains(key_of(drawn_[i]))) continue;
        given_[i] = {true, how};
        done_[i] = 1;
      }
    }
  }

  std::vector<judged_mutant> judge() {
    build_.write(headers_, switched_);
    if (!build_.configure() || !build_.make({"test_prelude"})) stop("the copy cannot be configured");
    drop_what_does_not_compile(
        {probe(light_units().front())});  // quick, and finds most; the builds find the rest
    judge_with(false);
    judge_with(true);
    judge_alone();
    std::vector<judged_mutant> first;
    for (std::size_t i = 0; i < drawn_.size() && first.size() < o_.count; ++i) {
      if (!invalid_.contains(static_cast<int>(i))) first.push_back({drawn_[i], given_[i]});
    }
    return first;
  }

 private:
  [[noreturn]] static void stop(const std::string& why) {
    std::cerr << "error: " << why << '\n';
    std::exit(2);
  }

  static void say(const std::string& what) { std::cerr << what + '\n'; }

  using objects_by_number = std::map<int, std::set<std::string>>;

  static std::set<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
  }

  // What a later run may take as known.
  fs::path list(const std::string& name) const { return o_.work / (name + ".txt"); }

  void settle(std::size_t i, const verdict& v) {
    const std::scoped_lock lock(mutex_);
    given_[i] = v;
    if (v.how == ending::passed) return;
    done_[i] = 1;
    std::ofstream(list(word_of(v.how)), std::ios::app) << key_of(drawn_[i]) << '\n';
  }

  // Those that are neither killed nor beyond the first `count` which are known to compile.
  template <class Wanted>
  std::vector<int> left_of(const Wanted& wanted) const {
    std::vector<int> left;
    std::size_t good = 0;
    for (int i = 0; i < static_cast<int>(drawn_.size()) && good < o_.count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (switched_.contains(i) || drawn_[at].how == form::compiled) ++good;
      if (wanted(i) && !done_[at]) left.push_back(i);
    }
    return left;
  }

  // A file that includes all of the headers.
  unit probe(unit like) const {
    std::string text;
    for (const auto& [path, s] : headers_) {
      if (is_mutated(path)) text += "#include <passive_haptics/" + path + ">\n";
    }
    const fs::path source = o_.work / "probe.cpp";
    write_text(source, text);
    like.command.replace(like.command.find(like.source), like.source.string().size(), source);
    like.source = source;
    return like;
  }

  std::vector<unit> units_in(const std::string& places) const {
    const std::regex wanted(places + "/[a-z0-9_]+[.]cpp");
    std::vector<unit> some;
    for (const unit& u : build_.units()) {
      if (std::regex_match(fs::relative(u.source, build_.tree() / "tests").string(), wanted))
        some.push_back(u);
    }
    return some;
  }

  // What is compiled with every commit.
  std::vector<unit> light_units() const { return units_in("(unit/[a-z]+|property|static|driver|realtime)"); }

  // The programs of a pass: first those that are compiled with every commit, then the heavy ones.
  static bool is_of(bool full, const std::string& program) {
    static const std::regex light("(unit|property|driver|realtime)(_[a-z0-9_]+)?"),
        heavy("(unit|property|driver)_(.*_)?full|repository_parameters_page_full|stress_[a-z_]+");
    return std::regex_match(program, full ? heavy : light) && (full || !program.ends_with("_full"));
  }

  std::vector<std::string> full_targets() const {
    run({"ninja", "-C", build_.directory(), "-t", "targets", "all"}, o_.work / "targets.log");
    std::istringstream in(read_text(o_.work / "targets.log"));
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) {
      if (const std::string name = line.substr(0, line.find(':')); is_of(true, name)) all.push_back(name);
    }
    return all;
  }

  // What a switch cannot stand for is compiled alone.
  void drop_switches(const objects_by_number& failed_in, const std::string& log) {
    if (failed_in.empty()) stop("no switch is to blame:\n" + log.substr(0, 3000));
    for (const auto& [n, objects] : failed_in) {
      std::ofstream out(list("dropped"), std::ios::app);
      out << key_of(switched_.at(n)) << " |";
      for (const std::string& object : objects) out << ' ' << object;
      out << '\n';
      switched_.erase(n);
    }
    failed_in_.insert(failed_in.begin(), failed_in.end());
    say(std::to_string(failed_in.size()) + " switches do not compile");
    build_.write(headers_, switched_, true);
  }

  void drop_what_does_not_compile(std::vector<unit> left) {
    while (!left.empty()) {
      std::vector<std::string> logs(left.size());
      in_parallel(left.size(), o_.jobs, [&](std::size_t i, unsigned worker) {
        const fs::path log = o_.work / ("compile." + std::to_string(worker) + ".log");
        if (!build_.compile(left[i], "-fmax-errors=0", "", log)) logs[i] = read_text(log);
      });
      objects_by_number failed_in;
      std::vector<unit> again;
      std::string all;
      for (std::size_t i = 0; i < left.size(); ++i) {
        if (logs[i].empty()) continue;
        again.push_back(left[i]);
        for (const int n : numbers_in_errors(logs[i], headers_, switched_))
          failed_in[n];  // of it all units speak that include the header
        all += logs[i];
      }
      write_text(o_.work / "errors.log", all);
      left = again;
      if (!left.empty()) drop_switches(failed_in, all);
    }
  }

  void judge_with(bool full) {
    say("building");
    while (!build_.make(full ? full_targets() : std::vector<std::string>{"all"})) {
      const std::string log = read_text(o_.work / "make.log");
      objects_by_number failed_in;
      for (const auto& [object, errors] : failures_in(log)) {
        for (const int n : numbers_in_errors(errors, headers_, switched_)) failed_in[n].insert(object);
      }
      drop_switches(failed_in, log);
    }
    std::vector<fs::path> programs;
    for (const auto& entry : fs::directory_iterator(build_.directory() / "tests")) {
      if (entry.is_regular_file() && is_of(full, entry.path().filename())) programs.push_back(entry.path());
    }
    say("measuring " + std::to_string(programs.size()) + " programs");
    const auto tests = measured_tests(programs, o_.work, o_.jobs);
    const auto left = left_of([&](int i) { return switched_.contains(i); });
    say(std::to_string(tests.size()) + " tests, " + std::to_string(left.size()) + " mutants");
    in_parallel(left.size(), o_.jobs, [&](std::size_t k, unsigned worker) {
      const auto i = static_cast<std::size_t>(left[k]);
      verdict v = judged(left[k], tests, o_.work / ("judge." + std::to_string(worker)));
      v.reached = v.reached || given_[i].reached;
      settle(i, v);
      if (v.how == ending::passed) say("lives: " + key_of(drawn_[i]));
    });
  }

  void judge_alone() {
    const auto left = left_of([&](int i) { return !switched_.contains(i); });
    for (const int number : left) failed_in_[number];
    say(std::to_string(left.size()) + " mutants compiled alone");
    const lone_judge judge(build_, o_.work, light_units(), units_in("(unit/[a-z]+|property|driver)/full"));
    in_parallel(left.size(), o_.jobs, [&](std::size_t k, unsigned) {
      const int number = left[k];
      const auto i = static_cast<std::size_t>(number);
      const lone_verdict v = judge(*headers_.at(drawn_[i].file), drawn_[i], number, failed_in_[number]);
      if (v.compiles || drawn_[i].how == form::compiled) settle(i, v.given);
      else {
        const std::scoped_lock lock(mutex_);
        invalid_.insert(number);
      }
      if (v.given.how == ending::passed) say("lives, alone: " + key_of(drawn_[i]));
    });
  }

  options o_;
  const sources& headers_;
  mutated_build build_;
  std::vector<mutant> drawn_;
  std::vector<verdict> given_;
  std::vector<char> done_;
  std::map<int, mutant> switched_;  // by their numbers, which are places in drawn_
  objects_by_number failed_in_;     // where a switch could not be compiled
  std::set<int> invalid_;
  std::mutex mutex_;
};

}  // namespace mutants
