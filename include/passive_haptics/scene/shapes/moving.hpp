/// Moving shapes.
#pragma once

#include <passive_haptics/scene/shapes/shape_wrapper.hpp>

#include <utility>

namespace passive_haptics {

/// distance(x) = S(x - u) for a displacement u, which is set before each cycle. Displacement and velocity are
/// independent, so that a conveyor is a shape, too. Velocities of nested moving shapes add up. No bounds.
///
/// **Walls that move towards the hand.** Brakes only resist: the work against the push F_n of the hand must
/// come from the hand's own pull F_t along the wall, F_t v_t >= F_n v_wall. If the hand pulls less, it stops,
/// and the wall runs into it: 2 to 6 mm deep at 1 cm/s and 5 to 9 mm at 2 cm/s if the device deflects well,
/// without limit if no brake can turn the motion outward.
template <class S>
class moving : public shape_wrapper<S> {
 public:
  using shape_wrapper<S>::dimension;  ///< d

  /// The shape, at rest in its original place.
  explicit moving(S shape) : shape_wrapper<S>(std::move(shape)) {}

  /// Sets the displacement from the original place [m] and the velocity of the surface [m/s]; base frame.
  void set_motion(const point<dimension>& displacement, const point<dimension>& velocity) {
    set_displacement_ = displacement_ = displacement;
    velocity_ = velocity;
  }

  /// Extrapolates the motion by this time [s] from the values of set_motion.
  void extrapolate(double seconds) {
    displacement_ = set_displacement_ + seconds * velocity_;
    if constexpr (requires { this->shape_.extrapolate(seconds); }) this->shape_.extrapolate(seconds);
  }

  /// Signed distance [m].
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

/// moving(moving(s)) wraps twice instead of copying.
template <class S>
moving(moving<S>) -> moving<moving<S>>;

}  // namespace passive_haptics
