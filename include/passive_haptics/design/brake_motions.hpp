/// @file
/// How brakes may turn while the end effector moves, and what torques in a box then make along a normal at
/// most: the parts of displayable() and sink_slope().
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/design/hybrid_brakes.hpp>
#include <passive_haptics/design/largest_resistance.hpp>

#include <algorithm>
#include <limits>

namespace passive_haptics::detail {

// Whether n . F of a device with n = d is the sum of what its brakes make, by G: not at singular poses, where
// joints may turn though the end effector rests. Redundant brakes, m > n, have no other form.
template <class M>
bool forces_add_up(const mechanism_pose<M>& pose, const brake_matrix<M>& G) {
  using T = typename M::scalar;
  if (!all_finite(G)) return false;
  if constexpr (M::brake_count != M::dof) return true;
  const T rounding = rounding_tolerance<T>(M::dof);
  const T J = jacobian_matrix<M>(pose.jacobian()).squaredNorm();
  return rounding * J * rounding * G.squaredNorm() < pose.transposed_transmission().squaredNorm();
}

// The motions of the brakes of a pose: rates w = W v (m x d) for a velocity v of the end effector, for each W
// that the form of the device's forces allows. for_each_way(n, visit): the rates w at which the end effector
// may move along n, of which one is the easiest, whatever the torques are.
//
// By half-spaces, the primary template: as many brakes as joints. A self-motion is left alone, by the least
// joint rates: W = T J^+.
template <class M>
class brake_motions {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, joints = M::dof, m = M::brake_count;

 public:
  using rate_map = matrix<T, m, d>;

  brake_motions(const M& mechanism, const joint_vector<M>& q, const brake_matrix<M>& E,
                const hybrid_brakes<M>&)
      : E_(E) {
    if constexpr (joints == d) {
      const mechanism_pose<M> pose(mechanism, q);
      const brake_matrix<M> G = passive_haptics::force_generators(pose);
      adds_up_ = forces_add_up(pose, G);
      W_ = transposed(G);
      if (adds_up_) return;
    }
    const jacobian_matrix<M> J(passive_haptics::jacobian(mechanism, q));
    const orthogonal_decomposition<T, d, joints> moving(J, rounding_tolerance<T>(joints));
    W_ = transmission_matrix<M>(transposed(passive_haptics::transposed_transmission(mechanism, q))) *
         moving.pseudo_inverse();
  }

  static constexpr status outcome() { return status::ok; }
  const rate_map& rates() const { return W_; }
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(W_);
  }
  vector<T, m> signs(const rate_map& W, const vector<T, d>& v) const { return signs_in_motion(W, E_, v); }
  template <class Visit>
  void for_each_way(const vector<T, d>& n, const Visit& visit) const {
    if (adds_up_) visit(vector<T, m>(W_ * n));
    else detail::for_each_way(E_, n, visit);
  }

 private:
  brake_matrix<M> E_;
  rate_map W_;
  bool adds_up_ = false;
};

// By generators, W = G^T: other than n brakes where n = d, and inertial forces.
template <displays_by_generators M>
class brake_motions<M> {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;

 public:
  using rate_map = matrix<T, m, d>;

  brake_motions(const M& mechanism, const joint_vector<M>& q, const brake_matrix<M>& E,
                const hybrid_brakes<M>&)
      : E_(E), W_(transposed(passive_haptics::generators_of(mechanism_pose<M>(mechanism, q)))) {}

  status outcome() const { return all_finite(W_) ? status::ok : status::singular_jacobian; }
  const rate_map& rates() const { return W_; }
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(W_);
  }
  vector<T, m> signs(const rate_map& W, const vector<T, d>& v) const { return signs_in_motion(W, E_, v); }
  template <class Visit>
  void for_each_way(const vector<T, d>& n, const Visit& visit) const {
    visit(vector<T, m>(W_ * n));
  }

 private:
  brake_matrix<M> E_;
  rate_map W_;
};

// What two forms with self-motion have in common.
template <class M>
class motions_with_self_motion {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;

 public:
  using rate_map = typename settled_rates<M>::rate_map;
  static constexpr T tolerance = rounding_tolerance<T>(M::dof + m);

  motions_with_self_motion(const M& mechanism, const joint_vector<M>& q, const brake_matrix<M>& E,
                           const hybrid_brakes<M>& brakes)
      : E_(E), rates_(mechanism_pose<M>(mechanism, q), tolerance, without_torque(brakes)) {}

