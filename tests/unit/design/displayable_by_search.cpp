// slow
// What can be displayed at all, against brute force over torques, forces and signs.
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include "../../property/chain_cases.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr double right_angle = std::numbers::pi / 2, infinite = std::numeric_limits<double>::infinity();

// What sampling finds.
struct best {
  double angle = right_angle, max_force = 0;

  template <int D>
  void look_at(const ph::vector<double, D>& F, const ph::vector<double, D>& n) {
    const double along = n.dot(F), across = (F - along * n).norm();
    max_force = std::max(max_force, along);
    if (along > 1e-9 * across) angle = std::min(angle, std::atan2(across, along));
  }
};

template <class M>
ph::transmission_matrix<M> transmission_of(const M& mechanism, const ph::joint_vector<M>& q) {
  return ph::transposed(ph::transposed_transmission(mechanism, q));
}

// Rates of the brakes when the end effector moves with v and the joints as little as may be.
template <class M>
ph::brake_vector<M> rates_of(const M& mechanism, const ph::joint_vector<M>& q, const ph::task_vector<M>& v) {
  const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
  const ph::joint_vector<M> qd =
      Eigen::MatrixXd(J).completeOrthogonalDecomposition().solve(Eigen::VectorXd(v));
  return transmission_of(mechanism, q) * qd;
}

// Whether torques of these signs (bit i: of brake i, > 0) take power from no brake.
template <int Brakes>
bool passive(unsigned signs, const ph::vector<double, Brakes>& w) {
  for (int i = 0; i < Brakes; ++i)
    if (std::abs(w[i]) > 1e-9 && (w[i] > 0) == ((signs >> i & 1u) != 0)) return false;
  return true;
}

// n = d: torques of all signs, those at the limits and many between, and the forces J^T F = T^T t that they
// make.
template <class M>
best by_torques(const M& mechanism, const ph::joint_vector<M>& q, const ph::task_vector<M>& v,
                const ph::task_vector<M>& n, const ph::brake_vector<M>& limit,
                ph::testing::random_source& random) {
  constexpr int m = M::brake_count;
  using torques = ph::brake_vector<M>;
  const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
  const torques w = rates_of(mechanism, q, v);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> Jt(J.transpose());
  const ph::brake_matrix<M> G = Jt.solve(Eigen::MatrixXd(transmission_of(mechanism, q).transpose()));
  best all;
  for (unsigned signs = 0; signs < 1u << m; ++signs) {
    if (!passive<m>(signs, w)) continue;
    const auto force_of = [&](const torques& share) -> ph::task_vector<M> {
      torques t = share.cwiseProduct(limit);
      for (int i = 0; i < m; ++i)
        if ((signs >> i & 1u) == 0) t[i] = -t[i];
      return G * t;
    };
    for (unsigned corner = 0; corner < 1u << m; ++corner) {
      torques share;
      for (int i = 0; i < m; ++i) share[i] = corner >> i & 1u;
      all.look_at(force_of(share), n);
    }
    // The least angle: anywhere, and by the brakes of each subset the nearest to n, if they can push
    for (int k = 0; k < 300; ++k) {
      torques share;
      for (double& x : share) x = random.uniform(0.0, 1.0);
      all.look_at(force_of(share), n);
    }
    for (unsigned used = 1; used < 1u << m; ++used) {
      ph::brake_matrix<M> forces = ph::brake_matrix<M>::Zero();
      for (int i = 0; i < m; ++i)
        if ((used >> i & 1u) != 0) forces.col(i) = force_of(torques::Unit(i));
      const torques share =
          Eigen::MatrixXd(forces).completeOrthogonalDecomposition().solve(Eigen::VectorXd(n));
      if ((share.array() >= 0).all()) all.look_at(force_of(share / std::max(1.0, share.maxCoeff())), n);
    }
  }
  return all;
}

