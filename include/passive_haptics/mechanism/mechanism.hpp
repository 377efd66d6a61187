/// The Mechanism concept: joint positions to end effector (section 2).
///
/// Minimal complete definition (n = dof, d = task_dimension, m = brake_count):
///   - `using scalar`: float, double or long double;
///   - `static constexpr int dof, task_dimension, brake_count`: m = n >= d; with a transmission also
///     redundant brakes, m > n = d, or fewer brakes than joints, m < n >= d. d is 1, 2 or 3;
///   - `vector<scalar, d> position(const vector<scalar, n>& q) const`: end effector, base frame. All
///     components are lengths [m] along orthogonal axes; with an angle, as in (x, y, L phi), the nearest
///     force would depend on the unit of L. If it is a template over the scalar, jacobian.hpp differentiates
///     it.
///
/// Optional. Members without q are constant; matrices may be diagonal. Both save time in a control cycle:
///   - `matrix<scalar, d, n> jacobian(q) const` or `jacobian() const`;
///   - `matrix<scalar, m, n> transmission(q) const` or `transmission() const`: T in w = T qd, of full rank,
///     with the rates w of the brake axes. Without it, brake i is on joint i (m = n). For brakes on some of
///     the joints use braked_joints (mechanism/adaptors/braked_joints.hpp);
///   - `pose(q) const`, of any type: shared terms of position and jacobian, such as sines and cosines. Both
///     must then also accept it instead of q; transmission and the members of Dynamics may. A control cycle
///     computes it once.
///
/// Laws: position and jacobian of pose(q) equal those of q. jacobian is the derivative of position. Both are
/// pure. Finite q gives a finite position. testing/mechanism_properties.hpp checks these laws.
#pragma once

#include <passive_haptics/core/explain.hpp>
#include <passive_haptics/core/matrix.hpp>

#include <concepts>
#include <type_traits>

namespace passive_haptics {

/// Joint positions q [rad or m] or rates qd [rad/s or m/s] of M.
template <class M>
using joint_vector = vector<typename M::scalar, M::dof>;

/// Point [m], velocity [m/s] or force [N] at the end effector of M, in the base frame.
template <class M>
using task_vector = vector<typename M::scalar, M::task_dimension>;

/// Rates w [rad/s or m/s] or torques t [N m or N] of the brakes of M, on the brakes' own axes.
template <class M>
using brake_vector = vector<typename M::scalar, M::brake_count>;

/// E, from brake rates to velocity, or G, from brake torques to forces: d x m.
template <class M>
using brake_matrix = matrix<typename M::scalar, M::task_dimension, M::brake_count>;

/// J: d x n.
template <class M>
using jacobian_matrix = matrix<typename M::scalar, M::task_dimension, M::dof>;

/// T, m x n.
template <class M>
using transmission_matrix = matrix<typename M::scalar, M::brake_count, M::dof>;

namespace detail {

template <class M>
concept names_scalar = requires { requires std::floating_point<typename M::scalar>; };
template <class M>
concept names_dof = requires { requires(std::integral_constant<int, M::dof>::value > 0); };
template <class M>
concept names_task_dimension =
    requires { requires(std::integral_constant<int, M::task_dimension>::value > 0); };
template <class M>
concept names_brake_count = requires { requires(std::integral_constant<int, M::brake_count>::value > 0); };
template <class M>
concept names_sizes = names_scalar<M> && names_dof<M> && names_task_dimension<M> && names_brake_count<M>;

template <class M>
concept transmission_depends_on_pose =
    requires(const M mechanism, const joint_vector<M> q) { mechanism.transmission(q); };
template <class M>
concept transmission_is_constant = requires(const M mechanism) { mechanism.transmission(); };
template <class M>
concept names_transmission =
    transmission_depends_on_pose<M> || transmission_is_constant<M> || requires { &M::transmission; };

template <class M>
concept has_supported_sizes =
    (M::brake_count == M::dof && M::dof >= M::task_dimension) ||
    (M::brake_count > M::dof && M::dof == M::task_dimension && names_transmission<M>) ||
    (M::brake_count < M::dof && M::dof >= M::task_dimension && names_transmission<M>);

template <class M>
concept has_position = names_sizes<M> && requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.position(q) } -> ExactVector<typename M::scalar, M::task_dimension>;
};

// Detects calls of an optional member f with q, without q (constant), or not at all.
template <class M>
concept jacobian_depends_on_pose =
    requires(const M mechanism, const joint_vector<M> q) { mechanism.jacobian(q); };
