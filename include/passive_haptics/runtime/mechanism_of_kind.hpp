/// Type-erased mechanisms of one kind, so that code is compiled once per kind.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace passive_haptics::runtime {

/// Properties of a mechanism that a control cycle distinguishes at compile time.
struct mechanism_kind {
  int dof = 0;                             ///< n
  int task_dimension = 0;                  ///< d
  int brake_count = 0;                     ///< m
  bool has_constant_transmission = false;  ///< False: no transmission, a brake on each joint.
  /// True for equal members.
  friend bool operator==(const mechanism_kind&, const mechanism_kind&) = default;
};

/// The kind of mechanism M.
template <DifferentiableMechanism M>
inline constexpr mechanism_kind kind_of{M::dof, M::task_dimension, M::brake_count,
                                        detail::transmission_is_constant<M>};

/// Holds a mechanism of this kind. Shared by its copies. Results are bit-identical to those with the
/// mechanism itself, at the cost of a virtual call per pose.
template <mechanism_kind Kind>
class mechanism_of_kind {
  static constexpr int n = Kind.dof, d = Kind.task_dimension, m = Kind.brake_count;
  struct any_model;

 public:
  using scalar = double;                    ///< Scalar.
  static constexpr int dof = n;             ///< Joints.
  static constexpr int task_dimension = d;  ///< Components of position().
  static constexpr int brake_count = m;     ///< Brakes.

  using joints = vector<double, n>;     ///< [rad or m] or rates of them.
  using task = vector<double, d>;       ///< [m], [m/s] or [m/s^2].
  using d_by_n = matrix<double, d, n>;  ///< J
  using d_by_m = matrix<double, d, m>;  ///< G
  using m_by_n = matrix<double, m, n>;  ///< T
  using n_by_n = matrix<double, n, n>;  ///< M

  /// Position and Jacobian in one pose. Must not outlive the mechanism and q.
  class pose_values {
   public:
    pose_values(const pose_values&) = delete;
    pose_values& operator=(const pose_values&) = delete;
    task x;    ///< [m]
    d_by_n J;  ///< [m/rad or 1]

   private:
    friend mechanism_of_kind;
    pose_values(const any_model& of, const joints& q) { of.measure(q, *this); }
    static constexpr std::size_t max_size = 8192;  // [bytes], far above the need of seven bodies
    alignas(std::max_align_t) std::array<std::byte, max_size> own;  // mechanism_pose of the mechanism
  };

  /// Holds this mechanism.
  template <DifferentiableMechanism M>
    requires(!std::same_as<M, mechanism_of_kind>)
  explicit mechanism_of_kind(M mechanism) : held_(std::make_shared<model<M>>(std::move(mechanism))) {
    static_assert(kind_of<M> == Kind);
  }

  /// x and J.
  pose_values pose(const joints& q) const { return pose_values(*held_, q); }
  /// End effector [m], base frame.
  task position(const pose_values& at) const { return at.x; }
  /// End effector in pose q.
  task position(const joints& q) const { return held_->position(q); }
  /// J [m/rad or 1].
  d_by_n jacobian(const pose_values& at) const { return at.J; }
  /// J in pose q.
  d_by_n jacobian(const joints& q) const { return pose(q).J; }
  /// G (4) [N per N m], as force_generators() of the mechanism.
  d_by_m force_generators(const pose_values& at) const
    requires(n == d)
  {
    return held_->force_generators(at);
  }
  /// T
  m_by_n transmission() const
    requires(Kind.has_constant_transmission)
  {
    return held_->T;
  }