// m = n >= d: forces whose torques are at D of the limits (the corners of all that can be displayed), and
// forces in all directions of the plane.
template <class M>
best by_forces_at(const M& mechanism, const ph::joint_vector<M>& q, const ph::brake_vector<M>& w,
                  const ph::task_vector<M>& n, const ph::brake_vector<M>& limit) {
  constexpr int m = M::brake_count, d = M::task_dimension;
  using torques = ph::brake_vector<M>;
  using force = ph::task_vector<M>;
  const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> Tt(transmission_of(mechanism, q).transpose());
  const ph::matrix<double, m, d> Et = Tt.solve(Eigen::MatrixXd(J.transpose()));
  const auto max_share = [&](const force& F) {
    const torques t = Et * F;
    double share = infinite;
    for (int i = 0; i < m; ++i) {
      if (std::abs(t[i]) <= 1e-12 * F.norm()) continue;
      if (std::abs(w[i]) > 1e-9 && t[i] * w[i] > 0) return 0.0;
      share = std::min(share, limit[i] / std::abs(t[i]));
    }
    return share;
  };
  best all;
  const auto look_at = [&](const force& F) {
    if (const double share = max_share(F); share > 0 && std::isfinite(share))
      all.look_at(force(share * F), n);
  };
  for (unsigned held = 0; held < 1u << m; ++held) {
    if (std::popcount(held) != d) continue;
    for (unsigned corner = 0; corner < 3u * 3u * 3u; ++corner) {
      ph::matrix<double, d, d> A;
      force b;
      unsigned digits = corner;
      for (int i = 0, k = 0; i < m; ++i) {
        if ((held >> i & 1u) == 0) continue;
        A.row(k) = Et.row(i);
        b[k++] = (static_cast<double>(digits % 3) - 1) * limit[i];
        digits /= 3;
      }
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> corner_of(A);
      const force F = corner_of.solve(Eigen::VectorXd(b));
      if ((A * F - b).norm() <= 1e-9 && F.norm() > 0) look_at(F);
    }
  }
  if constexpr (d == 2) {
    for (int i = 0; i < m; ++i)
      for (const double side : {-1.0, 1.0}) look_at(force(side * Et(i, 1), -side * Et(i, 0)));
    for (int k = 0; k < 720; ++k)
      look_at(force(std::cos(k * ph::radians(0.5)), std::sin(k * ph::radians(0.5))));
    look_at(n);
  }
  return all;
}

template <class M>
void expect_best(const ph::displayable_force<M>& found, const best& sampled, double angle_tolerance) {
  ASSERT_EQ(found.outcome, ph::status::ok);
  ASSERT_NEAR(found.max_force, sampled.max_force, 1e-9 * (1 + sampled.max_force));
  ASSERT_LE(found.max_approximated_force, found.max_force * (1 + 1e-9));
  ASSERT_LE(found.angle, sampled.angle + angle_tolerance) << "sampling comes nearer";
  ASSERT_GE(found.angle, sampled.angle - angle_tolerance) << "no such force was found";
  ASSERT_EQ(ph::is_displayed(found.display), sampled.angle < right_angle);
  ASSERT_EQ(found.display == ph::display_class::exact, found.angle < 1e-7);
}

struct counts {
  int all = 0, nothing = 0, exact = 0;
  template <class M>
  void add(const ph::displayable_force<M>& found) {
    ++all;
    nothing += !ph::is_displayed(found.display);
    exact += found.display == ph::display_class::exact;
  }
};

// Random poses; the handle moves along the wall, into it, out of it, or so that only one brake turns.
template <class M, class Sample>
counts compare(const M& mechanism, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper,
               int poses, double angle_tolerance, Sample&& sample) {
  constexpr int d = M::task_dimension;
  ph::testing::random_source random(7);
  counts seen;
  for (int k = 0; k < poses; ++k) {
    SCOPED_TRACE(::testing::Message() << "pose " << k);
    const ph::joint_vector<M> q = random.between(lower, upper);
    const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
    if (!ph::all_finite(J) || Eigen::MatrixXd(J).jacobiSvd().singularValues()[d - 1] < 0.01) continue;
    const ph::task_vector<M> n = random.direction<double, d>();
    ph::task_vector<M> v = random.direction<double, d>();
    if (k % 4 == 0) v = (v - n.dot(v) * n).normalized();
    if (k % 4 == 1) v = n;
    if (k % 4 == 2) v = ph::brake_matrix<M>(ph::brake_jacobian(mechanism, q)).col(k / 4 % M::brake_count);
    ph::brake_vector<M> limit;
    for (double& x : limit) x = random.uniform(0.3, 2.0);
    const auto found = ph::displayable(mechanism, q, v, n, limit);
    expect_best(found, sample(q, v, n, limit, random), angle_tolerance);
    if (::testing::Test::HasFatalFailure()) return seen;
    seen.add(found);
  }
  return seen;
}

template <class M>
counts compare_by_torques(const M& mechanism, const ph::joint_vector<M>& lower,
                          const ph::joint_vector<M>& upper, int poses) {
  return compare(mechanism, lower, upper, poses, 0.01,
                 [&](auto&... now) { return by_torques(mechanism, now...); });
}

