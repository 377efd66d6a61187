/// Spatial serial chains from standard Denavit-Hartenberg parameters.
#pragma once

#include <passive_haptics/core/scalar/sine_cosine.hpp>
#include <passive_haptics/mechanism/chains/rigid_body_algebra.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_parameters.hpp>

namespace passive_haptics {

/// One row of a table of standard (distal) Denavit-Hartenberg parameters. Joint i moves on axis z_{i-1}:
///
///     frame i = frame i-1 . Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha),
///
/// theta = q + theta_offset and d = offset for a revolute joint, theta = theta_offset and d = q + offset for
/// a prismatic one. (The modified, proximal convention of Craig, which puts a and alpha first, is different.)
template <class T>
struct dh_joint {
  joint_kind kind = joint_kind::revolute;  ///< Selects whether theta or d moves.
  T length = T(0);                         ///< a, along x_i [m].
  T twist = T(0);                          ///< alpha, about x_i [rad].
  T offset = T(0);                         ///< d, along z_{i-1} [m], at q = 0.
  T angle = T(0);                          ///< theta, about z_{i-1} [rad], at q = 0.
};

/// Parameters of this chain. `tool`: end effector in frame N [m]; frame 0 is the base. Check the result with
/// validate().
template <class T, std::size_t N>
serial_chain_parameters<T, int(N), 3> from_denavit_hartenberg(
    const std::array<dh_joint<T>, N>& table, const vector<T, 3>& tool = vector<T, 3>::Zero()) {
  serial_chain_parameters<T, int(N), 3> p;
  matrix<T, 3, 3> A = matrix<T, 3, 3>::Identity();  // frame i in the zero pose
  vector<T, 3> origin = vector<T, 3>::Zero();
  for (std::size_t i = 0; i < N; ++i) {
    const dh_joint<T>& row = table[i];
    p.joints[i] = {row.kind, A.col(2), origin};
    const auto [theta, alpha] = sine_cosine(row.angle, row.twist);
    A = detail::turned_about_z<T>(A, theta.cosine, theta.sine);
    origin += A * vector<T, 3>(row.length, T(0), row.offset);
    A = detail::turned_about_x<T>(A, alpha.cosine, alpha.sine);
  }
  p.handle = origin + A * tool;
  return p;
}

}  // namespace passive_haptics
