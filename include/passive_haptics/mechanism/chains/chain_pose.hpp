/// @file
/// Where the joints of a serial chain are in a pose.
#pragma once

#include <passive_haptics/core/linear/sine_cosine.hpp>
#include <passive_haptics/mechanism/chains/rigid_body_algebra.hpp>

#include <array>
#include <cmath>

namespace passive_haptics {

/// Where the joints of a chain are in a pose, base frame. With the angular and linear part of each joint's
/// motion, revolute and prismatic joints obey the same formulas.
template <class T, int N, int D>
struct chain_pose {
  std::array<matrix<T, D, D>, N> turn;  ///< Orientation of body i: of a frame of its own.
  std::array<vector<T, D>, N> point;    ///< The point of body i that lies on its joint [m].
  /// Angular velocity per unit rate of joint i; 0 if it slides.
  std::array<angular_vector<T, D>, N> rotation;
  std::array<vector<T, D>, N> sliding;  ///< Velocity per unit rate of joint i; 0 if it turns.
  vector<T, D> handle;                  ///< End effector [m].
};

namespace detail {

/// A joint in the zero pose.
template <class T, int D>
struct zero_pose_joint {
  bool turns;
  vector<T, D> axis;    // unit vector; unused in a revolute planar joint
  vector<T, D> offset;  // from the point of the body before [m]
};

/// The bodies' frames of a chain: from q to a pose.
template <class T, int N, int D>
class chain_frames;

/// In the plane a body's frame is the base frame in the zero pose.
template <class T, int N>
class chain_frames<T, N, 2> {
 public:
  using joints = std::array<zero_pose_joint<T, 2>, N>;  ///< Of the chain.

  /// tip: from the last body's point to the handle [m].
  chain_frames(const joints& all, const vector<T, 2>& tip) : joints_(all), tip_(tip) {}

  /// All joints and the handle.
  chain_pose<T, N, 2> pose(const vector<T, N>& q) const {
    chain_pose<T, N, 2> at;
    matrix<T, 2, 2> A = matrix<T, 2, 2>::Identity();
    vector<T, 2> p = vector<T, 2>::Zero();
    T sine = T(0), cosine = T(1);  // of A
    const auto angles = sine_cosine(q);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const auto& j = joints_[i];
      const T qi = q[static_cast<int>(i)];
      p += A * j.offset;
      at.rotation[i][0] = j.turns ? T(1) : T(0);
      at.sliding[i].setZero();
      if (j.turns) {
        const auto [s, c] = angles[i];
        const T sum = sine * c + cosine * s;
        cosine = cosine * c - sine * s;
        sine = sum;
        A << cosine, -sine, sine, cosine;
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

  /// Orientation of a body in the zero pose.
  matrix<T, 2, 2> zero(std::size_t) const { return matrix<T, 2, 2>::Identity(); }

 private:
  joints joints_;
  vector<T, 2> tip_;
};

/// In space z is the joint's axis, so that a joint turns two columns only. Body i turns about z by q_i and a
/// phase, then a twist about x brings z to the next axis: the angles of Denavit and Hartenberg, with any
/// offset between the joints.
template <class T, int N>
class chain_frames<T, N, 3> {
 public:
  using joints = std::array<zero_pose_joint<T, 3>, N>;  ///< Of the chain.

  /// tip: from the last body's point to the handle [m].
  chain_frames(const joints& all, const vector<T, 3>& tip) : start_(all[0].offset) {
    body ground;
    first_ = aligned(matrix<T, 3, 3>::Identity(), all[0].axis, ground);
    matrix<T, 3, 3> B = first_;
    for (std::size_t i = 0; i < all.size(); ++i) {
      body& b = bodies_[i];
      b.turns = all[i].turns;
      const bool last = i + 1 == all.size();
      const matrix<T, 3, 3> next = last ? B : aligned(B, all[i + 1].axis, b);
      zero_[i] = turned_about_z(B, b.phase_cosine, b.phase_sine);
      b.to_next = zero_[i].transpose() * (last ? tip : all[i + 1].offset);
      B = next;
    }
  }

  /// All joints and the handle.
  chain_pose<T, N, 3> pose(const vector<T, N>& q) const {
    chain_pose<T, N, 3> at;
    matrix<T, 3, 3> B = first_;  // z along joint i
    vector<T, 3> p = start_;
    const auto angles = sine_cosine(q);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const body& b = bodies_[i];
      const T qi = q[static_cast<int>(i)];
      T c = b.phase_cosine, s = b.phase_sine;
      const T turns = b.turns ? T(1) : T(0);
      at.rotation[i] = turns * B.col(2);
      at.sliding[i] = (T(1) - turns) * B.col(2);
      if (b.turns) {
        const auto [sine, cosine] = angles[i];
        c = cosine * b.phase_cosine - sine * b.phase_sine;
        s = sine * b.phase_cosine + cosine * b.phase_sine;
      } else {
        p += qi * B.col(2);
      }
      const matrix<T, 3, 3> A = turned_about_z(B, c, s);
      at.point[i] = p;
      at.turn[i] = A;
      p += A * b.to_next;
      B = turned_about_x(A, b.twist_cosine, b.twist_sine);
    }
    at.handle = p;
    return at;
  }

  /// Orientation of body i in the zero pose.
  const matrix<T, 3, 3>& zero(std::size_t i) const { return zero_[i]; }

 private:
  struct body {
    T phase_cosine = T(1), phase_sine = T(0);  // about z
    T twist_cosine = T(1), twist_sine = T(0);  // about x, to the axis of the next joint
    vector<T, 3> to_next;                      // to the next joint's point, or to the handle [m], this frame
    bool turns;
  };

  // B turned so that z points along the axis; how, is left in `to`.
  static matrix<T, 3, 3> aligned(const matrix<T, 3, 3>& B, const vector<T, 3>& axis, body& to) {
    const vector<T, 3> u = B.transpose() * axis;  // (sin phase sin twist, -cos phase sin twist, cos twist)
    to.twist_cosine = u[2];
    to.twist_sine = std::hypot(u[0], u[1]);
    if (to.twist_sine > T(0)) {
      to.phase_cosine = -u[1] / to.twist_sine;
      to.phase_sine = u[0] / to.twist_sine;
    }
    return turned_about_x(turned_about_z(B, to.phase_cosine, to.phase_sine), to.twist_cosine, to.twist_sine);
  }

  vector<T, 3> start_;     // point of joint 1 [m]
  matrix<T, 3, 3> first_;  // frame with z along joint 1
  std::array<body, N> bodies_;
  std::array<matrix<T, 3, 3>, N> zero_;
};

}  // namespace detail
}  // namespace passive_haptics
