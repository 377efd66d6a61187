// What is done to the driver's processes, at each stage, under each release policy: what flows then, and that
// nothing is lost untold. A table, printed and checked. Each case is a process of its own, so that what it
// leaves is its child.
#include "program.hpp"

#include <ports/simulated_wire.hpp>

#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <numeric>
#include <set>
#include <thread>

namespace process_faults_tests {

using namespace program;
using passive_haptics::monotonic_seconds;
using wire = example::simulated_wire<8>;

// [s]; timeout < 0.8 watchdog
constexpr double timeout = 0.4, watchdog = 1, ramp_time = 0.8, hold_time = 1.2;
// What a machine without a processor to spare may add to a stated time; how long a process may take to end
constexpr double load = 5, ends_within = 25;  // [s]

enum class policy { zero, ramp, hold };
constexpr std::array policy_names{"zero", "ramp", "hold"};
double longest(policy p) { return p == policy::zero ? 0 : p == policy::ramp ? ramp_time : hold_time; }

enum class stage { start_up, homing, running, stopping };
constexpr std::array stage_names{"start-up", "homing", "running", "stopping"};

// The signal to each process, or what becomes of the log.
struct fault {
  const char* name;
  int to_loop = 0, to_supervisor = 0, to_recorder = 0;
  const char* told = nullptr;  // of a log that cannot be written
};
constexpr std::array faults_at_each_stage{
    fault{"SIGSTOP of the supervisor", 0, SIGSTOP},
    fault{"SIGSTOP of the recorder", 0, 0, SIGSTOP},
    fault{"SIGKILL of the loop", SIGKILL},
    fault{"SIGSTOP, SIGCONT of the loop", SIGSTOP},
    fault{"SIGKILL of the supervisor", 0, SIGKILL},
    fault{"SIGKILL of the recorder", 0, 0, SIGKILL},
    fault{"SIGKILL of loop and supervisor", SIGKILL, SIGKILL},
    fault{"SIGSTOP, SIGCONT of loop and supervisor", SIGSTOP, SIGSTOP},
    fault{"SIGSTOP of the supervisor, SIGKILL of the loop", SIGKILL, SIGSTOP}};
constexpr fault request{"SIGINT"}, full_disk{"full disk", 0, 0, 0, "File too large"},
    removed_folder{"removed folder", 0, 0, 0, "its .part was removed"};

struct one_case {
  fault what;
  stage when;
  policy at_release;
};

// One case: the driver, its wire looked at each millisecond, and what is wrong.
class bench : public a_driver {
 public:
  explicit bench(const one_case& c) : case_(c) { log_name = "log/brake_driver.csv"; }
  void TestBody() override {}

  std::string row() {
    fs::create_directory(directory / "log");
    settings s{.supervisor_timeout = timeout,
               .period = 4e-3,
               .hand_start = 0,
               .watchdog = watchdog,
               .start_depth = 0.1};
    s.homing = case_.when == stage::homing ? 1 : 0.1;
    s.top += "\nlog = \"log/brake_driver.csv\"\n";
    s.sections = std::string("[[walls]]\nsurface_point = [0, 0.2245]\nnormal = [0, -1]\nstiffness = 1e7\n");
    std::string text = s.text();
    const auto put = [&](const std::string& before, const std::string& more) {
      text.insert(text.find(before) + before.size(), more);
    };
    put("[safety]\n", "at_release = \"" + std::string(policy_names[index(case_.at_release)]) +
                          "\"\nramp_time = " + std::to_string(ramp_time) +
                          "\nhold_time = " + std::to_string(hold_time) + "\n");
    put("[simulation]\n", "wire = \"wire\"\nspeed = 0.001\npath = 0.5\nsensor_noise = 0\n");
    file("c.toml", text);
    launch();
    watch();
    if (reach_stage()) {
      happen();
      finish();
      check();
    }
    watching_ = false;
    if (watcher_.joinable()) watcher_.join();
    char line[400];
    std::snprintf(
        line, sizeof line, "%-5s %-9s %-47s %7.2f  %7.2f  %4d  %6zu  %5s  %s",
        policy_names[index(case_.at_release)], stage_names[index(case_.when)], case_.what.name, stated_,
        until_zero_, status_, rows_, lost_.c_str(),
        wrong_.empty() ? "as stated" : ((was_held_up() ? "HELD UP: " : "WRONG: ") + wrong_).c_str());
    return line;
  }

 private:
  template <class E>
  static std::size_t index(E e) {
    return static_cast<std::size_t>(e);
  }
  struct flow {
    double time, current;
  };

