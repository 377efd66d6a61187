// Arms with more joints than task dimensions keep their wall: random states that move into one.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/extensions/generator_form.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <random>

namespace ph = passive_haptics;

namespace {

template <int N>
using arm = ph::serial_chain_with_inertia<double, N, 2>;

constexpr double particle_brake = 1e-3;  // rotor of one of a few N m [kg m^2]

// Links of 0.15 m and 0.2 kg.
template <int N>
arm<N> planar_arm(double rotor_inertia) {
  std::array<double, N> lengths;
  lengths.fill(0.15);
  ph::serial_chain_inertia<double, N, 2> inertia;
  for (int i = 0; i < N; ++i)
    inertia.links[std::size_t(i)] = ph::uniform_rod<double, 2>(0.2, {0.15 * i, 0}, {0.15 * (i + 1), 0});
  inertia.rotor_inertia.setConstant(rotor_inertia);
  inertia.handle_mass = 0.1;
  return arm<N>(ph::planar_arm<double>(lengths), inertia);
}

// Share of states moving into a wall, the hand pushing at will, in which no brake is told to hold.
template <class M>
double share_without_wall(const char* name, const M& mechanism) {
  std::mt19937_64 engine(20040627);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  std::normal_distribution<double> gauss;
  const int states = 5000;
  int without = 0;
  for (int k = 0; k < states; ++k) {
    ph::device_state<M> state;
    for (double& q : state.q) q = angle(engine);
    for (double& qd : state.qd) qd = gauss(engine);
    for (double& f : state.hand_force) f = gauss(engine);
    const double heading = angle(engine);
    ph::point<2> n(std::cos(heading), std::sin(heading));
    const ph::task_vector<M> v = ph::jacobian(mechanism, state.q) * state.qd;
    if (n.dot(v) > 0) n = -n;
    const ph::point<2> x = mechanism.position(state.q);
    ph::controller control(mechanism, ph::brakes_of<M>(),
                           ph::scene(ph::wall(ph::half_space<2>(x + 1e-4 * n, n))), ph::direct_control());
    const auto result = control(state);
    EXPECT_EQ(result.outcome, ph::status::ok);
    if (!result.capacity.isZero(0)) continue;
    ++without;
    bool empty = false;  // no force at all, of brakes that leave the self-motion alone
    if constexpr (!ph::has_inertial_forces<M>)
      empty = ph::cone_is_zero(ph::brake_jacobian(mechanism, state.q), result.signs);
    EXPECT_EQ(result.display, empty ? ph::display_class::empty_cone : ph::display_class::none)
        << name << ": state " << k << " has no wall and says " << to_string(result.display);
  }
  const double share = static_cast<double>(without) / states;
  std::printf("%s: no wall in %.1f %% of %d states\n", name, 100 * share, states);
  return share;
}

}  // namespace

TEST(self_motion, of_arms_with_inertia_leaves_the_wall) {
  EXPECT_LT(share_without_wall("3R", planar_arm<3>(particle_brake)), 0.05);
  EXPECT_LT(share_without_wall("4R", planar_arm<4>(particle_brake)), 0.05);
  // What lighter rotors leave to the links, nobody's torques can undo
  EXPECT_LT(share_without_wall("3R, without rotors", planar_arm<3>(0)), 0.08);
  EXPECT_LT(share_without_wall("4R, without rotors", planar_arm<4>(0)), 0.05);
}

TEST(self_motion, left_alone_costs_the_wall_and_says_so) {
  EXPECT_GT(share_without_wall("3R, kinetostatic", ph::kinetostatic(planar_arm<3>(particle_brake))), 0.25);
  EXPECT_GT(share_without_wall("4R, kinetostatic", ph::kinetostatic(planar_arm<4>(particle_brake))), 0.5);
}
