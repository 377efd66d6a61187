/// @file
/// Encoders: positions in whole counts, rates by differences.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/validate.hpp>
#include <passive_haptics/plant/first_order_lag.hpp>

#include <cmath>
#include <numbers>

namespace passive_haptics {

/// Encoders of all axes of a device.
struct encoder_parameters {
  /// One count, on the encoder's axis [rad, or m of a slide]; 8192 a turn. 0 is an ideal encoder, whose position and rate
  /// are exact and unfiltered.
  double resolution = 2 * std::numbers::pi / 8192;
  double rate_corner = 50;  ///< First-order low-pass of the differenced rates [Hz]; 0 for none.
};

/// What is wrong with the parameters; empty if nothing.
inline std::string validate(const encoder_parameters& p) {
  return detail::first_complaint(detail::check_not_negative("resolution [rad or m]", p.resolution),
                                 detail::check_not_negative("rate_corner [Hz]", p.rate_corner));
}

/// Encoders on N axes, read once a period: position = resolution floor(true position / resolution), so it is late by up
/// to one count; rate = difference of two positions / period, low-passed. The first reading starts at the true rate.
template <class T, int N>
class encoder {
 public:
  /// Read every period [s]. Throws std::invalid_argument with the text of validate(p) or if the period is not > 0.
  encoder(const encoder_parameters& p, double period)
      : resolution_(static_cast<T>(require_valid(p).resolution)),
        period_(static_cast<T>(period)),
        share_(p.rate_corner > 0
                   ? -std::expm1(-period_ / low_pass_time_constant(static_cast<T>(p.rate_corner)))
                   : T(1)) {
    require_no_complaint(detail::check_positive("period [s]", period));
  }

  /// One reading of axes at `position` [rad or m] that move with `rate` [rad/s or m/s].
  void read(const vector<T, N>& position, const vector<T, N>& rate) {
    if (!(resolution_ > T(0))) {
      position_ = position;
      rate_ = rate;
      return;
    }
    vector<T, N> count;
    for (int i = 0; i < N; ++i) count[i] = std::floor(position[i] / resolution_);
    if (first_) rate_ = rate;
    // Differences of counts are exact, those of positions are not
    else rate_ += share_ * ((count - count_) * (resolution_ / period_) - rate_);
    count_ = count;
    position_ = resolution_ * count;
    first_ = false;
  }

  /// Position as read [rad or m].
  const vector<T, N>& position() const { return position_; }
  /// Rate as estimated [rad/s or m/s].
  const vector<T, N>& rate() const { return rate_; }

 private:
  T resolution_, period_, share_;
  bool first_ = true;
  vector<T, N> count_ = vector<T, N>::Zero(), position_ = vector<T, N>::Zero(), rate_ = vector<T, N>::Zero();
};

/// Encoders of mechanism M and the joint positions and rates that a controller gets from them. They sit on the brakes'
/// axes if the transmission is constant, then q = T^+ theta and qd = T^+ w (the mean of what redundant brakes tell); on the joints if
/// the transmission depends on the pose, where a brake's angle is no function that a controller could invert.
template <class M>
class joint_encoders {
 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// Read every period [s]. Throws std::invalid_argument as encoder.
  joint_encoders(const M& mechanism, const encoder_parameters& p, double period)
      : encoder_(p, period), exact_(!(p.resolution > 0)) {
    if constexpr (on_brakes) {
      to_axes_ = wide(mechanism.transmission());
      to_joints_ = matrix<scalar, M::dof, M::brake_count>(pseudo_inverse(mechanism.transmission()));
    }
  }

  /// One reading of joints at q [rad or m] that move with qd [rad/s or m/s].
  void read(const joint_vector<M>& q, const joint_vector<M>& qd) {
    if constexpr (on_brakes) {
      encoder_.read(to_axes_ * q, to_axes_ * qd);
      // There and back through the transmission would round
      q_ = exact_ ? q : joint_vector<M>(to_joints_ * encoder_.position());
      qd_ = exact_ ? qd : joint_vector<M>(to_joints_ * encoder_.rate());
    } else {
      encoder_.read(q, qd);
      q_ = encoder_.position();
      qd_ = encoder_.rate();
    }
  }

  /// Joint positions as read [rad or m].
  const joint_vector<M>& q() const { return q_; }
  /// Joint rates as estimated [rad/s or m/s].
  const joint_vector<M>& qd() const { return qd_; }

 private:
  static constexpr bool on_brakes = detail::transmission_is_constant<M>;
  static constexpr int axes = on_brakes ? M::brake_count : M::dof;
  using wide = matrix<scalar, M::brake_count, M::dof>;

  encoder<scalar, axes> encoder_;
  bool exact_;
  wide to_axes_ = wide::Zero();
  matrix<scalar, M::dof, M::brake_count> to_joints_ = matrix<scalar, M::dof, M::brake_count>::Zero();
  joint_vector<M> q_ = joint_vector<M>::Zero(), qd_ = joint_vector<M>::Zero();
};

}  // namespace passive_haptics
