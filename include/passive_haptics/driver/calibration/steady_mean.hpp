/// Mean of readings at rest, for homing and taring.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// Parameters of steady_mean.
struct steady_parameters {
  double duration = 0.5;  ///< Duration of the mean [s].
  double tolerance = 3;   ///< Maximum range of a reading, in its unit (counts).
  double max_gap = 0.02;  ///< Maximum time between two readings [s].

  static constexpr auto members() {
    using p = steady_parameters;
    return member_table(
        member("duration", &p::duration, "s", range::positive).suspicious_above(600),
        member("tolerance", &p::tolerance, "counts", range::not_negative).suspicious_above(1e6),
        member("max_gap", &p::max_gap, "s", range::positive).suspicious_above(10));
  }
};

/// Progress of a steady_mean.
enum class steady_status {
  collecting,   ///< Steady so far.
  moved,        ///< A reading exceeded the tolerance: restarted with it.
  interrupted,  ///< A reading was not finite, late, or its time did not increase: restarted.
  done,         ///< The mean is complete; further readings are ignored.
};

/// Text of the status.
constexpr std::string_view to_string(steady_status s) {
  return detail::word_of(s, {"collecting", "moved: started again", "interrupted: started again", "done",
                             "unknown steady status"});
}

/// Mean of N readings over a time in which none varied by more than a tolerance.
template <int N>
class steady_mean {
 public:
  /// Throws std::invalid_argument with the text of validate(p).
  explicit steady_mean(const steady_parameters& p = {}) : p_(require_valid(p)) {}

  /// Adds readings at a time [s].
  steady_status add(double time, const vector<double, N>& reading) noexcept {
    if (status_ == steady_status::done) return status_;
    if (!std::isfinite(time) || !all_finite(reading)) {
      reset();
      return status_ = steady_status::interrupted;
    }
    if (count_ == 0) return begin(time, reading, steady_status::collecting);
    if (!(time > last_) || time - last_ > p_.max_gap) return begin(time, reading, steady_status::interrupted);
    min_ = min_.cwiseMin(reading);
    max_ = max_.cwiseMax(reading);
    if ((max_ - min_).maxCoeff() > p_.tolerance) return begin(time, reading, steady_status::moved);
    last_ = time;
    sum_ += reading - first_;
    count_ += 1;
    return status_ = time - start_ < p_.duration ? steady_status::collecting : steady_status::done;
  }

  steady_status status() const noexcept { return status_; }  ///< Result of the last add().

  /// Mean in the unit of the readings; NaN until done.
  vector<double, N> mean() const noexcept {
    if (status_ == steady_status::done) return first_ + sum_ / count_;
    return vector<double, N>::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  /// Restarts.
  void reset() noexcept {
    count_ = 0;
    status_ = steady_status::collecting;
  }

 private:
  steady_status begin(double time, const vector<double, N>& reading, steady_status why) noexcept {
    first_ = min_ = max_ = reading;
    sum_.setZero();
    count_ = 1;
    start_ = last_ = time;
    return status_ = why;
  }

  steady_parameters p_;
  steady_status status_ = steady_status::collecting;
  vector<double, N> first_ = vector<double, N>::Zero(), min_ = first_, max_ = first_, sum_ = first_;
  double start_ = 0, last_ = 0, count_ = 0;
};

}  // namespace passive_haptics
