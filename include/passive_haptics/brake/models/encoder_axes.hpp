/// Encoder axes of a mechanism, and the joint positions from them.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>

namespace passive_haptics {

/// Encoder axes theta of mechanism M. With a constant transmission and m >= n, these are the brake axes:
/// theta = T q and q = T^+ theta. Otherwise they are the joints.
template <class M>
class encoder_axes {
 public:
  using scalar = typename M::scalar;  ///< Scalar type.
  /// True if the axes are those of the brakes.
  static constexpr bool on_brakes = detail::transmission_is_constant<M> && M::brake_count >= M::dof;
  static constexpr int count = on_brakes ? M::brake_count : M::dof;  ///< Number of axes.

  /// Axes of this mechanism. to_joints returns NaN if T does not have full column rank.
  explicit encoder_axes(const M& mechanism) {
    if constexpr (on_brakes) {
      to_axes_ = wide(mechanism.transmission());
      to_joints_ = tall(pseudo_inverse(mechanism.transmission()));
    }
  }

  /// Axis positions [rad or m] for joint positions, or axis rates for joint rates.
  vector<scalar, count> from_joints(const joint_vector<M>& q) const noexcept {
    if constexpr (on_brakes) return vector<scalar, count>(to_axes_ * q);
    else return q;
  }

  /// Joint positions [rad or m] for axis positions, or joint rates for axis rates.
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
