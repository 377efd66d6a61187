// The table in a terminal, as it stands there after all that was written.
#include "program.hpp"

#include <pty.h>
#include <sys/ioctl.h>

namespace terminal_tests {

using namespace program;

// As much of a terminal as the table asks for.
class screen {
 public:
  screen(int rows, int columns) : columns_(columns), lines_(static_cast<std::size_t>(rows)) {}

  void write(const std::string& bytes) {
    for (const char c : bytes) put(c);
  }
  // Lines that begin with this.
  int count(const std::string& beginning) const {
    int n = 0;
    for (const auto& line : lines_) n += line.starts_with(beginning);
    return n;
  }
  std::string text() const {
    std::string all;
    for (const auto& line : lines_) all += line + "\n";
    return all;
  }
  // Of another size: what was there is broken into other lines.
  void resize(int rows, int columns) {
    columns_ = columns;
    lines_.assign(static_cast<std::size_t>(rows), "torn");
    row_ = lines_.size() / 2;
    column_ = 0;
  }
  bool broke_a_line = false;
  int redrawn = 0;

 private:
  void put(char c) {
    if (!escape_.empty()) {
      escape_ += c;
      if (std::isalpha(static_cast<unsigned char>(c)) != 0) obey();
      return;
    }
    if (c == '\033') escape_ = c;
    else if (c == '\r') column_ = 0;
    else if (c == '\n') feed();
    else show(c);
  }
  void show(char c) {
    if (column_ == columns_) {
      broke_a_line = true;
      column_ = 0;
      feed();
    }
    std::string& line = lines_[row_];
    line.resize(std::max(line.size(), static_cast<std::size_t>(column_) + 1), ' ');
    line[static_cast<std::size_t>(column_++)] = c;
  }
  void feed() {
    if (++row_ < lines_.size()) return;
    --row_;
    lines_.erase(lines_.begin());
    lines_.emplace_back();
  }
  void obey() {
    const char what = escape_.back();
    if (what == 'A') {
      const auto up = static_cast<std::size_t>(std::stoi(escape_.substr(2)));
      row_ -= std::min(row_, up);
      ++redrawn;
    } else if (what == 'H') {
      row_ = 0;
      column_ = 0;
    } else if (escape_ == "\033[2J") {
      for (auto& line : lines_) line.clear();
    } else if (what == 'K' || what == 'J') {
      lines_[row_].resize(std::min(lines_[row_].size(), static_cast<std::size_t>(column_)));
      for (std::size_t i = row_ + 1; what == 'J' && i < lines_.size(); ++i) lines_[i].clear();
    } else {
      ADD_FAILURE() << "an escape sequence that no test knows";
    }
    escape_.clear();
  }

  int columns_, column_ = 0;
  std::size_t row_ = 0;
  std::vector<std::string> lines_;
  std::string escape_;
};

struct a_terminal : a_driver_at_a_terminal {
  int terminal = -1;
  screen shown{1, 1};

