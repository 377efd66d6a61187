// slow, optimised
// The momentum observer: on paper, and against what a simulated device's sensor feels.
#include "../../property/chain_cases.hpp"
#include "../support.hpp"

#include <passive_haptics/control/sensorless/momentum_observer.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/encoder.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace {

constexpr double cycle = 1e-3, plant_step = 1e-4;

template <class M>
using sensorless = ph::sensorless_device_state<M>;

// ---- on paper

using table = ph::xy_table<double>;  // 0.5 kg each way

TEST(momentum_observer, sees_the_force_that_accelerates) {
  ph::momentum_observer<table> observer{table(), ph::brakes_of<table>(), {.gain = 100}};
  observer.update(sensorless<table>{0, {0, 0}, {0, 0}}, {0, 0});
  EXPECT_EQ(observer.estimate().force, Eigen::Vector2d::Zero());
  const auto& hand = observer.update(sensorless<table>{0.001, {0, 0}, {0.01, -0.02}}, {0, 0});
  const double fresh = 1 - 1.2 * std::exp(-0.2);  // 0.5 kg in 1 ms to 10 mm/s: 5 N
  EXPECT_NEAR(hand.force[0], 5 * fresh, 1e-12);
  EXPECT_NEAR(hand.force[1], -10 * fresh, 1e-12);
  EXPECT_EQ(hand.unknown_torque, Eigen::Vector2d::Zero());
  EXPECT_EQ(hand.generators, Eigen::Matrix2d::Identity());
}

// After a second at the rates v(k) against brakes of 10 N without lag that are commanded 4 N and 2 N.
template <class Rates>
ph::hand_force_estimate<table> after_a_second(const Rates& v) {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(10);
  brakes.time_constant.setZero();
  brakes.rate_dead_band.setConstant(0.02);
  ph::momentum_observer<table> observer{table(), brakes, {.gain = 100}};
  for (int k = 0; k <= 1000; ++k) observer.update(sensorless<table>{k * cycle, {0, 0}, v(k)}, {4, 2});
  return observer.estimate();
}

// Against 4 N without acceleration the hand must push with 4 N; the brake at rest hides up to 2 N.
TEST(momentum_observer, knows_what_slipping_brakes_make_and_what_stuck_ones_might) {
  const auto hand = after_a_second([](int) { return Eigen::Vector2d(3, 0); });
  EXPECT_NEAR(hand.force[0], 4, 1e-9);
  EXPECT_EQ(hand.force[1], 0);
  EXPECT_NEAR(hand.unknown_torque[0], 0, 1e-9);
  EXPECT_NEAR(hand.unknown_torque[1], 2, 1e-9);
  EXPECT_NEAR(hand.half_width({0, 1}), 2, 1e-9);
  EXPECT_NEAR(hand.half_width({1, 0}), 0, 1e-9);
  EXPECT_NEAR(hand.half_width(Eigen::Vector2d(1, 1).normalized()), std::sqrt(2.0), 1e-9);
}

// What brakes were commanded before the first state may be there.
TEST(momentum_observer, knows_of_no_brake_what_it_makes_at_first) {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(10);
  for (const double time : {0.0, 5.0}) {
    brakes.time_constant.setConstant(time / 100);
    ph::momentum_observer<table> observer{table(), brakes};
    EXPECT_EQ(observer.update(sensorless<table>{time, {0, 0}, {3, 0}}, {4, 2}).unknown_torque,
              Eigen::Vector2d(4, 2));
  }
}

TEST(momentum_observer, takes_a_brake_that_turned_round_or_slips_half_of_the_period_for_unknown) {
  const auto sign = [](int k) { return k % 2 == 0 ? 1.0 : -1.0; };
  const auto turning = after_a_second([&](int k) { return Eigen::Vector2d(sign(k), 0); });
  EXPECT_NEAR(turning.unknown_torque[0], 4, 1e-9);
  const auto creeping = after_a_second([&](int k) {
    const double v = k % 2 == 0 ? 0.03 : 0.01;
    return Eigen::Vector2d(v, -v);
  });
  EXPECT_NEAR(creeping.unknown_torque[0], 4, 1e-9);
  EXPECT_NEAR(creeping.unknown_torque[1], 2, 1e-9);
}

