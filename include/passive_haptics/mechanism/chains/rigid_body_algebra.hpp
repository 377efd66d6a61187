/// Vector algebra of rotating bodies, planar and spatial.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>

namespace passive_haptics {

/// Size of an angular velocity: 1 if planar (about z), 3 if spatial.
template <int D>
inline constexpr int angular_size = D == 2 ? 1 : 3;

/// Angular velocity [rad/s], angular acceleration [rad/s^2] or moment [N m].
template <class T, int D>
using angular_vector = vector<T, angular_size<D>>;

/// Moment of inertia [kg m^2]: 1 x 1 if planar, 3 x 3 if spatial.
template <class T, int D>
using inertia_matrix = matrix<T, angular_size<D>, angular_size<D>>;

namespace detail {

template <class T>
PASSIVE_HAPTICS_INLINE inline matrix<T, 3, 3> turned_about_z(const matrix<T, 3, 3>& A, T cosine, T sine) {
  matrix<T, 3, 3> B;
  B << cosine * A.col(0) + sine * A.col(1), cosine * A.col(1) - sine * A.col(0), A.col(2);
  return B;
}

template <class T>
PASSIVE_HAPTICS_INLINE inline matrix<T, 3, 3> turned_about_x(const matrix<T, 3, 3>& A, T cosine, T sine) {
  matrix<T, 3, 3> B;
  B << A.col(0), cosine * A.col(1) + sine * A.col(2), cosine * A.col(2) - sine * A.col(1);
  return B;
}

/// Products for rotating bodies. Named after their roles, so that Eigen expressions convert unambiguously.
template <class T, int D>
struct rigid_body_algebra;

template <class T>
struct rigid_body_algebra<T, 2> {
  using angular = vector<T, 1>;  ///< About z.
  using linear = vector<T, 2>;
  using turn = matrix<T, 2, 2>;  ///< Rotation.

  static linear velocity(const angular& w, const linear& r) { return {-w[0] * r[1], w[0] * r[0]}; }
  static angular moment(const linear& r, const linear& f) { return angular(r[0] * f[1] - r[1] * f[0]); }
  static angular gyroscopic(const angular&, const angular&) { return angular::Zero(); }

  template <class S>
  static vector<S, 2> turned(const linear&, const S& angle, const vector<S, 2>& r) {
    using std::cos, std::sin;
    const S c = cos(angle), s = sin(angle);
    return {c * r[0] - s * r[1], s * r[0] + c * r[1]};
  }

  static inertia_matrix<T, 2> inertia(const turn&, const inertia_matrix<T, 2>& i) { return i; }

  static inertia_matrix<T, 2> point_inertia(T mass, const linear& r) {
    return inertia_matrix<T, 2>(mass * r.squaredNorm());
  }
};

template <class T>
struct rigid_body_algebra<T, 3> {
  using angular = vector<T, 3>;  ///< Base frame.
  using linear = vector<T, 3>;   ///< Base frame.
  using turn = matrix<T, 3, 3>;  ///< Rotation.

  /// w x r, the velocity of r.
  static linear velocity(const angular& w, const linear& r) { return cross(w, r); }
  /// r x f, the moment of f.
  static angular moment(const linear& r, const linear& f) { return cross(r, f); }
  /// v x w of two angular vectors.
  static angular gyroscopic(const angular& v, const angular& w) { return cross(v, w); }

  /// r rotated by `angle` [rad] about the unit vector w: r + sin w x r + (1 - cos) w x (w x r) (Rodrigues).
  template <class S>
  static vector<S, 3> turned(const angular& axis, const S& angle, const vector<S, 3>& r) {
    using std::cos, std::sin;
    const vector<S, 3> w = axis.template cast<S>(), across = cross(w, r);
    const S s = sin(angle), v = S(T(1)) - cos(angle);
    return r + s * across + v * cross(w, across);
  }

  /// Inertia of a body after a rotation, A I A^T.
  static inertia_matrix<T, 3> inertia(const turn& A, const inertia_matrix<T, 3>& i) {
    return A * i * A.transpose();
  }

  /// Inertia of a point mass at r about the origin, m (|r|^2 - r r^T).
  static inertia_matrix<T, 3> point_inertia(T mass, const linear& r) {
    return mass * (r.squaredNorm() * turn::Identity() - r * r.transpose());
  }
};

}  // namespace detail
}  // namespace passive_haptics
