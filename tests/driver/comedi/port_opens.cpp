// What is wrong with a Comedi card or with the parameters of its port is named when it opens.
#include "port_fixture.hpp"

#include <cerrno>
#include <string>
#include <vector>

namespace {

using opening_a_comedi_port = at_a_card;

TEST_F(opening_a_comedi_port, names_what_is_wrong_with_its_parameters) {
  EXPECT_EQ(validate(p), "");
  const auto expect = [](auto change, const std::string& text) {
    auto wrong = parameters();
    change(wrong);
    EXPECT_EQ(validate(wrong), text);
    EXPECT_EQ(port(wrong).open(), text) << "open() says the same";
  };
  expect([](auto& w) { w.device = ""; }, "device = \"\": expected a file like /dev/comedi0");
  expect([](auto& w) { w.output_subdevice = -2; }, "output_subdevice = -2: expected an index, or -1");
  expect([](auto& w) { w.brakes[1].channel = -1; }, "brakes[1].channel = -1: expected an index >= 0");
  expect([](auto& w) { w.brakes[1].channel = 0; },
         "brakes[1].channel = 0: expected a channel other than that of [0]");
  expect([](auto& w) { w.brakes[0].range = -1; }, "brakes[0].range = -1: expected an index >= 0");
  expect([](auto& w) { w.brakes[0] = {}; },
         "brakes[0].amperes_per_volt [A/V] = 0: expected a finite number > 0, the amplifier's gain");
  expect([](auto& w) { w.encoders[1].subdevice = 2; },
         "encoders[1].channel = 0: expected a channel other than that of [0]");
  expect([](auto& w) { w.encoders[0].a = -2; }, "encoders[0].a = -2: expected an index, or -1");
}

TEST_F(opening_a_comedi_port, names_the_device_that_it_cannot_open_and_what_to_do) {
  p.device = "/dev/comedi7";
  expect_error(
      "device = /dev/comedi7 does not exist: expected the file of a Comedi card: load the card's driver");
  const auto expect = [&](int error, const std::string& text) {
    plugged.open_error = error;
    expect_error("device = /dev/comedi7" + text);
  };
  expect(EACCES, " may not be opened by this user: join its group");
  expect(ENODEV, " belongs to no card: plug the card in");
  expect(ENOTTY, " is not a Comedi device: name one");
  expect(EIO, " cannot be opened: Input/output error");
}

TEST_F(opening_a_comedi_port, names_a_subdevice_of_the_wrong_type) {
  p.output_subdevice = 0;
  expect_error(
      "output_subdevice = 0: expected a subdevice of /dev/comedi0 that is an analog output, as 1 is");
  p.output_subdevice = 4;
  expect_error("output_subdevice = 4: expected 0 to 3, as many as /dev/comedi0 (double) has");
  p.output_subdevice = 1;
  p.encoders[1].subdevice = 1;
  expect_error("encoders[1].subdevice = 1: expected a subdevice of /dev/comedi0 that is a counter, as 2 is");
  plugged.subdevices.pop_back();
  plugged.subdevices.pop_back();
  expect_error(
      "encoders[0].subdevice: /dev/comedi0 (double) has no subdevice that is a counter; use a card that "
      "has one");
}

TEST_F(opening_a_comedi_port, names_a_channel_that_the_card_lacks) {
  p.brakes[1].channel = 2;
  expect_error("brakes[1].channel = 2: expected less than 2, the number of channels of subdevice 1");
  p.brakes[1].channel = 1;
  p.encoders[0].channel = 5;
  expect_error("encoders[0].channel = 5: expected less than 3, the number of channels of subdevice 2");
}

TEST_F(opening_a_comedi_port, names_a_range_that_does_not_fit_and_those_that_there_are) {
  p.brakes[0].range = 4;
  expect_error(
      "brakes[0].range = 4: expected a range in volts: subdevice 1, channel 0 has: 0 (-10 to 10 V), "
      "1 (0 to 5 V), 2 (1 to 5 V), 3 (0 to 20 mA)");
  p.brakes[0].range = 3;
  expect_error("brakes[0].range = 3: expected a range in volts");
  p.brakes[0].range = 2;
  expect_error("brakes[0].range = 2 (1 to 5 V): expected one from 0 V, for a free brake, upwards");
  p.brakes[0].range = 1;
  p.brakes[0].max_current = 3;
  expect_error("brakes[0].max_current [A] = 3 needs 6 V: expected at most 5 V: lower it, or choose another");
  p.brakes[0].range = 0;
  EXPECT_EQ(port(p).open(), "");
}

TEST_F(opening_a_comedi_port, names_a_largest_sample_that_makes_no_sense) {
  plugged.subdevices[3].max_sample = 0xffff;
  expect_error("encoders[1].channel = 0 counts to 65535: expected 2^n - 1, the same for all encoders");
  plugged.subdevices[2].max_sample = plugged.subdevices[3].max_sample = 999;
  expect_error("encoders[0].channel = 0 counts to 999: expected 2^n - 1");
  plugged.subdevices[1].max_sample = 0;
  expect_error("brakes[0].channel = 0: subdevice 1 reports no maximum sample (maxdata): expected at least 1");
}

TEST_F(opening_a_comedi_port, frees_brakes_that_an_earlier_program_left_on) {
  plugged.subdevices[1].value = {60000, 50000};
  ASSERT_NO_FATAL_FAILURE(open_card());
  expect_released();
}

TEST_F(opening_a_comedi_port, fails_if_it_may_not_write) {
  plugged.subdevices[1].value = {60000, 50000};
  plugged.subdevices[1].broken[0] = true;
  expect_error("/dev/comedi0 rejects 0 V: Input/output error");
  EXPECT_EQ(output(1), zero) << "the other brake is free";
}

TEST_F(opening_a_comedi_port, sets_counters_up_for_quadrature_if_asked_to) {
  p.encoders[0] = {.subdevice = 2, .setup = example::comedi_counter_setup::ni_quadrature, .a = 8, .b = 10};
  ASSERT_NO_FATAL_FAILURE(open_card());
  const std::vector<std::string> expected{"reset",         "no gate",       "no gate", "A from PFI 8",
                                          "B from PFI 10", "quadrature x4", "arm"};
  EXPECT_EQ(plugged.subdevices[2].set_up, expected);
  EXPECT_EQ(plugged.subdevices[2].value[0], 0x800000u) << "in the middle";
  EXPECT_TRUE(plugged.subdevices[3].set_up.empty());

  p.start_counters = false;
  port supervisors(p);
  ASSERT_EQ(supervisors.open(), "");
  EXPECT_EQ(plugged.subdevices[2].set_up, expected) << "a supervisor's port restarts nothing";

  p.start_counters = plugged.refuses_set_up = true;
  EXPECT_EQ(port(p).open(),
            "encoders[0].setup = ni_quadrature: the card rejects it (Invalid argument); "
            "expected a counter of National Instruments, else setup = keep");
}

}  // namespace
