/// @file
/// Section 4 for several touched walls: each keeps its own Fd and alpha, and one set of torques meets them in
/// order of priority (force/torques/contact_forces.hpp).
#pragma once

#include <passive_haptics/control/cycle_result.hpp>
#include <passive_haptics/control/pipeline.hpp>
#include <passive_haptics/control/pipelines/one_wall.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/nth.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace passive_haptics {

/// Several walls. Steps 1 and 3 are one: what can be displayed of several forces depends on each one's alpha.
template <class Result, class Setup, class Walls>
struct several_walls {
  using M = typename Setup::mechanism_type;         ///< Mechanism.
  using L = typename Setup::law_type;               ///< Law.
  using T = typename M::scalar;                     ///< Scalar.
  static constexpr int d = M::task_dimension;       ///< Task dimensions,
  static constexpr int m = M::brake_count;          ///< brakes.
  static constexpr int capacity = Walls::capacity;  ///< Walls at most.
  using force = typename form_of<M>::force;         ///< With the torques that make it.
  static_assert(!saturates_before_scaling<L>,
                "passive_haptics: a law that saturates before scaling takes one wall at a time; give this "
                "scene a law without saturates_before_scaling (control/control_law.hpp).");

  /// alpha of each wall, and which are met before the others.
  struct scales {
    vector<T, capacity> leaving = vector<T, capacity>::Zero();               ///< n_j . v of wall j [m/s].
    vector<T, capacity> alpha = vector<T, capacity>::Ones();                 ///< Of wall j.
    std::array<bool, static_cast<std::size_t>(capacity)> has_priority = {};  ///< Left, and the law gives way.
  };
  /// From Fd_j to td.
  struct steps {
    scales scale;            ///< 2
    vector<T, m> signs;      ///< Of the brakes; for n > d once they have settled.
    force_map<T, d, m> map;  ///< F = G t.
    torque_box<T, m> box;    ///< Torques that the brakes can make.
    force Fc_scaled;         ///< 1 and 3: the force that meets all alpha_j Fd_j.
    saturated_torque<T, m> td = {vector<T, m>::Zero(), false};  ///< 4
  };

  const Setup& setup;                                ///< Of the cycle.
  const Walls& touched;                              ///< The walls.
  const int governing = governing_contact(touched);  ///< The one that demands most; -1 if there is none.

  /// What wall j demands.
  desired_force<T, d> Fd(int j) const { return desired_force_of<T>(touched[j]); }

  /// Whether one of them demands a force.
  bool demands_force() const { return governing >= 0 && is_nonzero(Fd(governing)); }

  /// Section 4.
  template <class Device>
  PASSIVE_HAPTICS_PART steps command(const Device& device, step_memory<L>& memory) const {
    // 2. alpha_j: how much of what each wall demands is displayed (12), and which walls come first
    const scales scale = scales_of(device);
    // 1. and 3. Fc': the force nearest to all alpha_j Fd_j that the brakes can make within their limits
    force Fc_scaled = {};
    const demand_list demands = demands_of(scale);
    const vector<T, m> signs = form_of<M>::template signs<capacity>(
        device, demands.all, demands.count, touched.size(), [this](int j) { return Fd(j); }, memory.start,
        Fc_scaled);
    const auto map = form_of<M>::map(device.pose, device.E);
    const auto box = passive_haptics::torque_box_of(signs, device.brakes);
    find_force(Fc_scaled, demands, map, box, form_of<M>::units(signs, device.brakes));
    // 4. td: its torques, which are within the limits but for the rounding of a product
    return {scale,     signs,
            map,       box,
            Fc_scaled, passive_haptics::within_limits(Fc_scaled.torque, device.brakes, setup.options.limits)};
  }

  /// The result of a cycle. Its classes and alpha are those of the wall that demands most, display is
  /// exact where each wall gets all that it demands, and each has a report.
  template <class Device>
  PASSIVE_HAPTICS_PART Result result(const Device& device, const steps& done, const brake_vector<M>& t,
                                     step_memory<L>&) const {
    const status outcome = verdict(done);
    if (outcome != status::ok) return released<Result>(outcome);
    const auto of_governing = [&](const force& Fc) PASSIVE_HAPTICS_INLINE {
      const display_steps<M> one{Fc, done.scale.alpha[governing], done.Fc_scaled, done.td};
      return passive_haptics::result_of<Result>(device, touched, touched[governing].wall_number,
                                                Fd(governing), one, t);
    };
    if constexpr (!HasReports<Result>) {
      return of_governing(done.Fc_scaled);
    } else {
      if (!all_finite(done.Fc_scaled.torque)) return released<Result>(status::result_not_finite);
      Result result = of_governing(unscaled_force(device, done));
      if (result.outcome != status::ok) return result;
      result.saturated = passive_haptics::any_at_limit(done.td.torque, device.brakes);
      passive_haptics::report_contacts(result, touched, done.Fc_scaled.force, [&](int j) {
        return contact_report<T>{.wanted = done.scale.alpha[j] * Fd(j).magnitude,
                                 .has_priority = nth(done.scale.has_priority, j)};
      });
      return result;
    }
  }

