/// Force approximation for a settled self-motion: brakes at rest, and forces of the others.
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/brake/signs.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>
#include <passive_haptics/force/torques/settled_shortfall.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// Required advantage in cos(gamma) before another set of brakes at rest is selected. Without it, the
/// tangential force would jump with each encoder count between equally good sets.
inline constexpr double settled_gain = 0.1;

/// Displayable forces of a device with handle velocity v and settled self-motion: F belongs to them if T^T t
/// = J^T F and some self-motion z gives t_i (T (qd + N z))_i <= 0 for all i. They are the cones of all sets
/// of brakes that can come to rest. A brake that is off (also in `rates`) has no torque. If a one-way brake
/// of S would have to hold the other way, the other brakes produce the nearest force without it (force_map).
template <class M, class EMatrix, class B>
class settled_forces {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count, r = M::dof - d;
  static constexpr bool has_intervals = SwitchableBrakes<B, T, m>;

 public:
  using force = settled_force<T, d, m>;                  ///< Force with its signs.
  using rate_map = typename settled_rates<M>::rate_map;  ///< W_S

  /// Brakes with these rates, E of the pose and a velocity v [m/s]. The arguments must outlive this object.
  settled_forces(const settled_rates<M>& rates, const EMatrix& E, const B& brakes, const vector<T, d>& v)
      : rates_(rates), E_(E), brakes_(brakes), v_(v) {}

  /// s* for the set S at rest: 0 for its brakes and within the dead band, except for one-way brakes.
  vector<T, m> signs_of(const rate_map& W) const {
    return signs_within(brake_signs<T, m>(W * v_, vector<T, m>::Zero(), brakes_), brakes_);
  }

  /// Fc for a unit desired force n, as in approximate(), with the set S of maximum cos(gamma); exact if some
  /// set can display n. previous: S of the previous cycle, kept until another one gains settled_gain; 0 for
  /// none. Cost: an elimination and a projection for each of at most C(m, r) sets; one if the
  /// previous set is clearly kept.
  force nearest(const vector<T, d>& n, T min_cosine, brake_set previous = 0) const {
    const T least = std::max(min_cosine, rounding_tolerance<T>(d));
    candidate kept, best;
    if (previous != 0 && rates_.find(previous, kept.W)) {
      kept.S = previous;
      weigh(n, least, kept);
      if (kept.cosine >= T(1 - settled_gain)) return force_of(kept, n);
    }
    rates_.for_each([&](brake_set S, const rate_map& W) {
      candidate other{S, W};
      weigh(n, least, other);
      if (other.cosine > best.cosine) best = other;
      return best.cosine >= T(1);
    });
    return force_of(kept.cosine > T(0) && best.cosine <= kept.cosine + T(settled_gain) ? kept : best, n);
  }

  /// A choice of S for several contacts.
  struct choice {
    force signs;                ///< S, s* and v'; no force.
    settled_shortfall<T> left;  ///< Unmet share of the demands; infinite if there is no set.
  };

  /// S, s* and v' for the first `count` contacts: brakes without limits leave the smallest share of the
  /// demands with priority, then of the others, then the least |F|. Kept as in nearest(). Cost: a
  /// contact_forces of m - r brakes for each set.
  template <int Capacity>
  choice signs_under_demands(
      const std::array<contact_demand<T, d>, static_cast<std::size_t>(Capacity)>& demands, int count,
      brake_set previous = 0) const {
    choice best, kept;
    best.signs.velocity = kept.signs.velocity = v_;
    const auto consider = [&](brake_set S, const rate_map& W, choice& c, T gain) {
      const vector<T, m> signs = signs_of(W);
      const auto left = shortfall_of<Capacity>(S, W, signs, demands, count);
      if (!left.is_less_than(c.left, gain)) return;
      c.left = left;
      c.signs.held = S;
      c.signs.signs = signs;
    };
    rate_map W;
    if (previous != 0 && rates_.find(previous, W)) consider(previous, W, kept, T(0));
    rates_.for_each([&](brake_set S, const rate_map& of_set) {
      consider(S, of_set, best, rounding_tolerance<T>(16 * m));
      return false;
    });
    return best.left.is_less_than(kept.left, T(settled_gain)) ? best : kept;
  }

 private:
  template <int Capacity>
  settled_shortfall<T> shortfall_of(
      brake_set S, const rate_map& W, const vector<T, m>& signs,
      const std::array<contact_demand<T, d>, static_cast<std::size_t>(Capacity)>& demands, int count) const {
    return visit_active(S, W, signs, [&]<int Brakes>(const active_brakes<Brakes>& active) {
      auto box = torques_within<T, Brakes>(active.s,
                                           vector<T, Brakes>::Constant(std::numeric_limits<T>::infinity()));
      for (int k = 0; k < Brakes; ++k)
        if (active.G.col(k).isZero(T(0))) box.lower[k] = box.upper[k] = T(0);
      const auto met = contact_forces<T, d, Brakes, Capacity>({active.G}, box, demands, count);
      if constexpr (has_intervals)
        if (must_hold_otherwise(S, signs, met.force)) {
          const auto all = contact_forces<T, d, m, Capacity>(
              passive_haptics::force_map_of(rates_), unbounded_torque_box_of(signs, brakes_), demands, count);
          return settled_shortfall<T>::of(all, demands, count);
        }
      return settled_shortfall<T>::of(met, demands, count);
    });
  }

  struct candidate {
    brake_set S = 0;
    rate_map W = rate_map::Zero();
    vector<T, m> signs = vector<T, m>::Zero();
    T cosine = T(0);             // 0 if nothing is displayed, 1 if n is
    bool is_restricted = false;  // by one-way brakes of S
  };

