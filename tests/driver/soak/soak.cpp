// The simulated driver for an hour, or PASSIVE_HAPTICS_SOAK seconds: under changing load its processes are
// stopped and go on, and its brakes are rearmed. Memory and descriptors stay as they were, no cycle is lost
// untold, no current leaves its limits, and no fault comes that was not caused.
#include "../program/program.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <thread>

namespace {

using namespace program;
using passive_haptics::monotonic_seconds;

constexpr std::uint64_t seed = 20040627;
constexpr double limit = 1;                           // of a current [A], the default
constexpr double timeout = 4, stopped = timeout + 2;  // of the supervisor; what it surely notices [s]
constexpr double unnoticed = 0.5;                     // nobody minds so short a stop [s]
constexpr long slack = 256;                           // pages that were not touched before [KiB]
// Of a stopped supervisor, and of a stopped loop: it stood still for longer than hold_over
const std::string lost_supervisor = "the supervisor is lost, or released the brakes",
                  stopped_loop = "a cycle began too late";

void rest(double seconds) { usleep(static_cast<useconds_t>(1e6 * seconds)); }

// What a process holds.
struct holdings {
  long memory = 0;  // resident, and its own [KiB]
  std::size_t descriptors = 0;
  long threads = 0;
};

holdings held_by(pid_t process) {
  holdings h;
  const fs::path at = "/proc/" + std::to_string(process);
  std::ifstream status(at / "status");
  for (std::string name; status >> name; std::getline(status, name)) {
    if (name == "RssAnon:") status >> h.memory;
    if (name == "Threads:") status >> h.threads;
  }
  for (const auto& one : fs::directory_iterator(at / "fd")) h.descriptors += !one.path().empty();
  return h;
}

// Processors and a disk that are busy with something else.
class load {
 public:
  explicit load(const fs::path& directory) : file_(directory / "load") {}

  void set(int workers) {
    all_.clear();
    for (int i = 0; i < workers; ++i)
      all_.emplace_back([this, i](const std::stop_token& end) {
        while (!end.stop_requested()) {
          if (i == 0) std::ofstream(file_) << std::string(1 << 20, 'x');
          for (const double until = monotonic_seconds() + 1e-3; monotonic_seconds() < until;) {
          }
        }
      });
  }

 private:
  fs::path file_;
  std::vector<std::jthread> all_;
};

struct a_soak : a_driver {
  words names;  // of the log's columns

