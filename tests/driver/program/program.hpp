// The driver as its user meets it: a process in a directory of its own.
#pragma once

#include <gtest/gtest.h>
#include <passive_haptics/driver/clock.hpp>

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace program {

namespace fs = std::filesystem;
using words = std::vector<std::string>;

inline const std::string driver = PASSIVE_HAPTICS_BRAKE_DRIVER,
                         board_program = PASSIVE_HAPTICS_BRAKE_FIRMWARE,
                         shipped = PASSIVE_HAPTICS_BRAKE_DRIVER_DIR;

// Waits for what has to come; the time-out is for a test that has failed.
template <class F>
bool eventually(F&& f) {
  const double end = passive_haptics::monotonic_seconds() + 30;
  while (!f()) {
    if (passive_haptics::monotonic_seconds() > end) return false;
    usleep(20'000);
  }
  return true;
}

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream all;
  all << in.rdbuf();
  return all.str();
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// What a process forked, as long as it lives.
inline std::vector<pid_t> children_of(pid_t parent) {
  const std::string number = std::to_string(parent);
  std::ifstream in("/proc/" + number + "/task/" + number + "/children");
  std::vector<pid_t> all;
  for (pid_t one; in >> one;) all.push_back(one);
  return all;
}

inline bool has_open(pid_t process, const std::string& file_name) {
  std::error_code gone;
  for (const auto& one : fs::directory_iterator("/proc/" + std::to_string(process) + "/fd", gone)) {
    const fs::path file = fs::read_symlink(one.path(), gone);
    if (file.filename() == file_name) return true;
  }
  return false;
}

// Its exit status, or 128 + the signal that it died of.
inline int status_of(pid_t process) {
  int status = 0;
  if (waitpid(process, &status, 0) < 0) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// In the child of a fork.
[[noreturn]] inline void become(const words& command, const fs::path& directory) {
  std::vector<char*> arguments;
  for (const auto& one : command) arguments.push_back(const_cast<char*>(one.c_str()));
  arguments.push_back(nullptr);
  if (chdir(directory.c_str()) == 0) execv(arguments[0], arguments.data());
  _exit(127);
}

// A line of the log, by the names of its columns; below version and units.
class log_file {
 public:
  explicit log_file(const fs::path& file) : text_(text_of(file)) {
    std::istringstream lines(text_);
    std::string line;
    while (names_.empty() && std::getline(lines, line))
      if (!line.starts_with('#')) names_ = split(line);
    while (std::getline(lines, line)) rows_.push_back(line);
  }

  std::size_t size() const { return rows_.size(); }
  // Empty where the line is cut off.
  std::string text(std::size_t row, const std::string& name) const {
    const words cells = split(rows_[row]);
    for (std::size_t i = 0; i < names_.size() && i < cells.size(); ++i)
      if (names_[i] == name) return cells[i];
    return {};
  }
  double number(std::size_t row, const std::string& name) const {
    const std::string value = text(row, name);
    return value.empty() ? -1e300 : std::stod(value);
  }
  bool is_whole() const {
    for (const auto& row : rows_)
      if (split(row).size() != names_.size()) return false;
    return rows_.size() > 0 && text_.back() == '\n';
  }

  // The cells of a line.
  static words split(const std::string& line) {
    words all(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') quoted = !quoted;
      else if (c == ',' && !quoted) all.emplace_back();
      else all.back() += c;
    }
    return all;
  }

 private:
  std::string text_;
  words names_, rows_;  // rows are split when they are asked for: a test looks at a log often
};

// What of a configuration the tests change. As it stands, no load on the machine is a fault, and no hand
// touches the handle. A hand that presses before the brakes come on, or while they are released, needs a
// large start_depth.
struct settings {
  double hold_over = 5, supervisor_timeout = 5, max_sleep = 10, period = 1e-3, hand_start = 1000,
         watchdog = 30, homing = 0.1, start_depth = 0.005;
  // A law under which a pressing hand has a steady current
  std::string top = "law.type = \"direct_control\"";
  std::string sections{}, sensor{};

  std::string text() const {
    std::ostringstream all;
    all << top << "\n[homing]\npose = [1.8812, -1.3055]\nduration = " << homing
        << "\ntolerance = 1e6\nmax_gap = 5\nmax_start_depth = " << start_depth << "\n"
        << "[loop]\nmax_overruns = 1000000\nmax_sleep = " << max_sleep << "\nperiod = " << period
        << "\n[safety]\nhold_over = " << hold_over << "\nsupervisor_timeout = " << supervisor_timeout
        << "\n[simulation]\nhand_start = " << hand_start << "\nwatchdog = " << watchdog << "\n[sensor]\n"
        << sensor << "\n"
        << sections;
    return all.str();
  }
};

// A directory, and the driver in it.
struct a_driver : ::testing::Test {
  struct outcome {
    int status = 0;
    std::string out, err;
  };

  fs::path directory;
  pid_t pid = -1;

  a_driver() {
    std::string name = (fs::temp_directory_path() / "brake_driver_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no directory " + name);
    directory = name;
    // Its orphans become children of the test, which so sees them end
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
  }
  ~a_driver() override {
    for (auto all = children_of(getpid()); !all.empty(); all = children_of(getpid()))
      for (const pid_t one : all) kill(one, SIGKILL), waitpid(one, nullptr, 0);
    fs::remove_all(directory);
  }

  void file(const std::string& name, const std::string& text) const {
    std::ofstream(directory / name) << text;
  }

  pid_t spawn(const words& command, const std::string& output) const {
    const pid_t child = fork();
    if (child != 0) return child;
    for (const auto& [stream, name] : {std::pair{STDOUT_FILENO, ".out"}, std::pair{STDERR_FILENO, ".err"}}) {
      const int to = open((directory / (output + name)).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      dup2(to, stream);
      close(to);
    }
    become(command, directory);
  }
  void start(const words& arguments) {
    words command{driver};
    command.insert(command.end(), arguments.begin(), arguments.end());
    pid = spawn(command, "driver");
  }
  void start(const settings& s) {
    file("c.toml", s.text());
    start({"--config", "c.toml"});
  }
  void send(int signal, pid_t to) const {
    ASSERT_GT(to, 0) << "kill(2) would take it for all processes";
    kill(to, signal);
  }
  void send(int signal) const { send(signal, pid); }
  outcome end() {
    const int status = status_of(pid);
    pid = -1;
    return {status, text_of(directory / "driver.out"), text_of(directory / "driver.err")};
  }
  outcome run(const words& arguments) {
    start(arguments);
    return end();
  }
  outcome run(const std::string& configuration, words options) {
    file("c.toml", configuration);
    options.insert(options.begin(), {"--config", "c.toml"});
    return run(options);
  }
  outcome check(const std::string& configuration) { return run(configuration, {"--check"}); }
  // Ends it as its user does.
  outcome interrupt() {
    send(SIGINT);
    return end();
  }
  // It stands still for so long [s].
  void freeze(double seconds) const {
    send(SIGSTOP);
    usleep(static_cast<useconds_t>(1e6 * seconds));
    send(SIGCONT);
  }

  std::string log_name = "brake_driver.csv";
  fs::path log_path() const { return directory / log_name; }
  fs::path part_path() const { return directory / (log_name + ".part"); }
  log_file log() const { return log_file(fs::exists(log_path()) ? log_path() : part_path()); }

  // Whether there is a row of this state, from a row on, while it is being written; then that row.
  bool reaches(const std::string& state, std::size_t from = 0, std::size_t* found = nullptr) {
    return has_row([&](const log_file& all, std::size_t i) { return all.text(i, "state") == state; }, from,
                   found);
  }
  template <class Is>
  bool has_row(const Is& is, std::size_t from = 0, std::size_t* found = nullptr) {
    std::size_t i = from;  // each row once
    return eventually([&] {
      const log_file all = log();
      for (; i + 1 < all.size(); ++i)
        if (is(all, i)) {
          if (found != nullptr) *found = i;
          return true;
        }
      return false;
    });
  }
  // Of the last whole row of the log [s].
  double time_written() const {
    const log_file all = log();
    return all.size() < 2 ? 0 : all.number(all.size() - 2, "t");
  }
  // For the message of a test that fails.
  std::string ended() const {
    const log_file all = log();
    if (all.size() < 2) return "nothing logged; " + text_of(directory / "driver.err");
    const std::size_t i = all.size() - 2;
    return "at " + all.text(i, "t") + " s: " + all.text(i, "state") + ", " + all.text(i, "reason") +
           ", held_over " + all.text(i, "held_over") + "; ";
  }
  // Its two processes beside the loop.
  pid_t recorder() const { return child_that(true); }
  pid_t supervisor() const { return child_that(false); }
  // What survives the driver ends by itself, and soon.
  bool nothing_is_left() const {
    return eventually([] {
      while (waitpid(-1, nullptr, WNOHANG) > 0) {
      }
      return children_of(getpid()).empty();
    });
  }

  // Its log has all, in its file, and no process is left.
  void expect_whole_log() const {
    EXPECT_TRUE(nothing_is_left());
    EXPECT_FALSE(fs::exists(part_path()));
    EXPECT_TRUE(log().is_whole());
  }
  void expect_released_at_the_end(const std::string& reason) const {
    const log_file all = log();
    ASSERT_TRUE(all.is_whole());
    const std::size_t last = all.size() - 1;
    EXPECT_EQ(all.text(last, "state"), "released");
    EXPECT_EQ(all.text(last, "reason"), reason);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all.text(i, "state") != "released") continue;
      ASSERT_EQ(all.number(i, "current1"), 0);
      ASSERT_EQ(all.number(i, "current2"), 0);
    }
  }

 private:
  pid_t child_that(bool has_the_log) const {
    for (const pid_t one : children_of(pid))
      if (has_open(one, part_path().filename()) == has_the_log) return one;
    return -1;
  }
};

// Bare systems have no pseudo-terminals.
struct a_driver_at_a_terminal : a_driver {
  void SetUp() override {
    const int one = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (one < 0) GTEST_SKIP() << "no pseudo-terminal: is devpts mounted at /dev/pts?";
    close(one);
  }
};

}  // namespace program
