/// Encoders: quantised positions and differenced rates.
#pragma once

#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <numbers>

namespace passive_haptics {

/// Parameters of the encoders of a device.
struct encoder_parameters {
  /// One count [rad or m]; 0 is an ideal encoder with exact, unfiltered position and rate.
  double resolution = 2 * std::numbers::pi / 8192;
  double rate_corner = 50;  ///< Low-pass corner of the differenced rates [Hz]; 0 for none.

  static constexpr auto members() {
    using p = encoder_parameters;
    return member_table(member("resolution", &p::resolution, "rad or m", range::not_negative),
                        member("rate_corner", &p::rate_corner, "Hz", range::not_negative));
  }
};

/// Encoders on N axes, read once per period: position = resolution floor(true position / resolution), rate =
/// low-passed difference of two positions / period. The first reading starts at the true rate.
template <class T, int N>
class encoder {
 public:
  /// Sets the period [s]. Throws std::invalid_argument for invalid parameters or period.
  encoder(const encoder_parameters& p, double period)
      : resolution_(static_cast<T>(require_valid(p).resolution)),
        period_(static_cast<T>(period)),
        share_(lag_share(period_, low_pass_time_constant(static_cast<T>(p.rate_corner)))) {
    require_no_error(check_value("period", period, "s", range::positive));
  }

  /// Reads axes at `position` [rad or m] with `rate` [rad/s or m/s].
  void read(const vector<T, N>& position, const vector<T, N>& rate) {
    if (!(resolution_ > T(0))) {
      position_ = position;
      rate_ = rate;
      return;
    }
    const vector<T, N> count = (position / resolution_).array().floor();
    if (first_) rate_ = rate;
    // Differences of counts are exact, those of positions are not
    else rate_ += share_ * ((count - count_) * (resolution_ / period_) - rate_);
    count_ = count;
    position_ = resolution_ * count;
    first_ = false;
  }

  const vector<T, N>& position() const { return position_; }  ///< Measured position [rad or m].
  const vector<T, N>& rate() const { return rate_; }          ///< Estimated rate [rad/s or m/s].

 private:
  T resolution_, period_, share_;
  bool first_ = true;
  vector<T, N> count_ = vector<T, N>::Zero(), position_ = vector<T, N>::Zero(), rate_ = vector<T, N>::Zero();
};

/// Encoders on the encoder_axes of mechanism M, converted to joint positions and rates.
template <class M>
class joint_encoders {
 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// Sets the period [s]. Throws std::invalid_argument as encoder.
  joint_encoders(const M& mechanism, const encoder_parameters& p, double period)
      : axes_(mechanism), encoder_(p, period), exact_(!(p.resolution > 0)) {}

  /// Reads joints at q [rad or m] with rates qd [rad/s or m/s].
  void read(const joint_vector<M>& q, const joint_vector<M>& qd) {
    encoder_.read(axes_.from_joints(q), axes_.from_joints(qd));
    // Avoids rounding by the transmission and its inverse
    q_ = exact_ ? q : axes_.to_joints(encoder_.position());
    qd_ = exact_ ? qd : axes_.to_joints(encoder_.rate());
  }

  const joint_vector<M>& q() const { return q_; }    ///< Measured joint positions [rad or m].
  const joint_vector<M>& qd() const { return qd_; }  ///< Estimated joint rates [rad/s or m/s].

 private:
  encoder_axes<M> axes_;
  encoder<scalar, encoder_axes<M>::count> encoder_;
  bool exact_;
  joint_vector<M> q_ = joint_vector<M>::Zero(), qd_ = joint_vector<M>::Zero();
};

}  // namespace passive_haptics