TEST(momentum_observer, starts_anew_after_faults_and_pauses) {
  ph::momentum_observer<table> observer{table(), ph::brakes_of<table>()};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto push = [&](double from) {
    for (int k = 0; k < 100; ++k)
      observer.update(sensorless<table>{from + k * cycle, {0, 0}, {k * 1e-3, 0}}, {0, 0});
    EXPECT_NEAR(observer.estimate().force[0], 0.5, 1e-3);
    EXPECT_EQ(observer.estimate().outcome, ph::status::ok);
  };
  const auto expect_none = [&](double time, double q, double capacity, ph::status outcome) {
    const auto& hand = observer.update(sensorless<table>{time, {0, q}, {0, 0}}, {0, capacity});
    EXPECT_EQ(hand.outcome, outcome);
    EXPECT_TRUE(hand.force.isZero(0));
  };
  push(0);
  expect_none(0.1, nan, 0, ph::status::state_not_finite);
  push(0.2);
  expect_none(1, 0, 0, ph::status::ok);  // 0.7 s later
  push(2);
  for (const double time : {1.0, 1.0})  // it goes back, and stands still
    expect_none(time, 0, 0, ph::status::time_not_rising);
  push(3);
  expect_none(3.1, 0, nan, ph::status::state_not_finite);
  push(3.2);
  EXPECT_FALSE(observer.joint_torques().isZero(0));
  observer.reset();
  EXPECT_TRUE(observer.estimate().force.isZero(0));
  EXPECT_TRUE(observer.joint_torques().isZero(0));
}

TEST(momentum_observer, starts_anew_in_the_cycle_after_a_fault_or_a_reset) {
  ph::momentum_observer<table> observer{table(), ph::brakes_of<table>()};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto push = [&](double time, double v) {
    return observer.update(sensorless<table>{time, {0, 0}, {v, 0}}, {0, 0}).force[0];
  };
  push(0, 0);
  EXPECT_GT(push(0.001, 0.01), 0);
  push(0.002, nan);
  EXPECT_EQ(push(0.003, 0.05), 0) << "nothing is known of the speed before";
  EXPECT_GT(push(0.004, 0.06), 0);
  observer.reset();
  EXPECT_EQ(push(0.005, 0.1), 0);
  EXPECT_GT(push(0.006, 0.11), 0);
}

// At rest and commanded 1 N m, or 0 after that, over periods in which the lagged strength changes by some
// roundings.
TEST(momentum_observer, takes_no_strength_for_negative_or_over_its_limit) {
  constexpr double at_once = 1e20;
  ph::brakes_of<table> brakes;
  brakes.time_constant.setConstant(0.02);
  for (int k = 1; k < 40; ++k) {
    for (int j = 1; j < 40; ++j) {
      ph::momentum_observer<table> observer{table(), brakes, {.gain = at_once}};
      observer.update(sensorless<table>{-5e-4 * k, {0, 0}, {0, 0}}, {0, 1});
      observer.update(sensorless<table>{0, {0, 0}, {0, 0}}, {1, 0});
      const auto& unknown =
          observer.update(sensorless<table>{1e-19 * j, {0, 0}, {0, 0}}, {1, 0}).unknown_torque;
      ASSERT_GE(unknown.minCoeff(), 0) << k << ", " << j;
      ASSERT_TRUE((unknown.array() <= brakes.torque_limit.array()).all()) << k << ", " << j;
    }
  }
}

TEST(momentum_observer, knows_no_force_at_a_singular_pose) {
  using arm = ph::two_link<double>;
  ph::momentum_observer<arm> observer{arm(), ph::brakes_of<arm>()};
  EXPECT_EQ(observer.update(sensorless<arm>{0, {0.3, 0}, {0, 0}}, {0, 0}).outcome,
            ph::status::singular_jacobian);
  EXPECT_TRUE(observer.estimate().force.isZero(0));
  observer.update(sensorless<arm>{0.001, {0.3, 0.5}, {0, 0}}, {0, 0});
  EXPECT_EQ(observer.update(sensorless<arm>{0.002, {0.3, 0.5}, {0, 1}}, {0, 0}).outcome, ph::status::ok);
  EXPECT_FALSE(observer.estimate().generators.isZero(0));
  EXPECT_FALSE(observer.estimate().force.isZero(0));
  observer.update(sensorless<arm>{0.003, {0.3, 0}, {0, 1}}, {0, 0});
  EXPECT_TRUE(observer.estimate().generators.isZero(0)) << "those of another pose";
  EXPECT_TRUE(observer.estimate().force.isZero(0)) << "of another pose";
}

// A table without a Jacobian at x > 1 and without a mass at y > 1.
struct torn_table : table {
  double hole(bool is_there) const { return is_there ? std::numeric_limits<double>::quiet_NaN() : 1.0; }
  ph::matrix<double, 2, 2> jacobian(const Eigen::Vector2d& q) const {
    return hole(q[0] > 1) * ph::matrix<double, 2, 2>::Identity();
  }
  ph::matrix<double, 2, 2> mass_matrix(const Eigen::Vector2d& q) const {
    return hole(q[1] > 1) * table::mass_matrix(q);
  }
};