  // A machine that kept the test or the loop from the processor for so long [s] proves nothing
  bool was_held_up() const {
    constexpr double too_long = 0.05;
    for (std::size_t k = 1; k < std::min<std::size_t>(noted_, trace_.size()); ++k)
      if (trace_[k].time - trace_[k - 1].time > too_long) return true;
    const log_file all = log();
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
      if (all.number(k, "late") > too_long && !loop_is_stopped()) return true;
    return false;
  }
  void wrong(const std::string& what) { wrong_ += (wrong_.empty() ? "" : "; ") + what; }
  void require(bool holds, const std::string& what) {
    if (!holds) wrong(what);
  }
  bool is_told(const std::string& text) const {
    return eventually([&] { return has(text_of(directory / "driver.err"), text); });
  }

  void launch() {
    const words command{driver, "--config", "c.toml"};
    if (is(full_disk)) {
      // A file of at most 32 KiB stands for it
      pid = spawn({"/bin/bash", "-c", "ulimit -f 32; exec '" + driver + "' --config c.toml"}, "driver");
    } else {
      pid = spawn(command, "driver");
    }
  }

  // Looks at the wire until the end
  void watch() {
    watcher_ = std::thread([this] {
      const wire* at = nullptr;
      while (watching_) {
        if (at == nullptr) at = map();
        const double now = monotonic_seconds();
        if (at != nullptr) {
          const auto flowing = at->flowing(now);
          trace_[noted_ % trace_.size()] = {now, std::max(flowing[0], flowing[1])};
          ++noted_;
        }
        usleep(1000);
      }
    });
  }
  wire* map() {
    std::error_code none;
    if (fs::file_size(directory / "wire", none) < sizeof(wire) || none) return nullptr;
    const int from = open((directory / "wire").c_str(), O_RDWR | O_CLOEXEC);
    void* memory = mmap(nullptr, sizeof(wire), PROT_READ | PROT_WRITE, MAP_SHARED, from, 0);
    close(from);
    return memory == MAP_FAILED ? nullptr : static_cast<wire*>(memory);
  }
  double current() const { return noted_ == 0 ? 0 : trace_[(noted_ - 1) % trace_.size()].current; }