  ~a_terminal() override {
    if (terminal >= 0) close(terminal);
  }
  static winsize size_of(int rows, int columns) {
    return {static_cast<unsigned short>(rows), static_cast<unsigned short>(columns), 0, 0};
  }
  void start_in(int rows, int columns, const settings& s = {}) {
    file("c.toml", s.text());
    const winsize size = size_of(rows, columns);
    shown = screen(rows, columns);
    pid = forkpty(&terminal, nullptr, nullptr, &size);
    ASSERT_GE(pid, 0);
    if (pid == 0) become({driver, "--config", "c.toml"}, directory);
    ASSERT_EQ(fcntl(terminal, F_SETFL, O_NONBLOCK), 0);
  }
  void look() {
    std::array<char, 4096> bytes;
    for (ssize_t n; (n = read(terminal, bytes.data(), bytes.size())) > 0;)
      shown.write(std::string(bytes.data(), static_cast<std::size_t>(n)));
  }
  template <class Condition>
  bool shows(const Condition& condition) {
    return eventually([&] {
      look();
      return condition();
    });
  }
  bool redraws(int times) {
    return shows([&] { return shown.redrawn >= times; });
  }
  void quit() {
    send(SIGINT);
    shows([this] { return waitpid(pid, nullptr, WNOHANG) != 0; });
  }
  bool shows_the_release() {
    return shows([this] { return has(shown.text(), "brakes released: as requested"); });
  }
};

TEST_F(a_terminal, shows_one_table_that_is_redrawn_in_its_place) {
  start_in(50, 100);
  ASSERT_TRUE(reaches("active")) << ended();
  look();
  ASSERT_TRUE(redraws(shown.redrawn + 5));
  EXPECT_FALSE(shown.broke_a_line) << shown.text();
  for (const char* line :
       {"tendon_two_link, simulated device", "state    active", "handle   x ", "hand     x ", "wall     x ",
        "brake 1 ", "brake 2 ", "late     p50", "compute  p50", "late, of "})
    EXPECT_EQ(shown.count(line), 1) << line << "\n" << shown.text();
  EXPECT_EQ(shown.count("  up to"), 1) << shown.text();
  send(SIGINT);
  EXPECT_TRUE(shows_the_release()) << shown.text();
  EXPECT_EQ(end().status, 0);
}

TEST_F(a_terminal, shows_no_force_of_a_wall_that_is_not_displayed_and_how_to_rearm) {
  start_in(50, 100, {.max_sleep = 0.3, .hand_start = 0.2, .start_depth = 0.1});
  ASSERT_TRUE(reaches("active")) << ended();
  freeze(1);
  ASSERT_TRUE(shows([this] { return shown.count("state    released: a cycle began too late") == 1; }))
      << shown.text();
  ASSERT_TRUE(redraws(shown.redrawn + 2));
  EXPECT_EQ(shown.count("wall     not displayed"), 1) << shown.text();
  EXPECT_EQ(shown.count("wall     x"), 0) << shown.text();
  EXPECT_EQ(shown.count("rearm    when that is over: kill -USR1 " + std::to_string(pid)), 1) << shown.text();
  send(SIGUSR1);
  EXPECT_TRUE(shows([this] {
    return shown.count("state    active") == 1 && shown.count("wall     x") == 1 && shown.count("rearm") == 0;
  })) << shown.text();
  send(SIGINT);
  EXPECT_TRUE(shows_the_release()) << shown.text();
  EXPECT_EQ(end().status, 3) << "it had a fault, though it was rearmed";
  look();
  EXPECT_EQ(shown.count("releases by a fault before: 1, first: a cycle began too late"), 1) << shown.text();
}

TEST_F(a_terminal, of_another_size_keeps_nothing_of_the_table_before) {
  start_in(50, 100);
  ASSERT_TRUE(reaches("active")) << ended();
  ASSERT_TRUE(redraws(2));
  for (const auto& [rows, columns] : {std::pair{10, 40}, {40, 120}}) {
    const winsize size = size_of(rows, columns);
    look();
    ASSERT_EQ(ioctl(terminal, TIOCSWINSZ, &size), 0);
    shown.resize(rows, columns);
    EXPECT_TRUE(shows([this] { return shown.count("torn") == 0; })) << shown.text();
    shown.broke_a_line = false;  // by a table on its way
    ASSERT_TRUE(redraws(shown.redrawn + 3));
    EXPECT_FALSE(shown.broke_a_line) << shown.text();
    EXPECT_EQ(shown.count("state    active"), 1) << shown.text();
    EXPECT_EQ(shown.count("tendon_two_link"), 1) << shown.text();
  }
  quit();
}

TEST_F(a_terminal, that_nobody_reads_costs_the_log_no_cycle) {
  start_in(50, 100, {.period = 2e-4});
  // Its buffer is full after some tables, the queue of the log some seconds later
  ASSERT_TRUE(eventually([&] { return time_written() > 4; })) << time_written();
  quit();
  EXPECT_TRUE(has(shown.text(), ", 0 cycles lost")) << shown.text();
}

TEST_F(a_terminal, gets_its_Ctrl_C_through) {
  start_in(50, 100);
  ASSERT_TRUE(reaches("active")) << ended();
  ASSERT_EQ(write(terminal, "\003", 1), 1);
  shows_the_release();
  EXPECT_EQ(end().status, 0);
  EXPECT_TRUE(log().is_whole()) << "no process but the loop's heard it";
}

TEST_F(a_terminal, that_is_closed_ends_the_run) {
  start_in(50, 100);
  ASSERT_TRUE(reaches("active")) << ended();
  close(std::exchange(terminal, -1));
  status_of(pid);
  expect_whole_log();
}

}  // namespace terminal_tests
