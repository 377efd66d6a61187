/// Real-time settings of Linux.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace passive_haptics {

/// Requested settings; by default none.
struct real_time_parameters {
  int priority = 0;          ///< SCHED_FIFO priority, 1 to 99; 0 for none.
  bool lock_memory = false;  ///< mlockall, which avoids page faults.
  int cpu = -1;              ///< Processor, from 0; -1 for any.
  double dma_latency = -1;  ///< Maximum wake-up time from idle states, /dev/cpu_dma_latency [s]; < 0 for any.

  static constexpr auto members() {
    using p = real_time_parameters;
    return member_table(
        member("priority", &p::priority, "", range::between(0, 99).as("0 (none) to 99")),
        member("lock_memory", &p::lock_memory),
        member("cpu", &p::cpu, "",
               range::between(-1, CPU_SETSIZE - 1).as("-1 (any) or the number of a processor")),
        member("dma_latency", &p::dma_latency, "s",
               range{.upper = 1, .open_above = false, .words = "< 0 (any) to 1"}));
  }
};

/// Result of a request.
struct real_time_setting {
  std::string what;     ///< Description.
  std::string refused;  ///< Reason and remedy; empty if granted.
};

/// Requests the settings on construction: create it in the loop's thread, after forking, and before a
/// threaded_port is opened, which inherits them. Failures are reported. The latency request ends with it.
class real_time {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit real_time(const real_time_parameters& p = {}) {
    require_valid(p);
    if (p.lock_memory) lock_memory();
    if (p.cpu >= 0) pin(p.cpu);
    if (p.dma_latency >= 0) ask_for_latency(p.dma_latency);
    if (p.priority > 0) prioritise(p.priority);
  }
  real_time(const real_time&) = delete;
  real_time& operator=(const real_time&) = delete;
  ~real_time() {
    if (latency_file_ >= 0) close(latency_file_);
  }

  const std::vector<real_time_setting>& settings() const { return settings_; }  ///< All requests in order.

 private:
  void note(std::string what, bool granted, const char* help) {
    const std::string refused = granted ? "" : std::string(std::strerror(errno)).append("; ").append(help);
    settings_.push_back({std::move(what), refused});
  }

  void lock_memory() {
    note("memory locked", mlockall(MCL_CURRENT | MCL_FUTURE) == 0, "run as root, or raise `ulimit -l`");
  }

  void pin(int cpu) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<std::size_t>(cpu), &set);
    note(detail::indexed("stays on processor ", cpu, ""), sched_setaffinity(0, sizeof set, &set) == 0,
         "`nproc` prints how many there are, from 0");
  }

  void ask_for_latency(double seconds) {
    // Standard numbers would receive the program's output
    latency_file_ = detail::above_standard_descriptors(open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC));
    const auto microseconds = static_cast<std::int32_t>(std::lround(1e6 * seconds));
    const bool granted =
        latency_file_ >= 0 && write(latency_file_, &microseconds, sizeof microseconds) == sizeof microseconds;
    note(detail::indexed("wakes from idle within ", microseconds, " us"), granted,
         "run as root, or give write access to /dev/cpu_dma_latency");
  }

  void prioritise(int priority) {
    sched_param wanted{};
    wanted.sched_priority = priority;
    note(detail::indexed("SCHED_FIFO priority ", priority, ""),
         sched_setscheduler(0, SCHED_FIFO, &wanted) == 0, "run as root, or raise `ulimit -r`");
  }

  std::vector<real_time_setting> settings_;
  int latency_file_ = -1;
};

}  // namespace passive_haptics
