/// Section 4 of the paper: direct control of one wall.
#pragma once

#include <passive_haptics/control/cycle_result.hpp>
#include <passive_haptics/control/pipeline.hpp>
#include <passive_haptics/core/flatten.hpp>

namespace passive_haptics {

/// One wall, or none.
template <class Result, class Setup, class Walls>
struct one_wall {
  using M = typename Setup::mechanism_type;    ///< Mechanism.
  using L = typename Setup::law_type;          ///< Law.
  using T = typename M::scalar;                ///< Scalar.
  static constexpr int d = M::task_dimension;  ///< Task dimensions.
  static constexpr int m = M::brake_count;     ///< Brakes.
  using steps = display_steps<M>;              ///< Fc, alpha, Fc', td.

  const Setup& setup;    ///< Setup of the cycle.
  const Walls& touched;  ///< The wall.

  /// Demand of the wall; no force in free space. Not a data member because g++ 12 would keep it in memory.
  desired_force<T, d> demanded() const {
    if (touched.empty()) return {vector<T, d>::Zero(), T(0), vector<T, d>::Zero()};
    return desired_force_of<T>(touched[0]);
  }

  bool demands_force() const { return is_nonzero(demanded()); }  ///< True if there is a force to display.

  /// Section 4.
  template <class Device>
  PASSIVE_HAPTICS_PART steps command(const Device& device, step_memory<L>& memory) const {
    const auto Fd = demanded();
    // 1. Fc: Fd itself, or the nearest producible force with Fc . n = |Fd|
    const auto Fc = Fd.magnitude * form_of<M>::nearest(device, Fd, setup.options.min_cosine, memory.start);
    // 2. alpha: the displayed share (12)
    const T alpha = setup.law.scale(
        contact_situation<T, d>{Fd.direction, Fd.magnitude, outward(Fd, device.v), device.hand_force});
    // 3. Fc': leaves no resultant force normal to the wall
    const auto Fc_scaled = alpha * Fc;
    // 4. td: its torques within the brakes' limits, which some laws apply before alpha
    if constexpr (saturates_before_scaling<L>)
      return {Fc, alpha, Fc_scaled, alpha * limited(Fc.torque, device)};
    else return {Fc, alpha, Fc_scaled, limited(Fc_scaled.torque, device)};
  }

  /// Result of a cycle.
  template <class Device>
  PASSIVE_HAPTICS_PART Result result(const Device& device, const steps& done, const brake_vector<M>& t,
                                     step_memory<L>&) const {
    const auto Fd = demanded();
    auto result = passive_haptics::result_of<Result>(device, touched, touched[0].wall_number, Fd, done, t);
    if constexpr (HasReports<Result>)
      if (result.outcome == status::ok) {
        const bool gives_way = nulls_normal_force<L> && outward(Fd, device.v) > T(0);
        passive_haptics::report_contacts(result, touched, commanded_force(device, done), [&](int) {
          return contact_report<T>{.wanted = done.alpha * Fd.magnitude, .has_priority = gives_way};
        });
      }
    return result;
  }

 private:
  // F of td: a multiple of Fc' unless each brake was limited separately
  template <class Device>
  vector<T, d> commanded_force(const Device& device, const steps& done) const {
    if (!done.td.limited) return done.Fc_scaled.force;
    if (setup.options.limits == saturation::clamp_each)
      return form_of<M>::map(device.pose, device.E).G * done.td.torque;
    return done.td.torque.cwiseAbs().maxCoeff() / done.Fc_scaled.torque.cwiseAbs().maxCoeff() *
           done.Fc_scaled.force;
  }

  template <class Device>
  saturated_torque<T, m> limited(const vector<T, m>& t, const Device& device) const {
    return passive_haptics::within_limits(t, device.brakes, setup.options.limits);
  }
};

}  // namespace passive_haptics
