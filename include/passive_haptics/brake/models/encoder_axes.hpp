/// @file
/// The axes that the encoders of a mechanism turn with, and the joint positions that follow from them.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>

namespace passive_haptics {

/// The encoders' axes theta of mechanism M. Where the transmission is constant, they are the brakes' axes:
/// theta = T q and q = T^+ theta (the mean of what redundant brakes give). Where the transmission depends on
/// the pose, where there is none, or where not all joints have a brake, they are the joints: the brakes'
/// angles then do not give those of the joints.
template <class M>
class encoder_axes {
 public:
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.
  /// Whether they are the brakes' axes.
  static constexpr bool on_brakes = detail::transmission_is_constant<M> && M::brake_count >= M::dof;
  /// How many.
  static constexpr int count = on_brakes ? M::brake_count : M::dof;

  /// Of the mechanism. NaN comes out of to_joints where T has not full column rank.
  explicit encoder_axes(const M& mechanism) {
    if constexpr (on_brakes) {
      to_axes_ = wide(mechanism.transmission());
      to_joints_ = tall(pseudo_inverse(mechanism.transmission()));
    }
  }

  /// Axis positions [rad or m] of joint positions, or axis rates of joint rates.
  vector<scalar, count> from_joints(const joint_vector<M>& q) const noexcept {
    if constexpr (on_brakes) return vector<scalar, count>(to_axes_ * q);
    else return q;
  }

  /// Joint positions [rad or m] of axis positions, or joint rates of axis rates.
  joint_vector<M> to_joints(const vector<scalar, count>& theta) const noexcept {
    if constexpr (on_brakes) return joint_vector<M>(to_joints_ * theta);
    else return theta;
  }

 private:
  using wide = transmission_matrix<M>;
  using tall = matrix<scalar, M::dof, M::brake_count>;
  wide to_axes_ = wide::Zero();
  tall to_joints_ = tall::Zero();
};

}  // namespace passive_haptics