TEST(momentum_observer, starts_anew_after_a_pose_that_is_undefined) {
  for (const Eigen::Vector2d& nowhere : {Eigen::Vector2d(2, 0), Eigen::Vector2d(0, 2)}) {
    ph::momentum_observer<torn_table> observer{torn_table(), ph::brakes_of<torn_table>()};
    const auto push = [&](double time, const Eigen::Vector2d& q, double v) {
      return observer.update(sensorless<torn_table>{time, q, {v, 0}}, {0, 0});
    };
    push(0, {0, 0}, 0);
    EXPECT_GT(push(0.001, {0, 0}, 0.01).force[0], 0);
    const auto there = push(0.002, nowhere, 0.02);
    EXPECT_EQ(there.outcome, ph::status::pose_undefined);
    EXPECT_TRUE(there.force.isZero(0));
    push(0.003, {0, 0}, 0.03);
    EXPECT_GT(push(0.004, {0, 0}, 0.04).force[0], 0);
  }
}

TEST(momentum_observer, complains_of_its_gain) {
  EXPECT_EQ(validate(ph::momentum_observer_parameters{}), "");
  EXPECT_EQ(validate(ph::momentum_observer_parameters{.gain = 0}),
            "gain [1/s] = 0: expected a finite number > 0");
  EXPECT_THROW((ph::momentum_observer<table>{table(), {}, {.gain = -1}}), std::invalid_argument);
}

// ---- against the simulated device

// What an observer should see: the joint torques of the true force, with two lags of 1 / (2 K), from 0.
template <class M>
struct lagged {
  ph::joint_vector<M> once = ph::joint_vector<M>::Zero(), torque = ph::joint_vector<M>::Zero();
  void add(const ph::joint_vector<M>& tau, double gain) {
    const double fresh = -std::expm1(-2 * gain * plant_step);
    torque += fresh * (once - torque);
    once += fresh * (tau - once);
  }
};

struct errors {
  double worst = 0, size = 0, over_bound = 0, stuck_share = 0;
};

// A hand that pushes about on a device whose brakes are commanded `capacity`.
template <class M, class Capacity>
errors push_about(const M& arm, const ph::joint_vector<M>& q, double force, unsigned seed,
                  Capacity&& capacity) {
  constexpr int d = M::task_dimension;
  ph::testing::random_source random(seed);
  ph::brakes_of<M> brakes;
  brakes.rate_dead_band.setConstant(0.005);
  ph::simulated_device<M> device(arm, brakes, 0.5, q);
  const ph::momentum_observer_parameters p{.gain = 100};
  ph::momentum_observer<M> observer(arm, brakes, p);
  const ph::vector<double, d> direction = random.direction<double, d>();
  const double turn = random.uniform(5.0, 15.0), phase = random.uniform(0.0, 6.0);
  lagged<M> truth;
  errors found;
  ph::brake_vector<M> commanded = ph::brake_vector<M>::Zero();
  int samples = 0;
  for (int k = 0; k < 10000; ++k) {
    if (k % 10 == 0) {
      const auto& hand = observer.update(sensorless<M>{k * plant_step, device.q(), device.qd()}, commanded);
      EXPECT_EQ(hand.outcome, ph::status::ok);
      // r + T^T t = the lagged torque, so t = T^-T (lagged - r)
      ph::matrix<double, M::brake_count, M::dof> A = ph::matrix<double, M::brake_count, M::dof>::Identity();
      if constexpr (ph::detail::has_exact_transmission<M>)
        A = ph::matrix<double, M::brake_count, M::dof>(ph::transmission(arm, device.q()));
      const ph::joint_vector<M> off = truth.torque - observer.joint_torques();
      const ph::brake_vector<M> missing = A.transpose().inverse() * off;
      found.worst = std::max(found.worst, off.norm());
      found.size = std::max(found.size, truth.torque.norm());
      found.over_bound = std::max(found.over_bound, (missing.cwiseAbs() - hand.unknown_torque).maxCoeff());
      found.stuck_share += (hand.unknown_torque.array() > 1e-3).any() ? 1 : 0;
      ++samples;
      commanded = capacity(k * plant_step);
    }
    const ph::vector<double, d> wish =
        force * std::sin(turn * k * plant_step + phase) * direction - 3.0 * device.velocity();
    const ph::matrix<double, d, M::dof> J(ph::jacobian(arm, device.q()));
    device.advance(plant_step, commanded, wish);
    truth.add(J.transpose() * device.sensed_force(), p.gain);
  }
  found.stuck_share /= samples;
  return found;
}