  /// True if the mechanism has inertia; otherwise the following functions return NaN.
  bool has_inertia() const { return held_->has_inertia; }
  /// M [kg m^2, kg m or kg].
  n_by_n mass_matrix(const pose_values& at) const { return held_->mass_matrix(at); }
  /// M in pose q.
  n_by_n mass_matrix(const joints& q) const { return mass_matrix(pose(q)); }
  /// c [N m or N].
  joints bias_torque(const pose_values& at, const joints& qd) const { return held_->bias_torque(at, qd); }
  /// c in pose q.
  joints bias_torque(const joints& q, const joints& qd) const { return bias_torque(pose(q), qd); }
  /// Jd qd [m/s^2].
  task bias_acceleration(const pose_values& at, const joints& qd) const {
    return held_->bias_acceleration(at, qd);
  }
  /// Jd qd in pose q.
  task bias_acceleration(const joints& q, const joints& qd) const { return bias_acceleration(pose(q), qd); }

 private:
  struct any_model {
    explicit any_model(bool inertia) : has_inertia(inertia) {}
    virtual ~any_model() = default;
    virtual task position(const joints& q) const = 0;
    virtual void measure(const joints& q, pose_values& at) const = 0;
    virtual d_by_m force_generators(const pose_values& at) const = 0;
    virtual n_by_n mass_matrix(const pose_values& at) const = 0;
    virtual joints bias_torque(const pose_values& at, const joints& qd) const = 0;
    virtual task bias_acceleration(const pose_values& at, const joints& qd) const = 0;
    m_by_n T = m_by_n::Zero();
    bool has_inertia;
  };

  template <class M>
  struct model final : any_model {
    using own_pose = mechanism_pose<M>;
    static_assert(sizeof(own_pose) <= pose_values::max_size && std::is_trivially_destructible_v<own_pose>);

    explicit model(M given) : any_model(Dynamics<M>), mechanism(std::move(given)) {
      if constexpr (Kind.has_constant_transmission) this->T = mechanism.transmission();
    }
    task position(const joints& q) const override { return mechanism.position(q); }
    void measure(const joints& q, pose_values& at) const override {
      const auto& own = *new (at.own.data()) own_pose(mechanism, q);
      at.x = own.position();
      at.J = own.jacobian();
    }
    d_by_m force_generators([[maybe_unused]] const pose_values& at) const override {
      if constexpr (n == d) return passive_haptics::force_generators(own(at));
      else return d_by_m::Constant(nan);
    }
    n_by_n mass_matrix(const pose_values& at) const override {
      if constexpr (Dynamics<M>) return own(at).mass_matrix();
      else return n_by_n::Constant(nan);
    }
    joints bias_torque(const pose_values& at, const joints& qd) const override {
      if constexpr (Dynamics<M>) return own(at).bias_torque(qd);
      else return joints::Constant(nan);
    }
    task bias_acceleration(const pose_values& at, const joints& qd) const override {
      if constexpr (Dynamics<M>) return own(at).bias_acceleration(qd);
      else return task::Constant(nan);
    }

    static const own_pose& own(const pose_values& at) {
      return *std::launder(reinterpret_cast<const own_pose*>(at.own.data()));
    }
    static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    M mechanism;
  };

  std::shared_ptr<const any_model> held_;
};

/// A mechanism of which a cycle only needs the kind at compile time. A constant or diagonal Jacobian, or a
/// transmission that depends on the pose, requires the type itself.
template <class M>
concept HasKind = std::same_as<typename M::scalar, double> && !detail::transmission_depends_on_pose<M> &&
                  !detail::jacobian_is_constant<M> &&
                  ExactMatrix<decltype(std::declval<const mechanism_pose<M>&>().jacobian()), double,
                              M::task_dimension, M::dof>;

/// The type of held_mechanism.
template <DifferentiableMechanism M>
struct held_mechanism_of {
  using type = M;  ///< The mechanism itself.
};
/// The type of held_mechanism, for mechanisms of a kind.
template <DifferentiableMechanism M>
  requires HasKind<M>
struct held_mechanism_of<M> {
  using type = mechanism_of_kind<kind_of<M>>;  ///< Type for the kind.
};
/// Type by which controllers and plants hold mechanism M: by its kind, else M itself.
template <DifferentiableMechanism M>
using held_mechanism = typename held_mechanism_of<M>::type;

}  // namespace passive_haptics::runtime
