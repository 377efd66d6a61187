/// Force approximation: the displayed force for a desired force (sections 2 and 4, Fig. 3).
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/classification.hpp>
#include <passive_haptics/force/nearest_force.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace passive_haptics {

/// Options of the approximation.
template <class T>
struct approximation_parameters {
  /// Maximum angle between desired and producible force [rad], in (0, pi/2]; nothing is displayed beyond it,
  /// because the factor 1 / cos^2 diverges towards 90 degrees. pi/2 disables the limit.
  T max_approximation_angle = (radians)(T(89));

  static constexpr auto members() {
    using p = approximation_parameters;
    return member_table(member("max_approximation_angle", &p::max_approximation_angle, "rad",
                               range{0, std::numbers::pi / 2, true, false}.as("an angle > 0 and <= pi/2")));
  }
};

/// Start of the next approximation.
struct approximation_start {
  half_space_start half_spaces = {};  ///< For the half-space search.
  unsigned held = 0;                  ///< n > d: one bit per brake that comes to rest; 0 if unknown.
};

/// A displayable force and its torques.
template <class T, int D, int Brakes>
struct approximated_force {
  display_class display = display_class::none;  ///< How the desired force is displayed.
  vector<T, D> force = vector<T, D>::Zero();    ///< Fc [N], Fc . n = |Fd|; zero if nothing is displayed.
  vector<T, Brakes> torque = vector<T, Brakes>::Zero();  ///< t = E^T Fc [N m]; s_i t_i <= 0 exactly.
  T cosine_squared = T(0);  ///< cos^2(gamma) = (Fd / Fc)^2; 1 if exact, 0 if nothing is displayed.

  /// cos(gamma), gamma being the angle between desired and displayed force.
  T cosine() const { return sqrt(lanes<T, 1>(cosine_squared))[0]; }
};

/// A force F = W_S^T t for a settled self-motion (brake/at_rest/settled_rates.hpp).
template <class T, int D, int Brakes>
struct settled_force : approximated_force<T, D, Brakes> {
  unsigned held = 0;                                    ///< S, one bit per brake that comes to rest.
  vector<T, Brakes> signs = vector<T, Brakes>::Zero();  ///< s* after settling; s*_i t_i <= 0 exactly.
  vector<T, D> velocity = vector<T, D>::Zero();         ///< v' [m/s] to which they belong; F . v' <= 0.
};

/// Scales force and torques; the angle does not change.
template <class T, int D, int Brakes>
approximated_force<T, D, Brakes> operator*(T a, const approximated_force<T, D, Brakes>& F) {
  return {F.display, lanes(F.force) * a, lanes(F.torque) * a, F.cosine_squared};
}

/// Scales a settled force.
template <class T, int D, int Brakes>
settled_force<T, D, Brakes> operator*(T a, settled_force<T, D, Brakes> F) {
  static_cast<approximated_force<T, D, Brakes>&>(F) =
      a * static_cast<const approximated_force<T, D, Brakes>&>(F);
  return F;
}

/// cos^2 of the angle between a force [N] and the unit direction n; 0 from 90 degrees on.
template <class T, int D>
T cosine_squared(const vector<T, D>& force, const vector<T, D>& n) {
  const T along = n.dot(force);
  if (!(along > T(0))) return T(0);
  const T cosine = along / length_of(force);
  return cosine * cosine;
}

namespace detail {

// True if brakes that are off have no torque.
template <class T, int Brakes, class Off>
bool are_idle([[maybe_unused]] const vector<T, Brakes>& t, [[maybe_unused]] const Off& off) {
  if constexpr (std::is_same_v<Off, all_brakes_on>) return true;
  else return (off.array() * t.array() == T(0)).all();
}

// Brakes that cannot have the torques t because they would drive or are off; then the brakes that are on
template <class T, int Brakes, class Off>
auto refuse(const lanes<T, Brakes>& s, const lanes<T, Brakes>& t, [[maybe_unused]] const Off& off) {
  const auto drives = s * t > T(0);
  if constexpr (std::is_same_v<Off, all_brakes_on>) return drives;
  else return drives | (lanes(off) * abs(t) > T(0));
}
template <class Mask, class Off>
auto without_off(const Mask& brakes, [[maybe_unused]] const Off& off) {
  if constexpr (std::is_same_v<Off, all_brakes_on>) return brakes;
  else return brakes & (lanes(off) <= typename Off::Scalar(0));
}

}  // namespace detail

