/// @file
/// From a force sensor's channels to the force of the hand in the base frame.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>

#include <limits>
#include <string>

namespace passive_haptics {

/// The sensor's orientation as a mechanism moves: joint positions [rad or m] -> R (d x d, a rotation), which
/// turns the sensor's frame to the base frame: its columns are the sensor's axes.
template <class F, int Dof, int Dimension>
concept SensorFrame = requires(const F frame, const vector<double, Dof> q) {
  { frame(q) } -> ExactMatrix<double, Dimension, Dimension>;
};

/// A sensor that does not turn, as on an xy_table.
template <int Dimension>
struct fixed_sensor_frame {
  /// Its axes, as columns in the base frame.
  matrix<double, Dimension, Dimension> rotation = matrix<double, Dimension, Dimension>::Identity();
  /// R, in any pose.
  template <int Dof>
  matrix<double, Dimension, Dimension> operator()(const vector<double, Dof>&) const noexcept {
    return rotation;
  }
};

/// A sensor on a link of a planar mechanism, at the angle link . q + mounting.
template <int Dof>
struct planar_sensor_frame {
  /// The link's angle in joint angles: {1, 1} on the last link where q2 is measured from link 1 (two_link,
  /// tendon_two_link), {0, 1} where it is measured from the base, {0, 0} where the sensor does not turn.
  /// There is no default: a wrong one would turn the forces.
  vector<double, Dof> link = vector<double, Dof>::Constant(std::numeric_limits<double>::quiet_NaN());
  double mounting = 0;  ///< From the link to the sensor's x axis [rad].

  /// The table of core/parameters.hpp.
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

/// A force sensor between last link and handle, its d force components from Channels raw values.
template <int Dimension, int Channels = Dimension>
struct force_calibration_parameters {
  static_assert(Channels >= Dimension, "passive_haptics: a force sensor needs a channel for each dimension.");
  /// Force in the sensor's frame [N] for each unit of a raw value: what the handle does to the sensor. The
  /// sensor's sign is right if a push along its x axis reads positive. Default: the first d channels are
  /// these forces in N.
  matrix<double, Dimension, Channels> newtons_per_unit = matrix<double, Dimension, Channels>::Identity();
  /// What it reads without a load, in its frame [N]; taring finds it.
  vector<double, Dimension> tare = vector<double, Dimension>::Zero();
  double handle_mass = 0;  ///< Of all that hangs on the sensor [kg].
  /// Of the base frame [m/s^2]: 0 in a horizontal plane.
  vector<double, Dimension> gravity = vector<double, Dimension>::Zero();

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = force_calibration_parameters;
    return member_table(member("newtons_per_unit", &p::newtons_per_unit, "N", range::finite),
                        member("tare", &p::tare, "N", range::finite),
                        member("handle_mass", &p::handle_mass, "kg", range::not_negative),
                        member("gravity", &p::gravity, "m/s^2", range::finite));
  }
  /// The channels distinguish all directions, and gravity has a mass to pull at.
  std::string rules() const {
    if (!all_finite(pseudo_inverse(transposed(newtons_per_unit))))
      return "newtons_per_unit has dependent rows, expected one that distinguishes all directions";
    if (handle_mass > 0 || gravity.isZero(0)) return {};
    return detail::error_text("handle_mass [kg]", handle_mass,
                              "> 0 where gravity is given, as nothing else reads it; weigh the handle, or "
                              "leave gravity out");
  }
};

/// Force of the hand on the handle, base frame:
///
///     F = R (C raw - tare) - m g.
///
/// Not taken out: the handle's inertia, m times its acceleration, which a sensor between link and handle
/// reads, too.
template <int Dimension, int Channels = Dimension>
class force_calibration {
 public:
  using parameters = force_calibration_parameters<Dimension, Channels>;  ///< What it is made of.
  using rotation = matrix<double, Dimension, Dimension>;                 ///< From a SensorFrame.
  using readings = vector<double, Channels>;                             ///< Raw values.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit force_calibration(const parameters& p = {})
      : p_(require_valid(p)), weight_(p.handle_mass * p.gravity) {}

  /// Force of the hand [N], base frame. Cost: two products.
  vector<double, Dimension> force(const readings& raw, const rotation& R) const noexcept {
    return R * (p_.newtons_per_unit * raw - p_.tare) - weight_;
  }

  /// The tare [N], sensor's frame, of mean readings with the hand off, in a pose with R: what is left without
  /// the handle's weight.
  vector<double, Dimension> tare_of(const readings& raw, const rotation& R) const noexcept {
    return p_.newtons_per_unit * raw - R.transpose() * weight_;
  }

  /// The tare that is in use [N].
  const vector<double, Dimension>& tare() const noexcept { return p_.tare; }
  /// From here on this is the tare [N]; other than finite numbers change nothing.
  void set_tare(const vector<double, Dimension>& tare) noexcept {
    if (all_finite(tare)) p_.tare = tare;
  }

 private:
  parameters p_;
  vector<double, Dimension> weight_;
};

}  // namespace passive_haptics
