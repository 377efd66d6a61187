// together
#include <gtest/gtest.h>
#include <passive_haptics/driver/control_loop.hpp>

#include <algorithm>
#include <functional>
#include <random>
#include <stdexcept>
#include <vector>

namespace ph = passive_haptics;

namespace control_loop_tests {

constexpr std::int64_t ms = 1'000'000;

// A clock that stands still unless the test moves it.
struct test_clock {
  struct state {
    std::int64_t now = 5'000 * ms;
    std::vector<std::int64_t> woken;                                // at which deadlines
    std::function<std::int64_t(int)> late = [](int) { return 0; };  // of the k-th sleep
  };
  state* of;

  std::int64_t now() const noexcept { return of->now; }
  void sleep_until(std::int64_t deadline) const noexcept {
    of->woken.push_back(deadline);
    of->now = std::max(of->now, deadline) + of->late(static_cast<int>(of->woken.size()));
  }
};
static_assert(ph::LoopClock<test_clock>);

// Time that is suspended passes on this one alone.
struct suspended_clock : test_clock {
  const std::int64_t* suspended;
  std::int64_t boot_time() const noexcept { return now() + *suspended; }
};

struct a_control_loop : ::testing::Test {
  test_clock::state clock;
  ph::control_loop_parameters parameters;
  std::vector<ph::fault> released;
  std::vector<std::size_t> released_before;  // each cycle
  int wanted = 10;
  bool stopped = false;

