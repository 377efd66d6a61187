// Control cycles at the edges of floating-point arithmetic: singular poses, rates at the dead bands, forces
// from denormal to nearly overflowing, coincident and opposed walls.
#pragma once

#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>

namespace stress {

namespace ph = passive_haptics;

// All that a step is given.
template <class M, int Walls>
struct cycle {
  ph::device_state<M> state;
  ph::brakes_of<M> brakes;
  ph::contacts<M::task_dimension, Walls> touched{};
  ph::step_options<typename M::scalar> options;

  friend std::ostream& operator<<(std::ostream& out, const cycle& c) {
    out.precision(17);
    out << "q " << c.state.q.transpose() << ", qd " << c.state.qd.transpose() << ", hand force "
        << c.state.hand_force.transpose() << "; torque limit " << c.brakes.torque_limit.transpose()
        << ", rate dead band " << c.brakes.rate_dead_band.transpose() << ", torque dead band "
        << c.brakes.torque_dead_band.transpose() << "; min cosine " << c.options.min_cosine;
    for (const auto& wall : c.touched) {
      out << "; normal " << wall.normal.transpose() << ", depth " << wall.depth << ", stiffness "
          << wall.stiffness << ", wall velocity " << wall.wall_velocity.transpose();
    }
    return out;
  }
};

template <class M, int Walls>
class hard_cases {
 public:
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension, m = M::brake_count;

  hard_cases(const M& mechanism, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper,
             std::uint64_t seed)
      : mechanism_(mechanism), lower_(lower), upper_(upper), random_(seed) {}

  cycle<M, Walls> draw() {
    cycle<M, Walls> c;
    c.state.time = 0;
    c.state.q = one_in(2) ? singular_pose() : ordinary_pose();
    for (int i = 0; i < M::dof; ++i) c.state.qd[i] = one_in(4) ? any_size() : random_.template normal<T>();
    c.state.hand_force = (one_in(4)   ? T(0)
                          : one_in(3) ? std::abs(any_size())
                                      : random_.positive(T(0.01), T(100))) *
                         random_.template direction<T, d>();
    const auto E = ph::brake_jacobian(mechanism_, c.state.q);
    const ph::brake_vector<M> w = ph::brake_rates(mechanism_, c.state.q, c.state.qd);
    const ph::brake_vector<M> th = ph::brake_torque(E, c.state.hand_force);
    for (int i = 0; i < m; ++i) {
      c.brakes.torque_limit[i] = one_in(8) ? std::abs(any_size()) : random_.positive(T(1e-2), T(1e3));
      if (one_in(2)) c.brakes.rate_dead_band[i] = at_the_edge(std::abs(w[i]));
      if (one_in(4)) c.brakes.torque_dead_band[i] = at_the_edge(std::abs(th[i]));
    }
    c.options.limits = one_in(2) ? ph::saturation::clamp_each : ph::saturation::keep_direction;
    if (one_in(8)) c.options.min_cosine = one_in(2) ? T(0) : T(1);
    const int walls = one_in(2) ? 1 : 1 + static_cast<int>(random_.uniform(0.0, 1.0) * Walls);
    const ph::matrix<T, d, m> directions(E);
    for (int j = 0; j < walls; ++j) {
      ph::contact<d> wall;
      const bool repeats = j > 0 && one_in(2);
      wall.normal = repeats ? (one_in(2) ? 1.0 : -1.0) * c.touched[0].normal : normal_beside(directions);
      wall.depth = one_in(8)   ? static_cast<double>(std::numeric_limits<double>::denorm_min())
                   : one_in(4) ? random_.positive(1e-17, 1e-15)  // an ulp of a position
                               : random_.positive(1e-9, 1e-1);
      wall.stiffness = one_in(8) ? 0 : random_.positive(1e-3, 1e12);
      if (one_in(2))
        wall.wall_velocity = random_.positive(1e-6, 1e3) * random_.template direction<double, d>();
      wall.wall_number = j;
      wall.sensed_at = mechanism_.position(c.state.q).template cast<double>();
      c.touched.push_back(wall);
    }
    return c;
  }

