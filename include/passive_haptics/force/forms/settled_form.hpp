/// Forces of a device with self-motion (n > d): the cones of all sets of brakes that can come to rest.
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/force/forms/half_space_form.hpp>
#include <passive_haptics/force/torques/settled_approximation.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

namespace detail {

// Motions of brakes with a settled self-motion: rates w = W v for each set of brakes that can be at rest.
template <class M>
class settled_ways_to_move {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;
  static constexpr T tolerance = rounding_tolerance<T>(M::dof + m);

 public:
  using rate_map = typename settled_rates<M>::rate_map;  ///< W

  settled_ways_to_move(const mechanism_pose<M>& pose, brake_set without_torque)
      : rates_(pose, tolerance, without_torque) {}

  static constexpr status outcome() { return status::ok; }
  const settled_rates<M>& rates() const { return rates_; }
  template <class Visit>
  void for_each(const Visit& visit) const {
    rates_.for_each([&](brake_set, const rate_map& W) {
      visit(W);
      return false;
    });
  }
  // Rounding error of a zero rate, for a unit velocity.
  T rate_dead_band() const { return tolerance * rates_.least_norm_rates().norm(); }
  vector<T, m> signs(const rate_map& W, const vector<T, d>& v) const {
    brake_parameters<T, m> in_motion;
    in_motion.rate_dead_band.setConstant(rate_dead_band());
    return brake_signs<T, m>(W * v, vector<T, m>::Zero(), in_motion);
  }
  // Calls visit(w) with w = W n for each W: the rates for motion along n. None if the structure prevents it.
  template <class Visit>
  void for_each_way(const vector<T, d>& n, const Visit& visit) const {
    if (rates_.held_by_structure(n).norm() > tolerance) return;
    for_each([&](const rate_map& W) { visit(vector<T, m>(W * n)); });
  }

 private:
  settled_rates<M> rates_;
};

}  // namespace detail

/// Operations on the forces of M's brakes with a settled self-motion.
template <class M>
struct settled_form : private half_space_form<M> {
  using T = typename M::scalar;                ///< Scalar type.
  static constexpr int d = M::task_dimension;  ///< Task dimension.
  static constexpr int m = M::brake_count;     ///< Number of brakes.
  using force = settled_force<T, d, m>;        ///< Force with torques and settled signs.
  using half_space_form<M>::is_in_cone;
  using half_space_form<M>::units;

  /// Contribution of a tangential hand force to the velocity v' [m/s per N].
  static constexpr double mobility = 0.005;

  /// Velocity v' [m/s] by which the brake signs are chosen: the velocity v without its components into the
  /// `count` walls, plus a contribution of the tangential hand force. Fd(j) is the demand of wall j. The
  /// measured velocity may only be that of the landing, and at rest it would leave all brakes without a sign.
  /// Cost: a few products; four sweeps for several walls.
  template <class Device, class Demands>
  static task_vector<M> landed_velocity(const Device& device, int count, const Demands& Fd) {
    task_vector<M> along = device.hand_force, landed = device.v;
    for (int sweep = 0; sweep < (count > 1 ? 4 : 1); ++sweep) {
      for (int j = 0; j < count; ++j) {
        const auto wall = Fd(j);
        along -= wall.direction.dot(along) * wall.direction;
        landed += std::max(T(0), -outward(wall, landed)) * wall.direction;
      }
    }
    return landed + T(mobility) * along;
  }

  /// Fc for a desired force of 1 N, with the signs of the landed velocity, or else of the current one.
  template <class Device>
  static force nearest(const Device& device, const desired_force<T, d>& Fd, T min_cosine,
                       approximation_start& start) {
    const task_vector<M> landed = landed_velocity(device, 1, [&](int) { return Fd; });
    return nearest(device, landed, device.v, Fd.direction, min_cosine, start.held);
  }

  /// Fc for a unit force n with the signs of a velocity v' [m/s], or of v if they display nothing. Updates S.
  template <class Device>
  static force nearest(const Device& device, const task_vector<M>& landed, const task_vector<M>& v,
                       const task_vector<M>& n, T min_cosine, unsigned& held) {
    const settled_rates<M> rates = rates_of(device);
    auto F = settled_forces(rates, device.E, device.brakes, landed).nearest(n, min_cosine, held);
    if (!is_displayed(F.display))
      F = settled_forces(rates, device.E, device.brakes, v).nearest(n, min_cosine, held);
    held = F.held;
    return F;
  }

  /// S, s* and v' for `count` demands, at the landed velocity, or at v if this gains settled_gain. Updates S.
  template <int Capacity, class Device>
  static force signs_at(const Device& device, const task_vector<M>& landed, const task_vector<M>& v,
                        const std::array<contact_demand<T, d>, static_cast<std::size_t>(Capacity)>& demands,
                        int count, unsigned& held) {
    const settled_rates<M> rates = rates_of(device);
    const auto at = [&](const task_vector<M>& velocity) {
      return settled_forces(rates, device.E, device.brakes, velocity)
          .template signs_under_demands<Capacity>(demands, count, held);
    };
    auto found = at(landed);
    if (found.left.first + found.left.others > T(settled_gain))
      if (const auto now = at(v); now.left.is_less_than(found.left, T(settled_gain))) found = now;
    held = found.signs.held;
    return found.signs;
  }

