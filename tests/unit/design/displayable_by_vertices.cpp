// slow
// What devices of all forms can display, with and without motors, against all vertices of the torques that
// are possible: force, angle, least share of motors.
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/min_motor_share.hpp>
#include <passive_haptics/design/sink_slope.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace ph = passive_haptics;

namespace {

using any_vector = Eigen::VectorXd;
using any_matrix = Eigen::MatrixXd;

// Torques that each brake can make whatever its motion, and those of its motor.
struct torque_limits {
  any_vector lower, upper, motor;
  template <class B>
  torque_limits(const B& hybrid)
      : lower(hybrid.brakes.torque_lower.cwiseMax(-hybrid.brakes.torque_limit)),
        upper(hybrid.brakes.torque_upper.cwiseMin(hybrid.brakes.torque_limit)),
        motor(hybrid.motor_limit) {}
};

// A device in a pose as a linear program: maximise c . t over torques t in a box with A t = 0. c are the
// rates of the brakes for a motion along n, A t what is left of t on the self-motion.
struct torque_program {
  struct box {
    any_vector lower, upper;
  };
  any_matrix J, T, N, A;
  any_vector n, c;

  torque_program(const any_matrix& jacobian, const any_matrix& transmission, const any_vector& normal)
      : J(jacobian),
        T(transmission),
        N(J.cols() > J.rows() ? any_matrix(Eigen::FullPivLU<any_matrix>(J).kernel())
                              : any_matrix(J.cols(), 0)),
        A(N.transpose() * T.transpose()),
        n(normal),
        c(rates(n)) {}

  bool is_regular() const { return J.allFinite() && J.jacobiSvd().singularValues()[J.rows() - 1] >= 0.01; }
  any_vector rates(const any_vector& v) const { return T * J.completeOrthogonalDecomposition().solve(v); }

