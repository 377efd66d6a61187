// Many runs on all cores, with their results in order and the remaining time.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace experiments {

// "name [#####     ] 50 %, all: about 2 min" on a terminal's last line; nothing if stderr is not a terminal.
class progress_bar {
 public:
  progress_bar(std::string name, std::size_t total) : name_(std::move(name)), total_(total) {}
  ~progress_bar() { erase(); }
  progress_bar(const progress_bar&) = delete;
  progress_bar& operator=(const progress_bar&) = delete;

  void advance() {
    ++done_;
    ++done_of_all_;
    draw();
  }
  // Makes room for a line of output.
  void erase() const {
    if (on_terminal_) std::fprintf(stderr, "\r%*s\r", width + 72, "");
  }
  void draw() const {
    if (!on_terminal_) return;
    const std::string bar(static_cast<std::size_t>(width) * done_ / total_, '#');
    std::fprintf(stderr, "\r%-32s [%-*s] %3zu %%%s ", name_.c_str(), width, bar.c_str(), 100 * done_ / total_,
                 rest_of_all().c_str());
  }

  // Number of runs of the whole program.
  static void plan(std::size_t runs) {
    all_ = runs;
    start_ = clock::now();
  }
  static std::size_t done_of_all() { return done_of_all_; }

 private:
  using clock = std::chrono::steady_clock;
  static constexpr int width = 30;

  static std::string rest_of_all() {
    if (done_of_all_ >= all_) return "";
    const double spent = std::chrono::duration<double>(clock::now() - start_).count();
    const double rest = spent * static_cast<double>(all_ - done_of_all_) / static_cast<double>(done_of_all_);
    const auto seconds = static_cast<long>(rest + 0.5);
    return ", all: about " +
           (seconds < 90 ? std::to_string(seconds) + " s" : std::to_string((seconds + 30) / 60) + " min");
  }

  inline static std::size_t all_ = 0, done_of_all_ = 0;
  inline static clock::time_point start_{};
  std::string name_;
  std::size_t total_, done_ = 0;
  bool on_terminal_ = isatty(STDERR_FILENO) != 0;
};

// Runs job(0), ..., job(count - 1) on all cores. Results are in that order; show(k, result) is called as soon
// as all earlier ones exist. Throws the first exception of a job.
template <class Job, class Show>
auto on_all_cores(const std::string& name, std::size_t count, Job&& job, Show&& show) {
  std::vector<decltype(job(std::size_t{0}))> results(count);
  std::vector<bool> there(count);
  std::size_t shown = 0;
  std::exception_ptr failure;
  std::mutex telling;
  progress_bar bar(name, count);
  std::atomic<std::size_t> next = 0;
  const auto tell = [&](std::size_t k) {
    there[k] = true;
    if (k == shown) bar.erase();
    for (; shown < count && there[shown]; ++shown) show(shown, results[shown]);
    bar.advance();
  };
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        auto result = job(k);
        const std::lock_guard lock(telling);
        results[k] = std::move(result);
        tell(k);
      } catch (...) {
        const std::lock_guard lock(telling);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
      workers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return results;
}

// Runs all jobs without output.
template <class Job>
auto on_all_cores(const std::string& name, std::size_t count, Job&& job) {
  return on_all_cores(name, count, job, [](std::size_t, const auto&) {});
}

// The upper median; 0 without values.
template <class T>
double median(std::vector<T> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

// A member of all figures.
template <class Figures, class T>
std::vector<T> values_of(const std::vector<Figures>& figures, T Figures::* member) {
  std::vector<T> values;
  for (const Figures& f : figures) values.push_back(f.*member);
  return values;
}

}  // namespace experiments
