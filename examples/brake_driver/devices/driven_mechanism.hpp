/// A mechanism of the catalogue for this program: planar or spatial, with up to eight encoders and brakes.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/runtime/any_mechanism.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>

namespace example {

namespace ph = passive_haptics;

/// Maximum number of encoders, joints and brakes.
inline constexpr int max_axes = ph::runtime::max_joints;
/// One number each, 0 if the device has fewer.
using axis_numbers = ph::vector<double, max_axes>;
/// A position or a force; z = 0 for planar devices.
using spatial = ph::vector<double, 3>;

/// Numbers of a device, padded with zeros.
template <class Numbers>
Numbers filled_up(std::span<const double> given) {
  Numbers all = Numbers::Zero();
  std::ranges::copy(given, all.data());
  return all;
}

/// A mechanism for device_calibration, with the encoder axes as joints.
class driven_mechanism {
 public:
  using scalar = double;
  static constexpr int dof = max_axes, task_dimension = 3, brake_count = max_axes;

  driven_mechanism() = default;
  explicit driven_mechanism(std::shared_ptr<const ph::runtime::any_mechanism> of)
      : sizes_(of->sizes()), encoders_(of->encoders().count), of_(std::move(of)) {
    const auto maps = of_->encoders();
    for (int i = 0; i < joints(); ++i)
      to_axes_.col(i) = filled_up<axis_numbers>(numbers(maps.from_joints, i * encoders_, encoders_));
    for (int i = 0; i < encoders_; ++i)
      to_joints_.col(i) = filled_up<axis_numbers>(numbers(maps.to_joints, i * joints(), joints()));
  }

  const ph::runtime::any_mechanism& of() const { return *of_; }
  const ph::runtime::device_sizes& sizes() const { return sizes_; }
  int joints() const { return sizes_.dof; }
  int dimension() const { return sizes_.task_dimension; }
  int brakes() const { return sizes_.brake_count; }
  int encoders() const { return encoders_; }

  /// Handle [m] at these encoder axes [rad or m].
  spatial position(const axis_numbers& axes) const { return handle(joint_positions(axes)); }
  /// Handle [m] at these joint positions [rad or m].
  spatial handle(const axis_numbers& q) const {
    return filled_up<spatial>(of_->position({q.data(), static_cast<std::size_t>(joints())}));
  }
  /// Joint positions or rates from those of the axes.
  axis_numbers joint_positions(const axis_numbers& axes) const { return to_joints_ * axes; }
  /// Axis positions or rates from those of the joints.
  axis_numbers axis_positions(const axis_numbers& q) const { return to_axes_ * q; }

 private:
  template <class Values>
  static std::span<const double> numbers(const Values& all, int first, int count) {
    return std::span(all).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
  }

  ph::runtime::device_sizes sizes_;
  int encoders_ = 0;
  ph::matrix<double, max_axes, max_axes> to_axes_ = ph::matrix<double, max_axes, max_axes>::Zero();
  ph::matrix<double, max_axes, max_axes> to_joints_ = ph::matrix<double, max_axes, max_axes>::Zero();
  std::shared_ptr<const ph::runtime::any_mechanism> of_;
};

/// Rotating and sliding joints of a mechanism, detected by its motion: a full turn has no effect.
struct joint_motion {
  int joints = 0;                            ///< Number of joints.
  std::array<bool, max_axes> slides{};       ///< By joint.
  std::array<bool, max_axes> axis_slides{};  ///< By encoder axis.
  /// Planar: the first joint rotates nothing or the whole mechanism, as in a serial chain, so that the last
  /// link rotates by the sum of the angles.
  bool angles_add_up = true;

  /// Examines this mechanism.
  explicit joint_motion(const driven_mechanism& of) : joints(of.joints()) {
    using std::numbers::pi;
    axis_numbers somewhere = axis_numbers::Zero();
    for (int i = 0; i < joints; ++i) somewhere[i] = i % 2 == 0 ? 1.9 : 1.2;
    const auto is_far = [](const spatial& a, const spatial& b) {
      return (a - b).norm() > 1e-6;  // false for NaN
    };
    for (int i = 0; i < joints; ++i) {
      const axis_numbers turned = somewhere + 2 * pi * axis_numbers::Unit(i);
      if (!is_far(of.handle(somewhere), of.handle(turned))) continue;
      slides[static_cast<std::size_t>(i)] = true;
      const axis_numbers moved = of.axis_positions(axis_numbers::Unit(i));
      for (int axis = 0; axis < of.encoders(); ++axis)
        if (moved[axis] != 0) axis_slides[static_cast<std::size_t>(axis)] = true;
    }
    if (slides[0] || of.dimension() != 2) return;
    const auto jacobian = [&](const axis_numbers& q) {
      ph::matrix<double, 2, max_axes> J = ph::matrix<double, 2, max_axes>::Zero();
      of.of().jacobian({q.data(), static_cast<std::size_t>(joints)},
                       {J.data(), static_cast<std::size_t>(2 * joints)});
      return J;
    };
    const double c = std::cos(pi / 6), s = std::sin(pi / 6);
    const ph::matrix<double, 2, max_axes> rotated = ph::matrix_of<2, 2>(c, -s, s, c) * jacobian(somewhere);
    angles_add_up = (jacobian(somewhere + pi / 6 * axis_numbers::UnitX()) - rotated).norm() < 1e-6;
  }

  /// True if all joints slide; all(false): if all rotate.
  bool all(bool slide) const { return std::count(slides.begin(), slides.begin() + joints, slide) == joints; }
};

}  // namespace example
