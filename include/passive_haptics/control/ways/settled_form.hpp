/// @file
/// Step 1 of section 4 for devices whose self-motion settles (n > d).
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/control/ways/one_wall.hpp>
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/force/torques/settled_approximation.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// By the cones of all sets of brakes that can come to rest.
template <Settles M>
struct display_form<M> {
  /// What a push of the hand along the walls counts for in the velocity v' [m/s per N].
  static constexpr double mobility = 0.005;

  /// The velocity v' [m/s] by whose signs brakes are chosen: that of a handle which no longer sinks into any
  /// of `count` walls, Fd(j) being what wall j demands, and which goes where the hand pushes along them. The
  /// velocity now may only be that of the landing; and at rest it would leave all brakes without a sign, so
  /// that any force looked possible. Cost: some products; four sweeps for several walls.
  template <class Device, class Demands>
  static task_vector<M> landed_velocity(const Device& device, int count, const Demands& Fd) {
    using T = typename M::scalar;
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

  /// Fc for a desired force of 1 N, by the signs at the landed velocity; where these display nothing, at the
  /// velocity now. start: S of the cycle before.
  template <class Device, class T, int D>
  static auto nearest(const Device& device, const desired_force<T, D>& Fd, T min_cosine,
                      approximation_start& start) {
    const vector<T, D> landed = landed_velocity(device, 1, [&](int) { return Fd; });
    return nearest_at(device, landed, device.v, Fd.direction, min_cosine, start.held);
  }

  /// Fc for a unit force n by the signs at a velocity v' [m/s], or where these display nothing at v. held: S,
  /// in and out.
  template <class Device, class T, int D>
  static settled_force<T, D, M::brake_count> nearest_at(const Device& device, const vector<T, D>& landed,
                                                        const vector<T, D>& v, const vector<T, D>& n,
                                                        T min_cosine, unsigned& held) {
    const settled_rates<M> rates = rates_of(device);
    auto F = settled_forces(rates, device.E, device.brakes, landed).nearest(n, min_cosine, held);
    if (!is_displayed(F.display))
      F = settled_forces(rates, device.E, device.brakes, v).nearest(n, min_cosine, held);
    held = F.held;
    return F;
  }

  /// S, s* and v' for the first `count` of several demands: at the landed velocity, or at v where that leaves
  /// less of them by settled_gain (in a corner no velocity is left by which brakes could be chosen). held: S,
  /// in and out.
  template <int Capacity, class Device, class T, int D>
  static settled_force<T, D, M::brake_count> signs_at(
      const Device& device, const vector<T, D>& landed, const vector<T, D>& v,
      const std::array<contact_demand<T, D>, static_cast<std::size_t>(Capacity)>& demands, int count,
      unsigned& held) {
    const settled_rates<M> rates = rates_of(device);
    const auto at = [&](const vector<T, D>& velocity) {
      return settled_forces(rates, device.E, device.brakes, velocity)
          .template signs_for<Capacity>(demands, count, held);
    };
    auto found = at(landed);
    if (found.left.first + found.left.others > T(settled_gain))
      if (const auto now = at(v); now.left.is_less_than(found.left, T(settled_gain))) found = now;
    held = found.signs.held;
    return found.signs;
  }

  /// The force that brakes of these capacities [N m] make at the velocity now, once settled with the brakes
  /// at rest of `start`, or with those of nearest() where these cannot be at rest.
  template <class Device, class T, int D>
  static settled_force<T, D, M::brake_count> made_by(const Device& device, const desired_force<T, D>& Fd,
                                                     const brake_vector<M>& capacity,
                                                     approximation_start start) {
    settled_force<T, D, M::brake_count> F;
    F.torque = capacity;  // a NaN of the law stays, whatever is known of S
    const settled_rates<M> rates = rates_of(device);
    typename settled_rates<M>::rate_map W;
    if (!rates.find(start.held, W)) {
      start.held = nearest(device, Fd, T(0), start).held;
      if (!rates.find(start.held, W)) return F;
    }
    F.held = start.held;
    F.velocity = device.v;
    F.signs = settled_forces(rates, device.E, device.brakes, device.v).signs_of(W);
    const brake_vector<M> sense = brake_torque(device.E, Fd.direction);  // of those at rest
    for (int i = 0; i < M::brake_count; ++i)
      F.torque[i] = std::copysign(capacity[i], F.signs[i] != T(0) ? -F.signs[i] : sense[i]);
    const auto off = passive_haptics::brakes_off(F.signs, device.brakes);
    for (int i = 0; i < M::brake_count; ++i)
      if (detail::is_off(off, i)) F.torque[i] = T(0);
    F.force = W.transpose() * F.torque;
    return F;
  }

 private:
  template <class Device>
  static settled_rates<M> rates_of(const Device& device) {
    using T = typename M::scalar;
    return settled_rates<M>(device.pose, settled_rates<M>::default_share,
                            passive_haptics::brakes_without_torque<T, M::brake_count>(device.brakes));
  }
};

}  // namespace passive_haptics
