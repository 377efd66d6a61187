// Do the tests notice a mistake? One line of the library is changed at a time, and the tests are run.
#include "build.hpp"
#include "draw.hpp"
#include "lone.hpp"
#include "suites.hpp"
#include "table.hpp"

#include <cstdio>
#include <iostream>
#include <mutex>

using namespace mutants;

namespace {

struct options {
  std::uint64_t seed = 20040627;
  std::size_t count = 400;
  unsigned jobs = 2;
  bool again = false;
  fs::path repository = ".", work = "build/mutants";
};

options options_of(int argc, char** argv) {
  options o;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    if (name == "--seed") o.seed = std::stoull(value());
    else if (name == "--count") o.count = std::stoul(value());
    else if (name == "--jobs") o.jobs = static_cast<unsigned>(std::stoul(value()));
    else if (name == "--again") o.again = true;
    else {
      std::cerr << "usage: mutants [--seed S] [--count N] [--jobs J] [--again]\n"
                   "--again: what was killed before need not be killed again\n";
      std::exit(name == "--help" ? 0 : 2);
    }
  }
  o.repository = fs::absolute(o.repository);
  o.work = fs::absolute(o.work);
  return o;
}

sources read_headers(const fs::path& repository) {
  sources all;
  const fs::path root = repository / "include/passive_haptics";
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    const std::string path = fs::relative(entry, root);
    if (entry.is_regular_file()) all.emplace(path, std::make_unique<source>(path, read_text(entry)));
  }
  return all;
}

bool is_mutated(const std::string& path) {
  static const std::set<std::string> stages{"brake", "force", "control", "scene", "driver", "core/linear"};
  return stages.contains(stage_of(path));
}

