/// @file
/// The results of a device's transfers, and whether their faults last too long.
#pragma once

#include <passive_haptics/driver/checks/rejected_samples.hpp>
#include <passive_haptics/driver/fault.hpp>

#include <limits>

namespace passive_haptics {

/// The results of transfers of one kind: samples of the encoders or of the force sensor, or writes.
class transfer_watch {
 public:
  /// hold_over [s]: how long a fault may last.
  explicit transfer_watch(double hold_over) : hold_over_(hold_over), rejections_(hold_over) {}

  /// The result of a transfer at time `now` [s]; none if it was good.
  void add(const fault_record& result, double now) noexcept {
    result_ = result;
    rejections_.add(result.what, now);
    if (result.what == fault::none) good_ = now;
    lasts_ = now - good_ > hold_over_ || rejections_.is_too_many();
  }

  /// The last result.
  const fault_record& result() const noexcept { return result_; }
  /// True if the last result is a fault that cannot be bridged any more: one that releases_immediately(), one
  /// later than `hold_over` after the last good transfer, or one after too many rejected samples.
  bool fails() const noexcept {
    return result_.what != fault::none && (lasts_ || releases_immediately(result_));
  }
  /// True if the last transfer was good and not too many samples were rejected.
  bool is_good() const noexcept { return result_.what == fault::none && !rejections_.is_too_many(); }
  /// The time of the last good transfer [s]; -inf if there was none.
  double last_good() const noexcept { return good_; }
  /// The samples that arrived and that were rejected.
  const rejected_samples& rejections() const noexcept { return rejections_; }

 private:
  double hold_over_;
  rejected_samples rejections_;
  fault_record result_;
  bool lasts_ = false;
  double good_ = -std::numeric_limits<double>::infinity();
};

}  // namespace passive_haptics