using tendon = ph::tendon_two_link<double>;
using chain_in_space = chains::irregular_chain<double, 3, 3>;

TEST(momentum_observer_simulated, follows_a_free_hand_with_its_lag) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE(seed);
    for (const errors& e :
         {push_about(tendon(), {1.0, 1.2}, 3, seed, [](double) { return Eigen::Vector2d(0, 0); }),
          push_about(chain_in_space::make(), {0.5, 0.1, 0.7}, 3, seed,
                     [](double) { return Eigen::Vector3d(0, 0, 0); })}) {
      EXPECT_LE(e.worst, 0.02 * e.size);
      EXPECT_LE(e.stuck_share, 0);
    }
  }
}

// Brakes so weak that the hand mostly moves them: known torques while they slip.
TEST(momentum_observer_simulated, bounds_what_slipping_and_sticking_brakes_hide) {
  double least = 1, most = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    for (const double strength : {0.02, 0.1, 0.4}) {
      const auto commanded = [&](double time) -> Eigen::Vector2d {
        return strength * Eigen::Vector2d(1 + std::sin(20 * time), 1 + std::cos(13 * time));
      };
      const errors e = push_about(tendon(), {1.0, 1.2}, 3, seed, commanded);
      EXPECT_LE(e.over_bound, 0.02 * e.size) << "strength " << strength;
      least = std::min(least, e.stuck_share);
      most = std::max(most, e.stuck_share);
    }
  }
  EXPECT_LT(least, 0.7);
  EXPECT_GT(most, 0.99);
}

// A hand that turns both joints at constant rates against capacity(time), with the readings sense(q, qd).
// check(observer, lagged torque, lagged force) in each cycle once it has settled.
template <class Sense, class Capacity, class Check>
void turn_steadily(Sense&& sense, Capacity&& capacity, Check&& check) {
  const tendon arm;
  const ph::brakes_of<tendon> brakes;
  ph::simulated_device<tendon> device(arm, brakes, 0.5, {0.2, 1.2});
  ph::momentum_observer<tendon> observer(arm, brakes);
  lagged<tendon> truth;
  Eigen::Vector2d commanded(0, 0);
  for (int k = 0; k < 10000; ++k) {
    const double time = k * plant_step;
    const Eigen::Matrix2d Jt = ph::jacobian(arm, device.q()).transpose();
    if (k % 10 == 0) {
      const auto [q, qd] = sense(device.q(), device.qd());
      observer.update(sensorless<tendon>{time, q, qd}, commanded);
      if (k > 3000) check(observer, truth.torque, Eigen::Vector2d(Jt.inverse() * truth.torque));
      commanded = capacity(time);
    }
    device.advance(plant_step, commanded, Jt.inverse() * (2 * (Eigen::Vector2d(0.5, 0.5) - device.qd())));
    truth.add(Jt * device.sensed_force(), 100);
  }
}

// Against slipping brakes it is known as well as a free one.
TEST(momentum_observer_simulated, knows_a_hand_that_drags_slipping_brakes) {
  turn_steadily([](const auto& q, const auto& qd) { return std::pair(q, qd); },
                [](double time) { return Eigen::Vector2d(0.05 + 0.03 * std::sin(30 * time), 0.1); },
                [](const auto& observer, const Eigen::Vector2d& torque, const Eigen::Vector2d& force) {
                  const auto& hand = observer.estimate();
                  ASSERT_LE(hand.unknown_torque.norm(), 1e-3);
                  ASSERT_LE((torque - observer.joint_torques()).norm(), 0.02 * torque.norm());
                  ASSERT_LE((force - hand.force).norm(), 0.02 * force.norm());
                });
}

// A free handle read by encoders of 8192 counts a turn: all that is off is noise.
TEST(momentum_observer_simulated, passes_little_of_the_noise_of_encoders) {
  ph::joint_encoders<tendon> encoders(tendon(), ph::encoder_parameters(), cycle);
  double sum = 0;
  int samples = 0;
  turn_steadily(
      [&](const auto& q, const auto& qd) {
        encoders.read(q, qd);
        return std::pair(encoders.q(), encoders.qd());
      },
      [](double) { return Eigen::Vector2d(0, 0); },
      [&](const auto& observer, const Eigen::Vector2d&, const Eigen::Vector2d& force) {
        sum += (observer.estimate().force - force).squaredNorm();
        ++samples;
      });
  EXPECT_LT(std::sqrt(sum / samples), 0.1);
}

}  // namespace
