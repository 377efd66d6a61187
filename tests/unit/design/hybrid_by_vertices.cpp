// slow, optimised
// The strongest normal force of brakes with motors, and the least share of motors, against all vertices of
// the torques that are possible.
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/min_motor_share.hpp>
#include <passive_haptics/design/sink_slope.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include "../../property/chain_cases.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

namespace ph = passive_haptics;

namespace {

// A device in a pose as a linear program: maximise c . t over torques t in a box with A t = 0. c are the
// rates of the brakes for a motion along n, A t what is left of t on the self-motion.
template <class M>
struct torque_program {
  Eigen::MatrixXd J, T, N, A;
  Eigen::VectorXd c;

  torque_program(const M& mechanism, const ph::joint_vector<M>& q, const ph::task_vector<M>& n)
      : J(ph::jacobian_matrix<M>(ph::jacobian(mechanism, q))),
        T(ph::transposed_transmission(mechanism, q).transpose()),
        c(rates(n)) {
    if constexpr (M::dof > M::task_dimension) N = Eigen::FullPivLU<Eigen::MatrixXd>(J).kernel();
    else N = Eigen::MatrixXd(int(M::dof), 0);
    A = N.transpose() * T.transpose();
  }
  Eigen::VectorXd rates(const ph::task_vector<M>& v) const {
    return T * J.completeOrthogonalDecomposition().solve(Eigen::VectorXd(v));
  }
  // A vertex has all torques at bounds but as many as there are equations, which these decide.
  double largest(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) const {
    const auto m = static_cast<int>(c.size()), r = static_cast<int>(A.rows());
    double best = 0;
    for (unsigned open = 0; open < 1u << m; ++open) {
      if (std::popcount(open) != r) continue;
      for (unsigned corner = 0; corner < 1u << m; ++corner) {
        if ((corner & open) != 0) continue;
        Eigen::VectorXd t(m);
        Eigen::MatrixXd solved(r, r);
        Eigen::VectorXd left = Eigen::VectorXd::Zero(r);
        for (int i = 0, k = 0; i < m; ++i) {
          t[i] = (corner >> i & 1u) != 0 ? upper[i] : lower[i];
          if ((open >> i & 1u) != 0) solved.col(k++) = A.col(i);
          else left -= t[i] * A.col(i);
        }
        if (r > 0) {
          const Eigen::FullPivLU<Eigen::MatrixXd> lu(solved);
          if (!lu.isInvertible()) continue;
          const Eigen::VectorXd x = lu.solve(left);
          for (int i = 0, k = 0; i < m; ++i)
            if ((open >> i & 1u) != 0) t[i] = x[k++];
        }
        if (((t - upper).array() <= 1e-9).all() && ((lower - t).array() <= 1e-9).all())
          best = std::max(best, c.dot(t));
      }
    }
    return best;
  }
  double largest(const Eigen::VectorXd& w, const ph::hybrid_brakes<M>& hybrid) const {
    const auto& b = hybrid.brakes;
    Eigen::VectorXd lower(w.size()), upper(w.size());
    for (Eigen::Index i = 0; i < w.size(); ++i) {
      const double motor = hybrid.motor_limit[i], limit = b.torque_limit[i];
      upper[i] = std::max(motor, w[i] > 1e-12 ? 0.0 : std::min(limit, b.torque_upper[i]));
      lower[i] = std::min(-motor, w[i] < -1e-12 ? 0.0 : std::max(-limit, b.torque_lower[i]));
    }
    return largest(lower, upper);
  }
  // Over all self-motions where one settles: one between each two at which a brake comes to rest.
  double max_force(const ph::task_vector<M>& v, const ph::hybrid_brakes<M>& hybrid) const {
    const Eigen::VectorXd w = rates(v);
    if constexpr (!ph::Settles<M>) {
      return largest(w, hybrid);
    } else {
      const Eigen::VectorXd z = T * N.col(0);
      std::vector<double> rests;
      for (Eigen::Index i = 0; i < w.size(); ++i) rests.push_back(-w[i] / z[i]);
      std::sort(rests.begin(), rests.end());
      std::vector<double> between{rests.front() - 1, rests.back() + 1};
      for (std::size_t k = 1; k < rests.size(); ++k) between.push_back((rests[k - 1] + rests[k]) / 2);
      double best = 0;
      for (const double s : between) best = std::max(best, largest(w + s * z, hybrid));
      return best;
    }
  }
};

struct shares_seen {
  int none = 0, some = 0, over_1 = 0;
};

template <class M>
void compare_with_vertices(const M& mechanism, const ph::joint_vector<M>& lower,
                           const ph::joint_vector<M>& upper, int poses) {
  constexpr int d = M::task_dimension;
  ph::testing::random_source random(17);
  shares_seen seen;
  int compared = 0;
  for (int k = 0; k < poses; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 17, pose " << k);
    const ph::joint_vector<M> q = random.between(lower, upper);
    const ph::task_vector<M> n = random.direction<double, d>(), v = random.direction<double, d>(),
                             along = (v - n.dot(v) * n).normalized();
    const torque_program<M> program(mechanism, q, n);
    if (!program.J.allFinite() || program.J.jacobiSvd().singularValues()[d - 1] < 0.01) continue;
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
    const double expected = program.max_force(v, hybrid);
    EXPECT_NEAR(ph::displayable(mechanism, q, v, n, hybrid).max_force, expected, 1e-8 * (1 + expected));

    const double push = random.uniform(0.1, 1.5) * program.max_force(-n, hybrid.brakes);
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
  std::printf("%d poses: no motors needed in %d, some in %d, stronger than brakes in %d\n", compared,
              seen.none, seen.some, seen.over_1);
}

template <int N>
ph::serial_chain<double, N, 2> equal_links() {
  std::array<double, N> lengths;
  lengths.fill(0.2);
  return ph::serial_chain<double, N, 2>(ph::planar_arm<double>(lengths));
}
template <int N>
ph::vector<double, N> each(double x) {
  return ph::vector<double, N>::Constant(x);
}

TEST(hybrid_brakes, make_what_the_vertices_of_their_torques_make) {
  using planar = ph::vector<double, 2>;
  const planar low(1.7, 0.2), high(2.9, 1.4);
  compare_with_vertices(ph::tendon_two_link<double>(), planar(-3, 0.2), planar(3, 2.9), 300);
  compare_with_vertices(ph::five_bar<double>(), low, high, 300);
  compare_with_vertices(ph::five_bar<double, 4>(), low, high, 300);
  compare_with_vertices(ph::delta<double>(), each<3>(-0.3), each<3>(1.1), 300);
  compare_with_vertices(chains::irregular_chain<double, 3, 3>::make(), each<3>(-2), each<3>(2), 300);
  compare_with_vertices(equal_links<3>(), each<3>(-2), each<3>(2), 300);
  compare_with_vertices(chains::irregular_chain<double, 4, 3>::make(), each<4>(-2), each<4>(2), 200);
  compare_with_vertices(ph::braked_joints<ph::serial_chain<double, 3, 2>, 0, 2>(equal_links<3>()),
                        each<3>(-2), each<3>(2), 300);
}

}  // namespace
