/// Joints of a serial chain in a pose.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/mechanism/chains/rigid_body_algebra.hpp>

#include <array>
#include <cmath>

namespace passive_haptics {

/// Joints and handle of a chain in a pose, base frame.
template <class T, int N, int D>
struct chain_pose {
  std::array<vector<T, D>, std::size_t(N)> axis;   ///< Axis of joint i; 0 for a planar revolute joint.
  std::array<vector<T, D>, std::size_t(N)> point;  ///< Point of body i on its joint [m].
  vector<T, D> handle;                             ///< End effector [m].
};

/// Adds body motions, with the same formulas for revolute and prismatic joints.
template <class T, int N, int D>
struct chain_bodies : chain_pose<T, N, D> {
  std::array<matrix<T, D, D>, std::size_t(N)> turn;  ///< Orientation of the frame of body i.
  /// Angular velocity per unit rate of joint i; 0 if prismatic.
  std::array<angular_vector<T, D>, std::size_t(N)> rotation;
  std::array<vector<T, D>, std::size_t(N)> sliding;  ///< Velocity per unit rate of joint i; 0 if revolute.
};

namespace detail {

template <class T, int D>
struct zero_pose_joint {
  bool turns;
  vector<T, D> axis;    // unit vector; unused in a planar revolute joint
  vector<T, D> offset;  // from the point of the previous body [m]
};

/// Frames of the bodies of a chain: q to pose.
template <class T, int N, int D>
class chain_frames;

/// Planar frames, equal to the base frame in the zero pose.
template <class T, int N>
class chain_frames<T, N, 2> {
 public:
  using joints = std::array<zero_pose_joint<T, 2>, std::size_t(N)>;  ///< Joints of the chain.

  /// tip: from the last body's point to the handle [m].
  chain_frames(const joints& all, const vector<T, 2>& tip) : joints_(all), tip_(tip) {}

  /// Joints and handle. Calls each(i, A) with the orientation A() of body i.
  template <class Each>
  PASSIVE_HAPTICS_INLINE chain_pose<T, N, 2> follow(const vector<T, N>& q, Each&& each) const {
    chain_pose<T, N, 2> at;
    matrix<T, 2, 2> A = matrix<T, 2, 2>::Identity();
    vector<T, 2> p = vector<T, 2>::Zero();
    T sine = T(0), cosine = T(1);  // of A
    const auto angles = sine_cosine(q);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const auto& j = joints_[i];
      p += A * j.offset;
      at.axis[i].setZero();
      if (j.turns) {
        const auto [s, c] = angles[i];
        const T sum = sine * c + cosine * s;
        cosine = cosine * c - sine * s;
        sine = sum;
        A << cosine, -sine, sine, cosine;
      } else {
        at.axis[i] = A * j.axis;
        p += q[static_cast<int>(i)] * at.axis[i];
      }
      at.point[i] = p;
      each(i, [&] { return A; });
    }
    at.handle = p + A * tip_;
    return at;
  }

  matrix<T, 2, 2> zero(std::size_t) const { return matrix<T, 2, 2>::Identity(); }

 private:
  joints joints_;
  vector<T, 2> tip_;
};

/// Spatial frames with z along the joint axis, so that a joint rotates only two columns. Body i rotates about
/// z by q_i and a phase; a twist about x then brings z to the next axis. These are the angles of Denavit and
/// Hartenberg, with any offset between the joints.
template <class T, int N>
class chain_frames<T, N, 3> {
 public:
  using joints = std::array<zero_pose_joint<T, 3>, std::size_t(N)>;  ///< Joints of the chain.

  chain_frames(const joints& all, const vector<T, 3>& tip) : start_(all[0].offset) {
    first_ = to_axis(matrix<T, 3, 3>::Identity(), all[0].axis).of(matrix<T, 3, 3>::Identity());
    matrix<T, 3, 3> B = first_;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const int k = static_cast<int>(i);
      const bool last = i + 1 == all.size();
      const z_then_x turn = last ? z_then_x() : to_axis(B, all[i + 1].axis);
      zero_[i] = turned_about_z(B, turn.phase.cosine, turn.phase.sine);
      phase_[k] = std::atan2(turn.phase.sine, turn.phase.cosine);
      turns_[k] = all[i].turns ? T(1) : T(0);
      bodies_[i] = {all[i].turns, turn.twist, zero_[i].transpose() * (last ? tip : all[i + 1].offset)};
      B = turn.of(B);
    }
  }

  template <class Each>
  PASSIVE_HAPTICS_INLINE chain_pose<T, N, 3> follow(const vector<T, N>& q, Each&& each) const {
    using column = lanes<T, 3>;
    chain_pose<T, N, 3> at;
    column x = column::load(&first_(0, 0)), y = column::load(&first_(0, 1)), z = column::load(&first_(0, 2));
    column p = column::load(start_.data());
    const auto angles = sine_cosine(vector<T, N>(turns_.cwiseProduct(q) + phase_));
    unrolled<N>([&](int k) PASSIVE_HAPTICS_INLINE {
      const auto i = static_cast<std::size_t>(k);
      const body& b = bodies_[i];
      z.store(at.axis[i].data());
      turn(x, y, angles[i]);
      if (!b.turns) p += q[k] * z;
      p.store(at.point[i].data());
      each(i, [&] {
        matrix<T, 3, 3> A;
        x.store(&A(0, 0)), y.store(&A(0, 1)), z.store(&A(0, 2));
        return A;
      });
      p += b.to_next[0] * x;
      p += b.to_next[1] * y;
      p += b.to_next[2] * z;
      turn(y, z, b.twist);
    });
    p.store(at.handle.data());
    return at;
  }

  const matrix<T, 3, 3>& zero(std::size_t i) const { return zero_[i]; }

 private:
  struct body {
    bool turns;
    sine_cosine_pair<T> twist;  // about x, to the axis of the next joint
    vector<T, 3> to_next;       // to the next joint's point, or to the handle [m], in this frame
  };

  struct z_then_x {
    sine_cosine_pair<T> phase = {T(0), T(1)}, twist = {T(0), T(1)};

    matrix<T, 3, 3> of(const matrix<T, 3, 3>& B) const {
      return turned_about_x(turned_about_z(B, phase.cosine, phase.sine), twist.cosine, twist.sine);
    }
  };

  // The rotation of B that aligns its z with the axis.
  static z_then_x to_axis(const matrix<T, 3, 3>& B, const vector<T, 3>& axis) {
    const vector<T, 3> u = B.transpose() * axis;  // (sin phase sin twist, -cos phase sin twist, cos twist)
    const T length = std::hypot(u[0], u[1]);
    if (!(length > T(0))) return {{T(0), T(1)}, {T(0), u[2]}};
    return {{u[0] / length, -u[1] / length}, {length, u[2]}};
  }

  PASSIVE_HAPTICS_INLINE static void turn(lanes<T, 3>& u, lanes<T, 3>& v, const sine_cosine_pair<T>& angle) {
    const lanes<T, 3> before = u;
    u = angle.cosine * u + angle.sine * v;
    v = angle.cosine * v - angle.sine * before;
  }

  vector<T, 3> start_;          // point of joint 1 [m]
  matrix<T, 3, 3> first_;       // frame with z along joint 1
  vector<T, N> turns_, phase_;  // body i rotates about z by turns_i q_i + phase_i; turns_i is 0 if prismatic
  std::array<body, std::size_t(N)> bodies_;
  std::array<matrix<T, 3, 3>, std::size_t(N)> zero_;
};

}  // namespace detail
}  // namespace passive_haptics
