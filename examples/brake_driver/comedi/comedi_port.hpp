/// Brakes at analog outputs and encoders at counters of a Comedi card. Needs libcomedi.
#pragma once

#include <comedi/comedi_device.hpp>
#include <comedi/comedi_parameters.hpp>

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <bit>
#include <sstream>
#include <string>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// A BrakePort with currents as voltages to amplifiers, and encoder counts as reported by counters.
///
/// A counter wraps after 2^counter_bits() counts; safe_port unwraps it.
/// For a threaded_port: read and write are one system call each (ioctl), which waits for the card's driver:
/// microseconds on PCI, up to milliseconds on USB, a second if a card does not respond. The loop only
/// accesses memory and does not wait. An analog output keeps its voltage when the program dies: run a
/// supervisor.
template <int Encoders, int Brakes>
class comedi_port {
 public:
  static constexpr int encoder_count = Encoders, brake_count = Brakes;
  using parameters = comedi_port_parameters<Encoders, Brakes>;

  explicit comedi_port(parameters p) : p_(std::move(p)) {}
  comedi_port(comedi_port&&) noexcept = default;
  ~comedi_port() { release(); }

  /// Checks the card against the parameters, sets all brakes to 0 V and starts the counters.
  std::string open() {
    std::string text = validate(p_);
    if (text.empty()) text = device_.open(p_.device);
    if (text.empty()) text = find_outputs();
    if (text.empty()) text = find_counters();
    if (text.empty() && write({}) != ph::port_status::ok) {
      text = p_.device + " rejects 0 V: " + comedi_strerror(comedi_errno());
      release();  // the outputs that do not refuse
    }
    for (std::size_t i = 0; i < counters_.size() && p_.start_counters && text.empty(); ++i)
      text = start_counter(i);
    if (!text.empty()) device_.close();  // release() then accesses no unchecked channel
    return text;
  }

  /// A new sample with each call. no_sample: the card was busy; it may be tried again.
  ph::port_status read(ph::port_sample<Encoders>& sample) noexcept {
    if (const ph::port_status status = counts_.run(device_.get()); status != ph::port_status::ok)
      return status;
    sample.time = ph::monotonic_seconds();  // after the transfer, so that a pause in it is detected
    sample.sequence = ++sequence_;
    for (std::size_t i = 0; i < counters_.size(); ++i) {
      sample.value[i] = counts_.samples[i];
      sample.valid[i] = true;
    }
    return ph::port_status::ok;
  }

  /// Rounds to the nearest sample in the range. Unless ok, only some brakes may have received their currents.
  ph::port_status write(const ph::brake_currents<Brakes>& currents) noexcept {
    for (std::size_t i = 0; i < outputs_.size(); ++i)
      voltages_.samples[i] = outputs_[i].sample(currents[i] / p_.brakes[i].amperes_per_volt);
    return voltages_.run(device_.get()) == ph::port_status::ok ? ph::port_status::ok
                                                               : ph::port_status::failed;
  }