 private:
  template <class Device>
  scales scales_of(const Device& device) const {
    scales all;
    for (int j = 0; j < touched.size(); ++j) {
      const auto wanted = Fd(j);
      const T leaving = all.leaving[j] = outward(wanted, device.v);
      nth(all.has_priority, j) = nulls_normal_force<L> && leaving > T(0);
      if (is_nonzero(wanted))
        all.alpha[j] = setup.law.scale(
            contact_situation<T, d>{wanted.direction, wanted.magnitude, leaving, device.hand_force});
    }
    return all;
  }

  // What the walls demand: alpha_j |Fd_j|, the count of them
  struct demand_list {
    std::array<contact_demand<T, d>, static_cast<std::size_t>(capacity)> all;
    int count = 0;
  };
  demand_list demands_of(const scales& scale) const {
    demand_list demands;
    for (int j = 0; j < touched.size(); ++j) {
      const auto wanted = Fd(j);
      if (!is_nonzero(wanted)) continue;
      nth(demands.all, demands.count++) = {wanted.direction, scale.alpha[j] * wanted.magnitude,
                                           nth(scale.has_priority, j)};
    }
    return demands;
  }

  // The force that gives each wall alpha_j |Fd_j|, in order of priority
  template <class Units>
  void find_force(force& F, const demand_list& demands, const force_map<T, d, m>& map,
                  const torque_box<T, m>& box, Units units) const {
    const auto met = contact_forces<T, d, m, capacity>(map, box, demands.all, demands.count, map.G, units);
    F.display = display_class::approximate;
    F.force = met.force;
    F.torque = met.torque;
  }

  // ok, or why this is no command
  status verdict(const steps& done) const {
    vector<T, capacity> magnitude = vector<T, capacity>::Zero();
    for (int j = 0; j < touched.size(); ++j) magnitude[j] = Fd(j).magnitude;
    const auto alpha = done.scale.alpha.array();
    const bool are_shares = (alpha >= T(0) && alpha <= T(1)).all();
    const status outcome = check_command<T>(touched, done.scale.leaving, are_shares, magnitude);
    if (outcome != status::ok) return outcome;
    return all_finite(done.map.G) ? status::ok : status::pose_undefined;
  }

  // Fc before alpha and limits, exact where each wall gets all that it demands. Near a singular pose rounding
  // decides what brakes without limits could do: then it is what is commanded
  template <class Device>
  force unscaled_force(const Device& device, const steps& done) const {
    const vector<T, d> n = Fd(governing).direction;
    force F = done.Fc_scaled;
    if (!is_whole(done))
      find_force(F, demands_of({}), done.map,
                 passive_haptics::unbounded_torque_box_of(done.signs, device.brakes),
                 form_of<M>::units(done.signs, device.brakes));
    if (!form_of<M>::is_in_cone(device, done.signs, done.map.G, F)) {
      F = done.Fc_scaled;
    } else {
      const T tolerance = rounding_tolerance<T>(m + capacity) * size_of_terms(done.map.G, F.torque);
      bool met = true;
      for (int j = 0; j < touched.size(); ++j) {
        const auto wanted = Fd(j);
        if (is_nonzero(wanted))
          met = met && std::abs(wanted.magnitude - wanted.direction.dot(F.force)) <= tolerance;
      }
      if (met) F.display = display_class::exact;
      else if (F.force.isZero(T(0))) F.display = display_class::none;
    }
    F.cosine_squared = cosine_squared(F.force, n);
    return F;
  }

  // Whether Fc' is Fc: no wall's force is scaled or comes first, no limit is met
  bool is_whole(const steps& done) const {
    bool whole = true;
    for (int j = 0; j < touched.size(); ++j)
      whole = whole && done.scale.alpha[j] == T(1) && !nth(done.scale.has_priority, j);
    const vector<T, m>& t = done.Fc_scaled.torque;
    for (int i = 0; i < m; ++i)
      whole = whole && (t[i] == T(0) || (t[i] > done.box.lower[i] && t[i] < done.box.upper[i]));
    return whole;
  }
};

}  // namespace passive_haptics