  static box box_of(const any_vector& w, const torque_limits& limits) {
    box all{w, w};
    for (Eigen::Index i = 0; i < w.size(); ++i) {
      all.upper[i] = std::max(limits.motor[i], w[i] > 1e-9 ? 0.0 : limits.upper[i]);
      all.lower[i] = std::min(-limits.motor[i], w[i] < -1e-9 ? 0.0 : limits.lower[i]);
    }
    return all;
  }
  // A vertex has all torques at bounds but as many as there are equations, which these decide.
  double largest(const box& torques) const {
    const auto m = static_cast<int>(c.size()), r = static_cast<int>(A.rows());
    double best = 0;
    for (unsigned open = 0; open < 1u << m; ++open) {
      if (std::popcount(open) != r) continue;
      for (unsigned corner = 0; corner < 1u << m; ++corner) {
        if ((corner & open) != 0) continue;
        any_vector t(m), left = any_vector::Zero(r);
        any_matrix solved(r, r);
        for (int i = 0, k = 0; i < m; ++i) {
          t[i] = (corner >> i & 1u) != 0 ? torques.upper[i] : torques.lower[i];
          if ((open >> i & 1u) != 0) solved.col(k++) = A.col(i);
          else left -= t[i] * A.col(i);
        }
        if (r > 0) {
          const Eigen::FullPivLU<any_matrix> lu(solved);
          if (!lu.isInvertible()) continue;
          const any_vector x = lu.solve(left);
          for (int i = 0, k = 0; i < m; ++i)
            if ((open >> i & 1u) != 0) t[i] = x[k++];
        }
        if (((t - torques.upper).array() <= 1e-9).all() && ((torques.lower - t).array() <= 1e-9).all())
          best = std::max(best, c.dot(t));
      }
    }
    return best;
  }
  // If a self-motion settles, over all of them: one between each two at which a brake comes to rest.
  double max_force(const any_vector& v, const torque_limits& limits) const {
    const any_vector w = rates(v);
    if (N.cols() == 0) return largest(box_of(w, limits));
    const any_vector z = T * N.col(0);
    std::vector<double> rests;
    for (Eigen::Index i = 0; i < w.size(); ++i) rests.push_back(-w[i] / z[i]);
    std::sort(rests.begin(), rests.end());
    std::vector<double> between{rests.front() - 1, rests.back() + 1};
    for (std::size_t k = 1; k < rests.size(); ++k) between.push_back((rests[k - 1] + rests[k]) / 2);
    double best = 0;
    for (const double s : between) best = std::max(best, largest(box_of(w + s * z, limits)));
    return best;
  }
  // Without a self-motion: of the force nearest to n, the largest projection on some brakes that can push so.
  double max_cosine(const any_vector& v, const torque_limits& limits) const {
    const box torques = box_of(rates(v), limits);
    const any_matrix forces = J.transpose().colPivHouseholderQr().solve(any_matrix(T.transpose()));
    double best = 0;
    for (unsigned used = 1; used < 1u << forces.cols(); ++used) {
      any_matrix chosen = forces;
      for (Eigen::Index i = 0; i < forces.cols(); ++i)
        if ((used >> i & 1u) == 0) chosen.col(i).setZero();
      const any_vector t = chosen.completeOrthogonalDecomposition().solve(n);
      bool possible = true;
      for (Eigen::Index i = 0; i < t.size(); ++i)
        possible =
            possible && !(t[i] > 1e-9 && torques.upper[i] == 0) && !(t[i] < -1e-9 && torques.lower[i] == 0);
      if (possible) best = std::max(best, (chosen * t).norm());
    }
    return best;
  }
};

struct shares_seen {
  int none = 0, some = 0, over_1 = 0;
};

template <class M>
void compare_with_vertices(const M& mechanism, const ph::joint_vector<M>& lower,
                           const ph::joint_vector<M>& upper, int poses = 150) {
  constexpr int d = M::task_dimension;
  ph::testing::random_source random(17);
  shares_seen seen;
  int compared = 0;
  for (int k = 0; k < poses; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 17, pose " << k);
    const ph::joint_vector<M> q = random.between(lower, upper);
    const ph::task_vector<M> n = random.direction<double, d>();
    ph::task_vector<M> v = random.direction<double, d>();
    const ph::task_vector<M> along = (v - n.dot(v) * n).normalized();
    const torque_program program(ph::jacobian_matrix<M>(ph::jacobian(mechanism, q)),
                                 ph::transposed_transmission(mechanism, q).transpose(), n);
    if (!program.is_regular()) continue;
    ++compared;
    ph::hybrid_brakes<M> hybrid;
    for (int i = 0; i < M::brake_count; ++i) {
      hybrid.brakes.torque_limit[i] = random.uniform(0.3, 2.0);
      hybrid.motor_limit[i] = random.coin() ? 0.0 : random.uniform(0.0, 1.5);
      const double way = random.uniform(0.0, 1.0);
      if (way < 0.1) hybrid.brakes.switch_off(i);
      else if (way < 0.2) hybrid.brakes.make_positive(i);
      else if (way < 0.3) hybrid.brakes.torque_lower[i] = -0.2;
    }
    if (k % 4 == 0) v = along;
    if (k % 4 == 1) v = n;
    if (k % 4 == 2 && !ph::Settles<M>)  // few brakes turn
      v = ph::brake_matrix<M>(ph::brake_jacobian(mechanism, q)).col(k / 4 % M::brake_count).normalized();
    const double expected = program.max_force(v, hybrid);
    EXPECT_NEAR(ph::displayable(mechanism, q, v, n, hybrid).max_force, expected, 1e-8 * (1 + expected));
    const ph::hybrid_brakes<M> no_motors(hybrid.brakes);
    const auto by_brakes = ph::displayable(mechanism, q, v, n, no_motors);
    EXPECT_NEAR(by_brakes.max_force, program.max_force(v, no_motors), 1e-8 * (1 + expected));
    EXPECT_EQ(ph::is_displayed(by_brakes.display), by_brakes.max_force > 1e-8);
    EXPECT_LE(by_brakes.max_approximated_force, by_brakes.max_force * (1 + 1e-9));
    if (!ph::Settles<M>) {
      const double cosine = program.max_cosine(v, no_motors);
      EXPECT_NEAR(std::cos(by_brakes.angle), cosine, 1e-9);
      EXPECT_EQ(by_brakes.display == ph::display_class::exact, cosine > 1 - 1e-12);
    }

    const double push = random.uniform(0.1, 1.5) * program.max_force(-n, no_motors);
    if (!(push > 0.01)) continue;
    const auto found = ph::min_motor_share(mechanism, q, along, n, hybrid.brakes, push);
    ASSERT_EQ(found.outcome, ph::status::ok);
    ASSERT_TRUE(std::isfinite(found.share));
    const auto with_share = [&](double share) {
      return ph::hybrid_brakes<M>(hybrid.brakes, share * hybrid.brakes.torque_limit);
    };
    EXPECT_GE(program.max_force(along, with_share(found.share)), push * (1 - 1e-8));
    EXPECT_EQ(ph::sink_slope(mechanism, q, along, n, with_share(found.share * (1 + 1e-8)), push).slope, 0);
    seen.none += found.share == 0;
    seen.some += found.share > 0;
    seen.over_1 += found.share > 1;
    if (found.share == 0) continue;
    EXPECT_LT(program.max_force(along, with_share(0.999 * found.share)), push);
    EXPECT_GT(ph::sink_slope(mechanism, q, along, n, with_share(0.999 * found.share), push).slope, 0);
  }
  EXPECT_GT(compared, poses / 2);
  EXPECT_GT(seen.none, compared / 20);
  EXPECT_GT(seen.some, compared / 5);
  EXPECT_GT(seen.over_1, compared / 20);
}

template <int N>
ph::vector<double, N> each(double x) {
  return ph::vector<double, N>::Constant(x);
}

TEST(displayable, is_what_the_vertices_of_all_torques_make) {
  const ph::vector<double, 2> low(1.7, 0.2), high(2.9, 1.4);
  const ph::serial_chain<double, 3, 2> planar(ph::planar_arm<double>(std::array<double, 3>{0.2, 0.2, 0.2}));
  compare_with_vertices(ph::tendon_two_link<double>(), {-3, 0.2}, {3, 2.9});
  compare_with_vertices(ph::five_bar<double, 4>(), low, high);
  compare_with_vertices(ph::delta<double>(), each<3>(-0.3), each<3>(1.1));
  compare_with_vertices(planar, each<3>(-2), each<3>(2));
  compare_with_vertices(ph::braked_joints<ph::serial_chain<double, 3, 2>, 0, 2>(planar), each<3>(-2),
                        each<3>(2));
}

}  // namespace
