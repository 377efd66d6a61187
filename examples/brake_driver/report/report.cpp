#include <report/report.hpp>

#include <log/device_name.hpp>
#include <passive_haptics/runtime/device_file/device_text.hpp>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace example {
namespace {

constexpr double terminal_interval = 0.2, line_interval = 1;  // [s]

const char* words(phase p) {
  switch (p) {
    case phase::homing: return "homing: hold the handle still at the home pose";
    case phase::taring: return "taring: let go of the handle";
    case phase::running: break;
  }
  return "";
}

// printf to a string.
template <class... Arguments>
std::string text(const char* format, Arguments... arguments) {
  std::array<char, 1000> line{};
  std::snprintf(line.data(), line.size(), format, arguments...);
  return line.data();
}

// Remedy for released brakes; the recorder's parent is the loop.
std::string way_back(const record& r) {
  if (r.state != ph::port_state::released || r.reason.what == ph::fault::user) return "";
  return r.needs_homing ? "start again in the home pose"
                        : "when that is over: kill -USR1 " + std::to_string(getppid());
}

// Walls are only felt while the brakes are driven.
bool displays(const record& r) {
  return r.state == ph::port_state::active || r.state == ph::port_state::degraded;
}

// Empty for an unknown share.
std::string bar(double share, std::size_t width) {
  const double length = share > 0 ? std::min(share, 1.0) * static_cast<double>(width) : 0;
  const auto full = static_cast<std::size_t>(std::lround(length));
  return std::string(full, '#') + std::string(width - full, '.');
}

std::string words(const ph::fault_record& i) { return i.what == ph::fault::none ? "" : to_string(i); }

// Reason why the brakes are released or not activated.
std::string reason(const record& r) {
  return r.too_deep.number > 0 ? not_activated_in_words(r.too_deep) : words(r.reason);
}

// A line of the log: columns of all logs, then those of devices.
void put(log_row& row, const joint_kinds& joints, const record& r) {
  row.start();
  put_motion(row, joints, r);
  put_decision(row, joints, r.decision, r.was_asked);
  row.put("cycle", "1", r.number);
  row.put("state", to_string(r.state));
  row.put("reason", reason(r));
  row.put("held_over", words(r.held_over));
  constexpr std::array names{"x", "y", "z"};
  for (std::size_t i = 0; i < r.x.size(); ++i) row.put(names[i], "m", r.x[i]);
  row.put("current", "A", r.current);
  row.put("late", "s", r.late);
  row.put("compute", "s", r.compute);
}

// "-" for unknown values.
std::string number(const char* format, double value) { return std::isnan(value) ? "-" : text(format, value); }

// "0.08, 0.22"
template <class Numbers>
std::string list(const char* format, const Numbers& values) {
  std::string all;
  for (std::size_t i = 0; i < values.size(); ++i)
    all.append(i == 0 ? "" : ", ").append(number(format, values[i]));
  return all;
}

// Limits the table to the terminal: broken or scrolled lines could not be overwritten.
std::string fitting(const std::string& table, const winsize& terminal) {
  if (terminal.ws_row < 2 || terminal.ws_col < 2) return table;
  std::istringstream lines(table);
  std::string all, line;
  for (int rows = 1; rows < terminal.ws_row && std::getline(lines, line); ++rows)
    all += line.substr(0, terminal.ws_col - 1u) + "\n";
  return all;
}

}  // namespace

std::string duration(double nanoseconds) {
  if (nanoseconds < 1e3) return text("%.0f ns", nanoseconds);
  if (nanoseconds < 1e5) return text("%.1f us", 1e-3 * nanoseconds);
  if (nanoseconds < 1e6) return text("%.0f us", 1e-3 * nanoseconds);
  return text("%.2f ms", 1e-6 * nanoseconds);
}

