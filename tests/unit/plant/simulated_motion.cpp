// slow
// The simulated device in motion: the energy that it keeps, what its sensor feels, what its brakes do.
#include "../../property/chain_cases.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>

namespace ph = passive_haptics;

namespace {

// Brakes of 1 N m that follow their command at once.
template <class M>
ph::brakes_of<M> ready_brakes() {
  ph::brakes_of<M> brakes;
  brakes.time_constant.setZero();
  brakes.torque_limit.setOnes();
  return brakes;
}

// The links' own accelerations and the hand's: kinetic energy changes by the error of the integrator alone,
// which halves with the step.
TEST(simulated_motion, keeps_its_kinetic_energy_to_first_order) {
  using M = ph::tendon_two_link<double>;
  const auto drift = [](double dt) {
    const double hand_mass = 0.3;
    ph::simulated_device<M> device(M(), ready_brakes<M>(), hand_mass, {2, -1.2});
    device.set_motion({2, -1.2}, {3, -4});
    const auto energy = [&] {
      const ph::vector<double, 2> v = device.velocity();
      return (device.qd().dot(device.mechanism().mass_matrix(device.q()) * device.qd()) +
              hand_mass * v.dot(v)) /
             2;
    };
    const double before = energy();
    for (int k = 0; k < std::lround(0.1 / dt); ++k) device.advance(dt, {0, 0}, {0, 0});
    return (energy() - before) / before;
  };
  const double coarse = drift(4e-4), middle = drift(2e-4), fine = drift(1e-4);
  EXPECT_LT(std::abs(coarse), 0.02);
  EXPECT_NEAR(coarse / middle, 2, 0.1);
  EXPECT_NEAR(middle / fine, 2, 0.05);
}

// The muscle's work ends up as kinetic energy.
TEST(simulated_motion, gains_the_work_of_the_hand) {
  using M = ph::tendon_two_link<double>;
  const double hand_mass = 0.3, dt = 5e-5;
  ph::simulated_device<M> device(M(), ready_brakes<M>(), hand_mass, {2, -1.2});
  const ph::vector<double, 2> F(0.4, -0.3), start = device.position();
  for (int k = 0; k < 4000; ++k) device.advance(dt, {0, 0}, F);
  const ph::vector<double, 2> v = device.velocity();
  const double energy =
      (device.qd().dot(device.mechanism().mass_matrix(device.q()) * device.qd()) + hand_mass * v.dot(v)) / 2;
  EXPECT_GT(energy, 1e-3);
  EXPECT_NEAR(F.dot(device.position() - start) / energy, 1, 5e-3);
}

// A hand that only holds on: what it does to the handle is what its mass resists with, -m a.
TEST(simulated_motion, sensor_feels_the_hands_mass_on_a_curved_path) {
  using M = ph::tendon_two_link<double>;
  const double hand_mass = 0.3, dt = 1e-5;
  ph::simulated_device<M> device(M(), ready_brakes<M>(), hand_mass, {2, -1.2});
  device.set_motion({2, -1.2}, {3, -4});
  for (int k = 0; k < 100; ++k) {
    const ph::vector<double, 2> before = device.velocity();
    device.advance(dt, {0, 0}, {0, 0});
    const ph::vector<double, 2> acceleration = (device.velocity() - before) / dt;
    EXPECT_GT(acceleration.norm(), 0.1);
    EXPECT_LE((device.sensed_force() + hand_mass * acceleration).norm(),
              0.01 * hand_mass * acceleration.norm());
  }
}

// J M^-1 J^T F = J M^-1 T^T t without the hand's mass, for n = d and n > d; and where the handle is.
template <class M>
void expect_brake_force(const M& mechanism, const ph::joint_vector<M>& q, double rounding) {
  ph::simulated_device<M> device(mechanism, ready_brakes<M>(), 0.3, q);
  device.set_motion(q, ph::joint_vector<M>::Constant(2));
  for (int k = 0; k < 100; ++k) {
    device.advance(1e-4, ph::brake_vector<M>::Constant(0.2), ph::task_vector<M>::Zero());
    EXPECT_LE((device.position() - mechanism.position(device.q())).norm(), 1e-15) << k;
    const ph::jacobian_matrix<M> J(ph::jacobian(mechanism, device.q()));
    const ph::joint_vector<M> tau =
        ph::transposed_transmission(mechanism, device.q()) * device.brake_torque();
    const auto inverse_mass = mechanism.mass_matrix(device.q()).inverse().eval();
    const ph::task_vector<M> by_torques = J * inverse_mass * tau,
                             by_force = J * inverse_mass * J.transpose() * device.brake_force();
    EXPECT_GT(by_torques.norm(), 1e-3) << k;
    EXPECT_LE((by_force - by_torques).norm(), rounding * by_torques.norm()) << k;
  }
}

TEST(brake_force, does_to_the_handle_what_the_brakes_do) {
  expect_brake_force(ph::tendon_two_link<double>(), {2, -1.2}, 1e-12);
  expect_brake_force(chains::irregular_chain<double, 4, 2>::make(), {0.3, -0.7, 1.1, 0.5}, 1e-11);
}

}  // namespace
