/// Section 4 with effects: first the walls, then the effects with the remaining freedom of the brakes.
#pragma once

#include <passive_haptics/control/cycle_result.hpp>
#include <passive_haptics/control/pipeline.hpp>
#include <passive_haptics/control/pipelines/one_wall.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/walls_and_effects.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/force/torques/torques_beside.hpp>

#include <concepts>

namespace passive_haptics {

/// The single touched wall, and the effects.
template <class Walls, class... Effects>
auto as_single(const walls_and_effects<Walls, Effects...>& touched) {
  return walls_and_effects<decltype(as_single(touched.walls)), Effects...>{as_single(touched.walls),
                                                                           touched.effects};
}

/// Walls, then effects. Touched: walls_and_effects.
template <class Result, class Setup, class Touched>
struct beside_effects {
  using M = typename Setup::mechanism_type;                                            ///< Mechanism.
  using L = typename Setup::law_type;                                                  ///< Law.
  using T = typename M::scalar;                                                        ///< Scalar.
  using pipeline_of_walls = pipeline_of<Result, Setup, typename Touched::walls_type>;  ///< Without effects.
  static constexpr int d = M::task_dimension;                                          ///< Task dimensions.
  static constexpr int m = M::brake_count;                                             ///< Brakes.
  static_assert(ScalingLaw<L>,
                "passive_haptics: with_effects needs a ScalingLaw, such as direct_control: a TorqueLaw "
                "commands the brakes itself.");

  /// Demand of the effects.
  struct demands {
    task_vector<M> force = task_vector<M>::Zero();     ///< Fe [N].
    joint_vector<M> torque = joint_vector<M>::Zero();  ///< Torques of effects on joints [N m].
  };
  /// From Fd to td.
  struct steps {
    typename pipeline_of_walls::steps walls = {};  ///< Walls.
    demands effects = {};                          ///< Effects.
    saturated_torque<T, m> td = walls.td;          ///< Walls and effects.
    status outcome = status::result_not_finite;    ///< ok, or why effects could not be added.
  };

  const Setup& setup;                                   ///< Setup of the cycle.
  const Touched& touched;                               ///< Walls and effects.
  const pipeline_of_walls walls{setup, touched.walls};  ///< Pipeline without effects.

  static bool demands_force() { return true; }  ///< Effects may always demand something.

  /// Section 4 for the walls, then torques_beside for the effects.
  template <class Device>
  PASSIVE_HAPTICS_PART steps command(const Device& device, step_memory<L>& memory) const {
    steps done;
    if (walls.demands_force()) done.walls = walls.command(device, memory);
    done.td = done.walls.td;
    done.effects = demanded_by_effects(device);
    if (!all_finite(done.td.torque, done.effects.force, done.effects.torque)) return done;
    done.outcome = status::ok;
    // Nothing to add. The drag is minimal unless each brake was limited separately
    const bool has_min_drag = !done.td.limited || setup.options.limits == saturation::keep_direction;
    if (has_min_drag && done.effects.force.isZero(T(0)) && done.effects.torque.isZero(T(0))) return done;

    const auto map = form_of<M>::map(device.pose, device.E);
    if (!all_finite(map.G)) {
      done.outcome = status::pose_undefined;
      return done;
    }
    const vector<T, m> signs = form_of<M>::signs_beside(device, done.walls.Fc_scaled, done.walls.td.torque,
                                                        done.effects, memory.start);
    const auto box = passive_haptics::torque_box_of(signs, device.brakes);
    done.td.torque =
        torques_beside(map, box, done.td.torque, normals(), effect_demand_of(device, done.effects),
                       form_of<M>::units(signs, device.brakes));
    done.td.limited = done.td.limited || passive_haptics::any_at_limit(done.td.torque, device.brakes);
    if (!all_finite(done.td.torque)) done.outcome = status::result_not_finite;  // demands near overflow
    return done;
  }

  /// Result of a cycle: that of the walls, and the demands of the effects.
  template <class Device>
  PASSIVE_HAPTICS_PART Result result(const Device& device, const steps& done, const brake_vector<M>& t,
                                     step_memory<L>& memory) const {
    Result result;
    if (walls.demands_force()) {
      result = walls.result(device, done.walls, t, memory);
      if (result.outcome == status::ok) result.capacity = done.td.torque.cwiseAbs();
      if constexpr (requires { result.saturated; }) result.saturated = result.saturated || done.td.limited;
    } else {
      result = released<Result>(passive_haptics::status_without_force<M>(device.x, touched.walls));
      result.capacity = done.td.torque.cwiseAbs();
      if constexpr (requires { result.torque; }) {
        result.torque = t;
        result.saturated = done.td.limited;
        result.signs = device.s;
      }
    }
    if (result.outcome == status::ok)
      result.outcome = all_finite(device.v) ? done.outcome : status::pose_undefined;
    if (result.outcome != status::ok)
      return passive_haptics::released<Result>(setup, device.time, result.outcome, memory);
    if constexpr (requires { result.effect_force; }) {
      result.effect_force = done.effects.force;
      result.effect_torque = done.effects.torque;
      result.torque_for_walls = done.walls.td.torque;
      result.torque_for_effects = done.td.torque - done.walls.td.torque;
    }
    return result;
  }

 private:
  // J^T F
  template <class Device>
  static joint_vector<M> torque_at_joints(const Device& device, const vector<T, d>& F) {
    if constexpr (m < M::dof) return transposed(jacobian_matrix<M>(device.pose.jacobian())) * F;
    else return device.pose.transposed_transmission() * brake_torque(device.E, F);
  }

  template <class Device>
  demands demanded_by_effects(const Device& device) const {
    demands all;
    detail::for_each(touched.effects, [&]<class E>(const E& effect) {
      static_assert(std::same_as<typename E::scalar, T>,
                    "passive_haptics: an effect's scalar must be the mechanism's.");
      if constexpr (Effect<E>) {
        all.force += effect.force(as<T>(device.x), device.v, device.hand_force);
      } else if constexpr (WallEffect<E>) {
        all.force += effect.force_at(touched.walls, device.v, device.hand_force);
      } else {
        static_assert(E::dof == M::dof,
                      "passive_haptics: an effect on joints must be of as many as the mechanism has.");
        all.torque += effect.torque(device.q, device.qd, torque_at_joints(device, device.hand_force));
      }
    });
    return all;
  }

  // Additional torques of joints with an effect torque: that, and their share of effect forces
  template <class Device>
  auto effect_demand_of(const Device& device, const demands& wanted) const {
    effect_demand<T, d, m, M::dof> demand{wanted.force, device.pose.transposed_transmission(), wanted.torque};
    for (int i = 0; i < M::dof; ++i)
      if (wanted.torque[i] == 0) demand.joint_rows.row(i).setZero();
    if constexpr (m < M::dof) {
      const joint_vector<M> of_force = torque_at_joints(device, wanted.force);
      for (int i = 0; i < M::dof; ++i)
        if (wanted.torque[i] != 0) demand.joint_torque[i] += of_force[i];
    } else {
      demand.joint_torque += demand.joint_rows * brake_torque(device.E, wanted.force);
    }
    return demand;
  }

  // n_j of the walls that demand a force, in rows
  auto normals() const {
    matrix<T, Touched::capacity, d> rows = matrix<T, Touched::capacity, d>::Zero();
    for (int j = 0; j < touched.walls.size(); ++j) {
      const auto Fd = desired_force_of<T>(touched.walls[j]);
      if (is_nonzero(Fd)) rows.row(j) = Fd.direction.transpose();
    }
    return rows;
  }
};

}  // namespace passive_haptics