  // The last whole line of the log.
  words last_row() {
    constexpr std::streamoff enough = 8192;  // [bytes]
    std::ifstream in(part_path());
    for (std::string line; names.empty() && std::getline(in, line);)
      if (!line.starts_with('#') && !in.eof()) names = log_file::split(line);
    in.seekg(0, std::ios::end);
    in.seekg(std::max<std::streamoff>(0, in.tellg() - enough));
    std::ostringstream all;
    all << in.rdbuf();
    const std::string text = all.str();
    const std::size_t end = text.rfind('\n');
    if (end == text.npos || end == 0) return {};
    const std::size_t begin = text.rfind('\n', end - 1) + 1;
    return log_file::split(text.substr(begin, end - begin));
  }
  std::size_t column(const std::string& name) const {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  std::string state() {
    const words row = last_row();
    return row.size() == names.size() && !row.empty() ? row[column("state")] : "";
  }
  bool becomes(const std::string& wanted) {
    return eventually([&] { return state() == wanted; });
  }

  // What a stopped process brings about, and how it is mended.
  void stop(pid_t process, double seconds) {
    send(SIGSTOP, process);
    rest(seconds);
    send(SIGCONT, process);
  }
  int releases = 0;    // that were caused
  double largest = 0;  // of all currents in the log [A]
  void stop_and_rearm(pid_t process) {
    stop(process, stopped);
    ASSERT_TRUE(becomes("released"));
    ++releases;
    rest(0.5);
    send(SIGUSR1);
    ASSERT_TRUE(becomes("active"));
  }

  // How many rows the log has, each as it must be.
  std::size_t check_log() {
    std::ifstream in(log_path());
    std::size_t rows = 0;
    int released = 0;
    bool was_released = false;
    double cycle = -1, time = -1;
    for (std::string line; std::getline(in, line) && !HasFailure();) {
      if (line.starts_with('#')) continue;
      const words row = log_file::split(line);
      if (row == names) continue;
      const auto number = [&](const char* name) { return std::stod(row[column(name)]); };
      ++rows;
      EXPECT_EQ(row.size(), names.size()) << line;
      EXPECT_GT(number("cycle"), cycle);
      EXPECT_GT(number("t"), time);
      cycle = number("cycle"), time = number("t");
      const bool is_released = row[column("state")] == "released";
      for (const char* brake : {"current1", "current2"}) {
        EXPECT_TRUE(number(brake) >= 0 && number(brake) <= limit) << line;
        largest = std::max(largest, number(brake));
        EXPECT_TRUE(!is_released || number(brake) == 0) << line;
      }
      const std::string reason = row[column("reason")];
      EXPECT_TRUE(is_released ? reason == lost_supervisor || reason == stopped_loop : reason.empty()) << line;
      EXPECT_EQ(row[column("held_over")], "") << line;
      released += is_released && !was_released;
      was_released = is_released;
    }
    EXPECT_EQ(released, releases) << "faults in the log, and those that were caused";
    return rows;
  }
};

TEST_F(a_soak, holds_nothing_more_at_its_end) {
  const char* const given = std::getenv("PASSIVE_HAPTICS_SOAK");
  const double seconds = given == nullptr ? 3600 : std::atof(given);
  std::printf("%g s, seed %llu\n", seconds, static_cast<unsigned long long>(seed));
  file("c.toml", settings{.supervisor_timeout = timeout, .hand_start = 1, .start_depth = 0.1}.text());
  start({"--config", "c.toml", "--quiet"});
  const double begin = monotonic_seconds();
  ASSERT_TRUE(becomes("active")) << ended();

  load others(directory);
  std::mt19937_64 random(seed);
  const std::array<std::pair<const char*, std::function<void()>>, 6> events{
      {{"the loop stopped, rearmed", [&] { stop_and_rearm(pid); }},
       {"the supervisor stopped, rearmed", [&] { stop_and_rearm(supervisor()); }},
       {"the loop stopped for a moment", [&] { stop(pid, unnoticed); }},
       {"the recorder stopped", [&] { stop(recorder(), 3); }},
       {"rearmed while active", [&] { send(SIGUSR1); }},
       {"a signal that nobody waits for", [&] {
          for (const pid_t one : {pid, recorder(), supervisor()}) send(SIGWINCH, one);
        }}}};
  const std::map<std::string, pid_t> processes{
      {"loop", pid}, {"recorder", recorder()}, {"supervisor", supervisor()}};
  std::map<std::string, holdings> first, most;
  std::map<std::string, int> happened;
  // Each of them twice to warm up, then in any order
  for (std::size_t k = 0; monotonic_seconds() - begin < seconds || k <= 2 * events.size(); ++k) {
    others.set(static_cast<int>(random() % 5));
    const auto& [what, event] = events[k < 2 * events.size() ? k % events.size() : random() % events.size()];
    event();
    ++happened[what];
    ASSERT_FALSE(HasFailure()) << what;
    rest(2 + static_cast<double>(random() % 8));
    ASSERT_EQ(state(), "active") << what << ": " << text_of(directory / "driver.err");
    if (k + 1 < 2 * events.size()) continue;
    for (const auto& [name, process] : processes) {
      const holdings now = held_by(process);
      first.emplace(name, now);
      holdings& worst = most[name];
      worst = {std::max(worst.memory, now.memory), std::max(worst.descriptors, now.descriptors),
               std::max(worst.threads, now.threads)};
      ASSERT_LE(now.memory, first[name].memory + slack) << name << " grows [KiB]";
      ASSERT_EQ(now.descriptors, first[name].descriptors) << name;
      ASSERT_EQ(now.threads, first[name].threads) << name;
    }
  }
  others.set(0);
  send(SIGINT);
  const outcome o = end();
  const double lasted = monotonic_seconds() - begin;
  EXPECT_TRUE(nothing_is_left());

  for (const auto& [what, times] : happened) std::printf("%5d times: %s\n", times, what.c_str());
  for (const auto& [name, now] : first)
    std::printf("%-10s  %ld KiB, at most %ld later; %zu descriptors, %ld threads\n", name.c_str(), now.memory,
                most[name].memory, now.descriptors, now.threads);
  EXPECT_GT(largest, 0) << "no brake held";
  ASSERT_TRUE(fs::exists(log_path())) << o.err;
  const std::size_t rows = check_log();
  const auto number_before = [&](const char* words) {
    const std::size_t at = o.out.rfind(words);
    return at == o.out.npos ? 0 : std::stoul(o.out.substr(o.out.find_last_of("\n ", at - 1) + 1));
  };
  const std::size_t cycles = number_before(" cycles, "), lost = number_before(" cycles lost");
  std::printf("%.0f s: %zu cycles, %zu rows, %zu lost; %d releases; currents up to %g A\n", lasted, cycles,
              rows, lost, releases, largest);
  EXPECT_EQ(rows + lost, cycles);
  EXPECT_EQ(o.status, (releases > 0 ? 3 : 0) + (lost > 0 ? 4 : 0)) << o.out << o.err;
}

}  // namespace
