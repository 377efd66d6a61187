/// Brake rates of a device with a settled self-motion.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/linear/lanes.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <cmath>
#include <limits>

namespace passive_haptics {

/// A set of brakes: bit i is brake i.
using brake_set = unsigned;

/// True if brake i is in the set.
constexpr bool contains(brake_set set, int i) { return (set >> i & 1u) != 0; }

/// True if the set has `Count` >= 1 brakes. Avoids std::popcount, a function call with g++ 12.
template <int Count>
constexpr bool holds(brake_set set) {
  for (int k = 1; k < Count; ++k) set &= set - 1;  // removes the first brake
  return set != 0 && (set & (set - 1)) == 0;
}

/// Brakes that cannot produce torque in either direction in this cycle. Empty for brakes without an interval.
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

/// Brakes of a device with self-motion, n > d, at a handle velocity v. The self-motion N = ker J of a light
/// arm changes until the brakes dissipate the least power. Then r = rank(T N) brakes are at rest, usually n -
/// d. Such a set S determines the rates of the other brakes:
///
///     w* = W_S v,   W_S = T J^+ - T N ((T N)_S)^-1 (T J^+)_S.
///
/// By virtual work the other torques produce the force F = W_S^T t; those of S balance the rest of the
/// self-motion. Candidates for S are all sets of r brakes with independent rows of T N, at most C(m, r). A
/// brake that is off holds nothing, and r is then the rank of the other rows.
template <class M>
class settled_rates {
  using T = typename M::scalar;
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  static_assert(m <= 32, "passive_haptics: a device with self-motion has at most 32 brakes.");

 public:
  /// W_S (m x d), from handle velocities to brake rates; its rows of S are 0.
  using rate_map = matrix<T, m, d>;
  static constexpr T default_share = T(1e-3);  ///< min_share in a control cycle, see the constructor.

  /// Rates in one pose. A row of T N is dependent if, projected off the previous ones, it is shorter than
  /// min_share times the maximum motion of its brake, because holding such a brake would let the others race.
  /// off: brakes that cannot hold (brakes_without_torque). Cost: an orthogonal decomposition of d x n.
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

  /// T J^+ (m x d): brake rates for the least joint rates of a velocity.
  const rate_map& least_norm_rates() const { return start_.rates; }
  /// T N (m x n): brake rates of self-motions; the columns beyond the self-motions are 0.
  const matrix<T, m, n>& of_self_motion() const { return start_.self; }
  /// Component of a force that no joint feels in a singular pose, so that the structure carries it; else 0.
  vector<T, d> held_by_structure(const vector<T, d>& F) const {
    if (lost_) return held_by_structure_ * F;
    return vector<T, d>::Zero();
  }

  /// True if these brakes can be at rest; then also sets W to W_S.
  bool find(brake_set S, rate_map& W) const {
    candidate x = start_;
    for (int i = 0; i < m; ++i)
      if (contains(S, i) && !hold(x, i)) return false;
    W = x.rates;
    return x.depth == rank_;
  }

  /// Calls visit(S, W_S) for each set of brakes that can be at rest, until it returns true.
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit_from(0, 0, start_, visit);
  }

 private:
  // W for the brakes held so far, and T N with its first `depth` columns used
  struct candidate {
    rate_map rates;
    matrix<T, m, n> self;
    int depth = 0;
  };

  // Brings brake i to rest by the remaining self-motion; false if that does not move it
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

  // Removes from rates[0], ..., rates[m - 1] the motion of brake i
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
  vector<T, m> max_motion_;  // infinite for a brake that is off, so that no share suffices
  bool lost_ = false;
  matrix<T, d, d> held_by_structure_;
};

}  // namespace passive_haptics
