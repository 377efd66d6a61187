// together
#include <passive_haptics/driver/real_time.hpp>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <functional>

namespace ph = passive_haptics;

namespace real_time_tests {

constexpr ph::real_time_parameters everything{
    .priority = 10, .lock_memory = true, .cpu = 0, .dma_latency = 1e-4};

// In a process of its own, as most settings stay.
bool in_a_child(const std::function<bool()>& test) {
  const pid_t child = fork();
  if (child == 0) _exit(test() ? 0 : 1);
  int status = 1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(real_time, asks_for_nothing_by_default) { EXPECT_TRUE(ph::real_time().settings().empty()); }

TEST(real_time, goes_on_where_all_is_refused) {
  EXPECT_TRUE(in_a_child([] {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) return false;
    ph::real_time_parameters p = everything;
    p.lock_memory = false;  // a sanitizer grants it without asking
    p.cpu = CPU_SETSIZE - 1;
    const ph::real_time quick(p);
    int refused = 0;
    for (const auto& setting : quick.settings()) refused += !setting.refused.empty();
    return refused == 3;
  }));
}

TEST(real_time, keeps_to_the_processor_and_has_the_priority_that_it_may) {
  EXPECT_TRUE(in_a_child([] {
    const ph::real_time quick({.priority = 1, .cpu = 0});
    cpu_set_t set;
    sched_param is{}, wanted{};
    sched_getparam(0, &is);
    wanted.sched_priority = 1;
    const bool may = sched_setscheduler(0, SCHED_FIFO, &wanted) == 0;
    const auto granted = [&](const std::string& name) {
      for (const auto& setting : quick.settings())
        if (setting.what.starts_with(name)) return setting.refused.empty();
      return false;
    };
    return quick.settings().size() == 2 && granted("SCHED_FIFO") == may && is.sched_priority == may &&
           quick.settings()[0].refused.empty() + quick.settings()[1].refused.empty() == 1 + may &&
           sched_getcpu() == 0 && sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) == 1;
  }));
}

TEST(real_time, tells_why_the_kernel_refused) {
  EXPECT_TRUE(in_a_child([] {
    const int file = open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC);
    const std::string why = file < 0 ? std::string(std::strerror(errno)).append("; ") : "";
    close(file);
    errno = 0;
    const ph::real_time quick({.lock_memory = true, .dma_latency = 1e-4});
    const auto& memory = quick.settings()[0];
    const auto& latency = quick.settings()[1];
    return !memory.refused.starts_with(std::strerror(0)) && latency.what == "wakes from idle within 100 us" &&
           (file < 0 ? latency.refused.starts_with(why) : latency.refused.empty());
  }));
}

TEST(real_time, closes_what_it_opened_and_nothing_else) {
  EXPECT_TRUE(in_a_child([] {
    dup2(STDERR_FILENO, STDOUT_FILENO);  // which is open then
    const auto lowest_free = [] {
      const int file = dup(STDERR_FILENO);
      close(file);
      return file;
    };
    const int before = lowest_free();
    for (const double latency : {-1.0, 0.0}) ph::real_time({.dma_latency = latency});
    return lowest_free() == before;
  }));
}

TEST(real_time, takes_no_standard_descriptor_that_is_closed) {
  EXPECT_TRUE(in_a_child([] {
    for (const int number : {0, 1, 2}) close(number);
    const ph::real_time quick({.dma_latency = 1e-4});
    for (const int number : {0, 1, 2})
      if (fcntl(number, F_GETFD) >= 0) return false;
    return true;
  }));
}

TEST(real_time, checks_its_parameters) {
  EXPECT_EQ(validate(ph::real_time_parameters{}), "");
  EXPECT_EQ(validate(ph::real_time_parameters{.priority = 100}), "priority = 100: expected 0 (none) to 99");
  EXPECT_EQ(validate(ph::real_time_parameters{.cpu = -2}),
            "cpu = -2: expected -1 (any) or the number of a processor");
  EXPECT_EQ(validate(ph::real_time_parameters{.dma_latency = 2}),
            "dma_latency [s] = 2: expected < 0 (any) to 1");
  EXPECT_THROW(ph::real_time({.priority = -1}), std::invalid_argument);
}

}  // namespace real_time_tests
