/// Effects chosen at run time, and scenes with them.
#pragma once

#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/runtime/any_scene.hpp>

#include <concepts>
#include <memory>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Holds an Effect, a WallEffect or a JointEffect of a device with D = n = d. Shared by its copies.
template <int D>
class any_effect {
 public:
  using numbers = vector<double, D>;                        ///< [m], [rad], [N], [N m] and their rates.
  using walls_type = typename any_scene<D>::contacts_type;  ///< Touched walls.

  /// Holds this effect.
  template <class E>
    requires(!std::same_as<E, any_effect>)
  explicit any_effect(E effect) : held_(std::make_shared<model<E>>(std::move(effect))) {}

  /// True for an effect on joints; force() is then zero, else torque() is.
  bool is_on_joints() const { return held_->is_on_joints(); }
  /// Force on the handle [N] at x [m] with velocity v [m/s], hand force [N] and touched walls.
  numbers force(const numbers& x, const numbers& v, const numbers& hand_force,
                const walls_type& touched) const {
    return held_->force(x, v, hand_force, touched);
  }
  /// Torques of the joints [N m] at q [rad] with rates qd [rad/s] and the hand's torques [N m].
  numbers torque(const numbers& q, const numbers& qd, const numbers& hand_torque) const {
    return held_->torque(q, qd, hand_torque);
  }

 private:
  struct any_model {
    virtual ~any_model() = default;
    virtual bool is_on_joints() const = 0;
    virtual numbers force(const numbers& x, const numbers& v, const numbers& hand_force,
                          const walls_type& touched) const = 0;
    virtual numbers torque(const numbers& q, const numbers& qd, const numbers& hand_torque) const = 0;
  };
  template <class E>
  struct model final : any_model {
    explicit model(E e) : effect(std::move(e)) {}
    bool is_on_joints() const override { return JointEffect<E>; }
    numbers force([[maybe_unused]] const numbers& x, [[maybe_unused]] const numbers& v,
                  [[maybe_unused]] const numbers& hand_force,
                  [[maybe_unused]] const walls_type& touched) const override {
      if constexpr (Effect<E>) return effect.force(x, v, hand_force);
      else if constexpr (WallEffect<E>) return effect.force_at(touched, v, hand_force);
      else return numbers::Zero();
    }
    numbers torque([[maybe_unused]] const numbers& q, [[maybe_unused]] const numbers& qd,
                   [[maybe_unused]] const numbers& hand_torque) const override {
      if constexpr (JointEffect<E>) return effect.torque(q, qd, hand_torque);
      else return numbers::Zero();
    }
    E effect;
  };

  std::shared_ptr<const any_model> held_;
};

/// A scene with walls and effects for a device with D = n = d, with the result type of the scene.
template <int D>
class any_scene_with_effects {
  using numbers = vector<double, D>;
  using walls_type = typename any_scene<D>::contacts_type;
  using effect_list = std::vector<any_effect<D>>;

  struct on_handle {
    using scalar = double;
    static constexpr int dimension = D;
    numbers force(const numbers& x, const numbers& v, const numbers& hand_force) const {
      numbers sum = numbers::Zero();
      for (const auto& one : *all)
        if (!one.is_on_joints()) sum += one.force(x, v, hand_force, *touched);
      return sum;
    }
    const effect_list* all;
    const walls_type* touched;
  };
  struct on_joints {
    using scalar = double;
    static constexpr int dof = D;
    numbers torque(const numbers& q, const numbers& qd, const numbers& hand_torque) const {
      numbers sum = numbers::Zero();
      for (const auto& one : *all)
        if (one.is_on_joints()) sum += one.torque(q, qd, hand_torque);
      return sum;
    }
    const effect_list* all;
  };
  using touched_type = walls_and_effects<const walls_type&, on_handle, on_joints>;

 public:
  static constexpr int dimension = D;  ///< d
  /// The contacts and the effects.
  struct contacts_type : touched_type {
    /// As without effects.
    template <class M>
    using result_type = step_result_for<M, walls_type>;
  };

  /// Holds these walls and effects.
  any_scene_with_effects(any_scene<D> walls, effect_list effects)
      : walls_(std::move(walls)), effects_(std::move(effects)), sums_{on_handle{}, on_joints{}} {}

  /// The walls touched at x [m] and a time [s], and the effects; valid until the next call.
  touched_type touched_at(const point<D>& x, double time) {
    const walls_type& touched = walls_.touched_at(x, time);
    boost::hana::at_c<0>(sums_) = {&effects_, &touched};
    boost::hana::at_c<1>(sums_) = {&effects_};
    return touched_type{touched, sums_};
  }
  /// Forgets the handle.
  void reset() { walls_.reset(); }

 private:
  any_scene<D> walls_;
  effect_list effects_;
  passive_haptics::detail::effects_of<on_handle, on_joints> sums_;
};

}  // namespace passive_haptics::runtime
