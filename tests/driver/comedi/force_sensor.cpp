// A force sensor at a Comedi card tells volts, and which channels are at the end of their range.
#include "comedi_double.hpp"

#include <comedi/comedi_force_sensor.hpp>

#include <gtest/gtest.h>

#include <cerrno>

namespace ph = passive_haptics;

namespace {

using comedi_double::plugged;
using sensor = example::comedi_force_sensor<3>;
static_assert(ph::ForceSensor<sensor>);

struct comedi_force_sensor : ::testing::Test {
  comedi_force_sensor() { comedi_double::plug_in(); }

  void expect_error(const std::string& text) const {
    EXPECT_NE(sensor(p).open().find(text), std::string::npos) << sensor(p).open();
    EXPECT_EQ(plugged.handles, 0);
  }
  auto& value() const { return plugged.subdevices[0].value; }

  sensor::parameters p;
  ph::port_sample<3> sample;
};

TEST_F(comedi_force_sensor, reads_volts_of_the_channels_that_it_was_given) {
  p.channels = {4, 0, 7};
  sensor card(p);
  ASSERT_EQ(card.open(), "");
  value() = {32768, 0, 0, 0, 1, 0, 0, 65534};
  ASSERT_EQ(card.read(sample), ph::port_status::ok);
  const double step = 20.0 / 65535;
  EXPECT_NEAR(sample.value[0], -10 + step, 1e-12);
  EXPECT_NEAR(sample.value[1], step / 2, 1e-12);
  EXPECT_NEAR(sample.value[2], 10 - step, 1e-12);
  EXPECT_TRUE(sample.valid[0] && sample.valid[1] && sample.valid[2]);
  EXPECT_EQ(plugged.lists, 1) << "one system call for all channels";
}

TEST_F(comedi_force_sensor, does_not_trust_a_channel_at_either_end_of_its_range) {
  sensor card(p);
  ASSERT_EQ(card.open(), "");
  value() = {0, 40000, 65535};
  ASSERT_EQ(card.read(sample), ph::port_status::ok);
  EXPECT_FALSE(sample.valid[0]);
  EXPECT_TRUE(sample.valid[1]);
  EXPECT_FALSE(sample.valid[2]);
  EXPECT_EQ(sample.value[2], 10);
}

// port_opens.cpp has all that can be wrong with a subdevice, a channel and a range.
TEST_F(comedi_force_sensor, names_what_does_not_fit) {
  p.subdevice = 1;
  expect_error("subdevice = 1: expected a subdevice of /dev/comedi0 that is an analog input, as 0 is");
  p.subdevice = -1;
  p.channels[2] = 8;
  expect_error("channels[2] = 8: expected less than 8, the number of channels of subdevice 0");
  p.channels[2] = 2;
  p.reference = example::comedi_reference::differential;
  expect_error("reference = differential: expected one that this card has: ground");
}

TEST_F(comedi_force_sensor, measures_against_the_reference_that_it_was_given) {
  plugged.subdevices[0].flags = SDF_GROUND | SDF_DIFF;
  p.reference = example::comedi_reference::differential;
  sensor card(p);
  ASSERT_EQ(card.open(), "");
  ASSERT_EQ(card.read(sample), ph::port_status::ok);
  EXPECT_EQ(plugged.subdevices[0].last_reference, unsigned{AREF_DIFF});
}

TEST_F(comedi_force_sensor, that_is_busy_may_be_read_again_and_one_that_is_gone_may_not) {
  sensor card(p);
  EXPECT_EQ(card.read(sample), ph::port_status::failed) << "before it opens";
  ASSERT_EQ(card.open(), "");
  plugged.transfer_error = ETIMEDOUT;
  EXPECT_EQ(card.read(sample), ph::port_status::no_sample);
  plugged.transfer_error = ENODEV;
  EXPECT_EQ(card.read(sample), ph::port_status::failed);
}

}  // namespace