std::vector<mutant> all_mutants(const sources& headers) {
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
  campaign(const options& o, const sources& headers, const std::vector<mutant>& all)
      : o_(o), headers_(headers), build_(o.repository, o.work), drawn_(drawn(all, o.seed, o.count * 3 / 2)) {
    if (o.again) killed_before_ = keys_in(read_text(o.work / "killed.txt"));
    else fs::remove(o.work / "killed.txt");
    given_.resize(drawn_.size());
    done_.resize(drawn_.size());
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      if (drawn_[i].how != form::compiled) switched_.emplace(static_cast<int>(i), drawn_[i]);
      if (killed_before_.contains(key_of(drawn_[i]))) settle(i, {true, ending::failed, "before"});
    }
  }

  std::vector<judged_mutant> judge() {
    build_.write(headers_, switched_);
    if (!build_.configure() || !build_.make({"test_prelude"})) stop("the copy cannot be configured");
    const auto light = light_units();
    // Most errors are seen in the headers alone and where many types meet; that is quick. The rest ends a
    // build.
    drop_what_does_not_compile({probe(light.front())});
    drop_what_does_not_compile(units_in("property/"));
    judge_with({"all"}, [](const std::string& name) { return !name.ends_with("_full"); });
    judge_alone(light);
    judge_with(full_targets(), [](const std::string& name) { return name.ends_with("_full"); });
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

  void settle(std::size_t i, const verdict& v) {
    const std::scoped_lock lock(mutex_);
    given_[i] = v;
    if (v.how == ending::passed) return;
    done_[i] = 1;
    if (v.by != "before") std::ofstream(o_.work / "killed.txt", std::ios::app) << key_of(drawn_[i]) << '\n';
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

  // Compiled with every commit, without devices.
  std::vector<unit> units_in(const std::string& folder) const {
    std::vector<unit> some;
    for (const unit& u : build_.units()) {
      const std::string path = fs::relative(u.source, build_.tree() / "tests");
      if (path.starts_with(folder) && path.find("/full/") == std::string::npos) some.push_back(u);
    }
    return some;
  }
  std::vector<unit> light_units() const {
    std::vector<unit> light;
    for (const char* folder : {"unit/", "property/", "static/"}) {
      for (unit& u : units_in(folder)) light.push_back(std::move(u));
    }
    return light;
  }

  std::vector<std::string> full_targets() const {
    run({"ninja", "-C", build_.directory(), "-t", "targets", "all"}, o_.work / "targets.log");
    std::istringstream in(read_text(o_.work / "targets.log"));
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) {
      const std::string name = line.substr(0, line.find(':'));
      const bool test =
          name.starts_with("unit_") || name.starts_with("property_") || name.starts_with("driver_");
      if (test && name.ends_with("_full") && name.find("busy_machine") == std::string::npos)
        all.push_back(name);
    }
    return all;
  }

  // What a switch cannot stand for is compiled alone.
  void drop_switches(const std::set<int>& numbers, const std::string& log) {
    if (numbers.empty()) stop("no switch is to blame:\n" + log.substr(0, 3000));
    for (const int n : numbers) {
      switched_.erase(n);
      dropped_.insert(n);
    }
    say(std::to_string(numbers.size()) + " switches do not compile");
    build_.write(headers_, switched_);
  }

  void drop_what_does_not_compile(std::vector<unit> left) {
    while (!left.empty()) {
      std::vector<std::string> logs(left.size());
      in_parallel(left.size(), o_.jobs, [&](std::size_t i, unsigned worker) {
        const fs::path log = o_.work / ("compile." + std::to_string(worker) + ".log");
        if (!build_.compile(left[i], "-fmax-errors=0", "", log)) logs[i] = read_text(log);
      });
      std::set<int> numbers;
      std::vector<unit> again;
      std::string all;
      for (std::size_t i = 0; i < left.size(); ++i) {
        if (logs[i].empty()) continue;
        again.push_back(left[i]);
        numbers.merge(numbers_in_errors(logs[i], headers_, switched_));
        all += logs[i];
      }
      write_text(o_.work / "errors.log", all);
      left = again;
      if (!left.empty()) drop_switches(numbers, all);
    }
  }

  template <class Wanted>
  void judge_with(const std::vector<std::string>& targets, const Wanted& wanted) {
    say("building");
    while (!build_.make(targets)) {
      const std::string log = read_text(o_.work / "make.log");
      drop_switches(numbers_in_errors(log, headers_, switched_), log);
    }
    std::vector<fs::path> programs;
    for (const auto& entry : fs::directory_iterator(build_.directory() / "tests")) {
      const std::string name = entry.path().filename();
      const bool test = name.starts_with("unit_") || name.starts_with("property") ||
                        name.starts_with("driver_") || name.starts_with("realtime_");
      if (entry.is_regular_file() && test && name.find('.') == std::string::npos &&
          name.find('[') == std::string::npos && wanted(name))
        programs.push_back(entry.path());
    }
    say("measuring " + std::to_string(programs.size()) + " programs");
    const auto tests = measured_tests(programs, o_.work, o_.jobs);
    std::vector<int> left;
    for (const auto& [number, m] : switched_) {
      if (!done_[static_cast<std::size_t>(number)]) left.push_back(number);
    }
    say(std::to_string(tests.size()) + " tests, " + std::to_string(left.size()) + " mutants");
    in_parallel(left.size(), o_.jobs, [&](std::size_t k, unsigned worker) {
      const auto i = static_cast<std::size_t>(left[k]);
      verdict v = judged(left[k], tests, o_.work / ("judge." + std::to_string(worker)));
      v.reached = v.reached || given_[i].reached;
      settle(i, v);
      if (v.how == ending::passed) say("lives: " + key_of(drawn_[i]));
    });
  }

  void judge_alone(const std::vector<unit>& light) {
    std::vector<int> left;
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      if (!switched_.contains(static_cast<int>(i)) && !done_[i]) left.push_back(static_cast<int>(i));
    }
    say(std::to_string(left.size()) + " mutants compiled alone");
    const lone_judge judge(build_, o_.work, light);
    in_parallel(left.size(), o_.jobs, [&](std::size_t k, unsigned) {
      const int number = left[k];
      const auto i = static_cast<std::size_t>(number);
      const lone_verdict v = judge(*headers_.at(drawn_[i].file), drawn_[i], number);
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
  std::set<int> dropped_, invalid_;
  std::set<std::string> killed_before_;
  std::mutex mutex_;
};

}  // namespace

int main(int argc, char** argv) {
  const options o = options_of(argc, argv);
  fs::create_directories(o.work);
  const sources headers = read_headers(o.repository);
  const std::vector<mutant> all = all_mutants(headers);
  const auto argued = keys_in(read_text(o.repository / "tests/mutants/equivalent.txt"));
  for (const std::string& key : stale(argued, all)) {
    std::cerr << "tests/mutants/equivalent.txt argues about what is no longer there: " << key << '\n';
    return 2;
  }
  std::cout << "seed " << o.seed << ", " << o.count << " of " << all.size() << " mutants\n" << std::flush;
  const auto judged = campaign(o, headers, all).judge();
  return print_table(std::cout, judged, argued) ? 0 : 1;
}
