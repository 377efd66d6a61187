/// Section 4 for several touched walls, each with its own Fd and alpha.
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

/// Combines steps 1 and 3 (contact_forces), because the displayable forces depend on each alpha.
template <class Result, class Setup, class Walls>
struct several_walls {
  using M = typename Setup::mechanism_type;         ///< Mechanism.
  using L = typename Setup::law_type;               ///< Law.
  using T = typename M::scalar;                     ///< Scalar.
  static constexpr int d = M::task_dimension;       ///< Task dimensions.
  static constexpr int m = M::brake_count;          ///< Brakes.
  static constexpr int capacity = Walls::capacity;  ///< Maximum number of walls.
  using force = typename form_of<M>::force;         ///< Force with its torques.
  static_assert(!saturates_before_scaling<L>,
                "passive_haptics: a law that saturates before scaling takes one wall at a time; give this "
                "scene a law without saturates_before_scaling (control/control_law.hpp).");

  /// alpha and priority of each wall.
  struct scales {
    vector<T, capacity> leaving = vector<T, capacity>::Zero();               ///< n_j . v of wall j [m/s].
    vector<T, capacity> alpha = vector<T, capacity>::Ones();                 ///< alpha of wall j.
    std::array<bool, static_cast<std::size_t>(capacity)> has_priority = {};  ///< Left under direct control.
  };
  /// From Fd_j to td.
  struct steps {
    scales scale;            ///< 2
    vector<T, m> signs;      ///< Brake signs; settled ones for n > d.
    force_map<T, d, m> map;  ///< F = G t.
    torque_box<T, m> box;    ///< Torques of the brakes.
    force Fc_scaled;         ///< 1 and 3: the force nearest to all alpha_j Fd_j.
    saturated_torque<T, m> td = {vector<T, m>::Zero(), false};  ///< 4
  };

  const Setup& setup;                                ///< Setup of the cycle.
  const Walls& touched;                              ///< The walls.
  const int governing = governing_contact(touched);  ///< Wall with the maximum demand; -1 if there is none.

  desired_force<T, d> Fd(int j) const { return desired_force_of<T>(touched[j]); }  ///< Demand of wall j.

  /// True if a wall demands a force.
  bool demands_force() const { return governing >= 0 && is_nonzero(Fd(governing)); }

  /// Section 4.
  template <class Device>
  PASSIVE_HAPTICS_PART steps command(const Device& device, step_memory<L>& memory) const {
    // 2. alpha_j: displayed shares (12), and priorities
    const scales scale = scales_of(device);
    // 1. and 3. Fc': the force within the brakes' limits that is nearest to all alpha_j Fd_j
    force Fc_scaled = {};
    const demand_list demands = demands_of(scale);
    const vector<T, m> signs = form_of<M>::template signs<capacity>(
        device, demands.all, demands.count, touched.size(), [this](int j) { return Fd(j); }, memory.start,
        Fc_scaled);
    const auto map = form_of<M>::map(device.pose, device.E);
    const auto box = passive_haptics::torque_box_of(signs, device.brakes);
    find_force(Fc_scaled, demands, map, box, form_of<M>::units(signs, device.brakes));
    // 4. td: its torques, within the limits except for rounding of a product
    return {scale,     signs,
            map,       box,
            Fc_scaled, passive_haptics::within_limits(Fc_scaled.torque, device.brakes, setup.options.limits)};
  }

  /// Result of a cycle, with a report per wall. Classes and alpha are those of the wall with the maximum
  /// demand; display is exact if all demands are met.
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

  // Demands alpha_j |Fd_j|, and their number
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

  template <class Units>
  void find_force(force& F, const demand_list& demands, const force_map<T, d, m>& map,
                  const torque_box<T, m>& box, Units units) const {
    const auto met = contact_forces<T, d, m, capacity>(map, box, demands.all, demands.count, map.G, units);
    F.display = display_class::approximate;
    F.force = met.force;
    F.torque = met.torque;
  }

  status verdict(const steps& done) const {
    vector<T, capacity> magnitude = vector<T, capacity>::Zero();
    for (int j = 0; j < touched.size(); ++j) magnitude[j] = Fd(j).magnitude;
    const auto alpha = done.scale.alpha.array();
    const bool are_shares = (alpha >= T(0) && alpha <= T(1)).all();
    const status outcome = check_command<T>(touched, done.scale.leaving, are_shares, magnitude);
    if (outcome != status::ok) return outcome;
    return all_finite(done.map.G) ? status::ok : status::pose_undefined;
  }

  // Fc before alpha and limits, exact if each wall gets its whole demand. If rounding near a singular pose
  // puts it outside the cone, the commanded force is returned
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

  // True if Fc' = Fc: no scale, priority or limit is active
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
