// A port with two brakes and two encoders at the double of a card.
#pragma once

#include "comedi_double.hpp"

#include <comedi/comedi_port.hpp>

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace ph = passive_haptics;

using comedi_double::plugged;
using port = example::comedi_port<2, 2>;
static_assert(ph::BrakePort<port> && ph::BrakePort<example::comedi_port<0, 1>>);

constexpr lsampl_t zero = 32768;  // of -10 to 10 V in 16 bits: 0 V lies between this and the one before

inline port::parameters parameters() {
  port::parameters p;
  p.brakes[0].amperes_per_volt = p.brakes[1].amperes_per_volt = 0.5;
  p.encoders[0] = {.subdevice = 2};
  p.encoders[1] = {.subdevice = 3};
  return p;
}

struct at_a_card : ::testing::Test {
  at_a_card() { comedi_double::plug_in(); }

  void expect_error(const std::string& text) const {
    EXPECT_NE(port(p).open().find(text), std::string::npos) << port(p).open();
    EXPECT_EQ(plugged.handles, 0);
  }
  lsampl_t output(std::size_t i) const { return plugged.subdevices[1].value[i]; }
  void expect_released() const {
    EXPECT_EQ(output(0), zero);
    EXPECT_EQ(output(1), zero);
  }

  // The port, opened
  void open_card() {
    card.emplace(p);
    ASSERT_EQ(card->open(), "");
  }

  std::optional<port> card;
  port::parameters p = parameters();
  ph::port_sample<2> sample;
};
