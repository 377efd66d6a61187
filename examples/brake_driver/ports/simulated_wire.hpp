/// The wire to the brakes of a simulated device, at its amplifiers.
#pragma once

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace example {

namespace ph = passive_haptics;

/// Currents of N brakes behind a board that keeps them, even if a process dies, until its watchdog trips;
/// then it rejects currents until a release. Several processes may use it concurrently.
template <int N>
class simulated_wire {
 public:
  using currents = ph::brake_currents<N>;  ///< [A]

  /// Watchdog time [s].
  explicit simulated_wire(double watchdog) : watchdog_(watchdog) {}

  /// Returns false without effect if the watchdog has tripped.
  bool set(const currents& wanted) noexcept {
    const double now = ph::monotonic_seconds();
    if (let_go(now)) return false;
    for (std::size_t i = 0; i < wanted.size(); ++i) value_[i] = wanted[i];
    fed_ = now;
    return true;
  }
  /// Sets 0 A and accepts currents again.
  void release() noexcept {
    for (auto& one : value_) one = 0;
  }
  /// Trips the watchdog.
  void lose() noexcept { fed_ = -std::numeric_limits<double>::infinity(); }
  /// Currents at a time [s, CLOCK_MONOTONIC].
  currents flowing(double now) const noexcept { return let_go(now) ? currents{} : values(); }

 private:
  currents values() const noexcept {
    currents all;
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = value_[i];
    return all;
  }
  // Not fed while currents flowed
  bool let_go(double now) const noexcept { return now - fed_ > watchdog_ && values() != currents{}; }

  double watchdog_;
  std::atomic<double> fed_ = 0;  // [s]
  std::array<std::atomic<double>, static_cast<std::size_t>(N)> value_{};
};

/// A simulated_wire in memory shared with forked processes; with the name of a new file, others can map it,
/// too. The file is kept. Throws std::runtime_error on failure.
template <int N>
class shared_simulated_wire {
 public:
  shared_simulated_wire(double watchdog, const std::string& file) {
    using wire = simulated_wire<N>;
    const int to = file.empty() ? -1 : open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (!file.empty() && (to < 0 || ftruncate(to, sizeof(wire)) != 0))
      throw std::runtime_error("[simulation] wire = " + file + ": " + std::strerror(errno) +
                               ": expected the name of a new file");
    void* memory =
        mmap(nullptr, sizeof(wire), PROT_READ | PROT_WRITE, MAP_SHARED | (to < 0 ? MAP_ANONYMOUS : 0), to, 0);
    if (to >= 0) close(to);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    wire_ = new (memory) wire(watchdog);
  }
  shared_simulated_wire(const shared_simulated_wire&) = delete;
  shared_simulated_wire& operator=(const shared_simulated_wire&) = delete;
  ~shared_simulated_wire() { munmap(wire_, sizeof *wire_); }

  simulated_wire<N>* operator->() const noexcept { return wire_; }

 private:
  simulated_wire<N>* wire_;
};

}  // namespace example