TEST(displayable, is_the_best_of_all_torques) {
  using planar = ph::vector<double, 2>;
  using spatial = ph::vector<double, 3>;
  const planar low(1.7, 0.2), high(2.9, 1.4);
  for (const counts& seen :
       {compare_by_torques(ph::tendon_two_link<double>(), planar(-3, -3), planar(3, 3), 400),
        compare_by_torques(ph::xy_table<double>(), planar(-1, -1), planar(1, 1), 200),
        compare_by_torques(ph::five_bar<double>(), low, high, 400),
        compare_by_torques(ph::five_bar<double, 4>(), low, high, 100),
        compare_by_torques(ph::delta<double>(), spatial(-0.3, -0.3, -0.3), spatial(1.1, 1.1, 1.1), 200),
        compare_by_torques(chains::irregular_chain<double, 3, 3>::make(), spatial(-2, -2, -2),
                           spatial(2, 2, 2), 200)}) {
    EXPECT_GT(seen.nothing, seen.all / 8);
    EXPECT_GT(seen.exact, seen.all / 50);
    EXPECT_GT(seen.all, 60);
  }
}

// A self-motion that settles: rates T (J^+ v + z N), of which the signs change where a brake comes to rest.
// The best over all z is the best of one z between each two such points. free: whether a joint has no brake.
template <class M, class Sample>
best over_self_motion(const M& mechanism, const ph::joint_vector<M>& q, const ph::task_vector<M>& v,
                      Sample&& sample) {
  const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, q));
  const Eigen::VectorXd least =
      Eigen::MatrixXd(J).completeOrthogonalDecomposition().solve(Eigen::VectorXd(v));
  const Eigen::MatrixXd N = Eigen::FullPivLU<Eigen::MatrixXd>(J).kernel();
  const ph::transmission_matrix<M> T = transmission_of(mechanism, q);
  const ph::brake_vector<M> a = T * least, b = T * N.col(0);
  std::vector<double> changes;
  for (int i = 0; i < M::brake_count; ++i) changes.push_back(-a[i] / b[i]);
  std::sort(changes.begin(), changes.end());
  std::vector<double> between = {changes.front() - 1, changes.back() + 1};
  for (std::size_t k = 1; k < changes.size(); ++k) between.push_back((changes[k - 1] + changes[k]) / 2);
  best all;
  for (const double z : between) {
    const best one = sample(ph::brake_vector<M>(a + z * b));
    all.angle = std::min(all.angle, one.angle);
    all.max_force = std::max(all.max_force, one.max_force);
  }
  return all;
}

TEST(displayable, of_a_self_motion_that_settles_is_the_best_over_it) {
  const auto planar =
      ph::serial_chain<double, 3, 2>(ph::planar_arm<double>(std::array<double, 3>{0.2, 0.2, 0.2}));
  const counts seen =
      compare(planar, {-2, -2, -2}, {2, 2, 2}, 400, 1e-6, [&](auto& q, auto& v, auto& n, auto& limit, auto&) {
        return over_self_motion(planar, q, v, [&](const ph::vector<double, 3>& w) {
          return by_forces_at(planar, q, w, n, limit);
        });
      });
  EXPECT_LT(seen.nothing, seen.all / 2);
  EXPECT_GT(seen.exact, 20);
}

// With a joint free, only forces along one line leave it without torque.
TEST(displayable, of_two_brakes_on_three_joints_is_along_one_line) {
  using arm = ph::serial_chain<double, 3, 2>;
  const ph::braked_joints<arm, 0, 2> settled(
      arm(ph::planar_arm<double>(std::array<double, 3>{0.2, 0.2, 0.2})));
  ph::testing::random_source random(5);
  int displayed = 0;
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 5, pose " << k);
    const auto q = random.between(ph::vector<double, 3>(-2, -2, -2), ph::vector<double, 3>(2, 2, 2));
    const ph::vector<double, 2> v = random.direction<double, 2>(), n = random.direction<double, 2>(),
                                limit(random.uniform(0.3, 2.0), random.uniform(0.3, 2.0));
    const ph::matrix<double, 2, 3> J = ph::jacobian(settled, q);
    const ph::vector<double, 2> line(-J(1, 1), J(0, 1));  // at right angles to what the free joint moves
    const auto along_line = [&](const ph::vector<double, 2>& w) {
      best all;
      for (const double side : {-1.0, 1.0}) {
        const ph::vector<double, 2> F = side * line;
        const ph::vector<double, 3> joints = J.transpose() * F;
        const ph::vector<double, 2> t(joints[0], joints[2]);
        if (t[0] * w[0] > 0 || t[1] * w[1] > 0) continue;
        all.look_at(ph::vector<double, 2>((limit.array() / t.array().abs()).minCoeff() * F), n);
      }
      return all;
    };
    const auto found = ph::displayable(settled, q, v, n, limit);
    expect_best(found, over_self_motion(settled, q, v, along_line), 1e-6);
    if (HasFatalFailure()) return;
    displayed += ph::is_displayed(found.display);
  }
  EXPECT_GT(displayed, 100);
}

}  // namespace
