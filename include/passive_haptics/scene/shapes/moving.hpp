/// @file
/// A shape that is carried along.
#pragma once

#include <passive_haptics/scene/shapes/shape_wrapper.hpp>

#include <utility>

namespace passive_haptics {

/// distance(x) = S(x - u) for a displacement u, and its velocity for the contacts. Motion comes from outside:
/// set it before each cycle. It is not checked here; a step reports a displacement or velocity that is not
/// finite.
///
/// Displacement and velocity are two values, so that a conveyor (velocity, no displacement) is a shape too.
/// Of a moving shape inside another the velocities add. It provides no bounds, as they would move.
///
/// **A wall that moves towards the hand.** Brakes hold, they do not push: the work against the push F_n of
/// the hand comes from the hand's own pull F_t along the wall, F_t v_t >= F_n v_wall. A hand that pulls less
/// stops, and the wall runs into it at v_wall until it pulls enough: at 1 cm/s 2 to 6 mm, at 2 cm/s 5 to 9 mm
/// deep where the device deflects well, without end where no brake can turn the motion outward. A wall
/// that moves away, or along its surface, is followed as one at rest.
template <class S>
class moving : public shape_wrapper<S> {
 public:
  using shape_wrapper<S>::dimension;  ///< d

  /// The shape, at rest and where it is.
  explicit moving(S shape) : shape_wrapper<S>(std::move(shape)) {}

  /// Displacement from where the shape was made [m], and velocity of its surface [m/s]; base frame.
  void set_motion(const point<dimension>& displacement, const point<dimension>& velocity) {
    set_displacement_ = displacement_ = displacement;
    velocity_ = velocity;
  }

  /// Carries the shape on with its velocity for this time [s] from where set_motion put it.
  void extrapolate(double seconds) {
    displacement_ = set_displacement_ + seconds * velocity_;
    if constexpr (requires { this->shape_.extrapolate(seconds); }) this->shape_.extrapolate(seconds);
  }

  /// Signed distance [m]; that of the shape and D subtractions.
  double distance(const point<dimension>& x) const { return this->shape_.distance(x - displacement_); }

  /// Gradient of the displaced shape.
  point<dimension> gradient(const point<dimension>& x) const {
    return this->shape_.gradient(x - displacement_);
  }

  /// Velocity of the surface [m/s].
  point<dimension> velocity(const point<dimension>& x) const {
    return velocity_ + surface_velocity(this->shape_, point<dimension>(x - displacement_));
  }

  /// Hessian of the displaced shape [1/m].
  matrix<double, dimension, dimension> hessian(const point<dimension>& x) const
    requires CurvedShape<S>
  {
    return this->shape_.hessian(x - displacement_);
  }

 private:
  point<dimension> set_displacement_ = point<dimension>::Zero();
  point<dimension> displacement_ = point<dimension>::Zero();  // in this cycle
  point<dimension> velocity_ = point<dimension>::Zero();
};

/// moving(moving(s)) is carried twice, not a copy.
template <class S>
moving(moving<S>) -> moving<moving<S>>;

}  // namespace passive_haptics
