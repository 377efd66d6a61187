/// Velocity-level direct control: keeps the handle at a small depth in each wall.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/laws/contact_memory.hpp>
#include <passive_haptics/control/laws/velocity/acceleration_display.hpp>
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>
#include <passive_haptics/control/laws/velocity/min_power.hpp>
#include <passive_haptics/control/laws/velocity/settled_torques.hpp>
#include <passive_haptics/control/laws/velocity/stopping_torques.hpp>
#include <passive_haptics/control/laws/velocity/torque_range.hpp>
#include <passive_haptics/control/laws/velocity/velocity_contact_state.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control_parameters.hpp>
#include <passive_haptics/control/laws/velocity/wall_demand.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace passive_haptics {

/// Direct control that keeps the handle at a small depth in each wall. The normal force f is mostly learned,
/// so the measured hand force, the brake gains and the inertia need not be accurate.
///
///     f   = f_ff + b + Lambda_n (v_ref - n . v) / tau_v                              demand of the wall [N]
///     f_ff = -Lambda_n (v^T H v + n . a_0)                                           feedforward
///     v_ref = clip(k_d (depth - d_ref), +-v_max),
///     db/dt = Lambda_n (v_ref - n . v) / (tau_v tau_i)                               the bias
///
/// H is the curvature of the wall, Lambda_n the inertia along n of the device with a hand mass m_h on its
/// handle, and a_0 the acceleration without brakes under the share phi of the measured hand force. (A larger
/// share would feed back the hand's own mass.) The brakes produce f as accurately as possible with minimum
/// power, and nothing if they would have to push the handle in. Their lag is inverted over a horizon.
///
/// **Sticking brakes.** In steady sliding, the torque that cancels the push is the sticking torque, and a
/// sticking brake holds at any command. Therefore b does not grow then, and while the handle leaves, b decays
/// to 1/e within release_length, until the brake slips and its torque is known. A brake at rest counts for at
/// most twice its holding torque, and for nothing if it would hold the handle in. While the handle sinks, no
/// brake at rest is reduced below its current torque, because errors of gains and sensor may hide the load.
/// The direction of a brake is that of its rate after the landing (torque_range).
///
/// **Several walls.** Only walls with f > 0 constrain the handle. They get their forces together, as
/// accurately as possible. A brake at rest then takes its sign from its holding torque; the rates w* that the
/// walls demand decide only for one wall, because near a corner they describe a fictitious motion into the
/// shallower one. If the walls enclose the handle (is_cornered), all brakes stop it (stopping_torques) and b
/// is frozen. The same applies to a handle that moves into all walls while one of them gets less than half of
/// its f: near a fold no brake may have a force along a normal, but together they can stop the motion. A hand
/// that pulls out ends this state in the first cycle that detects it.
///
/// **Steady-state depth.** d_ref is rest_depth with fine encoders, and a multiple of the depth jumps with
/// coarse ones (velocity_contact_state). It must be larger if lags and dead times are less certain:
/// docs/results.md has contact losses for 1 to 4 mm. b and the jumps belong to a contact (contact_memory).
///
/// **Margin.** At 0.1 m/s, a handle is over a millimetre deep before lagging brakes hold it. Scenes therefore
/// provide contacts from margin() on, approach_speed (1 / k_d + 3 T_b) with T_b of the slowest brake.
/// Contacts held by a slow virtual environment are extrapolated to second order from their sensed position.
///
/// Requires the hand force, the inertia and the brake lag. Cost: an n x n Cholesky decomposition and, with a
/// brake at rest, another solution; for several walls a cone projection and a prioritised least squares.
class velocity_direct_control {
 public:
  static constexpr bool needs_hand_force = true;   ///< Needs a force sensor at the handle.
  static constexpr bool needs_dynamics = true;     ///< Needs the inertia of the mechanism.
  static constexpr bool needs_brake_lag = true;    ///< Needs the time constants of the brakes.
  static constexpr bool needs_sensed_at = true;    ///< Extrapolates held contacts to the handle.
  static constexpr bool needs_rising_time = true;  ///< Integrates over the time between cycles.
  static constexpr bool commands_torques = true;   ///< Required by TorqueLaw.
  static constexpr int max_contacts = 8;           ///< Maximum number of walls.