  /// Brake signs s* for `count` demands of `wall_count` walls with forces wall(j). Sets S, s* and v' of F.
  template <int Capacity, class Device, class Demands, class Wall>
  static brake_vector<M> signs(const Device& device, const Demands& demands, int count, int wall_count,
                               const Wall& wall, approximation_start& start, force& F) {
    const task_vector<M> landed = landed_velocity(device, wall_count, wall);
    F = signs_at<Capacity>(device, landed, device.v, demands, count, start.held);
    return F.signs;
  }
  /// Brake signs for effects in addition to walls, for which the brakes produce F with the torques td: the
  /// settled signs of the walls, or those for the force of the effects. Brakes without a wall torque on
  /// joints with an effect torque keep the signs of their rates.
  template <class Device, class Effects>
  static brake_vector<M> signs_beside(const Device& device, const force& F, const brake_vector<M>& td,
                                      const Effects& effects, approximation_start& start) {
    brake_vector<M> signs = device.s;
    if (is_displayed(F.display)) {
      signs = F.signs;
    } else if (const T size = effects.force.norm(); size > T(0)) {
      const task_vector<M> n = effects.force / size;
      const force Fe = nearest(device, device.v, device.v, n, T(0), start.held);
      if (is_displayed(Fe.display)) signs = Fe.signs;
    }
    const matrix<T, M::dof, m> Tt = device.pose.transposed_transmission();
    for (int i = 0; i < m; ++i)
      if (td[i] == T(0) && (Tt.col(i).array() * effects.torque.array() != T(0)).any()) signs[i] = device.s[i];
    return signs;
  }
  /// Returns all torques t [N m] of a law, because signs change until the self-motion has settled.
  static const brake_vector<M>& without_driving(const brake_vector<M>& t, const brake_vector<M>&) {
    return t;
  }
  /// Torques [N m] that brakes with signs s produce for capacities td [N m], against their current rates.
  template <class B>
  static brake_vector<M> resisting(const brake_vector<M>& td, const brake_vector<M>& s,
                                   [[maybe_unused]] const B& brakes) {
    if constexpr (SwitchableBrakes<B, T, m>)
      return (-s.cwiseProduct(td.cwiseAbs())).cwiseMax(brakes.torque_lower).cwiseMin(brakes.torque_upper);
    else return -s.cwiseProduct(td.cwiseAbs());
  }

  /// Map F = G t for torques without effect on the self-motion.
  template <class EMatrix>
  static force_map<T, d, m> map(const mechanism_pose<M>& pose, const EMatrix&) {
    return passive_haptics::force_map_of(settled_rates<M>(pose));
  }
  /// Sets F to the settled force of the capacities F.torque at the current velocity, with the brakes at rest
  /// of `start`, or else of nearest(). Returns the magnitude of its terms [N], for rounding bounds.
  template <class Device>
  static T set_force(force& F, const Device& device, const desired_force<T, d>& Fd,
                     approximation_start start) {
    const brake_vector<M> capacity = F.torque;
    F = {};
    F.torque = capacity;  // keeps a NaN of the law
    const settled_rates<M> rates = rates_of(device);
    typename settled_rates<M>::rate_map W;
    if (!rates.find(start.held, W)) {
      start.held = nearest(device, Fd, T(0), start).held;
      if (!rates.find(start.held, W)) return Fd.magnitude;
    }
    F.held = start.held;
    F.velocity = device.v;
    F.signs = settled_forces(rates, device.E, device.brakes, device.v).signs_of(W);
    const brake_vector<M> sense = brake_torque(device.E, Fd.direction);  // for brakes at rest
    const auto off = passive_haptics::brakes_off(F.signs, device.brakes);
    for (int i = 0; i < m; ++i)
      F.torque[i] = detail::is_off(off, i)
                        ? T(0)
                        : std::copysign(capacity[i], F.signs[i] != T(0) ? -F.signs[i] : sense[i]);
    F.force = W.transpose() * F.torque;
    return Fd.magnitude;
  }

  /// Motions of the brakes in pose q, for design. Brakes without torque hold nothing.
  template <class B>
  static detail::settled_ways_to_move<M> motions(const M& mechanism, const joint_vector<M>& q,
                                                 const brake_matrix<M>&, const B& brakes) {
    const torque_box<T, m> box = torque_box_of(brake_vector<M>(brake_vector<M>::Zero()), brakes);
    brake_set without_torque = 0;
    for (int i = 0; i < m; ++i)
      if (!(box.lower[i] < T(0)) && !(box.upper[i] > T(0))) without_torque |= brake_set(1) << i;
    return {mechanism_pose<M>(mechanism, q), without_torque};
  }
  /// Fc for a unit force n while the end effector moves with v. Sets the signs and the brakes at rest.
  template <class B>
  static force nearest(const detail::settled_ways_to_move<M>& moving, const brake_matrix<M>& E,
                       const task_vector<M>& v, const task_vector<M>& n, const B& brakes,
                       brake_vector<M>& signs, brake_set& held) {
    B in_motion = brakes;
    in_motion.rate_dead_band.setConstant(moving.rate_dead_band());
    const force Fc = settled_forces(moving.rates(), E, in_motion, v).nearest(n, T(0));
    signs = Fc.signs;
    held = Fc.held;
    return Fc;
  }
  /// Force F [N] of torques t in motion with the brakes `held` at rest; 0 if they cannot be.
  static task_vector<M> force_in_motion(const mechanism_pose<M>& pose, const brake_vector<M>& t,
                                        brake_set held) {
    typename settled_rates<M>::rate_map W;
    if (!settled_rates<M>(pose).find(held, W)) return task_vector<M>::Zero();
    return W.transpose() * t;
  }

 private:
  template <class Device>
  static settled_rates<M> rates_of(const Device& device) {
    return settled_rates<M>(device.pose, settled_rates<M>::default_share,
                            passive_haptics::brakes_without_torque<T, m>(device.brakes));
  }
};

}  // namespace passive_haptics
