/// Conversion of force sensor channels to the hand force in the base frame.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>

#include <limits>
#include <string>

namespace passive_haptics {

/// Orientation of the sensor: joint positions [rad or m] -> rotation R (d x d) from the sensor's frame to the
/// base frame, with the sensor's axes as columns.
template <class F, int Dof, int Dimension>
concept SensorFrame = requires(const F frame, const vector<double, Dof> q) {
  { frame(q) } -> ExactMatrix<double, Dimension, Dimension>;
};

/// A sensor that does not rotate, as on an xy_table.
template <int Dimension>
struct fixed_sensor_frame {
  /// Sensor axes as columns, base frame.
  matrix<double, Dimension, Dimension> rotation = matrix<double, Dimension, Dimension>::Identity();
  /// R, for any pose.
  template <int Dof>
  matrix<double, Dimension, Dimension> operator()(const vector<double, Dof>&) const noexcept {
    return rotation;
  }
};

/// A sensor on a link of a planar mechanism, at the angle link . q + mounting.
template <int Dof>
struct planar_sensor_frame {
  /// Angle of the link in joint angles, without default: {1, 1} on the last link if q2 is relative to link 1
  /// (two_link, tendon_two_link), {0, 1} if it is relative to the base, {0, 0} for a sensor that does not
  /// rotate.
  vector<double, Dof> link = vector<double, Dof>::Constant(std::numeric_limits<double>::quiet_NaN());
  double mounting = 0;  ///< From the link to the sensor's x axis [rad].

  static constexpr auto members() {
    using p = planar_sensor_frame;
    return member_table(
        member(
            "link", &p::link, "1",
            range::finite.as("a finite number; set link to {1, 1} on the last link of a two_link or "
                             "tendon_two_link, {0, 1} where q2 is measured from the base, {0, 0} where the "
                             "sensor does not turn"))
            .suspicious_above(100),
        member("mounting", &p::mounting, "rad", range::finite));
  }
  /// R(q).
  matrix<double, 2, 2> operator()(const vector<double, Dof>& q) const noexcept {
    const auto [s, c] = sine_cosine(link.dot(q) + mounting);
    return matrix_of<2, 2>(c, -s, s, c);
  }
};

/// Parameters of a force sensor between last link and handle.
template <int Dimension, int Channels = Dimension>
struct force_calibration_parameters {
  static_assert(Channels >= Dimension, "passive_haptics: a force sensor needs a channel for each dimension.");
  /// Force in the sensor's frame [N] per raw unit: force of the handle on the sensor, positive for a push
  /// along the sensor's x axis. Default: the first d channels in N.
  matrix<double, Dimension, Channels> newtons_per_unit = matrix<double, Dimension, Channels>::Identity();
  /// Reading without load in the sensor's frame [N]; see taring.
  vector<double, Dimension> tare = vector<double, Dimension>::Zero();
  double handle_mass = 0;  ///< Mass supported by the sensor [kg].
  /// In the base frame [m/s^2]; 0 for a horizontal plane.
  vector<double, Dimension> gravity = vector<double, Dimension>::Zero();

  static constexpr auto members() {
    using p = force_calibration_parameters;
    return member_table(member("newtons_per_unit", &p::newtons_per_unit, "N", range::finite),
                        member("tare", &p::tare, "N", range::finite),
                        member("handle_mass", &p::handle_mass, "kg", range::not_negative),
                        member("gravity", &p::gravity, "m/s^2", range::finite));
  }
  /// Requires channels that distinguish all directions, and a mass if gravity is given.
  std::string rules() const {
    if (!all_finite(pseudo_inverse(transposed(newtons_per_unit))))
      return "newtons_per_unit has dependent rows: expected independent rows: measure each direction by "
             "itself";
    if (handle_mass > 0 || gravity.isZero(0)) return {};
    return detail::error_text(
        "handle_mass [kg]", handle_mass,
        "> 0 if gravity is given, as gravity acts on nothing else; weigh the handle, or "
        "remove gravity");
  }
};

/// Force of the hand on the handle, base frame:
///
///     F = R (C raw - tare) - m g.
///
/// The handle's inertia force is not compensated.
template <int Dimension, int Channels = Dimension>
class force_calibration {
 public:
  using parameters = force_calibration_parameters<Dimension, Channels>;  ///< Parameters.
  using rotation = matrix<double, Dimension, Dimension>;                 ///< From a SensorFrame.
  using readings = vector<double, Channels>;                             ///< Raw values.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit force_calibration(const parameters& p = {})
      : p_(require_valid(p)), weight_(p.handle_mass * p.gravity) {}

  /// Hand force [N], base frame.
  vector<double, Dimension> force(const readings& raw, const rotation& R) const noexcept {
    return R * (p_.newtons_per_unit * raw - p_.tare) - weight_;
  }

  /// Tare [N] in the sensor's frame, from mean readings without the hand in a pose with R.
  vector<double, Dimension> tare_of(const readings& raw, const rotation& R) const noexcept {
    return p_.newtons_per_unit * raw - R.transpose() * weight_;
  }

  const vector<double, Dimension>& tare() const noexcept { return p_.tare; }  ///< Current tare [N].
  /// Sets the tare [N]; ignores values that are not finite.
  void set_tare(const vector<double, Dimension>& tare) noexcept {
    if (all_finite(tare)) p_.tare = tare;
  }

 private:
  parameters p_;
  vector<double, Dimension> weight_;
};

}  // namespace passive_haptics
