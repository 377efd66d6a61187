// States of a device along one wall or two, ordinary ones and hard ones in turns.
#pragma once

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <utility>
#include <vector>

namespace worst_case {

namespace ph = passive_haptics;

inline constexpr unsigned seed = 20040627;

// What two cycles find, one after the other. The second is counted; the first is what a law remembers.
template <class M>
struct situation {
  ph::device_state<M> before, now;
  std::array<ph::half_space<M::task_dimension>, 2> walls;
  bool is_hard;
};

// Ordinary: random poses, rates and forces, as in benchmarks/latency.cpp, three brakes in ten hardly turn,
// and walls whose desired forces are 0.01 to 10 N. Hard: of what follows each every other time, so that they
// also come together.
//   - A pose that is singular, or beside one by 1e-16 to 1e-2.
//   - Any set of the brakes at rest, within their dead bands or on the edge of them.
//   - A handle at rest on an arm that moves (n > d).
//   - No hand force; one along the wall's normal or a column of E; 1e-9 to 100 N.
//   - A normal along a column of E, or at right angles to it, to 0 to 1e-9.
//   - A second wall that coincides with the first, to 0 to 1e-6, is opposite to it or at right angles to it.
//   - Both walls 1 m deep, where every limit is met, or just touched.
// The state before is another one, or that of 1 ms before in the same motion.
template <class M>
class states {
  static_assert(std::same_as<typename M::scalar, double>);
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  using joints = ph::joint_vector<M>;
  using place = ph::point<d>;

 public:
  explicit states(const M& mechanism) : mechanism_(mechanism), random_(seed) {
    for (int k = 0; k < 200; ++k) singular_.push_back(singular_pose());
  }

  situation<M> next() {
    const bool hard = is_hard_ = !is_hard_;
    ph::device_state<M> now = hard ? hard_state() : ordinary_state();
    ph::device_state<M> before = ordinary_state();
    if (random_.coin()) {
      before = now;
      before.q -= 1e-3 * now.qd;
    }
    before.time = 0;
    now.time = 1e-3;
    const place x = mechanism_.position(now.q);
    const place first = hard && random_.coin() ? special_direction(now) : random_.direction<double, d>();
    if (hard && random_.coin()) now.hand_force = force_along(random_.coin() ? first : special_direction(now));
    return {before,
            now,
            {wall(x, first, hard), wall(x, hard ? beside(first) : random_.direction<double, d>(), hard)},
            hard};
  }

 private:
  bool is_finite(const joints& q) const { return ph::all_finite(mechanism_.position(q)); }

  joints any_pose() {
    joints q;
    do q = random_.uniform(0.0, 2.0) * random_.direction<double, n>();
    while (!is_finite(q));
    return q;
  }

  ph::device_state<M> ordinary_state() {
    ph::device_state<M> s;
    s.q = any_pose();
    s.qd = random_.direction<double, n>();
    for (double& rate : s.qd) rate *= random_.uniform(0.0, 1.0) < 0.3 ? 0.01 : 1.0;
    s.hand_force = 2 * random_.direction<double, d>();
    return s;
  }

  ph::device_state<M> hard_state() {
    ph::device_state<M> s = ordinary_state();
    if (random_.coin()) {
      const joints q =
          singular_[std::size_t(random_.uniform(0.0, double(singular_.size())))] +
          (random_.coin() ? random_.positive(1e-16, 1e-2) : 0.0) * random_.direction<double, n>();
      if (is_finite(q)) s.q = q;
    }
    const ph::mechanism_pose<M> pose(mechanism_, s.q);
    if (random_.coin()) s.qd = rates_of_brakes_at_rest(pose);
    if constexpr (n > d)
      if (random_.coin()) s.qd = joints(self_motion(pose) * random_.normal<double>());
    if (random_.coin())
      s.hand_force = random_.coin() ? place(place::Zero()) : force_along(random_.direction<double, d>());
    return s;
  }

  place force_along(const place& way) { return random_.wide(1e-9, 100.0) * way; }