  static constexpr status outcome() { return status::ok; }
  const settled_rates<M>& rates() const { return rates_; }
  template <class Visit>
  void for_each_way(const vector<T, d>& n, const Visit& visit) const {
    detail::for_each_way<M>(rates_, n, visit);
  }

 protected:
  brake_matrix<M> E_;

 private:
  static brake_set without_torque(const hybrid_brakes<M>& brakes) {
    const torque_box<T, m> box = passive_haptics::torque_box_of(vector<T, m>(vector<T, m>::Zero()), brakes);
    brake_set none = 0;
    for (int i = 0; i < m; ++i)
      if (!(box.lower[i] < T(0)) && !(box.upper[i] > T(0))) none |= brake_set(1) << i;
    return none;
  }

  settled_rates<M> rates_;
};

// Fewer brakes than joints, and a self-motion that is left alone.
template <leaves_free_joints_alone M>
class brake_motions<M> : public motions_with_self_motion<M> {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;

 public:
  using typename motions_with_self_motion<M>::rate_map;
  using motions_with_self_motion<M>::motions_with_self_motion;

  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(this->rates().least_rates());
  }
  vector<T, m> signs(const rate_map& W, const vector<T, d>& v) const {
    return signs_in_motion<T, m, d>(W, this->E_, v);
  }
};

// A self-motion that settles, W = W_S: one motion for each set of brakes that can be at rest.
template <Settles M>
class brake_motions<M> : public motions_with_self_motion<M> {
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;

 public:
  using typename motions_with_self_motion<M>::rate_map;
  using motions_with_self_motion<M>::motions_with_self_motion;

  template <class Visit>
  void for_each(const Visit& visit) const {
    this->rates().for_each([&](brake_set, const rate_map& W) {
      visit(W);
      return false;
    });
  }
  // The rate that rounding may make of none, for a unit velocity.
  T rate_dead_band() const { return this->tolerance * this->rates().least_rates().norm(); }
  vector<T, m> signs(const rate_map& W, const vector<T, d>& v) const {
    brake_parameters<T, m> in_motion;
    in_motion.rate_dead_band.setConstant(rate_dead_band());
    return brake_signs<T, m>(W * v, vector<T, m>::Zero(), in_motion);
  }
};

// Largest n . F of torques in a box: what they make against the easiest way. Infinite where there is none.
template <class M>
typename M::scalar strongest_of_box(const brake_motions<M>& motions,
                                    const torque_box<typename M::scalar, M::brake_count>& box,
                                    const task_vector<M>& n) {
  using T = typename M::scalar;
  T least = std::numeric_limits<T>::infinity();
  motions.for_each_way(n, [&](const brake_vector<M>& w) {
    least = std::min(least, largest_resistance<T, M::brake_count>(box, w));
  });
  return least;
}

// Largest n . F of these brakes and motors while the end effector moves with v.
template <class M>
typename M::scalar strongest_in_motion(const brake_motions<M>& motions, const task_vector<M>& v,
                                       const task_vector<M>& n, const hybrid_brakes<M>& brakes) {
  using T = typename M::scalar;
  T strongest = T(0);
  motions.for_each([&](const auto& W) {
    const auto box = passive_haptics::torque_box_of(motions.signs(W, v), brakes);
    strongest = std::max(strongest, strongest_of_box(motions, box, n));
  });
  return strongest;
}

// The part of a direction along a wall, as a unit vector; 0 where there is none.
template <class T, int D>
vector<T, D> along_wall(const vector<T, D>& direction, const vector<T, D>& n) {
  const vector<T, D> v = direction_of(direction), along = v - n.dot(v) * n;
  return along.norm() > rounding_tolerance<T>(D) ? direction_of(along) : vector<T, D>(vector<T, D>::Zero());
}

// Neighbouring numbers of at least this size are 1e-4 rad or m apart: a joint position beyond it has no
// meaningful sine.
template <class T>
inline constexpr T max_joint_position = T(1e-4) / std::numeric_limits<T>::epsilon();

// Why there is no result: of q, direction, normal or brakes. Else ok.
template <class M>
status outcome_of(const joint_vector<M>& q, const task_vector<M>& direction, const task_vector<M>& normal,
                  const hybrid_brakes<M>& brakes) {
  if (!all_finite(q, direction)) return status::state_not_finite;
  if (!(q.cwiseAbs().maxCoeff() <= max_joint_position<typename M::scalar>)) return status::pose_undefined;
  if (!all_finite(normal) || normal.isZero(0)) return status::contact_invalid;
  return brakes.is_valid() ? status::ok : status::parameters_invalid;
}

}  // namespace passive_haptics::detail