std::string bars(const ph::duration_histogram& h) {
  std::string all;
  for (std::uint64_t to = 1024; to / 2 <= static_cast<std::uint64_t>(h.maximum()); to *= 2) {
    const std::uint64_t count = h.between(all.empty() ? 0 : to / 2, to);
    if (all.empty() && count == 0) continue;
    const double share = static_cast<double>(count) / static_cast<double>(h.count());
    all += text("  %s %8s %10llu  ", all.empty() ? "up to" : "     ",
                duration(static_cast<double>(to)).c_str(), static_cast<unsigned long long>(count)) +
           bar(share, 50) + "\n";
  }
  return all;
}

report_sink::report_sink(const session_options& options, const configuration& c)
    : name_(c.log),
      title_(summary(c)),
      live_(options.live),
      live_port_(options.live_port),
      curves_(c.curves),
      device_text_(ph::runtime::device_text(c.device)),
      blank_(c.mechanism.sizes()) {
  const joint_motion motion(c.mechanism);
  joints_ = {std::vector<bool>(motion.slides.begin(), motion.slides.end())};
}

std::string report_sink::open() {
  terminal_ = isatty(STDOUT_FILENO) != 0;
  struct stat kind{};
  // Reopened, because stdout is shared: only this descriptor must not block. Not for a file, which has a
  // position
  if (terminal_ || (fstat(STDOUT_FILENO, &kind) == 0 && S_ISFIFO(kind.st_mode)))
    output_ = ::open("/proc/self/fd/1", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (output_ < 0) output_ = STDOUT_FILENO;
  if (const std::string error = stream_.open(live_port_); !error.empty())
    return "UDP port " + std::to_string(live_port_) + ": " + error;
  put(row_, joints_, blank_);  // sets the column names
  if (name_.empty()) return {};
  auto file = std::make_unique<output_file>(name_);  // not created without the other
  device_file_ = std::make_unique<output_file>(device_name(name_), leftover::replace);
  file_ = std::move(file);
  file_->stream() << row_.header();
  device_file_->stream() << device_text_ << std::flush;  // for the log of a killed run
  return {};
}

void report_sink::take(const record& r) {
  last_ = r;
  ++count_;
  late_.add(std::llround(1e9 * r.late));
  compute_.add(std::llround(1e9 * r.compute));
  put(row_, joints_, r);
  if (live_port_ != 0) stream_.send(row_);
  if (!file_) return;
  file_->keep();
  device_file_->keep();
  file_->stream() << row_.csv();
}

void report_sink::rest(std::uint64_t missing) {
  const bool was_lost = !loss().empty();
  missing_ = missing;
  if (file_) {
    file_->stream().flush();
    if (file_->is_removed()) kept_ = 0;
    else if (file_->error().empty()) kept_ = count_;
    lost_ = count_ - kept_;
  }
  if (!was_lost && !loss().empty()) std::fprintf(stderr, "warning: %s\n", loss().c_str());
  const double interval = terminal_ ? terminal_interval : line_interval;
  write_shown();
  if (!live_ || count_ == 0 || last_.time < shown_ + interval || !pending_.empty()) return;
  shown_ = last_.time;
  show();
}

// Empty if there is none
std::string report_sink::loss() const {
  const std::uint64_t all = lost_ + missing_;
  if (!file_ || all == 0) return {};
  return "log " + name_ + ": " + std::to_string(all) + " cycles lost: " +
         (lost_ == 0            ? "the recorder could not write them in time"
          : file_->is_removed() ? "its .part was removed"
                                : file_->error());
}

void report_sink::show() {
  const record& r = last_;
  const double degrees = ph::degrees(r.decision.approximation_angle());
  const char* const ampere = r.current_is_known ? "A" : "A?";
  std::string state(to_string(r.state));
  if (r.too_deep.number > 0) state += ", " + not_activated_in_words(r.too_deep);
  else if (r.state == ph::port_state::ready) state += std::string(", ") + words(r.doing);
  if (r.reason.what != ph::fault::none) state += ": " + to_string(r.reason);
  else if (r.held_over.what != ph::fault::none) state += ", holding over " + to_string(r.held_over);

  const std::string rearm = way_back(r);
  if (!terminal_) {
    if (!rearm.empty()) state += " (" + rearm + ")";
    pending_ =
        text("%7.1f s  %-10s handle (%s) m  hand (%s) N  %-17s brakes %s %s  late %s at most%s\n", r.time,
             state.c_str(), list("%.4f", r.x).c_str(), list("%5.2f", r.hand_force).c_str(),
             displays(r) ? ph::display_text(r.decision).data() : "no display",
             list("%.3f", r.current).c_str(), ampere, duration(static_cast<double>(late_.maximum())).c_str(),
             loss().empty() ? "" : ("  " + loss()).c_str());
    write_shown();
    return;
  }
  std::string table;
  table += text("%s %*s\n", title_.c_str(), std::max(1, 90 - static_cast<int>(title_.size())),
                text("%.1f s", r.time).c_str());
  table += "state    " + state + "\n";
  if (!rearm.empty()) table += "rearm    " + rearm + "\n";
  const auto components = [&](const char* name, const char* format, const ph::runtime::task_numbers& v,
                              const char* unit) {
    std::string line = text("%-8s", name);
    for (std::size_t i = 0; i < v.size(); ++i)
      line += text("%s %c %8s %s", i == 0 ? "" : "   ", "xyz"[i], number(format, v[i]).c_str(), unit);
    return line;
  };
  table += components("handle", "%.4f", r.x, "m") + "\n";
  table += components("hand", "%.3f", r.hand_force, "N") + "\n";
  table += displays(r)
               ? components("wall", "%.1f", r.decision.desired_force, "N") +
                     text("    %s, %s, gamma %.0f deg, alpha %.2f\n", to_string(r.decision.power).data(),
                          ph::display_text(r.decision).data(), degrees, r.decision.alpha)
               : "wall     not displayed\n";
  for (std::size_t i = 0; i < r.current.size(); ++i)
    table += text("brake %zu  %9s /s  may hold %6.3f %s  %6s %s  ", i + 1,
                  number("%.4f", i < r.qd.size() ? r.qd[i] : std::nan("")).c_str(), r.decision.capacity[i],
                  joints_.torque()(i), number("%.3f", r.current[i]).c_str(), ampere) +
             bar(r.current[i] / curves_[i].current_limit, 20) + "\n";
  for (const auto& [name, h] : {std::pair{"late", &late_}, std::pair{"compute", &compute_}})
    table += text("%-8s p50 %8s   p99 %8s   p99.9 %8s   max %8s\n", name,
                  duration(static_cast<double>(h->percentile(0.5))).c_str(),
                  duration(static_cast<double>(h->percentile(0.99))).c_str(),
                  duration(static_cast<double>(h->percentile(0.999))).c_str(),
                  duration(static_cast<double>(h->maximum())).c_str());
  if (!loss().empty()) table += loss() + "\n";
  table += "late, of " + text("%llu cycles\n", static_cast<unsigned long long>(count_)) + bars(late_);

  // Overwrites the previous table; a resized terminal may have broken its lines
  winsize size{};
  ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
  const bool resized = size.ws_row != size_.ws_row || size.ws_col != size_.ws_col;
  table = fitting(table, size_ = size);
  if (lines_ == 0) pending_.clear();
  else pending_ = resized ? "\033[H\033[2J" : text("\033[%dA", lines_);
  lines_ = static_cast<int>(std::count(table.begin(), table.end(), '\n'));
  for (const char c : table) pending_ += c == '\n' ? std::string("\033[K\n") : std::string(1, c);
  pending_ += "\033[J";
  write_shown();
}

void report_sink::write_shown() {
  if (pending_.empty()) return;
  const ssize_t size = write(output_, pending_.data(), pending_.size());
  if (size > 0) pending_.erase(0, static_cast<std::size_t>(size));
  else if (errno != EAGAIN) pending_.clear();  // no reader is left
}

void report_sink::close() {
  write_shown();
  if (live_ && count_ > 0 && pending_.empty()) show();
  if (!file_) return;
  // Without cycles, the log of a previous run is kept
  if (count_ > 0) try {
      device_file_->commit();  // first, so that a complete log has its device
      file_->commit();
    } catch (const std::runtime_error& failed) {
      throw std::runtime_error(std::string("error: ").append(failed.what()));
    }
  file_.reset();
  device_file_.reset();
}

}  // namespace example
