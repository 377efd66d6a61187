/// Monitoring of a device's transfers.
#pragma once

#include <passive_haptics/driver/checks/rejected_samples.hpp>
#include <passive_haptics/driver/fault.hpp>

#include <limits>

namespace passive_haptics {

/// Results of one kind of transfer: samples of the encoders or of the force sensor, or writes.
class transfer_watch {
 public:
  /// hold_over [s]: maximum duration of a fault.
  explicit transfer_watch(double hold_over) : hold_over_(hold_over), rejections_(hold_over) {}

  /// Adds the result of a transfer at time `now` [s]; none if it was good.
  void add(const fault_record& result, double now) noexcept {
    result_ = result;
    rejections_.add(result.what, now);
    if (result.what == fault::none) good_ = now;
    lasts_ = now - good_ > hold_over_ || rejections_.is_too_many();
  }

  const fault_record& result() const noexcept { return result_; }  ///< Result of the last transfer.
  /// True if the last result is a fault that can no longer be bridged: it releases_immediately(), lasts
  /// longer than `hold_over`, or follows too many rejected samples.
  bool fails() const noexcept {
    return result_.what != fault::none && (lasts_ || releases_immediately(result_));
  }
  /// True if the last transfer was good and not too many samples were rejected.
  bool is_good() const noexcept { return result_.what == fault::none && !rejections_.is_too_many(); }
  /// Time of the last good transfer [s]; -inf if there was none.
  double last_good() const noexcept { return good_; }
  /// Counts of arrived and rejected samples.
  const rejected_samples& rejections() const noexcept { return rejections_; }

 private:
  double hold_over_;
  rejected_samples rejections_;
  fault_record result_;
  bool lasts_ = false;
  double good_ = -std::numeric_limits<double>::infinity();
};

}  // namespace passive_haptics