  using contact_state = velocity_contact_state;  ///< State of one contact.
  /// Memory between cycles.
  struct memory {
    contact_memory<contact_state, max_contacts> walls;        ///< One state per contact.
    brake_lag_model brakes;                                   ///< Torques of the brakes.
    approximation_start start;                                ///< n > d: the brakes that come to rest.
    bool moving = false;                                      ///< Rates and time are valid.
    double time = 0;                                          ///< Time of the previous cycle [s].
    std::array<double, brake_lag_model::max_brakes> rates{};  ///< Low-passed joint rates [rad/s or m/s].
    seen_position position;                                   ///< Position of the handle.
  };

  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit velocity_direct_control(const velocity_direct_control_parameters& p = {}) : p_(require_valid(p)) {}

  const velocity_direct_control_parameters& parameters() const { return p_; }  ///< The constants as given.

  /// Distance from a wall at which its contact is needed [m].
  template <class B>
  double margin(const B& brakes) const noexcept {
    return p_.margin(max_lag(brakes));
  }

  /// Brake torques [N m].
  template <class M, class EMatrix, int D, int Capacity, class B>
  brake_vector<M> torque(const brake_situation<M, EMatrix, B>& device, const contacts<D, Capacity>& touched,
                         memory& remembered) const noexcept {
    using T = typename M::scalar;
    constexpr int m = M::brake_count;
    const double dt = remembered.moving ? device.time - remembered.time : 0.0;
    const joint_vector<M> qd = smooth_rates<M>(device.qd, dt, remembered);
    const pose_dynamics<M> dynamics(device.pose, qd, static_cast<T>(p_.hand_mass));
    remembered.moving = true;
    remembered.time = device.time;
    remembered.brakes.advance(device.time, device.brakes.time_constant);
    remembered.walls.begin_cycle(touched);
    const double moved = remembered.position.move_to(device.x);
    std::array<wall_demand<T, D, m>, std::size_t(Capacity)> walls;
    const task_vector<M> Fh = static_cast<T>(p_.force_share) * device.hand_force;
    const T lag = velocity_lag<T>(device.brakes);
    for (int j = 0; j < touched.size(); ++j)
      nth(walls, j) = passive_haptics::wall_demand_of(touched[j], device, dynamics, Fh, dt, moved,
                                                      remembered.walls[j], p_, lag);
    const int count = touched.size();
    if constexpr (Capacity > 1)
      if (count > 1) {
        const weighted_motion<M> motion(dynamics, qd, device.hand_force);
        if (passive_haptics::is_cornered(dynamics, motion, walls, count, lag))
          return stop(device, dynamics, motion, remembered);
      }
    if constexpr (Settles<M>) return settled_torque(device, dynamics, walls, count, dt, remembered);
    else return min_power_torque(device, dynamics, qd, walls, count, dt, remembered);
  }

  /// Forgets the walls.
  void released(memory& remembered, double) const noexcept {
    remembered.walls.clear();
    remembered.brakes.release();
    remembered.moving = false;
  }

 private:
  // n > d: torques with settled signs
  template <class M, class Device, class Wall, std::size_t Capacity>
  brake_vector<M> settled_torque(const Device& device, const pose_dynamics<M>& dynamics,
                                 std::array<Wall, Capacity>& walls, int count, double dt,
                                 memory& remembered) const {
    using T = typename M::scalar;
    const int demanding = passive_haptics::demanding_first(walls, count);
    const auto found = passive_haptics::settled_torques_for<M>(
        device, dynamics, walls, count, demanding, static_cast<T>(p_.force_share), remembered.start);
    for (auto j = std::size_t(0); j < std::size_t(count); ++j) {
      const bool demands = j < std::size_t(demanding);
      walls[j].learn(found.made[j], demands ? found.max_force[j] : std::numeric_limits<T>::infinity(),
                     found.sticks, dt, p_);
    }
    return passive_haptics::torques_to_command(
        device, found.capacity, passive_haptics::lag_shares(device.brakes, p_.horizon), remembered.brakes);
  }

