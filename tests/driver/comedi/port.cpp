// Currents and counts through a port to a Comedi card; no fault leaves a brake with its current.
#include "../../realtime/allocations.hpp"

#include "port_fixture.hpp"

#include <cerrno>
#include <limits>
#include <memory>
#include <utility>

namespace {

using comedi_port = at_a_card;

TEST_F(comedi_port, turns_currents_into_volts_into_samples) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  ASSERT_EQ(card->write({1, 2.5}), ph::port_status::ok);  // 2 V and 5 V of -10 to 10 V
  EXPECT_EQ(output(0), 39321u);
  EXPECT_EQ(output(1), 49151u);
  ASSERT_EQ(card->write({4.99999, 0}), ph::port_status::ok);
  EXPECT_EQ(output(0), 65535u);
  EXPECT_EQ(output(1), zero);
  EXPECT_EQ(plugged.lists, 3) << "one system call for both brakes";

  comedi_range range{-10, 10, UNIT_volt};
  for (double current = 0; current < 5; current += 0.00137) {
    ASSERT_EQ(card->write({current, 0}), ph::port_status::ok);
    ASSERT_EQ(output(0), comedi_from_phys(current / 0.5, &range, 0xffff)) << current;
  }
}

TEST_F(comedi_port, never_leaves_the_range_and_takes_what_is_no_number_for_0_A) {
  p.brakes[1].range = 1;
  ASSERT_NO_FATAL_FAILURE(open_card());
  EXPECT_EQ(output(1), 0u) << "0 V of 0 to 5 V";
  const double infinity = std::numeric_limits<double>::infinity();
  ASSERT_EQ(card->write({100, infinity}), ph::port_status::ok);
  EXPECT_EQ(output(0), 65535u);
  EXPECT_EQ(output(1), 65535u);
  ASSERT_EQ(card->write({std::numeric_limits<double>::quiet_NaN(), -1}), ph::port_status::ok);
  EXPECT_EQ(output(0), zero);
  EXPECT_EQ(output(1), 0u);
}

TEST_F(comedi_port, reads_all_counters_as_one_sample) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  plugged.subdevices[2].value[0] = 123;
  plugged.subdevices[3].value[0] = 0xffffff;
  const double before = ph::monotonic_seconds();
  ASSERT_EQ(card->read(sample), ph::port_status::ok);
  EXPECT_EQ(sample.value[0], 123);
  EXPECT_EQ(sample.value[1], 16777215);
  EXPECT_TRUE(sample.valid[0] && sample.valid[1]);
  EXPECT_GE(sample.time, before);
  EXPECT_LE(sample.time, ph::monotonic_seconds());
  const auto first = sample.sequence;
  ASSERT_EQ(card->read(sample), ph::port_status::ok);
  EXPECT_EQ(sample.sequence, first + 1);
}

TEST_F(comedi_port, tells_the_width_of_its_counters) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  EXPECT_EQ(ph::counter_bits(*card), 24);
}

TEST_F(comedi_port, that_is_busy_may_be_read_again_and_one_that_is_gone_may_not) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  for (const int error : {EBUSY, EAGAIN, EINTR, ETIMEDOUT}) {
    plugged.transfer_error = error;
    EXPECT_EQ(card->read(sample), ph::port_status::no_sample) << comedi_strerror(error);
  }
  for (const int error : {ENODEV, EIO, EACCES, EINVAL, EBADF}) {
    plugged.transfer_error = error;
    EXPECT_EQ(card->read(sample), ph::port_status::failed) << comedi_strerror(error);
  }
  plugged.transfer_error = 0;
  plugged.served = 1;
  EXPECT_EQ(card->read(sample), ph::port_status::failed) << "one counter of two";
}

TEST_F(comedi_port, whose_write_is_short_or_refused_has_failed_and_can_still_be_released) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  ASSERT_EQ(card->write({2, 2}), ph::port_status::ok);
  plugged.served = 1;
  EXPECT_EQ(card->write({1, 1}), ph::port_status::failed);
  EXPECT_NE(output(0), output(1)) << "one brake has its new current, the other its old one";
  card->release();
  expect_released();
  plugged.served = -1;
  for (const int error : {ENODEV, EIO, EBUSY, EINTR}) {
    plugged.transfer_error = 0;
    ASSERT_EQ(card->write({2, 2}), ph::port_status::ok);
    plugged.transfer_error = error;
    EXPECT_EQ(card->write({1, 1}), ph::port_status::failed) << comedi_strerror(error);
  }
  card->release();  // the device is still gone
  plugged.transfer_error = 0;
  card->release();
  expect_released();
}

TEST_F(comedi_port, releases_a_brake_though_the_one_before_it_does_not_answer) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  ASSERT_EQ(card->write({2, 2}), ph::port_status::ok);
  plugged.subdevices[1].broken[0] = true;
  card->release();
  EXPECT_NE(output(0), zero);
  EXPECT_EQ(output(1), zero);
}

TEST_F(comedi_port, that_is_not_open_transfers_nothing_and_touches_no_channel_that_was_not_checked) {
  plugged.subdevices[1].value = {60000, 50000};
  p.brakes[1].channel = 7;
  port wrong(p);
  ASSERT_NE(wrong.open(), "");
  EXPECT_EQ(wrong.read(sample), ph::port_status::failed);
  EXPECT_EQ(wrong.write({1, 1}), ph::port_status::failed);
  wrong.release();
  EXPECT_EQ(plugged.lists, 0);
  EXPECT_EQ(output(0), 60000u);
}

TEST_F(comedi_port, may_be_moved_and_releases_once) {
  auto first = std::make_unique<port>(p);
  ASSERT_EQ(first->open(), "");
  port card(std::move(*first));
  ASSERT_EQ(card.write({2, 2}), ph::port_status::ok);
  const lsampl_t holding = output(0);
  EXPECT_EQ(first->read(sample), ph::port_status::failed);
  EXPECT_EQ(first->write({0, 0}), ph::port_status::failed);
  first.reset();
  EXPECT_EQ(output(0), holding) << "the one that is left has nothing to release";
  EXPECT_EQ(card.read(sample), ph::port_status::ok);
}

TEST_F(comedi_port, allocates_nothing_once_it_is_open) {
  ASSERT_NO_FATAL_FAILURE(open_card());
  const auto cycle = [&] {
    card->read(sample);
    card->write({1, 2});
    card->release();
  };
  EXPECT_EQ(allocations_in(cycle), 0);
  plugged.transfer_error = ENODEV;
  EXPECT_EQ(allocations_in(cycle), 0) << "of a device that is gone";
}

}  // namespace
