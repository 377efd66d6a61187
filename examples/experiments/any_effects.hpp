/// Effects chosen at run time.
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
  virtual ~any_effect() = default;
  /// Force on the handle [N] at x [m] with velocity v [m/s] and hand force [N].
  virtual vector force(const vector& x, const vector& v, const vector& hand_force,
                       const contacts& touched) const = 0;
};

/// A JointEffect on N joints.
template <int N>
struct any_joint_effect {
  using vector = ph::vector<double, N>;  ///< [rad], [rad/s] or [N m].
  virtual ~any_joint_effect() = default;
  /// Torques [N m] of the joints at q with rates qd and the hand's torques.
  virtual vector torque(const vector& q, const vector& qd, const vector& hand_torque) const = 0;
};

/// The sum of effects on the handle, in order. It is an Effect, although some effects depend on the walls,
/// which its scene provides.
template <int D>
class effects_on_handle {
  using vector = ph::vector<double, D>;

 public:
  using scalar = double;               ///< As Effect.
  static constexpr int dimension = D;  ///< d

  void add(std::shared_ptr<const any_effect<D>> one) { all_.push_back(std::move(one)); }
  /// Sets the touched walls, which must outlive the next call of force().
  void see(const typename any_scene<D>::contacts_type& touched) { touched_ = &touched; }
  vector force(const vector& x, const vector& v, const vector& hand_force) const {
    vector sum = vector::Zero();
    for (const auto& one : all_) sum += one->force(x, v, hand_force, *touched_);
    return sum;
  }

 private:
  std::vector<std::shared_ptr<const any_effect<D>>> all_;
  const typename any_scene<D>::contacts_type* touched_ = nullptr;
};

/// The sum of effects on the joints, in order. A JointEffect.
template <int N>
class effects_on_joints {
  using vector = ph::vector<double, N>;

 public:
  using scalar = double;         ///< As JointEffect.
  static constexpr int dof = N;  ///< n

  void add(std::shared_ptr<const any_joint_effect<N>> one) { all_.push_back(std::move(one)); }
  vector torque(const vector& q, const vector& qd, const vector& hand_torque) const {
    vector sum = vector::Zero();
    for (const auto& one : all_) sum += one->torque(q, qd, hand_torque);
    return sum;
  }

 private:
  std::vector<std::shared_ptr<const any_joint_effect<N>>> all_;
};

/// A spatial or planar scene with walls and effects, for a mechanism of N joints. Its result type is that of
/// a scene without effects, which compiles faster.
template <int D, int N>
class scene_with_effects {
  using walls_type = typename any_scene<D>::contacts_type;
  using touched_type = ph::walls_and_effects<const walls_type&, effects_on_handle<D>, effects_on_joints<N>>;

 public:
  static constexpr int dimension = D;  ///< d
  /// Contacts and effects, with the result type of a cycle.
  struct contacts_type : touched_type {
    template <class M>
    using result_type = ph::step_result_for<M, walls_type>;
  };

  explicit scene_with_effects(any_scene<D> walls) : walls_(std::move(walls)) {}
  effects_on_handle<D>& on_handle() { return boost::hana::at_c<0>(effects_); }
  effects_on_joints<N>& on_joints() { return boost::hana::at_c<1>(effects_); }
  /// Forgets the handle and a held sample.
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
