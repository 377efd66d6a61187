/// Plausibility of the states of a control loop.
#pragma once

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/core/text.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace passive_haptics {

namespace detail {

struct motion_sums {
  double max_step = 0;                                      // [s]
  int standing = 0, backward = 0;                           // time steps that are 0, or negative
  double rate_squares = 0, slope_squares = 0, product = 0;  // of qd and of the slopes of q
  // Hand impulse [N s] and change of velocity [m/s] per window
  double impulse_squares = 0, change_squares = 0, impulse_by_change = 0;
};

template <class M, class State>
motion_sums sums_of(const M& mechanism, const std::vector<State>& states) {
  motion_sums s;
  using vec = vector<double, M::task_dimension>;
  const auto velocity = [&](const State& at) -> vec {
    return as<double>(mechanism_pose<M>(mechanism, at.q).velocity(at.qd));
  };
  constexpr double window = 0.05;  // [s], long enough for encoder noise to be small
  std::size_t first = 0;           // of the window
  vec impulse = vec::Zero();
  for (std::size_t k = 1; k < states.size(); ++k) {
    const State &before = states[k - 1], &now = states[k];
    const double dt = now.time - before.time;
    s.standing += dt == 0;
    s.backward += dt < 0;
    if (!(dt > 0)) continue;
    s.max_step = std::max(s.max_step, dt);
    const vector<double, M::dof> slope = (as<double>(now.q) - as<double>(before.q)) / dt;
    const vector<double, M::dof> rate = (as<double>(now.qd) + as<double>(before.qd)) / 2;
    s.rate_squares += rate.squaredNorm();
    s.slope_squares += slope.squaredNorm();
    s.product += rate.dot(slope);
    if constexpr (HandForceState<State, M>) {
      impulse += dt / 2 * vec(as<double>(now.hand_force) + as<double>(before.hand_force));
      if (now.time - states[first].time < window) continue;
      const vec change = velocity(now) - velocity(states[first]);
      s.impulse_squares += impulse.squaredNorm();
      s.change_squares += change.squaredNorm();
      s.impulse_by_change += impulse.dot(change);
      impulse.setZero();
      first = k;
    }
  }
  return s;
}

}  // namespace detail

/// Returns a line for each implausible property of the states of a loop, one state per cycle: a time that
/// stands still, runs backwards or looks like milliseconds; rates that are not the slopes of the positions; a
/// hand force that does not act along the acceleration. Record some seconds in which a hand moves the handle
/// back and forth with the brakes released. For set-up.
template <class M, class State>
std::string plausibility(const M& mechanism, const std::vector<State>& states) {
  static_assert(is_device_state<State, M, explain>());
  const detail::motion_sums s = detail::sums_of(mechanism, states);
  std::string all;
  const auto remark = [&](const std::string& what, double value, const char* usually) {
    all.append(what)
        .append(" = ")
        .append(detail::value_text(value))
        .append(", usually ")
        .append(usually)
        .append("\n");
  };
  const auto cycles = static_cast<double>(states.size());
  if (s.standing > 0.1 * cycles)
    remark("cycles in which the time stands still", s.standing, "none: is the state updated in each?");
  if (s.backward > 0) remark("cycles in which the time runs backwards", s.backward, "none: another clock?");
  if (s.max_step > 0.5) remark("longest time step [s]", s.max_step, "0.0001 to 0.01: milliseconds?");

  const double slope = s.slope_squares > 0 ? s.product / s.slope_squares : 1;  // of qd over q'
  constexpr double degrees = 180 / std::numbers::pi;
  if (s.slope_squares > 0 && s.rate_squares == 0)
    remark("rates qd for each slope of q", 0, "1: is qd never filled?");
  else if (slope < 0) remark("rates qd for each slope of q", slope, "1: a wrong sign?");
  else if (slope > degrees / 2 || slope < 2 / degrees)
    remark("rates qd for each slope of q", slope, "1: degrees, or another unit of time?");

  const double size = std::sqrt(s.impulse_squares * s.change_squares);
  const double along = s.impulse_by_change / size;  // a cosine
  if (size > 0 && along < -0.3)
    remark("cosine of hand force and acceleration", along,
           "over 0.3: the force on the hand, not on the handle?");
  else if (size > 0 && along < 0.3)
    remark("cosine of hand force and acceleration", along,
           "over 0.3: of the sensor's frame, not the base's?");
  return all;
}

}  // namespace passive_haptics
