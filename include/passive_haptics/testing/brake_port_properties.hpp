/// The laws of the BrakePort concept as a GoogleTest suite for any port and a device or its substitute.
///
/// A case is default-constructible, and is the device:
///
///     using port = ...;                        // the port under test
///     port make();                             // a port to this device, not open
///     port make_releasing();                   // a port as of a supervisor; may be of another type
///     std::string open(port&);                 // port.open(), while the device runs; for both types
///     void live();                             // a millisecond: samples are sent, currents arrive
///     std::array<double, N> currents();        // currents of the brakes [A]
///     static constexpr double resolution;      // of a current [A]
///     static std::string missing();            // optional: reason why there is no device
///
/// Without a device the tests are skipped.
#pragma once

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace passive_haptics::testing {

/// Suite of a port's laws.
template <class Case>
class brake_port_properties : public ::testing::Test {
 protected:
  static_assert(BrakePort<typename Case::port>);
  using port = typename Case::port;                    ///< The port.
  using currents = brake_currents<port::brake_count>;  ///< [A]
  static constexpr int patience = 2000;                ///< Maximum time for an event [ms].

  Case device;  ///< The device.

  /// Skips the test without a device.
  void SetUp() override {
    if constexpr (requires { Case::missing(); })
      if (const std::string why = Case::missing(); !why.empty()) GTEST_SKIP() << why;
  }

  /// A different current for each brake, accepted by any device.
  static currents some() {
    currents all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = 0.02 + 0.01 * static_cast<double>(i);
    return all;
  }

  /// True if the brakes have these currents, within the resolution.
  bool have(const currents& wanted) {
    const auto got = device.currents();
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!(std::abs(got[i] - wanted[i]) <= (wanted[i] == 0 ? 0 : Case::resolution))) return false;
    return true;
  }

  /// Runs until the brakes have these currents; calls `again` each millisecond.
  template <class Again>
  bool come_to(const currents& wanted, Again&& again) {
    for (int k = 0; k < patience && !have(wanted); ++k) {
      again();
      device.live();
    }
    return have(wanted);
  }

  /// Writes currents until they are applied, as a loop does.
  void hold(port& p) {
    port_sample<port::encoder_count> sample;
    ASSERT_TRUE(come_to(some(), [&] {
      p.read(sample);
      ASSERT_NE(p.write(some()), port_status::failed);
    }));
  }
};

TYPED_TEST_SUITE_P(brake_port_properties);

/// release() may be called before open() and twice.
TYPED_TEST_P(brake_port_properties, release_may_be_called_at_any_time) {
  auto p = this->device.make();
  p.release();
  p.release();
  ASSERT_EQ(this->device.open(p), "");
  p.release();
  p.release();
  this->device.live();
  EXPECT_TRUE(this->come_to({}, [] {}));
}

/// Each ok sample has a new number and a time near now; the currents are 0 before any write.
TYPED_TEST_P(brake_port_properties, samples_go_on_in_sequence_and_in_time) {
  auto p = this->device.make();
  ASSERT_EQ(this->device.open(p), "");
  port_sample<TypeParam::port::encoder_count> sample;
  std::optional<std::uint32_t> last;
  int good = 0;
  for (int k = 0; k < this->patience && good < 50; ++k) {
    this->device.live();
    const port_status status = p.read(sample);
    ASSERT_NE(status, port_status::failed);
    if (status != port_status::ok) continue;
    ++good;
    if (last) {
      ASSERT_GT(static_cast<std::int32_t>(sample.sequence - *last), 0) << "sample " << good;
    }
    last = sample.sequence;
    ASSERT_LT(std::abs(monotonic_seconds() - sample.time), 1) << "sample " << good;
    for (std::size_t i = 0; i < sample.value.size(); ++i)
      ASSERT_TRUE(!sample.valid[i] || std::isfinite(sample.value[i])) << "encoder " << i;
  }
  EXPECT_EQ(good, 50);
  EXPECT_TRUE(this->have({}));
}

/// Currents reach their brakes; release() ends all of them, and the port can be written to again.
TYPED_TEST_P(brake_port_properties, release_takes_all_currents_back) {
  auto p = this->device.make();
  ASSERT_EQ(this->device.open(p), "");
  for (int round = 0; round < 3; ++round) {
    ASSERT_NO_FATAL_FAILURE(this->hold(p)) << "round " << round;
    p.release();
    EXPECT_TRUE(this->come_to({}, [] {})) << "round " << round;
  }
}

/// The destructor ends all currents.
TYPED_TEST_P(brake_port_properties, the_destructor_takes_all_currents_back) {
  {
    auto p = this->device.make();
    ASSERT_EQ(this->device.open(p), "");
    ASSERT_NO_FATAL_FAILURE(this->hold(p));
  }
  EXPECT_TRUE(this->come_to({}, [] {}));
}

/// Moving a port has no effect on the device; the moved-from port releases nothing.
TYPED_TEST_P(brake_port_properties, a_moved_port_is_the_same_port) {
  auto first = this->device.make();
  auto second = std::move(first);
  ASSERT_EQ(this->device.open(second), "");
  ASSERT_NO_FATAL_FAILURE(this->hold(second));
  auto third = std::move(second);
  ASSERT_NO_FATAL_FAILURE(this->hold(third));
  third.release();
  EXPECT_TRUE(this->come_to({}, [] {}));
}

/// A second port, as of a supervisor, ends the currents.
TYPED_TEST_P(brake_port_properties, a_second_port_takes_all_currents_back) {
  auto watching = this->device.make_releasing();
  ASSERT_EQ(this->device.open(watching), "");
  auto p = this->device.make();
  ASSERT_EQ(this->device.open(p), "");
  ASSERT_NO_FATAL_FAILURE(this->hold(p));
  watching.release();
  EXPECT_TRUE(this->come_to({}, [] {}));
}

/// A second port can also set currents, for a dead process (supervisor).
TYPED_TEST_P(brake_port_properties, a_second_port_gives_currents) {
  auto watching = this->device.make_releasing();
  ASSERT_EQ(this->device.open(watching), "");
  auto p = this->device.make();
  ASSERT_EQ(this->device.open(p), "");
  ASSERT_NO_FATAL_FAILURE(this->hold(p));
  auto less = this->some();
  for (double& current : less) current /= 2;
  EXPECT_TRUE(this->come_to(less, [&] { EXPECT_EQ(watching.write(less), port_status::ok); }));
  watching.release();
  EXPECT_TRUE(this->come_to({}, [] {}));
}

REGISTER_TYPED_TEST_SUITE_P(brake_port_properties, release_may_be_called_at_any_time,
                            samples_go_on_in_sequence_and_in_time, release_takes_all_currents_back,
                            the_destructor_takes_all_currents_back, a_moved_port_is_the_same_port,
                            a_second_port_takes_all_currents_back, a_second_port_gives_currents);

}  // namespace passive_haptics::testing
