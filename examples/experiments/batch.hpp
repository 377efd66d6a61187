// Many runs on all cores, with a progress bar.
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

// Draws "name [#####     ] 50 %" on a terminal's last line while it lives; nothing where stderr is no
// terminal.
class progress_bar {
 public:
  progress_bar(std::string name, std::size_t total)
      : name_(std::move(name)), total_(total), on_terminal_(isatty(STDERR_FILENO) != 0) {}
  ~progress_bar() {
    if (on_terminal_) std::fprintf(stderr, "\r%*s\r", width + 50, "");
  }
  progress_bar(const progress_bar&) = delete;
  progress_bar& operator=(const progress_bar&) = delete;

  void advance() {
    const std::lock_guard lock(drawing_);
    ++done_;
    if (!on_terminal_) return;
    const std::size_t filled = static_cast<std::size_t>(width) * done_ / total_;
    std::fprintf(stderr, "\r%-32s [%-*s] %3zu %%", name_.c_str(), width, std::string(filled, '#').c_str(),
                 100 * done_ / total_);
  }

 private:
  static constexpr int width = 30;
  std::string name_;
  std::size_t total_, done_ = 0;
  bool on_terminal_;
  std::mutex drawing_;
};

// job(0), ..., job(count - 1) on all cores; their results in that order. The first exception of a job is
// thrown here.
template <class Job>
auto on_all_cores(const std::string& name, std::size_t count, Job&& job) {
  std::vector<decltype(job(std::size_t{0}))> results(count);
  progress_bar bar(name, count);
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        results[k] = job(k);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        next = count;
      }
      bar.advance();
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

}  // namespace experiments
