/// Brake rates while the end effector moves.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/status.hpp>

namespace passive_haptics::detail {

// Signs of the rates w = A v; 0 within the rounding errors of A and E, since E w = v.
template <class T, int Brakes, int D>
vector<T, Brakes> signs_in_motion(const matrix<T, Brakes, D>& A, const matrix<T, D, Brakes>& E,
                                  const vector<T, D>& v) {
  const vector<T, Brakes> w = A * v;
  const T terms = v.norm() + (E.cwiseAbs() * w.cwiseAbs()).norm();
  const vector<T, Brakes> rounding = rounding_tolerance<T>(D + Brakes) * terms * A.rowwise().norm();
  return (w.array().abs() > rounding.array()).select(w.array().sign(), T(0));
}

// Calls visit(w) for rates w with E w = n, for all sets of moving brakes. One of them minimises any weighted
// sum of |w_i| with sign-dependent weights, because the minimum has as many zero rates as possible.
template <class T, int D, int Brakes, class Visit>
void for_each_way(const matrix<T, D, Brakes>& E, const vector<T, D>& n, const Visit& visit) {
  const T tolerance = rounding_tolerance<T>(D + Brakes);
  for (half_space_set moving = 1; moving < (half_space_set{1} << Brakes); ++moving) {
    matrix<T, D, Brakes> moved = E;
    for (int i = 0; i < Brakes; ++i)
      if ((moving >> i & 1u) == 0) moved.col(i).setZero();
    const vector<T, Brakes> w = orthogonal_decomposition<T, D, Brakes>(moved, tolerance).solve(n);
    const T rounding = tolerance * (T(1) + (moved.cwiseAbs() * w.cwiseAbs()).norm());
    if ((moved * w - n).norm() <= rounding) visit(w);
  }
}

// Motions of brakes without a self-motion: rates w = W v for a velocity v of the end effector.
template <class T, int D, int Brakes>
class ways_to_move {
 public:
  using rate_map = matrix<T, Brakes, D>;  ///< W

  // is_unique: W n are the only rates that move the end effector along n.
  ways_to_move(const matrix<T, D, Brakes>& E, const rate_map& W, bool is_unique)
      : E_(E), W_(W), is_unique_(is_unique) {}

  status outcome() const { return all_finite(W_) ? status::ok : status::singular_jacobian; }
  const rate_map& rates() const { return W_; }
  template <class Visit>
  void for_each(const Visit& visit) const {
    visit(W_);
  }
  vector<T, Brakes> signs(const rate_map& W, const vector<T, D>& v) const {
    return signs_in_motion(W, E_, v);
  }
  // Calls visit(w) for rates w that move the end effector along n, including the easiest for any torques.
  template <class Visit>
  void for_each_way(const vector<T, D>& n, const Visit& visit) const {
    if (is_unique_) visit(vector<T, Brakes>(W_ * n));
    else detail::for_each_way(E_, n, visit);
  }

 private:
  matrix<T, D, Brakes> E_;
  rate_map W_;
  bool is_unique_;
};

}  // namespace passive_haptics::detail