  // The rotating brakes and their forces F = G t, G = W_S^T
  template <int Brakes>
  struct active_brakes {
    matrix<T, d, Brakes> G;                                    // 0 for a brake that is off
    vector<T, Brakes> s;                                       // their signs
    std::array<int, static_cast<std::size_t>(Brakes)> number;  // their indices

    vector<T, m> of_all(const vector<T, Brakes>& t) const {
      vector<T, m> all = vector<T, m>::Zero();
      for (int k = 0; k < Brakes; ++k) all[nth(number, k)] = t[k];
      return all;
    }
  };

  // True if a one-way brake of S would have to hold F the other way, beyond rounding
  bool must_hold_otherwise(brake_set S, const vector<T, m>& signs, const vector<T, d>& F) const {
    const vector<T, m> t = brake_torque(E_, F);
    const T rounding = rounding_tolerance<T>(d + m) * matrix<T, d, m>(E_).norm() * F.norm();
    bool some = false;
    for (int i = 0; i < m; ++i) some = some || (contains(S, i) && signs[i] * t[i] > rounding);
    return some;
  }

  // Nearest force to n if brakes of S only hold one way
  nearest_torque_result<T, d, m> nearest(const candidate& c, const vector<T, d>& n) const {
    const auto box = unbounded_torque_box_of(c.signs, brakes_);
    return nearest_torque(passive_haptics::force_map_of(rates_), box, n);
  }

  void weigh(const vector<T, d>& n, T least, candidate& c) const {
    c.signs = signs_of(c.W);
    const vector<T, d> structure = rates_.held_by_structure(n), rest = n - structure;
    vector<T, d> Fp = structure + visit_active(c.S, c.W, c.signs,
                                               [&](const auto& active) { return nearest(active, rest); });
    if constexpr (has_intervals) {
      c.is_restricted = must_hold_otherwise(c.S, c.signs, Fp);
      if (c.is_restricted) Fp = structure + this->nearest(c, rest).force;
    }
    const T cosine = Fp.norm();
    const bool exact = (n - Fp).norm() <= rounding_tolerance<T>(d + m);
    c.cosine = exact ? T(1) : cosine >= least ? std::min(cosine, T(1) - rounding_tolerance<T>(1)) : T(0);
  }

  // Calls visit(active) with the rotating brakes, usually m - r, else all
  template <class Visit>
  auto visit_active(brake_set S, const rate_map& W, const vector<T, m>& signs, const Visit& visit) const {
    constexpr int moving = m - r;
    if constexpr (moving > 0)
      if (holds<r>(S)) return visit(active_of<moving>(S, W, signs));
    return visit(active_of<m>(0, W, signs));
  }
  template <int Brakes>
  active_brakes<Brakes> active_of(brake_set at_rest, const rate_map& W, const vector<T, m>& signs) const {
    const auto off = brakes_off(signs, brakes_);
    active_brakes<Brakes> active;
    for (int i = 0, k = 0; i < m; ++i) {
      if (contains(at_rest, i)) continue;
      const bool is_off = detail::is_off(off, i);
      active.G.col(k) = W.row(i).transpose();
      active.s[k] = is_off ? T(1) : signs[i];
      if (is_off) active.G.col(k).setZero();
      nth(active.number, k++) = i;
    }
    return active;
  }

  // Point of nearest_torque without its torques, if this is cheaper
  template <int Brakes>
  static vector<T, d> nearest(const active_brakes<Brakes>& active, const vector<T, d>& n) {
    constexpr T max_square = sizeof(T) > sizeof(float) ? T(1e60) : T(1e15);
    const auto& G = active.G;
    const T square = G.squaredNorm();
    if (active.s.prod() == T(0) || !(square < max_square && square > T(1) / max_square))
      return nearest_torque(G, active.s, n).force;
    return detail::face_of(matrix<T, d, Brakes>(G * vector<T, Brakes>(-active.s).asDiagonal()), n).point;
  }

  // Fc = Fp / |Fp|^2 and t = E^T Fc. Clears torques that are rounding errors or that the brake cannot have
  force force_of(const candidate& c, const vector<T, d>& n) const {
    force F;
    F.velocity = v_;
    if (!(c.cosine > T(0))) return F;
    const vector<T, d> structure = rates_.held_by_structure(n), rest = n - structure;
    vector<T, m> pushes = vector<T, m>::Zero();
    vector<T, d> Fp = structure;
    if (has_intervals && c.is_restricted) {
      const auto found = this->nearest(c, rest);
      pushes = found.torque;
      Fp += found.force;
    } else {
      Fp += visit_active(c.S, c.W, c.signs, [&](const auto& active) {
        const auto found = nearest_torque(active.G, active.s, rest);
        pushes = active.of_all(found.torque);
        return found.force;
      });
    }
    const bool exact = c.cosine == T(1);
    const T square = exact ? T(1) : Fp.squaredNorm();
    F.display = exact ? display_class::exact : display_class::approximate;
    F.force = exact ? n : vector<T, d>(Fp / square);
    F.cosine_squared = square;
    F.held = c.S;
    F.signs = c.signs;
    F.torque = brake_torque(E_, F.force);
    for (int i = 0; i < m; ++i) {
      const bool has_none = pushes[i] == T(0) && (!contains(c.S, i) || c.is_restricted);
      if (has_none || c.signs[i] * F.torque[i] > T(0)) F.torque[i] = T(0);
    }
    return F;
  }

  const settled_rates<M>& rates_;
  const EMatrix& E_;
  const B& brakes_;
  vector<T, d> v_;
};

}  // namespace passive_haptics
