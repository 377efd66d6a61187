/// Figures of a device at one point of a task.
#pragma once

#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/path_point.hpp>
#include <passive_haptics/design/sink_slope.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// Figures of a device at a point of a task where its end effector moves along a wall.
template <class T>
struct design_figures {
  status outcome = status::ok;  ///< ok, or the reason for no figures: as displayable(), or out_of_reach.
  display_class display = display_class::none;  ///< Display of a force along the normal.
  /// cos(gamma) [1] between the normal and the nearest producible force: 1 if exact, 0 if none.
  T cosine = T(0);
  /// Force against the motion along the wall per newton of normal force by force approximation [1];
  /// tan(gamma) for planar devices. NaN if nothing is displayed.
  T drag = std::numeric_limits<T>::quiet_NaN();
  /// Maximum n . F [N] of the brakes within their limits; with limits of 1 N m it is in N per N m.
  T max_force = T(0);
  T sink_slope = std::numeric_limits<T>::infinity();  ///< Sink slope [1]: depth per distance along the wall.
  /// Minimum by maximum singular value of E, the map from brake rates to end-effector velocity [1]: 1 if
  /// isotropic, 0 at singular poses. If rates have mixed units (rad/s and m/s), it depends on them.
  T isotropy = T(0);
};

namespace detail {

// Minimum by maximum singular value; 0 for zero matrices and values that are not finite. One-sided Jacobi,
// which compiles much faster than Eigen's JacobiSVD: J. Demmel, K. Veselic, Jacobi's method is more accurate
// than QR, SIAM J. Matrix Analysis 13 (4), 1992.
template <class T, int D, int Brakes>
T isotropy_of(matrix<T, D, Brakes> E) {
  constexpr int max_sweeps = 30;
  const T scale = E.cwiseAbs().maxCoeff();
  if (!(scale > T(0)) || !all_finite(E)) return T(0);
  E /= scale;
  bool turned = true;
  for (int sweep = 0; turned && sweep < max_sweeps; ++sweep) {
    turned = false;
    for (int i = 0; i < D; ++i) {
      for (int j = i + 1; j < D; ++j) {
        const T a = E.row(i).squaredNorm(), b = E.row(j).squaredNorm(), c = E.row(i).dot(E.row(j));
        if (!(std::abs(c) > std::numeric_limits<T>::epsilon() * std::sqrt(a * b))) continue;
        turned = true;
        const T cotangent = (b - a) / (T(2) * c);
        const T t = std::copysign(T(1) / (std::abs(cotangent) + std::hypot(T(1), cotangent)), cotangent);
        const T cosine = T(1) / std::hypot(T(1), t), sine = cosine * t;
        for (int k = 0; k < Brakes; ++k) {
          const T x = E(i, k), y = E(j, k);
          E(i, k) = cosine * x - sine * y;
          E(j, k) = sine * x + cosine * y;
        }
      }
    }
  }
  T least = E.row(0).norm(), largest = least;
  for (int i = 1; i < D; ++i) {
    least = std::min(least, E.row(i).norm());
    largest = std::max(largest, E.row(i).norm());
  }
  return least / largest;
}

}  // namespace detail

/// Returns the figures at one point for these brakes and a hand that pushes with `push` [N]. Cost:
/// displayable, sink_slope and the singular values of E.
template <class M>
design_figures<typename M::scalar> design_figures_at(const M& mechanism, const path_point<M>& at,
                                                     const hybrid_brakes<M>& brakes,
                                                     typename M::scalar push) {
  using T = typename M::scalar;
  design_figures<T> found;
  const auto force = displayable(mechanism, at.q, at.direction, at.normal, brakes);
  const auto sink = sink_slope(mechanism, at.q, at.direction, at.normal, brakes, push);
  found.outcome = force.outcome != status::ok ? force.outcome : sink.outcome;
  if (found.outcome != status::ok) return found;
  const task_vector<M> along = detail::along_wall(at.direction, direction_of(at.normal));
  found.display = force.display;
  if (is_displayed(force.display)) {
    found.cosine = std::cos(force.angle);
    found.drag = T(0) - along.dot(force.nearest);  // no -0
  }
  found.max_force = force.max_force;
  found.sink_slope = sink.slope;
  found.isotropy = detail::isotropy_of(brake_matrix<M>(passive_haptics::brake_jacobian(mechanism, at.q)));
  return found;
}

}  // namespace passive_haptics
