/// @file
/// Force approximation: what is displayed for a desired force (sections 2 and 4, Fig. 3).
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/validate.hpp>
#include <passive_haptics/force/classification.hpp>
#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// Options of the approximation.
template <class T>
struct approximation_parameters {
  /// Beyond this angle between desired and producible force nothing is displayed [rad]: 1 / cos^2 explodes
  /// near 90 degrees. In (0, pi/2).
  T max_approximation_angle = radians(T(89));
};

/// What is wrong with the parameters; empty if nothing.
template <class T>
std::string validate(const approximation_parameters<T>& p) {
  const T angle = p.max_approximation_angle;
  return angle > T(0) && angle < radians(T(90))
             ? ""
             : detail::error_text("max_approximation_angle [rad]", angle, "an angle between 0 and pi/2");
}

/// What brakes can display of a unit desired force n.
template <class T, int D, int Brakes>
struct approximated_force {
  display_class display = display_class::none;           ///< How n is displayed.
  vector<T, D> force = vector<T, D>::Zero();             ///< Fc / |Fd|; Fc . n = |Fd|. Zero if none.
  vector<T, Brakes> torque = vector<T, Brakes>::Zero();  ///< E^T Fc / |Fd| [N m per N]; s_i t_i <= 0 exactly.
  T cosine = T(0);                                       ///< cos(gamma) = |Fp| / |Fd|; 1 if exact.
};

/// Fc for a unit desired force n (base frame), its torques t = E^T n already known, and signs s.
///
/// Exact (Fc = n) where all s_i t_i <= 0. Else Fc = Fp / |Fp|^2 with Fp the nearest displayable force, "so
/// that its component in the normal direction becomes Fd" (section 4); cos(gamma) = |Fp|. None where |Fp| is
/// of rounding size or gamma is over the limit. Feasible to rounding: Fp = Fc cos^2(gamma), not Fc itself.
/// active: brakes to begin with, left with those that the answer releases; the answer does not depend on
/// them. WithCosine: without it the cosine of an approximate force is left out, and with it a square root.
template <bool WithCosine = true, class EMatrix, class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate(const EMatrix& E, const vector<T, Brakes>& s,
                                             const vector<T, D>& n, const vector<T, Brakes>& t, T min_cosine,
                                             half_space_set& active) {
  if (producible(s, t)) return {display_class::exact, as<T>(n), as<T>(t), T(1)};
  approximated_force<T, D, Brakes> result;
  const auto nearest = nearest_force(E, s, n, active);
  active = nearest.active;
  const vector<T, D>& Fp = nearest.force;
  const T square = dot(Fp, Fp), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return result;

  result.display = display_class::approximate;
  if constexpr (WithCosine) result.cosine = std::sqrt(square);
  result.force = scaled(T(1) / square, Fp);
  const vector<T, Brakes> tc = brake_torque(E, result.force);
  // Where rounding left a brake a torque that it should not or cannot have, it is exactly 0
  unrolled<Brakes>(
      [&](auto i) { result.torque[i] = (active >> i & 1u) != 0 || s[i] * tc[i] > T(0) ? T(0) : tc[i]; });
  return result;
}

/// The same for two brakes in the plane: what is nearest lies on an edge r of the cone, so Fc = r / (r . n).
template <bool WithCosine = true, class T>
approximated_force<T, 2, 2> approximate(const matrix<T, 2, 2>& E, const vector<T, 2>& s,
                                        const vector<T, 2>& n, const vector<T, 2>& t, T min_cosine,
                                        half_space_set& active) {
  if (producible(s, t)) return {display_class::exact, as<T>(n), as<T>(t), T(1)};
  const vector<T, 2> square = detail::column_squares(E);
  const T area = s[0] * s[1] * detail::area_between(E, square);
  if (area == T(0)) return approximate<WithCosine, matrix<T, 2, 2>>(E, s, n, t, min_cosine, active);
  const auto edge = detail::nearest_edge(E, s, n, square, area);
  const T least = std::max(min_cosine, rounding_tolerance<T>(2));
  approximated_force<T, 2, 2> result;
  if (edge.held < 0 || !(edge.along * edge.along >= least * least * edge.square)) return result;

  active = 1u << edge.held;
  const T scale = T(1) / edge.along;
  result.display = display_class::approximate;
  if constexpr (WithCosine) result.cosine = edge.along / std::sqrt(edge.square);
  unrolled<2>([&](auto i) {
    result.force[i] = scale * edge.direction[i];
    result.torque[i] = i == edge.held ? T(0) : -s[i] * std::abs(area) * scale;  // E_i . r is the area
  });
  return result;
}

