/// Inertia of the links of a serial chain.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/mechanism/chains/rigid_body_algebra.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_parameters.hpp>

namespace passive_haptics {

namespace detail {

/// Error unless a rigid body can have this inertia: no principal moment exceeds the sum of the others.
template <class T>
std::string check_inertia(const char* name, const matrix<T, 3, 3>& inertia) {
  const T size = inertia.cwiseAbs().maxCoeff();
  const T rounding = rounding_tolerance<T>(3) * size;
  const T skew = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  if (!(skew <= rounding))
    return error_text(std::string(name).append(": |I - I^T|"), skew, "0, a symmetric matrix");
  if (size == T(0)) return "";  // a point mass
  // int r r^T dm, which no mass makes indefinite
  const matrix<T, 3, 3> second_moment =
      (inertia.trace() / T(2) + rounding) * matrix<T, 3, 3>::Identity() - inertia;
  if (cholesky<T, 3>(second_moment).is_positive_definite()) return "";
  return std::string(name).append(
      " has a principal moment over the sum of the other two: expected that of a rigid body");
}

template <class T>
std::string check_inertia(const char* name, const matrix<T, 1, 1>& inertia) {
  if (range::not_negative.contains(inertia(0, 0))) return {};
  return error_text(name, inertia(0, 0), to_text(range::not_negative));
}

}  // namespace detail

/// A rigid link in the zero pose, base frame. The default mass is invalid and must be set.
template <class T, int D>
struct link_inertia {
  T mass = T(0);                               ///< [kg], > 0.
  vector<T, D> centre = vector<T, D>::Zero();  ///< Centre of mass [m].
  /// Moment of inertia [kg m^2]; symmetric; 1 x 1 if planar.
  inertia_matrix<T, D> about_centre = inertia_matrix<T, D>::Zero();

  static constexpr auto members() {
    using p = link_inertia;
    return member_table(member("mass", &p::mass, "kg", range::positive),
                        member("centre", &p::centre, "m", range::finite),
                        member("about_centre", &p::about_centre, "kg m^2"));
  }
  /// The inertia is that of a rigid body.
  std::string rules() const { return detail::check_inertia<T>("about_centre [kg m^2]", about_centre); }
};

/// A uniform thin rod between two points of the zero pose [m].
template <class T, int D>
link_inertia<T, D> uniform_rod(T mass, const vector<T, D>& from, const vector<T, D>& to) {
  const vector<T, D> along = to - from;
  return {mass, (from + to) / T(2), detail::rigid_body_algebra<T, D>::point_inertia(mass / T(12), along)};
}

/// Combines two bodies.
template <class T, int D>
link_inertia<T, D> joined(const link_inertia<T, D>& a, const link_inertia<T, D>& b) {
  const T mass = a.mass + b.mass;
  const T share = b.mass / mass;
  const vector<T, D> apart = b.centre - a.centre;
  return {mass, a.centre + share * apart,
          a.about_centre + b.about_centre +
              detail::rigid_body_algebra<T, D>::point_inertia(share * a.mass, apart)};
}

/// Inertia of a serial chain: links, brake rotors, handle and gravity.
template <class T, int N, int D>
struct serial_chain_inertia {
  std::array<link_inertia<T, D>, std::size_t(N)> links = {};  ///< Link i moves with joint i.
  /// On the joint axes [kg m^2 or kg]; as in two_link.
  vector<T, N> rotor_inertia = vector<T, N>::Constant(T(5e-5));
  T handle_mass = T(0.1);                       ///< Point mass at the end effector [kg]; as in two_link.
  vector<T, D> gravity = vector<T, D>::Zero();  ///< [m/s^2]; zero: horizontal or counterbalanced.

  static constexpr auto members() {
    using p = serial_chain_inertia;
    return member_table(member("links", &p::links),
                        member("rotor_inertia", &p::rotor_inertia, "kg m^2 or kg", range::not_negative),
                        member("handle_mass", &p::handle_mass, "kg", range::not_negative),
                        member("gravity", &p::gravity, "m/s^2", range::finite));
  }
};

}  // namespace passive_haptics