  /// Sets 0 V brake by brake, so that a failure affects no other.
  void release() noexcept {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      voltages_.samples[i] = outputs_[i].zero;
      voltages_.run_one(device_.get(), i);
    }
  }

  /// Width of the counters, equal for all; 0 without encoders and before open().
  int counter_bits() const noexcept {
    return Encoders == 0 ? 0 : static_cast<int>(std::bit_width(counters_.front().max_sample));
  }

 private:
  std::string find_outputs() {
    unsigned subdevice = 0;
    std::string text = device_.find("output_subdevice", p_.output_subdevice, COMEDI_SUBD_AO, subdevice);
    for (std::size_t i = 0; i < outputs_.size() && text.empty(); ++i) {
      const comedi_brake& b = p_.brakes[i];
      comedi_channel& c = outputs_[i];
      c.subdevice = subdevice;
      c.channel = static_cast<unsigned>(b.channel);
      c.range = static_cast<unsigned>(b.range);
      const std::string name = ph::detail::indexed("brakes[", i, "].");
      text = device_.check_channel(name + "channel", c);
      if (text.empty()) text = device_.check_range(name + "range", c);
      if (text.empty()) text = check_currents(name, b, c);
      voltages_.set(i, INSN_WRITE, c);
    }
    return text;
  }

  std::string check_currents(const std::string& name, const comedi_brake& b, const comedi_channel& c) const {
    std::ostringstream text;
    const double needed = b.max_current / b.amperes_per_volt;
    if (!(c.low <= 0 && c.high > 0)) {
      text << name << "range = " << b.range << " (" << c.low << " to " << c.high
           << " V): expected one from 0 V, for a free brake, upwards: the channel has" << device_.ranges(c);
    } else if (needed > c.high) {
      text << name << "max_current [A] = " << b.max_current << " needs " << needed << " V: expected at most "
           << c.high << " V: lower it, or choose another range" << device_.ranges(c);
    }
    return text.str();
  }

  std::string find_counters() {
    std::string text;
    for (std::size_t i = 0; i < counters_.size() && text.empty(); ++i) {
      const comedi_encoder& e = p_.encoders[i];
      comedi_channel& c = counters_[i];
      const std::string name = ph::detail::indexed("encoders[", i, "].");
      c.channel = static_cast<unsigned>(e.channel);
      text = device_.find(name + "subdevice", e.subdevice, COMEDI_SUBD_COUNTER, c.subdevice);
      if (text.empty()) text = device_.check_channel(name + "channel", c);
      if (text.empty()) text = check_width(name, c);
      counts_.set(i, INSN_READ, c);
    }
    return text;
  }

  std::string check_width(const std::string& name, const comedi_channel& c) const {
    const unsigned expected = counters_.front().max_sample;
    if (c.max_sample == expected && c.max_sample > 1 && std::has_single_bit(std::uint64_t{c.max_sample} + 1))
      return "";
    std::ostringstream text;
    text << name << "channel = " << c.channel << " counts to " << c.max_sample
         << ": expected 2^n - 1, the same for all encoders: use counters of one kind";
    return text.str();
  }

  // As the demo gpct_encoder of libcomedi.
  std::string start_counter(std::size_t i) {
    const comedi_encoder& e = p_.encoders[i];
    if (e.setup == comedi_counter_setup::keep) return "";
    comedi_t* const card = device_.get();
    const unsigned s = counters_[i].subdevice, middle = counters_[i].max_sample / 2 + 1;
    bool done = comedi_reset(card, s) >= 0;
    // The counter and its two load registers
    for (unsigned place = 0; place < 3; ++place)
      done = done && comedi_data_write(card, s, place, 0, 0, middle) == 1;
    done = done && comedi_set_gate_source(card, s, 0, 0, NI_GPCT_DISABLED_GATE_SELECT) >= 0;
    if (done)
      comedi_set_gate_source(card, s, 0, 1, NI_GPCT_DISABLED_GATE_SELECT);  // not every card has this gate
    const auto wire = [&](unsigned input, int terminal) {
      const unsigned source = NI_GPCT_PFI_OTHER_SELECT(static_cast<unsigned>(terminal));
      return terminal < 0 || comedi_set_other_source(card, s, 0, input, source) >= 0;
    };
    done = done && wire(NI_GPCT_SOURCE_ENCODER_A, e.a) && wire(NI_GPCT_SOURCE_ENCODER_B, e.b);
    const unsigned mode =
        NI_GPCT_COUNTING_MODE_QUADRATURE_X4_BITS | NI_GPCT_COUNTING_DIRECTION_HW_UP_DOWN_BITS;
    done = done && comedi_set_counter_mode(card, s, 0, mode) >= 0 &&
           comedi_arm(card, s, NI_GPCT_ARM_IMMEDIATE) >= 0;
    if (done) return "";
    return ph::detail::indexed("encoders[", i, "].setup = ni_quadrature: the card rejects it (") +
           comedi_strerror(comedi_errno()) +
           "); expected a counter of National Instruments, else setup = keep";
  }

  parameters p_;
  comedi_device device_;
  std::uint32_t sequence_ = 0;
  std::array<comedi_channel, static_cast<std::size_t>(Brakes)> outputs_;
  std::array<comedi_channel, static_cast<std::size_t>(Encoders)> counters_;
  comedi_transfer<Brakes> voltages_;
  comedi_transfer<Encoders> counts_;
};

}  // namespace example