  bool reach_stage() {
    const bool there = eventually([&] {
      const auto children = children_of(pid);
      // A process that is stopped before it left the driver's group is one that nothing wakes
      if (children.size() < 2 || !std::all_of(children.begin(), children.end(), leads_a_group)) return false;
      if (case_.when == stage::start_up) return true;
      if (case_.when == stage::homing) return log_file(part_path()).size() > 5;
      return current() > 0.5;
    });
    if (!there) {
      wrong("never got there: " + text_of(directory / "driver.err"));
      return false;
    }
    recorder_ = recorder();
    supervisor_ = supervisor();
    if (case_.when == stage::running || case_.when == stage::stopping) usleep(200'000);  // until it stays
    level_ = current();
    begun_ = monotonic_seconds();
    if (case_.when != stage::stopping) return true;
    send(SIGINT);
    usleep(20'000);
    return true;
  }
  static bool leads_a_group(pid_t one) { return getpgid(one) == one; }
  bool is(const fault& one) const { return std::string(case_.what.name) == one.name; }
  bool loop_is_dead() const { return case_.what.to_loop == SIGKILL; }
  bool loop_is_stopped() const { return case_.what.to_loop == SIGSTOP; }
  bool of_supervisor() const { return case_.what.to_loop == 0 && case_.what.to_supervisor != 0; }
  // A stopped supervisor is woken as its loop dies
  bool of_both() const {
    return case_.what.to_supervisor != 0 && case_.what.to_loop == case_.what.to_supervisor;
  }

  // The fault, and its stated time until 0 A
  void happen() {
    happened_ = monotonic_seconds();
    const auto& [name, to_loop, to_supervisor, to_recorder, told] = case_.what;
    if (to_recorder != 0) send(to_recorder, recorder_);
    if (to_supervisor != 0) send(to_supervisor, supervisor_);
    if (to_loop != 0) send(to_loop);
    if (is(removed_folder)) fs::remove_all(directory / "log");
    if (told != nullptr) require(is_told(std::string("cycles lost: ") + told), "not told as it happens");
    stated_ = longest(case_.at_release);
    if (of_both()) stated_ = watchdog;
    else if (loop_is_stopped()) stated_ += 1.25 * timeout;
    // The loop holds as long as it lives
    else if (of_supervisor() && case_.at_release != policy::hold && case_.when != stage::stopping)
      stated_ += timeout;
  }

  // By itself, as the fault alone ends the current
  bool ends_by_itself() const {
    if (case_.what.to_loop != 0) return true;
    if (of_supervisor()) return case_.at_release != policy::hold || case_.when == stage::stopping;
    return case_.what.to_recorder != 0 && case_.when == stage::stopping;
  }
  bool comes_to_zero(double most) {
    const double end = monotonic_seconds() + most;
    while (current() != 0 && monotonic_seconds() < end) usleep(1000);
    usleep(5000);
    return current() == 0;
  }

  // Until the program ended
  void finish() {
    if (of_supervisor() && case_.when != stage::stopping)
      require(eventually([this] {
                const log_file all(part_path());
                return status_now() != 0 ||
                       (all.size() > 2 && all.text(all.size() - 2, "state") == "released");
              }),
              "the loop goes on without a supervisor");
    bool asked = case_.when == stage::stopping;
    if (!ends_by_itself()) {
      asked = true;
      begun_ = happened_ = monotonic_seconds();
      send(SIGINT);
    }
    require(comes_to_zero(stated_ + load), "current still flows");
    until_zero_ = std::max(0.0, last_flow() - happened_);
    if (loop_is_stopped() && case_.when == stage::homing) usleep(static_cast<unsigned>(1.5e6 * timeout));
    if (loop_is_stopped()) {
      send(SIGCONT);
      if (of_both()) send(SIGCONT, supervisor_);
      usleep(100'000);
    }
    if (!loop_is_dead() && !asked) send(SIGINT);
    const double end = monotonic_seconds() + ends_within;
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(pid, &status, WNOHANG)) == 0 && monotonic_seconds() < end) usleep(2000);
    require(ended == pid, "it does not end");
    if (ended != pid) return;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    require(nothing_is_left(), "a process is left");
    usleep(5000);
    watching_ = false;
    watcher_.join();
  }
  // Whether it ended, without taking its status
  pid_t status_now() const {
    siginfo_t what{};
    waitid(P_PID, static_cast<id_t>(pid), &what, WEXITED | WNOHANG | WNOWAIT);
    return what.si_pid;
  }
  double last_flow() const {
    for (std::size_t k = noted_; k-- > (noted_ > trace_.size() ? noted_ - trace_.size() : 0);)
      if (const flow& one = trace_[k % trace_.size()]; one.current > 0) return one.time;
    return 0;
  }

  void check() {
    if (!wrong_.empty()) return;
    check_current();
    check_status();
    check_log();
  }

  // The law of the policy, from what was seen: a clock read late only makes it milder
  void check_current() {
    const bool flowed = case_.when == stage::running || case_.when == stage::stopping;
    double before = 1e9, widest = 0;
    int returned = 0;  // to a current from 0 A
    const bool by_policy = !of_both();
    for (std::size_t k = 0; k < std::min<std::size_t>(noted_, trace_.size()); ++k) {
      const auto [time, current] = trace_[k];
      if (case_.when == stage::homing && current != 0) return wrong("current before it was active");
      if (!flowed || time < begun_) continue;
      const double since = time - begun_;
      if (by_policy && case_.at_release == policy::hold && since < hold_time && current != level_)
        return wrong("not held after " + std::to_string(since) + " s");
      // The loop reads its clock at the begin of a cycle, and begins a release then
      if (by_policy && case_.at_release == policy::ramp &&
          current < level_ * (1 - (since + 4e-3) / ramp_time) - 1e-9)
        return wrong("steeper than the ramp after " + std::to_string(since) + " s");
      // A loop that goes on may be about to write; a supervisor knows what flowed a cycle before
      if (current > before + (case_.at_release == policy::ramp ? 8e-3 / ramp_time : 0) && !loop_is_stopped())
        return wrong("current rises again");
      if (loop_is_stopped() && before == 0 && current > 0) ++returned;
      widest = std::max(widest, before < 1e9 ? before - current : 0);
      before = current;
    }
    require(returned <= 1, "current returns without a rearm");
    if (flowed && by_policy && case_.at_release == policy::ramp)
      require(widest < 0.7 * level_ || until_zero_ > ramp_time, "a step instead of a ramp");
  }

  void check_status() {
    const bool early = case_.when == stage::start_up, late = case_.when == stage::stopping;
    std::set<int> right{0};
    if (loop_is_dead()) {
      right = {128 + SIGKILL};
      if (late && case_.at_release == policy::zero) right.insert(0);  // it had ended
    } else if (loop_is_stopped() || of_supervisor()) {
      right = early ? std::set{0, 1, 3} : late ? std::set{0} : std::set{3};
      if (late && of_both()) right.insert(3);                                 // by the watchdog
      if (loop_is_stopped() && case_.when == stage::homing) right.insert(0);  // where the supervisor was late
    } else if (case_.what.to_recorder == SIGKILL) {
      right = early ? std::set{1, 4} : late ? std::set{0, 4} : std::set{4};
    } else if (case_.what.to_recorder == SIGSTOP && early) {
      right = {0, 1};
    } else if (case_.what.told != nullptr) {
      right = {4};
    }
    require(right.contains(status_), "status " + std::to_string(status_));
  }

  // All that was recorded is in the file, or said to be lost
  void check_log() {
    const bool has_part = fs::exists(part_path());
    rows_ = log().size();
    if (status_ == 1) return;
    require(!(has_part && fs::exists(log_path())), "a file and its .part");
    if (status_ == 0 || status_ == 3 || loop_is_dead()) {
      require(!has_part, "a .part is left");
      require(log_file(log_path()).is_whole() || case_.when == stage::start_up, "the log is not whole");
    }
    if (status_ == 4 && !is(removed_folder)) require(has_part, "the .part was not kept");
    const std::string out = text_of(directory / "driver.out");
    if (is(full_disk))
      require(is_told("error: cannot write all of 'log/brake_driver.csv.part'") &&
                  has(out, "log: log/brake_driver.csv.part, as far as it came"),
              "the end does not tell of the full disk");
    const auto cycles = out.rfind(" cycles, "), lost = out.rfind(" cycles lost");
    if (cycles == std::string::npos || lost == std::string::npos) return;
    const auto number = [&](std::size_t end) {
      return std::stoul(out.substr(out.find_last_of("\n ", end - 1) + 1));
    };
    lost_ = std::to_string(number(lost));
    require(rows_ + number(lost) >= number(cycles),
            "of " + std::to_string(number(cycles)) + " cycles some are lost untold");
    require((number(lost) > 0 || has_part) == (status_ == 4), "the status says nothing of the loss");
  }

  one_case case_;
  pid_t recorder_ = -1, supervisor_ = -1;
  std::thread watcher_;
  std::atomic<bool> watching_ = true;
  std::array<flow, 1 << 16> trace_{};
  std::atomic<std::size_t> noted_ = 0;
  double level_ = 0, begun_ = 0, happened_ = 0, stated_ = 0, until_zero_ = 0;
  int status_ = -1;
  std::size_t rows_ = 0;
  std::string lost_ = "-", wrong_;
};

std::vector<one_case> all_cases() {
  std::vector<one_case> all;
  for (const policy p : {policy::zero, policy::ramp, policy::hold}) {
    using enum stage;
    for (const fault& what : faults_at_each_stage)
      for (const stage when : {start_up, homing, running, stopping}) all.push_back({what, when, p});
    for (const stage when : {homing, running}) all.push_back({request, when, p});
    for (const fault& what : {full_disk, removed_folder}) all.push_back({what, running, p});
  }
  return all;
}

// Some of the cases, so many at once; into each its row.
void run(const std::vector<one_case>& cases, const std::vector<std::size_t>& which, std::size_t at_once,
         std::vector<std::string>& rows) {
  struct worker {
    pid_t pid;
    int from;
    std::size_t row;
  };
  std::vector<worker> workers;
  const auto collect = [&] {
    const pid_t ended = waitpid(-1, nullptr, 0);
    const auto one =
        std::find_if(workers.begin(), workers.end(), [&](const worker& w) { return w.pid == ended; });
    if (one == workers.end()) return;
    std::array<char, 1000> text{};
    const ssize_t size = read(one->from, text.data(), text.size());
    close(one->from);
    rows[one->row].assign(text.data(), static_cast<std::size_t>(std::max<ssize_t>(0, size)));
    workers.erase(one);
  };
  for (const std::size_t k : which) {
    while (workers.size() >= at_once) collect();
    std::array<int, 2> ends;
    ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      const std::string row = std::make_unique<bench>(cases[k])->row();
      _exit(write(ends[1], row.data(), row.size()) < 0);
    }
    close(ends[1]);
    workers.push_back({child, ends[0], k});
  }
  while (!workers.empty()) collect();
}

TEST(process_faults, end_as_the_release_policy_says_and_lose_nothing_untold) {
  const auto cases = all_cases();
  std::vector<std::string> rows(cases.size());
  std::vector<std::size_t> which(cases.size());
  std::iota(which.begin(), which.end(), std::size_t{0});
  // Again and fewer at once where the machine held a case up
  std::size_t tried = 0;
  for (const std::size_t at_once : {12u, 4u, 2u, 1u, 1u, 1u}) {
    run(cases, which, at_once, rows);
    tried += which.size();
    std::erase_if(which, [&](std::size_t k) { return !has(rows[k], "HELD UP: "); });
  }
  std::printf("%-5s %-9s %-47s %7s  %7s  %4s  %6s  %5s\n", "", "", "", "0 A [s]", "after", "exit", "rows",
              "lost");
  for (const auto& row : rows) {
    std::printf("%s\n", row.c_str());
    EXPECT_TRUE(row.ends_with("as stated")) << row;
  }
  std::printf("%zu cases, %zu of them again as the machine held them up\n", cases.size(),
              tried - cases.size());
}

}  // namespace process_faults_tests
