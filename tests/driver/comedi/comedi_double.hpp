// Stands in for libcomedi at link time: one card in memory, with the faults that a test gives it.
#pragma once

#include <comedilib.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace comedi_double {

constexpr std::size_t max_channels = 8;

struct subdevice {
  int type = COMEDI_SUBD_UNUSED;
  int channels = 0;
  lsampl_t max_sample = 0;
  std::vector<comedi_range> ranges{};
  unsigned flags = SDF_GROUND;
  std::array<lsampl_t, max_channels> value{};  // what is read, and what was written last
  std::array<int, max_channels> writes{};
  std::array<bool, max_channels> broken{};  // this channel alone refuses, with EIO
  unsigned last_reference = 0;
  std::vector<std::string> set_up{};  // calls that configure a counter
};

struct card {
  std::string file = "/dev/comedi0";
  int open_error = 0;      // errno of comedi_open
  int transfer_error = 0;  // errno of each transfer
  int served = -1;         // so many instructions of a list, and no errno; -1: all
  bool refuses_set_up = false;
  int handles = 0;  // open now
  int lists = 0;    // transfers of several channels
  std::vector<subdevice> subdevices;
};

// The card of the present test.
inline card plugged;

// Analog inputs, analog outputs and two counters of 24 bits, as of a usual card.
inline void plug_in() {
  const comedi_range ten{-10, 10, UNIT_volt}, upwards{0, 5, UNIT_volt}, without_zero{1, 5, UNIT_volt},
      current{0, 20, UNIT_mA};
  const std::vector<comedi_range> ranges{ten, upwards, without_zero, current};
  plugged = {};
  plugged.subdevices.resize(4);
  plugged.subdevices[0] = {.type = COMEDI_SUBD_AI, .channels = 8, .max_sample = 0xffff, .ranges = ranges};
  plugged.subdevices[1] = {.type = COMEDI_SUBD_AO, .channels = 2, .max_sample = 0xffff, .ranges = ranges};
  for (std::size_t i = 2; i < 4; ++i)
    plugged.subdevices[i] = {.type = COMEDI_SUBD_COUNTER, .channels = 3, .max_sample = 0xffffff};
}

}  // namespace comedi_double
