/// @file
/// How far a long call is, on a terminal.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

namespace passive_haptics_python {

namespace py = pybind11;

/// The line of progress.py of the package. Python is called a few times a second at most.
class progress {
 public:
  /// total: of what is counted; of: what it is, "places".
  progress(long total, const char* of) : total_(total), of_(of) {}
  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;
  ~progress() {
    try {
      if (!line_.is_none()) line_.attr("close")();
    } catch (...) {  // as where stderr is closed
    }
  }

  /// So many are completed by now.
  void show(long done) {
    constexpr std::chrono::milliseconds between(200);
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < between) return;
    last_ = now;
    if (line_.is_none()) return begin(done);
    line_.attr("add")(done - shown_);
    shown_ = done;
  }

 private:
  void begin(long done) {
    line_ = py::module_::import("passive_haptics.progress").attr("progress_line")(total_, of_);
    line_.attr("add")(done);
    shown_ = done;
  }

  long total_, shown_ = 0;
  const char* of_;
  py::object line_ = py::none();
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace passive_haptics_python
