// Counters of 8 to 32 bits, and pauses of 1 ms to 10 s in which a hand moves as fast as it may: in every
// state and under every release policy a position is right, or needs_homing(). 1e5 trials with
// PASSIVE_HAPTICS_STRESS=full.
#include "effort.hpp"

#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace stress {
namespace {

namespace ph = passive_haptics;
using ph::testing::random_source;

// A hand that turns an axis at any rate up to the largest, often at just that, and in the pause by whole
// turns of the counter.
struct axis {
  random_source& random;
  double max_rate, position = 0;  // [counts/s], [counts]

  void advance(double seconds, double turn) {
    const double reach = max_rate * seconds;
    double way = random.coin() ? random.uniform(-reach, reach) : random.coin() ? reach : -reach;
    const double turns = std::round(way / turn) * turn + random.uniform(-2.0, 2.0);
    if (random.coin() && std::abs(turns) <= reach) way = turns;
    position += way;
  }
};

enum class pause { of_the_loop, in_a_transfer, without_samples, with_invalid_samples, with_jumps };

struct device {
  double time = 100, count = 0;
  std::uint32_t sequence = 0;
  int bits = 0;
  ph::port_status status = ph::port_status::ok;
  bool valid = true;
};

struct port {
  static constexpr int encoder_count = 1, brake_count = 1;
  device* of;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<1>& sample) noexcept {
    const double turn = std::ldexp(1.0, of->bits);
    sample = {of->time, of->sequence, {of->count - turn * std::floor(of->count / turn)}, {of->valid}};
    return of->status;
  }
  ph::port_status write(const ph::brake_currents<1>&) noexcept { return ph::port_status::ok; }
  void release() noexcept {}
  int counter_bits() const noexcept { return of->bits; }
  double watchdog() const noexcept { return 1; }
};

class trial {
 public:
  explicit trial(std::uint64_t seed)
      : random_(seed),
        period_(random_.positive(2e-4, 5e-3)),
        device_{.bits = static_cast<int>(random_.uniform(8.0, 33.0))},
        turn_(std::ldexp(1.0, device_.bits)),
        hand_{random_, random_.positive(1e-3, 0.999) * ph::wrap_time(device_.bits, 1) / period_},
        port_({&device_}, {}, parameters()) {}

  // Whether the pause was one after which the position is still known.
  bool run() {
    EXPECT_EQ(port_.open(), "");
    cycles(25);
    const auto state = static_cast<int>(random_.uniform(0.0, 4.0));  // ready, active, degraded or released
    EXPECT_EQ(state > 0 && port_.activate(), state > 0);
    cycles(3);
    if (state == 2) cycle(pause::with_invalid_samples);
    if (state == 3) port_.release();
    pause_for(random_.positive(1e-3, 10.0), static_cast<pause>(random_.uniform(0.0, 5.0)));
    const bool known = !port_.needs_homing();
    for (int k = 0; k < 30; ++k) {
      cycle();
      const bool rearmed = port_.rearm(), activated = port_.activate();
      EXPECT_FALSE((rearmed || activated) && port_.needs_homing());
    }
    return known;
  }

 private:
  ph::safe_port<port>::parameters parameters() {
    ph::safe_port<port>::parameters p;
    p.encoders = {.max_rate = hand_.max_rate, .frozen_travel = 0};
    p.at_release.policy = static_cast<ph::release_policy>(random_.uniform(0.0, 3.0));
    p.hold_over = random_.positive(2 * period_, 0.2);
    if (random_.coin()) p.period = period_;
    counts_reads_ = random_.coin();
    return p;
  }

  void wait(double seconds) {
    hand_.advance(seconds, turn_);
    time_ += seconds;
    sequence_ += counts_reads_ ? 1 : std::max(1u, static_cast<std::uint32_t>(seconds / period_));
  }

  void cycle(pause spoilt = pause::of_the_loop) {
    wait(period_);
    device_ = {
        .time = time_, .count = std::floor(hand_.position), .sequence = sequence_, .bits = device_.bits};
    if (spoilt == pause::without_samples) device_.status = ph::port_status::no_sample;
    if (spoilt == pause::with_invalid_samples) device_.valid = false;
    if (spoilt == pause::with_jumps) device_.count = seen_ + turn_ / 2;
    read(time_);
  }
  void cycles(int count) {
    for (int k = 0; k < count; ++k) cycle();
  }

  void pause_for(double seconds, pause kind) {
    if (kind == pause::of_the_loop) return wait(seconds);
    if (kind == pause::in_a_transfer) {
      // Latched during it, dated after; the loop read its clock before, or another thread read the port
      wait(period_);
      const double before = time_, share = random_.uniform(0.0, 1.0);
      wait(share * seconds);
      device_ = {.count = std::floor(hand_.position), .sequence = sequence_, .bits = device_.bits};
      hand_.advance((1 - share) * seconds, turn_);
      device_.time = time_ = before + seconds;
      return read(random_.coin() ? before : time_);
    }
    for (const double end = time_ + seconds; time_ < end;) cycle(kind);
  }

  void read(double now) {
    port_.read(now);
    if (port_.pending_fault().what == ph::fault::none) seen_ = device_.count;
    if (std::isinf(first_)) first_ = seen_ - port_.position()[0];
    EXPECT_TRUE(port_.needs_homing() || port_.position()[0] == seen_ - first_)
        << device_.bits << " bits, off by " << port_.position()[0] - (seen_ - first_);
    port_.write({0.5});
  }

  random_source random_;
  double period_;  // of the loop and of the device [s]
  device device_;
  double turn_;  // [counts]
  axis hand_;
  bool counts_reads_ = false;  // the port counts its own reads
  ph::safe_port<port> port_;
  double time_ = 100;                   // [s]
  double first_ = INFINITY, seen_ = 0;  // counts where the position is 0, and of the last good sample
  std::uint32_t sequence_ = 0;
};

TEST(encoders, are_where_they_are_said_to_be_after_any_pause) {
  const std::uint64_t seed = first_seed(), trials = effort(2000, 100'000);
  std::uint64_t known = 0;
  for (std::uint64_t k = 0; k < trials; ++k) {
    SCOPED_TRACE(::testing::Message() << "PASSIVE_HAPTICS_STRESS_SEED=" << seed + k);
    known += trial(seed + k).run();
    ASSERT_FALSE(HasFailure());
  }
  std::printf("%llu of %llu positions were known after the pause\n", static_cast<unsigned long long>(known),
              static_cast<unsigned long long>(trials));
  EXPECT_GT(known, trials / 10);
  EXPECT_LT(known, trials);
}

}  // namespace
}  // namespace stress
