/// The handle of a Comedi card, and its properties. Needs libcomedi.
#pragma once

#include <comedi/comedi_channel.hpp>

#include <cerrno>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

namespace example {

namespace ph = passive_haptics;

/// The handle of a card, closed by the destructor.
class comedi_device {
 public:
  /// Returns an error with a remedy, or an empty string. `file` is, for example, /dev/comedi0.
  std::string open(const std::string& file) {
    file_ = file;
    handle_.reset(comedi_open(file.c_str()));
    return handle_ ? "" : "device = " + file + reason(comedi_errno());
  }

  void close() noexcept { handle_.reset(); }
  /// Null if it is not open.
  comedi_t* get() const noexcept { return handle_.get(); }

  /// Finds the subdevice of this type (COMEDI_SUBD_...): `index`, or the first one for -1. `name`: parameter
  /// in errors.
  std::string find(const std::string& name, int index, int type, unsigned& found) const {
    const int first = comedi_find_subdevice_by_type(get(), type, 0);
    const int wanted = index < 0 ? first : index;
    std::ostringstream text;
    if (first < 0) {
      text << name << ": " << file_ << " (" << comedi_get_board_name(get()) << ") has no subdevice that is "
           << type_name(type) << "; use a card that has one";
    } else if (wanted >= comedi_get_n_subdevices(get())) {
      text << name << " = " << index << ": expected 0 to " << comedi_get_n_subdevices(get()) - 1
           << ", as many as " << file_ << " (" << comedi_get_board_name(get()) << ") has; subdevice " << first
           << " is " << type_name(type);
    } else if (comedi_get_subdevice_type(get(), static_cast<unsigned>(wanted)) != type) {
      text << name << " = " << index << ": expected a subdevice of " << file_ << " that is "
           << type_name(type) << ", as " << first << " is";
    }
    found = static_cast<unsigned>(wanted);
    return text.str();
  }

  /// Sets the channel's maximum sample; `name`: parameter in errors.
  std::string check_channel(const std::string& name, comedi_channel& c) const {
    const int count = comedi_get_n_channels(get(), c.subdevice);
    std::ostringstream text;
    if (c.channel >= static_cast<unsigned>(count < 0 ? 0 : count)) {
      text << name << " = " << c.channel << ": expected less than " << count
           << ", the number of channels of subdevice " << c.subdevice;
    } else if (c.max_sample = comedi_get_maxdata(get(), c.subdevice, c.channel); c.max_sample == 0) {
      text << name << " = " << c.channel << ": subdevice " << c.subdevice
           << " reports no maximum sample (maxdata): expected at least 1; use another driver";
    }
    return text.str();
  }

  /// Sets the channel's range in volts and derived values; `name`: parameter in errors.
  std::string check_range(const std::string& name, comedi_channel& c) const {
    const comedi_range* r = comedi_get_range(get(), c.subdevice, c.channel, c.range);
    std::ostringstream text;
    if (r == nullptr || r->unit != UNIT_volt || !(r->max > r->min)) {
      text << name << " = " << c.range << ": expected a range in volts: subdevice " << c.subdevice
           << ", channel " << c.channel << " has" << ranges(c);
      return text.str();
    }
    comedi_range range = *r;
    c.low = range.min;
    c.high = range.max;
    c.samples_per_volt = c.max_sample / (c.high - c.low);
    c.zero = comedi_from_phys(0, &range, c.max_sample);
    return "";
  }

  /// Text such as ": 0 (-10 to 10 V), 1 (0 to 5 V)".
  std::string ranges(const comedi_channel& c) const {
    const int count = comedi_get_n_ranges(get(), c.subdevice, c.channel);
    std::ostringstream text;
    if (count <= 0) text << " none";
    for (int i = 0; i < count; ++i) {
      const comedi_range* r = comedi_get_range(get(), c.subdevice, c.channel, static_cast<unsigned>(i));
      if (r == nullptr) continue;
      text << (i == 0 ? ": " : ", ") << i << " (" << r->min << " to " << r->max
           << (r->unit == UNIT_volt ? " V)"
               : r->unit == UNIT_mA ? " mA)"
                                    : " of no unit)");
    }
    return text.str();
  }

  static std::string_view type_name(int type) {
    return type == COMEDI_SUBD_AO   ? "an analog output"
           : type == COMEDI_SUBD_AI ? "an analog input"
                                    : "a counter";
  }

 private:
  static std::string reason(int error) {
    switch (error) {
      case ENOENT:
        return " does not exist: expected the file of a Comedi card: load the card's driver (sudo modprobe "
               "NAME), or name "
               "another (ls /dev/comedi*)";
      case EACCES:
      case EPERM:
        return " may not be opened by this user: join its group (on Debian: sudo adduser $USER iocard) and "
               "log in again";
      case ENODEV:
      case ENXIO:
        return " belongs to no card: plug the card in and load its driver (sudo modprobe NAME); a card "
               "that does not "
               "configure itself needs comedi_config, too";
      case ENOTTY:
      case EINVAL: return " is not a Comedi device: name one (ls /dev/comedi*)";
      default: return std::string(" cannot be opened: ") + comedi_strerror(error);
    }
  }

  struct closer {
    void operator()(comedi_t* handle) const noexcept { comedi_close(handle); }
  };
  std::string file_;
  std::unique_ptr<comedi_t, closer> handle_;
};

}  // namespace example
