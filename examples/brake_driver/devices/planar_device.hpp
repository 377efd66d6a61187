/// @file
/// A mechanism of the catalogue as this program drives it: two joints and two brakes in the plane.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/runtime/any_mechanism.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// The sizes of all devices of this program.
inline constexpr int axes = 2;

/// A mechanism for device_calibration: the position of its handle, and the axes of its encoders.
class planar_device {
 public:
  using scalar = double;
  static constexpr int dof = axes, task_dimension = 2, brake_count = axes;
  using pair = ph::vector<double, 2>;

  /// Holds a mechanism with these sizes.
  explicit planar_device(std::shared_ptr<const ph::runtime::any_mechanism> of)
      : transmission_(of->encoders().from_joints.data()), of_(std::move(of)) {}

  /// True for the sizes of a mechanism that fits.
  static bool fits(const ph::runtime::device_sizes& sizes) {
    return sizes == ph::runtime::device_sizes{dof, task_dimension, brake_count};
  }

  pair position(const pair& q) const { return pair(of_->position({q.data(), axes}).data()); }
  ph::matrix<double, 2, 2> transmission() const { return transmission_; }

 private:
  ph::matrix<double, 2, 2> transmission_;
  std::shared_ptr<const ph::runtime::any_mechanism> of_;
};

/// Rotating and sliding joints of a mechanism, found by its motion: a turn ends where it began.
struct joint_motion {
  std::array<bool, axes> slides{};       ///< Of each joint.
  std::array<bool, axes> axis_slides{};  ///< Of the axis of each encoder.
  /// The first joint rotates nothing or the whole mechanism, as that of a serial chain does, so that the last
  /// link rotates by the sum of the angles.
  bool angles_add_up = true;

  /// Moves this mechanism, which fits a planar_device.
  explicit joint_motion(const ph::runtime::any_mechanism& of) {
    using pair = ph::vector<double, 2>;
    using square = ph::matrix<double, 2, 2>;
    using std::numbers::pi;
    const auto position = [&](const pair& q) { return pair(of.position({q.data(), axes}).data()); };
    const auto jacobian = [&](const pair& q) {
      square J;
      of.jacobian({q.data(), axes}, {J.data(), 2 * axes});
      return J;
    };
    const pair somewhere(1.9, 1.2);
    const auto is_far = [&](const pair& a, const pair& b) { return (a - b).norm() > 1e-6; };  // no for NaN
    for (int i = 0; i < axes; ++i)
      slides[static_cast<std::size_t>(i)] =
          is_far(position(somewhere), position(somewhere + 2 * pi * pair::Unit(i)));
    const auto maps = of.encoders();
    for (std::size_t axis = 0; axis < axis_slides.size(); ++axis)
      for (std::size_t joint = 0; joint < slides.size(); ++joint)
        if (slides[joint] && maps.from_joints[joint * axes + axis] != 0) axis_slides[axis] = true;
    if (slides[0]) return;
    const double c = std::cos(pi / 6), s = std::sin(pi / 6);
    const square rotated = ph::matrix_of<2, 2>(c, -s, s, c) * jacobian(somewhere);
    angles_add_up = (jacobian(somewhere + pi / 6 * pair::UnitX()) - rotated).norm() < 1e-6;
  }

  /// True if all joints slide, or, by `false`, if all rotate.
  bool all(bool slide) const { return std::ranges::count(slides, slide) == axes; }
};

}  // namespace example
