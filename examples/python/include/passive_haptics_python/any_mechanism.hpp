/// @file
/// A mechanism that is known at run time only, with a brake on each joint.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <concepts>
#include <memory>
#include <stdexcept>
#include <utility>

namespace passive_haptics_python {

namespace ph = passive_haptics;

/// Holds a mechanism of N joints and D task dimensions without a transmission. Copies share it. What is
/// compiled for this class serves all such mechanisms, with the bits that each has by itself, at the cost of
/// a virtual call for a pose. HasInverse: whether J^-T is a formula of the mechanism's own. HasInertia:
/// whether mechanisms with inertia are among them.
template <int N, int D, bool HasInverse = false, bool HasInertia = true>
class any_mechanism {
 public:
  using scalar = double;                                              ///< Scalar of all lengths and angles.
  static constexpr int dof = N, task_dimension = D, brake_count = N;  ///< n, d and m.

  using joints = ph::vector<double, N>;     ///< [rad or m] or rates of them.
  using task = ph::vector<double, D>;       ///< [m], [m/s] or [m/s^2].
  using d_by_n = ph::matrix<double, D, N>;  ///< J or J^-T.
  using n_by_n = ph::matrix<double, N, N>;  ///< M

  /// What is known of one pose.
  struct pose_values {
    task x;    ///< [m]
    d_by_n J;  ///< [m/rad or 1]
  };

  /// Holds this mechanism.
  template <ph::DifferentiableMechanism M>
    requires(!std::same_as<M, any_mechanism>)
  explicit any_mechanism(M mechanism) : held_(std::make_shared<model<M>>(std::move(mechanism))) {
    static_assert(M::dof == N && M::task_dimension == D && M::brake_count == N);
    static_assert(!ph::detail::names_transmission<M>);
    static_assert(
        ph::ExactMatrix<decltype(std::declval<const ph::mechanism_pose<M>&>().jacobian()), double, D, N>,
        "a diagonal J has bits of its own");
    static_assert(HasInverse == (ph::detail::has_inverse_transposed_jacobian<M> ||
                                 (N == D && ph::detail::has_inverse_jacobian<M>)));
  }

  /// x and J.
  pose_values pose(const joints& q) const { return held_->pose(q); }
  /// End effector [m], base frame.
  task position(const pose_values& at) const { return at.x; }
  /// End effector in pose q.
  task position(const joints& q) const { return held_->position(q); }
  /// J [m/rad or 1].
  d_by_n jacobian(const pose_values& at) const { return at.J; }
  /// J in pose q.
  d_by_n jacobian(const joints& q) const { return held_->pose(q).J; }
  /// J^-T by the mechanism's own formula.
  d_by_n inverse_transposed_jacobian(const joints& q) const
    requires HasInverse
  {
    return held_->inverse_transposed_jacobian(q);
  }

  /// M; throws std::logic_error for a mechanism without inertia, as both functions below do.
  n_by_n mass_matrix(const joints& q) const
    requires HasInertia
  {
    return held_->mass_matrix(q);
  }
  /// c [N m or N].
  joints bias_torque(const joints& q, const joints& qd) const
    requires HasInertia
  {
    return held_->bias_torque(q, qd);
  }
  /// Jd qd [m/s^2].
  task bias_acceleration(const joints& q, const joints& qd) const
    requires HasInertia
  {
    return held_->bias_acceleration(q, qd);
  }

 private:
  struct interface {
    virtual ~interface() = default;
    virtual pose_values pose(const joints& q) const = 0;
    virtual task position(const joints& q) const = 0;
    virtual d_by_n inverse_transposed_jacobian(const joints& q) const = 0;
    virtual n_by_n mass_matrix(const joints& q) const = 0;
    virtual joints bias_torque(const joints& q, const joints& qd) const = 0;
    virtual task bias_acceleration(const joints& q, const joints& qd) const = 0;
  };

  template <class M>
  struct model final : interface {
    explicit model(M m) : mechanism(std::move(m)) {}
    pose_values pose(const joints& q) const override {
      const ph::mechanism_pose<M> at(mechanism, q);
      return {at.position(), at.jacobian()};
    }
    task position(const joints& q) const override { return mechanism.position(q); }
    d_by_n inverse_transposed_jacobian([[maybe_unused]] const joints& q) const override {
      if constexpr (ph::detail::has_inverse_transposed_jacobian<M>)
        return mechanism.inverse_transposed_jacobian(q);
      else if constexpr (HasInverse) return ph::transposed(mechanism.inverse_jacobian(q));
      else throw std::logic_error("passive_haptics: a mechanism without a formula for J^-T");
    }
    n_by_n mass_matrix([[maybe_unused]] const joints& q) const override {
      if constexpr (ph::Dynamics<M>) return ph::mechanism_pose<M>(mechanism, q).mass_matrix();
      else throw no_inertia();
    }
    joints bias_torque([[maybe_unused]] const joints& q, [[maybe_unused]] const joints& qd) const override {
      if constexpr (ph::Dynamics<M>) return ph::mechanism_pose<M>(mechanism, q).bias_torque(qd);
      else throw no_inertia();
    }
    task bias_acceleration([[maybe_unused]] const joints& q,
                           [[maybe_unused]] const joints& qd) const override {
      if constexpr (ph::Dynamics<M>) return ph::mechanism_pose<M>(mechanism, q).bias_acceleration(qd);
      else throw no_inertia();
    }
    static std::logic_error no_inertia() {
      return std::logic_error("passive_haptics: a mechanism without inertia");
    }
    M mechanism;
  };

  std::shared_ptr<const interface> held_;
};

}  // namespace passive_haptics_python