 private:
  bool one_in(int n) { return random_.uniform(0.0, 1.0) * n < 1; }

  // 0, or of either sign and any size but the largest.
  T any_size() {
    if (one_in(4)) return T(0);
    if (one_in(4)) return std::numeric_limits<T>::denorm_min();
    constexpr T large = sizeof(T) == 4 ? T(1e30) : T(1e300);
    return random_.wide(T(1) / large, large);
  }

  // x, or its neighbours; 0; a denormal number.
  T at_the_edge(T x) {
    if (!std::isfinite(x) || one_in(5)) return T(0);
    if (one_in(5)) return std::numeric_limits<T>::denorm_min();
    if (one_in(2)) return x;
    return std::max(std::nextafter(x, one_in(2) ? T(0) : std::numeric_limits<T>::max()), T(0));
  }

  ph::joint_vector<M> ordinary_pose() { return random_.template between<T, M::dof>(lower_, upper_); }

  // Aligned with the axes, or between two random poses where det J changes sign (n = d) or the loop just
  // closes; exactly or to 1e-300 ... 1e-6.
  ph::joint_vector<M> singular_pose() {
    ph::joint_vector<M> q;
    if (one_in(3)) {
      for (int i = 0; i < M::dof; ++i)
        q[i] = std::numbers::pi_v<T> / T(2) * std::floor(random_.uniform(T(-4), T(5)));
    } else {
      q = boundary(ordinary_pose(), ph::joint_vector<M>(T(2) * ordinary_pose()));
    }
    for (int i = 0; i < M::dof; ++i)
      if (one_in(3)) q[i] += random_.wide(sizeof(T) == 4 ? T(1e-38) : T(1e-300), T(1e-6));
    return q;
  }

  // 0 where the pose is undefined, else the sign of det J; 1 if J is not square.
  T side_of(const ph::joint_vector<M>& q) const {
    const ph::matrix<T, d, M::dof> J(ph::jacobian(mechanism_, q));
    if (!ph::all_finite(mechanism_.position(q)) || !ph::all_finite(J)) return T(0);
    if constexpr (M::dof == d) return J.determinant() > T(0) ? T(1) : T(-1);
    return T(1);
  }

  // The last pose on the way from a to b on a's side, if b is on another; halved until the numbers end.
  ph::joint_vector<M> boundary(ph::joint_vector<M> a, ph::joint_vector<M> b) const {
    if (side_of(a) == T(0)) std::swap(a, b);
    const T side = side_of(a);
    if (side_of(b) == side) return a;
    for (int halving = 0; halving < 80; ++halving) {
      const ph::joint_vector<M> middle = a + (b - a) / T(2);
      (side_of(middle) == side ? a : b) = middle;
    }
    return a;
  }

  // Any direction, an axis, along or across a brake's column of E; exactly or nearly.
  ph::point<d> normal_beside(const ph::matrix<T, d, m>& E) {
    const int i = static_cast<int>(random_.uniform(0.0, 1.0) * m);
    ph::point<d> n = random_.template direction<double, d>();
    if (one_in(4)) return (random_.coin() ? 1 : -1) * ph::point<d>::Unit(i % d);
    const ph::point<d> e = E.col(i).template cast<double>().stableNormalized();
    if (one_in(2) || !ph::all_finite(e) || !(e.norm() > 0.5)) return n;
    if (one_in(2)) n = (random_.coin() ? 1 : -1) * e;
    else n -= n.dot(e) * e;
    if (one_in(2)) n += random_.positive(1e-18, 1e-6) * random_.template direction<double, d>();
    const double length = n.norm();
    return length > 1e-3 ? ph::point<d>(n / length) : ph::point<d>(ph::point<d>::Unit(0));
  }

  const M& mechanism_;
  ph::joint_vector<M> lower_, upper_;
  ph::testing::random_source random_;
};

}  // namespace stress