  // n = d: torques of minimum power
  template <class M, class Device, class Wall, std::size_t Capacity>
  brake_vector<M> min_power_torque(const Device& device, const pose_dynamics<M>& dynamics,
                                   const joint_vector<M>& qd, std::array<Wall, Capacity>& walls, int count,
                                   double dt, memory& remembered) const {
    using T = typename M::scalar;
    constexpr int m = M::brake_count;
    const int demanding = passive_haptics::demanding_first(walls, count);
    const brake_vector<M> w = passive_haptics::landing_rates(walls, demanding, dynamics);
    const bool alone = demanding == 1;
    const auto brakes =
        alone ? passive_haptics::torque_ranges_of(device, dynamics, w, walls[0].along.g, remembered.brakes,
                                                  p_.horizon)
              : passive_haptics::torque_ranges_of(device, dynamics, remembered.brakes, p_.horizon);
    const auto u = form_of<M>::units(brake_vector<M>(-brakes.sign), device.brakes);
    brake_vector<M> t = min_power_torques(walls, demanding, brakes, w, u);
    for (int j = 0; j < count; ++j) learn(nth(walls, j), brakes, t, dt);
    if constexpr (Capacity > 1)
      if (count > 1 && passive_haptics::enters_undisplayed(walls, count, brakes, t))
        return stop(device, dynamics, weighted_motion<M>(dynamics, qd, device.hand_force), remembered);
    const bool sinks = alone && walls[0].speed_error > T(0);
    for (int i = 0; i < m; ++i)
      if (sinks && t[i] > T(0) && t[i] >= brakes.upper[i]) t[i] = std::max(t[i], brakes.kept[i]);
    return passive_haptics::torques_to_command(device, t, brakes.lag_share, remembered.brakes);
  }

  template <class M>
  joint_vector<M> smooth_rates(const joint_vector<M>& qd, double dt, memory& remembered) const {
    static_assert(M::dof <= static_cast<int>(brake_lag_model::max_brakes),
                  "passive_haptics: velocity_direct_control is for at most 12 joints.");
    const double share = remembered.moving ? lag_share(dt, p_.rate_lag) : 1.0;
    joint_vector<M> smooth;
    unrolled<M::dof>([&](auto i) {
      double& rate = nth(remembered.rates, i);
      rate += share * (static_cast<double>(qd[i]) - rate);
      smooth[i] = static_cast<typename M::scalar>(rate);
    });
    return smooth;
  }

  template <class B>
  static double max_lag(const B& brakes) {
    return static_cast<double>(brakes.time_constant.maxCoeff());
  }

  // tau_v [s]
  template <class T, class B>
  T velocity_lag(const B& brakes) const {
    return static_cast<T>(p_.velocity_lag_for(max_lag(brakes)));
  }

  // All brakes stop the motion. The lag of brakes at rest is not inverted.
  template <class M, class Device>
  brake_vector<M> stop(const Device& device, const pose_dynamics<M>& dynamics,
                       const weighted_motion<M>& motion, memory& remembered) const {
    using T = typename M::scalar;
    auto share = passive_haptics::lag_shares(device.brakes, p_.horizon);
    unrolled<M::brake_count>([&](auto i) {
      if (!slips(dynamics.rates[i], rate_dead_band_of<T>(device.brakes, i))) share[i] = T(1);
    });
    return passive_haptics::torques_to_command(
        device,
        passive_haptics::stopping_torques(dynamics, motion, device.brakes, velocity_lag<T>(device.brakes)),
        share, remembered.brakes);
  }

  template <class Wall, class T, int Brakes>
  void learn(const Wall& wall, const torque_range<T, Brakes>& brakes, const vector<T, Brakes>& t,
             double dt) const {
    const vector<T, Brakes> gain = wall.along.inertia * brakes.sign.cwiseProduct(wall.along.g);
    T made = T(0), max_force = T(0);
    bool sticks = true;
    unrolled<Brakes>([&](auto i) {
      made += gain[i] * t[i];
      if (gain[i] > T(0)) max_force += gain[i] * brakes.upper[i];  // a limit may be infinite
      if (gain[i] > T(0) && t[i] > T(0) && !brakes.at_rest[i]) sticks = false;
    });
    wall.learn(made, max_force, sticks, dt, p_);
  }

  velocity_direct_control_parameters p_;
};

}  // namespace passive_haptics