template <class M>
concept jacobian_is_constant = requires(const M mechanism) { mechanism.jacobian(); };
template <class M>
concept names_jacobian = jacobian_depends_on_pose<M> || jacobian_is_constant<M> || requires { &M::jacobian; };

// A pose type with shared terms of position and jacobian.
template <class M>
concept names_pose = requires(const M mechanism, const joint_vector<M> q) { mechanism.pose(q); };
template <class M>
concept has_pose = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.position(mechanism.pose(q)) } -> ExactVector<typename M::scalar, M::task_dimension>;
  { mechanism.jacobian(mechanism.pose(q)) } -> ExactMatrix<typename M::scalar, M::task_dimension, M::dof>;
};

template <class X, class Base>
concept extends = std::derived_from<X, Base> && !std::same_as<X, Base>;

template <class X, class T, int R, int C>
concept exact_or_diagonal = ExactMatrix<X, T, R, C> || (R == C && ExactDiagonal<X, T, R>);

template <class M>
concept has_exact_jacobian = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.jacobian(q) } -> exact_or_diagonal<typename M::scalar, M::task_dimension, M::dof>;
} || requires(const M mechanism) {
  { mechanism.jacobian() } -> exact_or_diagonal<typename M::scalar, M::task_dimension, M::dof>;
};

template <class M>
concept has_exact_transmission = requires(const M mechanism, const joint_vector<M> q) {
  { mechanism.transmission(q) } -> exact_or_diagonal<typename M::scalar, M::brake_count, M::dof>;
} || requires(const M mechanism) {
  { mechanism.transmission() } -> exact_or_diagonal<typename M::scalar, M::brake_count, M::dof>;
};

}  // namespace detail

/// Requirements of Mechanism, with one message each: `static_assert(is_mechanism<M, explain>())`.
template <class M, bool Explain = false>
consteval bool is_mechanism() {
  if constexpr (!detail::names_scalar<M>)
    static_assert(!Explain, "passive_haptics: the mechanism needs `using scalar = double;` (or float).");
  else if constexpr (!detail::names_dof<M>)
    static_assert(!Explain,
                  "passive_haptics: the mechanism needs `static constexpr int dof`, its number of joints.");
  else if constexpr (!detail::names_task_dimension<M>)
    static_assert(!Explain,
                  "passive_haptics: the mechanism needs `static constexpr int task_dimension`, the size of "
                  "position(q).");
  else if constexpr (!detail::names_brake_count<M>)
    static_assert(
        !Explain,
        "passive_haptics: the mechanism needs `static constexpr int brake_count`, its number of brakes.");
  else if constexpr (M::task_dimension > 3)
    static_assert(
        !Explain,
        "passive_haptics: task_dimension must be 1, 2 or 3: position(q) is a point, each component a "
        "length [m]. Leave the orientation out: joints that only turn the handle are self-motion (dof > "
        "task_dimension).");
  else if constexpr (!detail::has_supported_sizes<M>)
    static_assert(
        !Explain,
        "passive_haptics: unsupported sizes; needed are brake_count == dof >= task_dimension or, with a "
        "transmission, brake_count > dof == task_dimension or brake_count < dof (for brakes on some of "
        "the joints see mechanism/adaptors/braked_joints.hpp).");
  else if constexpr (!detail::has_position<M>)
    static_assert(
        !Explain,
        "passive_haptics: position(q) must be const and return vector<scalar, task_dimension> exactly "
        "(not an Eigen expression) for a vector<scalar, dof>.");
  else if constexpr (detail::names_jacobian<M> && !detail::has_exact_jacobian<M>)
    static_assert(!Explain,
                  "passive_haptics: jacobian must be const, take q or nothing, and return "
                  "matrix<scalar, task_dimension, dof> exactly (or diagonal_matrix<scalar, dof>).");
  else if constexpr (detail::names_transmission<M> && !detail::has_exact_transmission<M>)
    static_assert(!Explain,
                  "passive_haptics: transmission must be const, take q or nothing, and return "
                  "matrix<scalar, brake_count, dof> exactly (or diagonal_matrix<scalar, dof>).");
  else if constexpr (detail::names_pose<M> && !detail::has_pose<M>)
    static_assert(
        !Explain,
        "passive_haptics: a mechanism with a pose(q) needs position(pose) and jacobian(pose) as well.");
  else return true;
  return Explain;
}

/// A mechanism as described above in this file.
template <class M>
concept Mechanism = is_mechanism<M>();

}  // namespace passive_haptics