  // cycle(k) takes the time that it returns.
  ph::loop_report run(const std::function<std::int64_t(const ph::loop_cycle&)>& cycle) {
    ph::control_loop loop(parameters, test_clock{&clock});
    int k = 0;
    return loop.run(
        [&](const ph::loop_cycle& now) {
          released_before.push_back(released.size());
          clock.now += cycle(now);
          return ++k < wanted;
        },
        [&] { return stopped; }, [&](ph::fault why) { released.push_back(why); });
  }
};

TEST_F(a_control_loop, wakes_at_absolute_times_however_late_each_cycle_is) {
  clock.late = [](int k) { return 10'000 * k; };
  std::vector<double> late;
  const auto report = run([&](const ph::loop_cycle& now) {
    late.push_back(now.late);
    return 300'000;
  });
  ASSERT_EQ(clock.woken.size(), 10u);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(clock.woken[k], (5'001 + static_cast<std::int64_t>(k)) * ms);
    EXPECT_NEAR(late[k], 1e-5 * static_cast<double>(k + 1), 1e-12);
  }
  EXPECT_EQ(report.cycles, 10u);
  EXPECT_EQ(report.overruns + report.missed, 0u);
  EXPECT_EQ(report.compute.maximum(), 300'000);
  EXPECT_EQ(report.late.maximum(), 100'000);
  EXPECT_EQ(released, std::vector{ph::fault::user}) << "released at the end in any case";
  EXPECT_EQ(report.ended_by, ph::fault::none);
}

TEST_F(a_control_loop, skips_what_a_long_cycle_missed_and_keeps_the_phase) {
  std::vector<std::int64_t> numbers;
  const auto report = run([&](const ph::loop_cycle& now) {
    numbers.push_back(now.number);
    return now.number == 3 ? 4'500'000 : 100'000;
  });
  EXPECT_EQ(numbers, (std::vector<std::int64_t>{1, 2, 3, 8, 9, 10, 11, 12, 13, 14}));
  EXPECT_EQ(clock.woken[3], 5'008 * ms);
  EXPECT_EQ(report.overruns, 1u);
  EXPECT_EQ(report.missed, 4u);
  EXPECT_EQ(released, std::vector{ph::fault::user}) << "one overrun is no reason";
  clock.late = [woken = int(clock.woken.size())](int k) { return k == woken + 2 ? 2'700'000 : 0; };
  numbers.clear();
  EXPECT_EQ(run([&](const ph::loop_cycle& now) {
              numbers.push_back(now.number);
              return 100'000;
            }).missed,
            2u);
  EXPECT_EQ(numbers, (std::vector<std::int64_t>{1, 2, 5, 6, 7, 8, 9, 10, 11, 12})) << "woken late, too";
}

TEST_F(a_control_loop, that_a_throwing_law_ends_releases_first_and_tells_what_was_thrown) {
  const auto report = run([](const ph::loop_cycle& now) -> std::int64_t {
    if (now.number == 4) throw std::runtime_error("no such wall");
    return 0;
  });
  EXPECT_EQ(report.cycles, 4u);
  EXPECT_EQ(report.ended_by, ph::fault::law_failed);
  EXPECT_EQ(report.exception, "no such wall");
  EXPECT_EQ(released, (std::vector{ph::fault::law_failed, ph::fault::law_failed}));
  const auto by_number = run([](const ph::loop_cycle&) -> std::int64_t { throw 3; });
  EXPECT_EQ(by_number.ended_by, ph::fault::law_failed);
  EXPECT_EQ(by_number.exception, "an exception that is not a std::exception");
}

TEST_F(a_control_loop, ends_before_the_next_cycle_when_it_is_told_to_stop) {
  wanted = 1000;
  const auto report = run([&](const ph::loop_cycle& now) {
    stopped = now.number == 7;
    return 0;
  });
  EXPECT_EQ(report.cycles, 7u);
  EXPECT_EQ(released, std::vector{ph::fault::user});
}

TEST_F(a_control_loop, may_sleep_just_so_long) {
  parameters.max_sleep = 0.25;
  clock.late = [](int k) { return k == 3 ? 250 * ms : k == 6 ? 250 * ms + 1000 : 0; };
  run([&](const ph::loop_cycle& now) {
    EXPECT_NEAR(now.time, 1e-9 * static_cast<double>(clock.now), 1e-9);
    return 0;
  });
  EXPECT_EQ(released_before, (std::vector<std::size_t>{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}));
  EXPECT_EQ(released.front(), ph::fault::cycle_late);
}

TEST_F(a_control_loop, whose_clock_goes_back_within_a_period_releases) {
  run([&](const ph::loop_cycle& now) {
    if (now.number == 3) clock.late = [](int) { return -ms / 2; };
    if (now.number == 4) clock.late = [](int) { return 0; };
    return 100'000;
  });
  EXPECT_EQ(released_before, (std::vector<std::size_t>{0, 0, 0, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(released.front(), ph::fault::clock_jump);
}

TEST_F(a_control_loop, may_overrun_so_often_from_its_first_cycle_on) {
  parameters.max_overruns = 3;
  const auto report = run([](const ph::loop_cycle&) { return ms + 1; });
  EXPECT_EQ(released_before, (std::vector<std::size_t>{0, 0, 0, 0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(report.overruns, 9u) << "the last cycle is told to be the last";
  EXPECT_EQ(report.missed, 9u);
}

TEST_F(a_control_loop, may_take_the_whole_period) {
  parameters.max_overruns = 0;
  const auto report = run([](const ph::loop_cycle&) { return ms; });
  EXPECT_EQ(report.overruns + report.missed, 0u);
  EXPECT_EQ(released, std::vector{ph::fault::user});
  parameters.max_overruns = 1;
  run([odd = false](const ph::loop_cycle&) mutable { return ms + (odd = !odd); });
  EXPECT_EQ(std::count(released.begin(), released.end(), ph::fault::overruns), 0) << "never two in a row";
}

TEST_F(a_control_loop, of_a_machine_that_was_suspended_releases_before_the_next_cycle) {
  std::int64_t suspended = 7'000 * ms;  // before the loop began
  ph::control_loop loop(parameters, suspended_clock{{&clock}, &suspended});
  loop.run(
      [&](const ph::loop_cycle& now) {
        released_before.push_back(released.size());
        if (now.number == 3) suspended += ms;  // no more than a period
        if (now.number == 5) suspended += 1;
        if (now.number == 7) suspended += 3'600'000 * ms;
        return now.number < 10;
      },
      [] { return false; }, [&](ph::fault why) { released.push_back(why); });
  EXPECT_EQ(released_before, (std::vector<std::size_t>{0, 0, 0, 0, 0, 1, 1, 2, 2, 2}));
  EXPECT_EQ(released, (std::vector{ph::fault::suspended, ph::fault::suspended, ph::fault::user}));
}

// The two clocks are read one after the other, and anything may take the processor in between.
TEST_F(a_control_loop, takes_no_pause_between_its_two_clocks_for_a_suspend) {
  struct interrupted_clock : test_clock {
    int reads;
    std::int64_t boot_time() noexcept {
      const std::int64_t booted = now();
      if (++reads % 3 == 0) of->now += 50 * ms;
      return booted;
    }
  };
  for (const int before : {0, 1, 2}) {
    ph::control_loop loop(parameters, interrupted_clock{{&clock}, before});
    loop.run([&](const ph::loop_cycle& now) { return now.number < 1000; }, [] { return false; },
             [&](ph::fault why) { released.push_back(why); });
  }
  EXPECT_EQ(std::count(released.begin(), released.end(), ph::fault::suspended), 0);
}

TEST(a_loop_cycle, is_none_by_default) {
  const ph::loop_cycle none;
  EXPECT_EQ(none.number, 0);
  EXPECT_EQ(none.time, 0);
  EXPECT_EQ(none.late, 0);
}

TEST(control_loop_parameters, are_checked_by_name) {
  EXPECT_EQ(validate(ph::control_loop_parameters{}), "");
  EXPECT_EQ(validate(ph::control_loop_parameters{.period = 0}), "period [s] = 0: expected 1e-6 to 1");
  EXPECT_EQ(validate(ph::control_loop_parameters{.max_overruns = -1}),
            "max_overruns = -1: expected a whole number >= 0");
  EXPECT_EQ(validate(ph::control_loop_parameters{.max_sleep = 0}),
            "max_sleep [s] = 0: expected a finite number > 0");
  EXPECT_THROW(ph::control_loop({.period = 2}), std::invalid_argument);
}

TEST(a_duration_histogram, has_percentiles_within_a_sixteenth) {
  std::mt19937_64 random(7);
  for (const double scale : {20.0, 5e3, 1e6, 1e12}) {
    ph::duration_histogram h;
    std::vector<std::int64_t> all;
    for (int k = 0; k < 10'000; ++k) {
      all.push_back(std::llround(scale * std::exponential_distribution<double>()(random)));
      h.add(all.back());
    }
    std::sort(all.begin(), all.end());
    for (const double share : {0.0, 0.5, 0.9, 0.99, 0.999, 1.0}) {
      const auto at = static_cast<std::size_t>(std::max(0.0, std::ceil(share * 1e4) - 1));
      const auto exact = static_cast<double>(all[at]);
      EXPECT_GE(static_cast<double>(h.percentile(share)), exact)
          << "seed 7, scale " << scale << ", " << share;
      EXPECT_LE(static_cast<double>(h.percentile(share)), exact * (1 + 1.0 / 16) + 1)
          << scale << ", " << share;
    }
    EXPECT_EQ(h.maximum(), all.back());
    EXPECT_EQ(h.count(), 10'000u);
    EXPECT_NEAR(h.mean(), scale, 0.05 * scale);
  }
}

TEST(a_duration_histogram, counts_in_bins_that_are_known) {
  ph::duration_histogram h;
  for (const std::int64_t duration : {1, 2, 6, 1000}) h.add(duration);
  EXPECT_EQ(h.mean(), 252.25);
  EXPECT_EQ(h.between(1, 2), 1u);
  EXPECT_EQ(h.between(1, 4), 2u);
  EXPECT_EQ(h.between(4, 512), 1u);
  EXPECT_EQ(h.between(512, 1024), 1u);
  EXPECT_EQ(h.percentile(0.5), 2);
  EXPECT_EQ(h.percentile(0.75), 6);
  EXPECT_EQ(h.percentile(1), 1000) << "not the end of its bin, 1023";
  h.add(5000);
  EXPECT_EQ(h.percentile(0.8), 1023);
}

TEST(a_duration_histogram, takes_any_number) {
  ph::duration_histogram h;
  EXPECT_EQ(h.percentile(0.5), 0);
  EXPECT_EQ(h.mean(), 0);
  for (const std::int64_t extreme : {std::numeric_limits<std::int64_t>::min(), std::int64_t{-1},
                                     std::int64_t{0}, std::numeric_limits<std::int64_t>::max()})
    h.add(extreme);
  EXPECT_EQ(h.count(), 4u);
  EXPECT_EQ(h.percentile(0.5), 0);
  EXPECT_EQ(h.percentile(1), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(h.between(0, 1), 3u);
}

}  // namespace control_loop_tests
