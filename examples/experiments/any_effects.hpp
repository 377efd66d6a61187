/// @file
/// Effects beside walls that are known at run time only.
#pragma once

#include "any_scene.hpp"

#include <passive_haptics/control/pipelines/with_effects.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace experiments {

/// An Effect or a WallEffect in D dimensions.
template <int D>
struct any_effect {
  using vector = ph::vector<double, D>;                   ///< [m], [m/s] or [N].
  using contacts = typename any_scene<D>::contacts_type;  ///< The walls that are touched.
  /// As of a base class.
  virtual ~any_effect() = default;
  /// Force on the handle [N] at x [m] with velocity v [m/s] and hand force [N].
  virtual vector force(const vector& x, const vector& v, const vector& hand_force,
                       const contacts& touched) const = 0;
};

/// A JointEffect on N joints.
template <int N>
struct any_joint_effect {
  using vector = ph::vector<double, N>;  ///< [rad], [rad/s] or [N m].
  /// As of a base class.
  virtual ~any_joint_effect() = default;
  /// Torques [N m] of the joints at q with rates qd and the hand's torques.
  virtual vector torque(const vector& q, const vector& qd, const vector& hand_torque) const = 0;
};

/// The sum of effects on the handle, in their order. An Effect, although some may see the walls: its
/// scene shows them to it.
template <int D>
class effects_on_handle {
  using vector = ph::vector<double, D>;

 public:
  using scalar = double;               ///< As of an Effect.
  static constexpr int dimension = D;  ///< d

  /// Adds an effect.
  void add(std::shared_ptr<const any_effect<D>> one) { all_.push_back(std::move(one)); }
  /// Shows the walls that are touched, which must outlive the next call of force().
  void see(const typename any_scene<D>::contacts_type& touched) { touched_ = &touched; }
  /// As of an Effect.
  vector force(const vector& x, const vector& v, const vector& hand_force) const {
    vector sum = vector::Zero();
    for (const auto& one : all_) sum += one->force(x, v, hand_force, *touched_);
    return sum;
  }

 private:
  std::vector<std::shared_ptr<const any_effect<D>>> all_;
  const typename any_scene<D>::contacts_type* touched_ = nullptr;
};

/// The sum of effects on the joints, in their order. A JointEffect.
template <int N>
class effects_on_joints {
  using vector = ph::vector<double, N>;

 public:
  using scalar = double;         ///< As of a JointEffect.
  static constexpr int dof = N;  ///< n

  /// Adds an effect.
  void add(std::shared_ptr<const any_joint_effect<N>> one) { all_.push_back(std::move(one)); }
  /// As of a JointEffect.
  vector torque(const vector& q, const vector& qd, const vector& hand_torque) const {
    vector sum = vector::Zero();
    for (const auto& one : all_) sum += one->torque(q, qd, hand_torque);
    return sum;
  }

 private:
  std::vector<std::shared_ptr<const any_joint_effect<N>>> all_;
};

/// A scene in D dimensions with effects beside its walls, for a mechanism of N joints. Its result is
/// that of a scene without effects, so that less is compiled.
template <int D, int N>
class scene_with_effects {
  using walls_type = typename any_scene<D>::contacts_type;
  using touched_type = ph::walls_and_effects<const walls_type&, effects_on_handle<D>, effects_on_joints<N>>;

 public:
  static constexpr int dimension = D;  ///< d
  /// What sensing gives, and the result of a cycle.
  struct contacts_type : touched_type {
    /// As of the walls alone.
    template <class M>
    using result_type = ph::step_result_for<M, walls_type>;
  };

  /// Of these walls.
  explicit scene_with_effects(any_scene<D> walls) : walls_(std::move(walls)) {}
  /// The effects on the handle.
  effects_on_handle<D>& on_handle() { return boost::hana::at_c<0>(effects_); }
  /// The effects on the joints.
  effects_on_joints<N>& on_joints() { return boost::hana::at_c<1>(effects_); }
  /// Forgets the handle, and the latest sample where one is held.
  void reset() { walls_.reset(); }
  /// The walls touched at x [m] and a time [s], and the effects; valid until the next call.
  touched_type touched_at(const ph::point<D>& x, double time) {
    const walls_type& touched = walls_.touched_at(x, time);
    on_handle().see(touched);
    return touched_type{touched, effects_};
  }

 private:
  any_scene<D> walls_;
  ph::detail::effects_of<effects_on_handle<D>, effects_on_joints<N>> effects_;
};

}  // namespace experiments
