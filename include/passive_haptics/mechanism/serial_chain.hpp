/// @file
/// Any serial chain of revolute and prismatic joints, in the plane or in space.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>
#include <passive_haptics/mechanism/serial_chain_parameters.hpp>
#include <passive_haptics/mechanism/turning.hpp>

namespace passive_haptics {

/// Where the joints of a chain are in a pose, base frame. With the angular and linear part of each joint's
/// motion, revolute and prismatic joints obey the same formulas.
template <class T, int N, int D>
struct chain_pose {
  std::array<matrix<T, D, D>, N> turn;  ///< Orientation of body i relative to the zero pose.
  std::array<vector<T, D>, N> point;    ///< The point of body i that lies on its joint [m].
  std::array<angular_vector<T, D>, N>
      turning;                          ///< Angular velocity per unit rate of joint i; 0 if it slides.
  std::array<vector<T, D>, N> sliding;  ///< Velocity per unit rate of joint i; 0 if it turns.
  vector<T, D> handle;                  ///< End effector [m].
};

/// N joints in series, planar (D = 2) or spatial (D = 3), a product of exponentials of joint screws S_i:
///
///     x = exp(S_1 q_1) ... exp(S_N q_N) x_0,   J_i = z_i x (x - p_i) (revolute),  z_i (prismatic),
///
/// z_i and p_i the axis of joint i and a point on it in the pose, x_0 the handle in the zero pose. Task:
/// position only. A brake on each joint. More joints than task dimensions (N > D) is a device with
/// self-motion. Singular where the columns of J do not span the task, e.g. a straight planar arm. Cost of
/// position or jacobian: one sine and one cosine for each revolute joint. For inertia see
/// serial_chain_with_inertia.hpp.
template <class T, int N, int D>
class serial_chain {
  static_assert((D == 2 || D == 3) && N >= 2 && N >= D,
                "passive_haptics: serial_chain<T, N, D> needs D = 2 or 3 and N >= D joints.");

 public:
  using scalar = T;                         ///< Scalar of all lengths and angles.
  static constexpr int dof = N;             ///< n
  static constexpr int task_dimension = D;  ///< d
  static constexpr int brake_count = N;     ///< m

  /// Throws std::invalid_argument with the text of validate(p).
  explicit serial_chain(const serial_chain_parameters<T, N, D>& p) : p_(require_valid(p)) {
    vector<T, D> previous = vector<T, D>::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      joint& to = joints_[i];
      to.turns = p.joints[i].kind == joint_kind::revolute;
      // A slide has no point of its own: its body is measured from the point before
      const vector<T, D> point = to.turns ? p.joints[i].point : previous;
      to.axis = to.turns && D == 2 ? vector<T, D>::Zero().eval() : p.joints[i].axis.stableNormalized();
      to.offset = point - previous;
      previous = point;
    }
    tip_ = p.handle - previous;
  }

  /// The parameters as given.
  const serial_chain_parameters<T, N, D>& parameters() const { return p_; }

  /// End effector [m], base frame. Any scalar S that can be made from T.
  template <class S>
  vector<S, D> position(const vector<S, N>& q) const {
    vector<S, D> x = in<S>(tip_);
    for (std::size_t i = size; i-- > 0;) {
      const S& qi = q[int(i)];
      if (joints_[i].turns) x = algebra::turned(joints_[i].axis, qi, x);
      else
        for (int k = 0; k < D; ++k) x[k] += joints_[i].axis[k] * qi;
      x += in<S>(joints_[i].offset);
    }
    return x;
  }

  /// J [m/rad, or 1 in the columns of prismatic joints].
  matrix<T, D, N> jacobian(const vector<T, N>& q) const {
    const chain_pose<T, N, D> at = pose(q);
    matrix<T, D, N> J;
    for (std::size_t i = 0; i < size; ++i)
      J.col(int(i)) = at.sliding[i] + algebra::velocity(at.turning[i], at.handle - at.point[i]);
    return J;
  }

  /// All joints and the handle. Cost: as jacobian.
  chain_pose<T, N, D> pose(const vector<T, N>& q) const {
    chain_pose<T, N, D> at;
    matrix<T, D, D> A = matrix<T, D, D>::Identity();
    vector<T, D> p = vector<T, D>::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      const joint& j = joints_[i];
      const T qi = q[int(i)];
      at.sliding[i].setZero();
      at.turning[i].setZero();
      p += A * j.offset;
      if (j.turns) {
        at.turning[i] = algebra::axis(A, j.axis);
        A = A * algebra::rotation(j.axis, qi);
      } else {
        at.sliding[i] = A * j.axis;
        p += qi * at.sliding[i];
      }
      at.turn[i] = A;
      at.point[i] = p;
    }
    at.handle = p + A * tip_;
    return at;
  }

 protected:
  /// The zero-pose point [m] that body i is measured from.
  vector<T, D> zero_point(std::size_t i) const {
    vector<T, D> p = vector<T, D>::Zero();
    for (std::size_t k = 0; k <= i; ++k) p += joints_[k].offset;
    return p;
  }

 private:
  using algebra = detail::turning<T, D>;
  static constexpr std::size_t size = std::size_t(N);
  struct joint {
    bool turns;
    vector<T, D> axis;    // unit vector, zero pose; unused in a turning planar joint
    vector<T, D> offset;  // from the point of the body before [m], zero pose
  };

  template <class S>
  static vector<S, D> in(const vector<T, D>& x) {
    vector<S, D> y;
    for (int k = 0; k < D; ++k) y[k] = S(x[k]);
    return y;
  }

  serial_chain_parameters<T, N, D> p_;
  std::array<joint, N> joints_;
  vector<T, D> tip_;  // from the point of the last body to the handle [m], zero pose
};

}  // namespace passive_haptics
