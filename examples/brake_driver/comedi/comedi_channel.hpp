/// Channels of a Comedi card, and transfers to several of them in one system call. Needs libcomedi.
#pragma once

#include <passive_haptics/driver/port.hpp>

#include <comedilib.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>

namespace example {

namespace ph = passive_haptics;

/// A channel of a card and its scale. For a counter, without volts, low = high = 0.
struct comedi_channel {
  unsigned subdevice = 0, channel = 0, range = 0;
  unsigned reference = AREF_GROUND;
  lsampl_t max_sample = 0;      ///< Maximum sample; the minimum is 0.
  lsampl_t zero = 0;            ///< The sample nearest to 0 V.
  double low = 0, high = 0;     ///< The range [V].
  double samples_per_volt = 0;  ///< [1/V]

  /// The sample nearest to `volts`, limited to the range; that nearest to 0 V for 0 and NaN.
  lsampl_t sample(double volts) const noexcept {
    if (!(volts < 0 || volts > 0)) return zero;
    if (volts <= low) return 0;
    if (volts >= high) return max_sample;
    return static_cast<lsampl_t>(std::floor((volts - low) * samples_per_volt + 0.5));
  }
  /// [V]
  double volts(lsampl_t sample) const noexcept { return low + sample / samples_per_volt; }
};

/// One sample to or from each of N channels, in one system call.
template <int N>
class comedi_transfer {
 public:
  static constexpr auto count = static_cast<std::size_t>(N);

  /// instruction: INSN_READ or INSN_WRITE
  void set(std::size_t i, unsigned instruction, const comedi_channel& c) noexcept {
    instructions_[i] = {instruction, 1, nullptr, c.subdevice, chanspec(c), {}};
  }

  /// ok if all channels were transferred; no_sample if the card was busy or slow, and may be tried again.
  ph::port_status run(comedi_t* handle) noexcept {
    if (handle == nullptr) return ph::port_status::failed;
    if (N == 0) return ph::port_status::ok;
    for (std::size_t i = 0; i < count; ++i) instructions_[i].data = &samples[i];  // may have moved
    comedi_insnlist list{static_cast<unsigned>(N), instructions_.data()};
    const int served = comedi_do_insnlist(handle, &list);
    if (served == N) return ph::port_status::ok;
    if (served >= 0) return ph::port_status::failed;  // some channels only, without an error
    const int error = comedi_errno();
    const bool later = error == EAGAIN || error == EINTR || error == EBUSY || error == ETIMEDOUT;
    return later ? ph::port_status::no_sample : ph::port_status::failed;
  }

  /// Transfers this channel only; false if it failed.
  bool run_one(comedi_t* handle, std::size_t i) noexcept {
    instructions_[i].data = &samples[i];
    return handle != nullptr && comedi_do_insn(handle, &instructions_[i]) == 1;
  }

  std::array<lsampl_t, count> samples{};

 private:
  static unsigned chanspec(const comedi_channel& c) noexcept {
    return CR_PACK(c.channel, c.range, c.reference);
  }
  std::array<comedi_insn, count> instructions_{};
};

}  // namespace example
