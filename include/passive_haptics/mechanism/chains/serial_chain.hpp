/// Planar or spatial serial chain of revolute and prismatic joints.
#pragma once

#include <passive_haptics/mechanism/chains/chain_pose.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_parameters.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// N joints in series, planar (D = 2) or spatial (D = 3), as a product of exponentials of joint screws S_i:
///
///     x = exp(S_1 q_1) ... exp(S_N q_N) x_0,   J_i = z_i x (x - p_i) (revolute),  z_i (prismatic),
///
/// with the axis z_i of joint i, a point p_i on it, and the handle x_0 in the zero pose. The task is a
/// position, without orientation. Each joint has a brake. A chain with N > D has self-motion. Singular if the
/// columns of J do not span the task, e.g. for a straight planar arm. Cost of position or jacobian: one sine
/// and cosine per revolute joint. For inertia see serial_chain_with_inertia.hpp.
template <class T, int N, int D>
class serial_chain {
  static_assert((D == 2 || D == 3) && N >= 2 && N >= D,
                "passive_haptics: serial_chain<T, N, D> needs D = 2 or 3 and N >= D joints.");

 public:
  using scalar = T;                         ///< Scalar type.
  static constexpr int dof = N;             ///< Joints n.
  static constexpr int task_dimension = D;  ///< Task dimensions d.
  static constexpr int brake_count = N;     ///< Brakes m.

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit serial_chain(const serial_chain_parameters<T, N, D>& p)
      : p_(require_valid(p)),
        joints_(joints_of(p)),
        tip_(p.handle - zero_point(size - 1)),
        frames_(joints_, tip_) {}

  /// Prevents slicing of derived classes.
  template <detail::extends<serial_chain> Larger>
  serial_chain(const Larger&) = delete;  // passive_haptics: would lose what the larger class adds
  /// Prevents slicing of derived classes.
  template <detail::extends<serial_chain> Larger>
  serial_chain& operator=(const Larger&) = delete;  // passive_haptics: would lose what the larger class adds

  const serial_chain_parameters<T, N, D>& parameters() const { return p_; }  ///< The parameters as given.

  /// End effector [m], base frame, for any scalar S that T converts to.
  template <class S = T>
  vector<S, D> position(const vector<S, N>& q) const {
    vector<S, D> x = tip_.template cast<S>();
    for (std::size_t i = size; i-- > 0;) {
      const S& qi = q[int(i)];
      if (joints_[i].turns) x = algebra::turned(joints_[i].axis, qi, x);
      else x += joints_[i].axis.template cast<S>() * qi;
      x += joints_[i].offset.template cast<S>();
    }
    return x;
  }

  /// J [m/rad, or 1 in the columns of prismatic joints].
  matrix<T, D, N> jacobian(const vector<T, N>& q) const { return jacobian(pose(q)); }

  /// End effector [m].
  const vector<T, D>& position(const chain_pose<T, N, D>& at) const { return at.handle; }

  /// J
  matrix<T, D, N> jacobian(const chain_pose<T, N, D>& at) const {
    matrix<T, D, N> J;
    unrolled<N>([&](int i) { J.col(i) = velocity(at, std::size_t(i)); });
    return J;
  }

  /// Joints and handle. Cost: one sine and cosine per revolute joint.
  chain_pose<T, N, D> pose(const vector<T, N>& q) const {
    return frames_.follow(q, [](std::size_t, const auto&) {});
  }

 protected:
  /// A pose with the orientations of the bodies.
  chain_bodies<T, N, D> bodies(const vector<T, N>& q) const {
    chain_bodies<T, N, D> at;
    const auto turn = [&](std::size_t i, const auto& A) { at.turn[i] = A(); };
    static_cast<chain_pose<T, N, D>&>(at) = frames_.follow(q, turn);
    for (std::size_t i = 0; i < size; ++i) {
      at.rotation[i].setZero();
      at.sliding[i].setZero();
      if (!joints_[i].turns) at.sliding[i] = at.axis[i];
      else if constexpr (D == 2) at.rotation[i][0] = T(1);
      else at.rotation[i] = at.axis[i];
    }
    return at;
  }

  /// Reference point of body i in the zero pose [m].
  vector<T, D> zero_point(std::size_t i) const {
    vector<T, D> p = vector<T, D>::Zero();
    for (std::size_t k = 0; k <= i; ++k) p += joints_[k].offset;
    return p;
  }

  /// Orientation of the frame of body i in the zero pose.
  matrix<T, D, D> zero_turn(std::size_t i) const { return frames_.zero(i); }

 private:
  using algebra = detail::rigid_body_algebra<T, D>;
  static constexpr std::size_t size = std::size_t(N);
  using joints = std::array<detail::zero_pose_joint<T, D>, size>;

  // Handle velocity per unit rate of joint i
  vector<T, D> velocity(const chain_pose<T, N, D>& at, std::size_t i) const {
    if (!joints_[i].turns) return at.axis[i];
    const vector<T, D> r = at.handle - at.point[i];
    if constexpr (D == 2) return {-r[1], r[0]};
    else return cross(at.axis[i], r);
  }

  static joints joints_of(const serial_chain_parameters<T, N, D>& p) {
    joints all;
    vector<T, D> previous = vector<T, D>::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      auto& to = all[i];
      to.turns = p.joints[i].kind == joint_kind::revolute;
      // A prismatic joint has no point, so its body is measured from the previous point
      const vector<T, D> point = to.turns ? p.joints[i].point : previous;
      to.axis = to.turns && D == 2 ? vector<T, D>::Zero().eval() : direction_of(p.joints[i].axis);
      to.offset = point - previous;
      previous = point;
    }
    return all;
  }

  serial_chain_parameters<T, N, D> p_;
  joints joints_;
  vector<T, D> tip_;  // from the point of the last body to the handle [m], zero pose
  detail::chain_frames<T, N, D> frames_;
};

}  // namespace passive_haptics