/// Displayed force Fc for a unit desired force n (base frame) and brake signs s, in half-space form.
///
/// Exact (Fc = n) if all s_i t_i <= 0 for t = E^T n. Otherwise Fc = Fp / |Fp|^2 with the nearest displayable
/// force Fp, "so that its component in the normal direction becomes Fd" (section 4), and cos(gamma) = |Fp|.
/// Nothing is displayed if |Fp| is rounding or gamma exceeds the limit. Fp is feasible to rounding.
///
/// start: start of the search, updated for the next cycle. off: from brakes_off; their torque is exactly 0.
/// Cost: core/linear/cone.hpp; with a brake that is off, the active set of 2 m half-spaces.
template <class EMatrix, class T, int D, int Brakes, class Off = all_brakes_on>
approximated_force<T, D, Brakes> approximate(const EMatrix& E, const vector<T, Brakes>& s,
                                             const vector<T, D>& n, T min_cosine, half_space_start& start,
                                             const Off& off = Off()) {
  if constexpr (!std::is_same_v<Off, all_brakes_on>)
    if (off.isZero(T(0))) return approximate(E, s, n, min_cosine, start);
  const vector<T, Brakes> t = brake_torque(E, n);
  if (producible(s, t) && detail::are_idle(t, off)) return {display_class::exact, n, t, T(1)};
  const auto nearest = project_onto_half_spaces(half_spaces_of(E, s, off), n, start);
  const vector<T, D>& Fp = nearest.point;
  const T square = Fp.squaredNorm(), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return {};

  const vector<T, D> Fc = Fp / square;
  vector<T, Brakes> tc = brake_torque(E, Fc);
  // Clear torques that are only rounding errors or that the brake cannot have
  unrolled<Brakes>([&](auto i) {
    if ((nearest.active >> i & 1u) != 0 || s[i] * tc[i] > T(0) || detail::is_off(off, i)) tc[i] = T(0);
  });
  return {display_class::approximate, Fc, tc, square};
}

namespace detail {

// One planar vector per brake, with dot products per brake.
template <class T>
struct vectors_of_brakes {
  lanes<T, 2> x, y;
  PASSIVE_HAPTICS_INLINE friend lanes<T, 2> dot(const vectors_of_brakes& a, const vectors_of_brakes& b) {
    return a.x * b.x + a.y * b.y;
  }
  PASSIVE_HAPTICS_INLINE friend lanes<T, 2> dot(const vectors_of_brakes& a, const vector<T, 2>& b) {
    return a.x * b[0] + a.y * b[1];
  }
};

}  // namespace detail

/// Displayed force for two planar brakes (Fig. 3). A brake that would drive is released; the other one
/// produces Fc along its reference force R, perpendicular to the released brake's column of E:
///
///     t_1 = e_1 . n,  t_2 = e_2 . n                             columns e_1, e_2 of E
///     if s_1 t_1 <= 0 and s_2 t_2 <= 0:                         exact, Fc = n
///     for (i, j) = (1, 2) and (2, 1):
///       if s_j t_j > 0:                                         j would drive
///         R = (-e_j,y, e_j,x)                                   reference force of i
///         t_i = e_i . R / (R . n),  t_j = 0
///         if s_i t_i <= 0 and |R . n| >= min_cosine |R|:        approximate, Fc = R / (R . n)
///     otherwise:                                                none, Fc = 0
///
/// The code handles both brakes together and without a branch, because the signs are unpredictable.
template <class T, class Off = all_brakes_on>
approximated_force<T, 2, 2> approximate(const matrix<T, 2, 2>& E, const vector<T, 2>& s,
                                        const vector<T, 2>& n, T min_cosine, half_space_start&,
                                        const Off& off = Off()) {
  using each = lanes<T, 2>;  // brake 1, brake 2
  const each sign = s, t = brake_torque(E, n);
  // e: column of E of each brake; R: perpendicular to the column of the other brake
  const detail::vectors_of_brakes<T> e{row(E, 0), row(E, 1)}, R{swapped(e.y), -swapped(e.x)};
  const each RR = dot(R, R), Rn = dot(R, n), share = T(1) / Rn;
  const each t_alone = cross_or_zero(dot(e, R), RR, swapped(RR)) * share;
  const each cosine_squared = Rn * Rn / RR, least = std::max(min_cosine, rounding_tolerance<T>(2));
  const auto drives = detail::refuse(sign, t, off), some = drives | swapped(drives);
  const auto acts =
      swapped(drives) & detail::without_off((sign * t_alone <= T(0)) & (Rn * Rn >= least * least * RR), off);
  const auto nearest = select(any(acts), display_class::approximate, display_class::none);
  const each of_R = select(first_only(acts), share, T(0));  // both act if their columns are parallel
  return {select(some[0], nearest, display_class::exact),
          select(some, horizontal_add(R.x * of_R, R.y * of_R), n),
          select(some, select(acts, t_alone, T(0)), t),
          select(some[0], sum(select(first_only(acts), cosine_squared, T(0))), T(1))};
}

/// Displayed force for a diagonal E: each axis separately, without a branch.
template <class T, int D, class Off = all_brakes_on>
approximated_force<T, D, D> approximate(const diagonal_matrix<T, D>& E, const vector<T, D>& s,
                                        const vector<T, D>& n, T min_cosine, half_space_start&,
                                        const Off& off = Off()) {
  using each = lanes<T, D>;
  const each t = brake_torque(E, n);
  const auto drives = detail::refuse(each(s), t, off), some = any_of(drives);
  const each Fp = select(drives, T(0), n), square = select(some, sum(Fp * Fp), T(1));
  const T least = std::max(min_cosine * min_cosine, std::numeric_limits<T>::min());
  const auto acts = square >= least;
  const auto nearest = select(some[0], display_class::approximate, display_class::exact);
  return {select(acts[0], nearest, display_class::none), select(acts, Fp / square, T(0)),
          select(acts, select(drives, T(0), t) / square, T(0)), select(acts, square, T(0))[0]};
}

/// Displayed force without a start.
template <class EMatrix, class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate(const EMatrix& E, const vector<T, Brakes>& s,
                                             const vector<T, D>& n, T min_cosine) {
  half_space_start start;
  return approximate(E, s, n, min_cosine, start);
}

}  // namespace passive_haptics
