/// A force sensor at analog inputs of a Comedi card. Needs libcomedi.
#pragma once

#include <comedi/comedi_device.hpp>
#include <comedi/comedi_parameters.hpp>

#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/port.hpp>

#include <string>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// A ForceSensor in volts; the calibration has newtons per volt. A channel at either end of its range is
/// invalid. For a threaded_sensor: read is one system call that may wait, see comedi_port.
template <int Channels>
class comedi_force_sensor {
 public:
  static constexpr int channel_count = Channels;
  using parameters = comedi_force_sensor_parameters<Channels>;

  explicit comedi_force_sensor(parameters p) : p_(std::move(p)) {}

  /// Checks the card against the parameters.
  std::string open() {
    std::string text = validate(p_);
    unsigned subdevice = 0;
    if (text.empty()) text = device_.open(p_.device);
    if (text.empty()) text = device_.find("subdevice", p_.subdevice, COMEDI_SUBD_AI, subdevice);
    if (text.empty()) text = check_reference(subdevice);
    for (std::size_t i = 0; i < inputs_.size() && text.empty(); ++i) {
      comedi_channel& c = inputs_[i];
      c.subdevice = subdevice;
      c.channel = static_cast<unsigned>(p_.channels[i]);
      c.range = static_cast<unsigned>(p_.range);
      c.reference = reference_of(p_.reference);
      text = device_.check_channel(ph::detail::indexed("channels[", i, "]"), c);
      if (text.empty()) text = device_.check_range("range", c);
      voltages_.set(i, INSN_READ, c);
    }
    if (!text.empty()) device_.close();
    return text;
  }

  /// A new sample with each call [V]. no_sample: the card was busy; it may be tried again.
  ph::port_status read(ph::port_sample<Channels>& sample) noexcept {
    const double before = ph::monotonic_seconds();
    if (const ph::port_status status = voltages_.run(device_.get()); status != ph::port_status::ok)
      return status;
    sample.time = 0.5 * (before + ph::monotonic_seconds());  // the card read its channels in between
    sample.sequence = ++sequence_;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const lsampl_t s = voltages_.samples[i];
      sample.value[i] = inputs_[i].volts(s);
      sample.valid[i] = s > 0 && s < inputs_[i].max_sample;
    }
    return ph::port_status::ok;
  }

 private:
  static unsigned reference_of(comedi_reference r) noexcept {
    return r == comedi_reference::ground   ? AREF_GROUND
           : r == comedi_reference::common ? AREF_COMMON
                                           : AREF_DIFF;
  }

  std::string check_reference(unsigned subdevice) const {
    const auto flags = static_cast<unsigned>(comedi_get_subdevice_flags(device_.get(), subdevice));
    const auto offered = [&](comedi_reference r) {
      return (flags & (r == comedi_reference::ground   ? SDF_GROUND
                       : r == comedi_reference::common ? SDF_COMMON
                                                       : SDF_DIFF)) != 0;
    };
    if (offered(p_.reference)) return "";
    std::string given, possible;
    for (const auto& [reference, name] :
         {std::pair{comedi_reference::ground, " ground"}, std::pair{comedi_reference::common, " common"},
          std::pair{comedi_reference::differential, " differential"}}) {
      if (reference == p_.reference) given = name;
      if (offered(reference)) possible += name;
    }
    return "reference =" + given + ": expected one that this card has:" + possible;
  }

  parameters p_;
  comedi_device device_;
  std::uint32_t sequence_ = 0;
  std::array<comedi_channel, static_cast<std::size_t>(Channels)> inputs_;
  comedi_transfer<Channels> voltages_;
};

}  // namespace example