namespace detail {

// For a diagonal E each axis is alone and nothing is solved. drives(i): whether brake i would have to, s_i
// t_i > 0.
template <bool WithCosine, class T, int D, class Drives>
approximated_force<T, D, D> approximate_axes(const vector<T, D>& n, const vector<T, D>& t, T min_cosine,
                                             const Drives& drives) {
  approximated_force<T, D, D> result;
  bool exact = true;
  unrolled<D>([&](auto i) {
    const bool released = drives(i);
    exact &= !released;
    result.force[i] = released ? T(0) : n[i];
    result.torque[i] = released ? T(0) : t[i];
  });
  if (exact) {
    result.display = display_class::exact;
    result.cosine = T(1);
    return result;
  }
  const T square = dot(result.force, result.force);
  // No rounding of a sum is in the square: what is not zero is meant
  const bool displayed = square > T(0) && square >= min_cosine * min_cosine;
  if (displayed) {
    result.display = display_class::approximate;
    if constexpr (WithCosine) result.cosine = std::sqrt(square);
  }
  const T scale = displayed ? T(1) / square : T(0);
  unrolled<D>([&](auto i) {
    result.force[i] *= scale;
    result.torque[i] *= scale;
  });
  return result;
}

}  // namespace detail

/// The same for a diagonal E: each axis alone. Nothing is solved, so there is nothing to begin with.
template <bool WithCosine = true, class T, int D>
approximated_force<T, D, D> approximate(const diagonal_matrix<T, D>&, const vector<T, D>& s,
                                        const vector<T, D>& n, const vector<T, D>& t, T min_cosine,
                                        half_space_set&) {
  return detail::approximate_axes<WithCosine>(n, t, min_cosine, [&](int i) { return s[i] * t[i] > T(0); });
}

/// The same from nothing.
template <class EMatrix, class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate(const EMatrix& E, const vector<T, Brakes>& s,
                                             const vector<T, D>& n, const vector<T, Brakes>& t,
                                             T min_cosine) {
  half_space_set active = 0;
  return approximate(E, s, n, t, min_cosine, active);
}

/// The same in generator form, F = G t, for redundant brakes and for devices with self-motion: exact where n
/// is in the cone, the torques those of least norm.
template <class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const vector<T, Brakes>& s, const vector<T, D>& n,
                                                           T min_cosine) {
  const vector<T, Brakes> unlimited = vector<T, Brakes>::Constant(std::numeric_limits<T>::infinity());
  const auto nearest = nearest_torque(G, torques_within(s, unlimited), n);
  const T cosine = nearest.force.norm();
  if (!(cosine > rounding_tolerance<T>(D) && cosine >= min_cosine)) return {};
  // What is left of n, against the size of the terms that were added up
  const T rounding =
      rounding_tolerance<T>(D + Brakes) * (T(1) + (G.cwiseAbs() * nearest.torque.cwiseAbs()).norm());
  if ((n - nearest.force).norm() <= rounding) return {display_class::exact, n, nearest.torque, T(1)};
  const T scale = T(1) / (cosine * cosine);
  return {display_class::approximate, scale * nearest.force, scale * nearest.torque, cosine};
}

}  // namespace passive_haptics
