/// @file
/// How the brakes of a device with self-motion turn once it has settled.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// A set of brakes: bit i stands for brake i.
using brake_set = unsigned;

/// Whether brake i is in the set.
constexpr bool contains(brake_set set, int i) { return (set >> i & 1u) != 0; }

/// Whether the set has `Count` brakes, 1 or more. Not by std::popcount, for which g++ 12 calls a function.
template <int Count>
constexpr bool holds(brake_set set) {
  for (int k = 1; k < Count; ++k) set &= set - 1;  // without its first brake
  return set != 0 && (set & (set - 1)) == 0;
}

/// The brakes that can make no torque in a cycle, neither way: those that are off. None of brakes without an
/// interval.
template <class T, int Brakes, class B>
brake_set brakes_without_torque([[maybe_unused]] const B& brakes) {
  brake_set off = 0;
  if constexpr (SwitchableBrakes<B, T, Brakes>)
    for (int i = 0; i < Brakes; ++i)
      if (!(passive_haptics::torque_bound_of<T>(brakes, i, T(1)) > T(0)) &&
          !(passive_haptics::torque_bound_of<T>(brakes, i, T(-1)) > T(0)))
        off |= brake_set(1) << i;
  return off;
}

/// The brakes of a device with self-motion, n > d, whose handle moves with v. A light arm that slips gives
/// way along N = ker J until its brakes take the least power there is; then as many of them are at rest as N
/// moves independently, r = rank(T N), n - d as a rule. Those S that are at rest leave one motion of all
/// joints, and so of the other brakes:
///
///     w* = W_S v,   W_S = T J^+ - T N ((T N)_S)^-1 (T J^+)_S.
///
/// By virtual work the torques of these others make the force F = W_S^T t, whatever they are; those of S
/// balance what is left on the self-motion. Which brakes come to rest the device decides: every set of r
/// brakes whose rows of T N are independent is a candidate, at most C(m, r). A brake that is off holds
/// nothing: r is the rank of the others' rows.
template <class M>
class settled_rates {
  using T = typename M::scalar;
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  static_assert(m <= 32, "passive_haptics: a device with self-motion has at most 32 brakes.");

 public:
  /// W_S (m x d), which maps velocities of the handle to rates of the brakes; its rows of S are 0.
  using rate_map = matrix<T, m, d>;
  /// Least share, see the constructor, of a control cycle.
  static constexpr T default_share = T(1e-3);

  /// Of a pose. A row of T N that is shorter than min_share times a brake's greatest motion, after those
  /// before it were taken out of it, counts as dependent. A brake at rest that the self-motion hardly moves
  /// would let the others race. off: brakes that cannot be held (brakes_without_torque). Cost: an orthogonal
  /// decomposition of d x n.
  explicit settled_rates(const mechanism_pose<M>& pose, T min_share = default_share, brake_set off = 0)
      : min_share_(min_share) {
    const orthogonal_decomposition<T, d, n> J(jacobian_matrix<M>(pose.jacobian()), rounding_tolerance<T>(n));
    const transmission_matrix<M> by_brakes = transposed(pose.transposed_transmission());
    self_motions_ = n - J.rank();
    start_.rates = by_brakes * J.pseudo_inverse();
    start_.self = by_brakes * J.null_space();
    max_motion_ = by_brakes.rowwise().norm();
    if (off != 0)
      for (int i = 0; i < m; ++i)
        if (contains(off, i)) max_motion_[i] = std::numeric_limits<T>::infinity();
    for (candidate x = start_; rank_ < self_motions_; ++rank_)
      if (!hold_next(x)) break;
    lost_ = J.rank() < d;
    if (lost_) held_by_structure_ = J.left_null_projection();
  }

  /// T J^+ (m x d): rates of the brakes under the least joint rates for a velocity.
  const rate_map& least_norm_rates() const { return start_.rates; }
  /// T N (m x n): rates of the brakes under self-motions; columns past the self-motions are 0.
  const matrix<T, m, n>& of_self_motion() const { return start_.self; }
  /// The part of a force that no joint feels, as the pose is singular: the structure holds it. Else 0.
  vector<T, d> held_by_structure(const vector<T, d>& F) const {
    if (lost_) return held_by_structure_ * F;
    return vector<T, d>::Zero();
  }

  /// Whether these brakes can be those at rest, and then their W_S.
  bool find(brake_set S, rate_map& W) const {
    candidate x = start_;
    for (int i = 0; i < m; ++i)
      if (contains(S, i) && !hold(x, i)) return false;
    W = x.rates;
    return x.depth == rank_;
  }

  /// visit(S, W_S) for each set of brakes that can be at rest, until it returns true.
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit_from(0, 0, start_, visit);
  }

 private:
  // W of the brakes held so far, and T N without what holds them, its first `depth` columns used up
  struct candidate {
    rate_map rates;
    matrix<T, m, n> self;
    int depth = 0;
  };

  // Brings brake i to rest by what is left of the self-motion; false where that does not move it
  bool hold(candidate& x, int i) const {
    if (x.depth >= self_motions_) return false;
    int pivot = x.depth;
    for (int k = x.depth + 1; k < self_motions_; ++k)
      if (std::abs(x.self(i, k)) > std::abs(x.self(i, pivot))) pivot = k;
    if (!(std::abs(x.self(i, pivot)) > min_share_ * max_motion_[i])) return false;
    x.self.col(pivot).swap(x.self.col(x.depth));
    const lanes<T, m> motion = lanes<T, m>::load(&x.self(0, x.depth)) / x.self(i, x.depth);
    for (int k = x.depth + 1; k < self_motions_; ++k) without(&x.self(0, k), motion, i);
    unrolled<d>([&](auto k) { without(&x.rates(0, k), motion, i); });
    ++x.depth;
    return true;
  }

  // rates[0], ..., rates[m - 1] without that part of the motion which moves brake i
  static void without(T* rates, const lanes<T, m>& motion, int i) {
    (lanes<T, m>::load(rates) - motion * rates[i]).store(rates);
    rates[i] = T(0);
  }

  bool hold_next(candidate& x) const {
    for (int i = 0; i < m; ++i)
      if (hold(x, i)) return true;
    return false;
  }

  template <class Visit>
  bool visit_from(int brake, brake_set S, const candidate& x, const Visit& visit) const {
    if (x.depth == rank_) return visit(S, x.rates);
    for (int i = brake; i + rank_ - x.depth <= m; ++i) {
      candidate next = x;
      if (hold(next, i) && visit_from(i + 1, S | brake_set(1) << i, next, visit)) return true;
    }
    return false;
  }

  T min_share_;
  int self_motions_ = 0, rank_ = 0;
  candidate start_ = {};
  vector<T, m> max_motion_;  // motion of a brake; infinite where it is off, so that no share is enough
  bool lost_ = false;
  matrix<T, d, d> held_by_structure_;
};

}  // namespace passive_haptics