  // Any set of brakes rests, one of its brakes perhaps on the edge of the dead band
  joints rates_of_brakes_at_rest(const ph::mechanism_pose<M>& pose) {
    const double edge = ph::brakes_of<M>().rate_dead_band[0];
    ph::brake_vector<M> w;
    for (double& rate : w) {
      const double at_rest[] = {0, 0, 0.5 * edge, edge, -edge, std::nextafter(edge, 1.0)};
      rate = random_.coin() ? at_rest[std::size_t(random_.uniform(0.0, 6.0))] : random_.uniform(-1.0, 1.0);
    }
    ph::matrix<double, m, n> T;
    for (int i = 0; i < n; ++i) T.col(i) = pose.brake_rates(joints(joints::Unit(i)));
    return ph::pseudo_inverse(T) * w;
  }

  joints self_motion(const ph::mechanism_pose<M>& pose) {
    const ph::matrix<double, d, n> J = pose.jacobian();
    const joints any = random_.direction<double, n>();
    const joints still = any - ph::pseudo_inverse(J) * (J * any);
    return ph::all_finite(still) ? still : any;  // J without full rank
  }

  // Along the column of a brake, or at right angles to it
  place special_direction(const ph::device_state<M>& s) {
    const auto E = ph::brake_jacobian(mechanism_, s.q);
    const int i = int(random_.uniform(0.0, double(m)));
    place column;
    for (int k = 0; k < d; ++k) column[k] = ph::brake_torque(E, ph::task_vector<M>(place::Unit(k)))[i];
    const place any = random_.direction<double, d>();
    if (!(column.norm() > 1e-100)) return any;
    const place along = (random_.coin() ? 1 : -1) * column.normalized();
    const place chosen = random_.coin() ? along : place(any - any.dot(along) * along);
    const place turned = chosen + (random_.coin() ? random_.positive(1e-16, 1e-9) : 0.0) * any;
    return turned.norm() > 1e-3 ? place(turned.normalized()) : any;
  }

  // A direction for the second wall
  place beside(const place& first) {
    const place any = random_.direction<double, d>();
    const double choice = random_.uniform(0.0, 5.0);
    if (choice < 1) return first;
    if (choice < 2) return (first + random_.positive(1e-16, 1e-6) * any).normalized();
    if (choice < 3) return -first;
    if (choice < 4) return any;
    const place across = any - any.dot(first) * first;
    return across.norm() > 1e-3 ? place(across.normalized()) : any;
  }

  ph::half_space<d> wall(const place& x, const place& normal, bool hard) {
    const double depth = !hard || random_.coin() ? random_.positive(1e-6, 1e-3)
                         : random_.coin()        ? 1.0
                                                 : 1e-12;
    return {place(x + depth * normal), normal};
  }

  // A pose without rank, to rounding: where det J changes its sign between two poses; where an arm is
  // straight
  joints singular_pose() {
    using jacobian = std::remove_cvref_t<decltype(std::declval<const ph::mechanism_pose<M>&>().jacobian())>;
    if constexpr (std::same_as<jacobian, ph::matrix<double, d, n>> && n == d) {
      const auto det = [&](const joints& q) {
        return ph::mechanism_pose<M>(mechanism_, q).jacobian().determinant();
      };
      for (int attempt = 0; attempt < 1000; ++attempt) {
        joints a = any_pose(), b = any_pose();
        if (!(det(a) * det(b) < 0)) continue;
        for (int k = 0; k < 60; ++k) {
          const joints middle = (a + b) / 2;
          (det(a) * det(middle) < 0 ? b : a) =
              middle;  // where det is NaN a pose beside the edge of the reach
        }
        if (is_finite(a)) return a;
      }
    }
    joints q = std::numbers::pi / 2 * random_.direction<double, n>().array().sign();
    for (double& angle : q) angle *= double(int(random_.uniform(0.0, 3.0)));
    return is_finite(q) ? q : any_pose();
  }

  M mechanism_;
  ph::testing::random_source random_;
  std::vector<joints> singular_;
  bool is_hard_ = true;
};

}  // namespace worst_case
