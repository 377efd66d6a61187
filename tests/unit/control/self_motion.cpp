// slow
// Arms with more joints than task dimensions keep their wall: random states that move into one.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>
#include <numbers>
#include <random>
#include <type_traits>

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
    state.time = 0;
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
    EXPECT_EQ(result.display, ph::display_class::none)
        << name << ": state " << k << " has no wall and says " << to_string(result.display);
  }
  const double share = static_cast<double>(without) / states;
  std::printf("%s: no wall in %.1f %% of %d states\n", name, 100 * share, states);
  return share;
}

}  // namespace

TEST(self_motion, that_settles_leaves_the_wall) {
  EXPECT_LT(share_without_wall("3R", planar_arm<3>(particle_brake)), 0.05);
  EXPECT_LT(share_without_wall("4R", planar_arm<4>(particle_brake)), 0.05);
}

// A narrower angle leaves fewer states with a force; brakes cut one by one make more.
TEST(self_motion, obeys_the_options_under_velocity_direct_control) {
  using M = arm<3>;
  std::mt19937_64 engine(20040627);
  std::normal_distribution<double> gauss;
  const ph::step_options<double> narrow(ph::approximation_parameters<double>{ph::radians(5.0)});
  const ph::step_options<double> each({}, ph::saturation::clamp_each);
  int cut_off = 0, displayed = 0, larger = 0;
  for (int k = 0; k < 200; ++k) {
    ph::device_state<M> state;
    state.time = 0;
    for (double& q : state.q) q = gauss(engine);
    for (double& qd : state.qd) qd = gauss(engine);
    ph::contacts<2, 1> touched;
    touched.push_back({.normal = ph::point<2>(gauss(engine), gauss(engine)).normalized(),
                       .depth = 5e-3,
                       .stiffness = 1000,
                       .sensed_at = planar_arm<3>(particle_brake).position(state.q)});
    const auto capacity = [&](const ph::step_options<double>& options) {
      ph::step_memory<ph::velocity_direct_control> memory;
      return ph::step(planar_arm<3>(particle_brake), ph::brakes_of<M>(), touched,
                      ph::velocity_direct_control(), state, memory, options)
          .capacity;
    };
    const ph::vector<double, 3> usual = capacity({}), more = capacity(each);
    EXPECT_TRUE((more.array() >= usual.array()).all() && (more.array() <= 1).all()) << k;
    larger += more != usual;
    const bool is_displayed = !usual.isZero(0), is_near = !capacity(narrow).isZero(0);
    EXPECT_TRUE(is_displayed || !is_near) << k;
    cut_off += is_displayed && !is_near;
    displayed += is_near;
  }
  EXPECT_GT(cut_off, 20);
  EXPECT_GT(displayed, 20);
  EXPECT_GT(larger, 5);
}

// On-off control displays what no_direct_control does.
TEST(self_motion, is_left_alone_by_a_relay_too) {
  using M = arm<3>;
  std::mt19937_64 engine(20040627);
  std::normal_distribution<double> gauss;
  int held = 0;
  for (int k = 0; k < 200; ++k) {
    ph::device_state<M> state;
    state.time = 0;
    for (double& q : state.q) q = gauss(engine);
    for (double& qd : state.qd) qd = gauss(engine);
    ph::contacts<2, 1> touched;
    touched.push_back({.normal = ph::point<2>(gauss(engine), gauss(engine)).normalized(),
                       .depth = 1,
                       .stiffness = 3,
                       .sensed_at = planar_arm<3>(particle_brake).position(state.q)});
    const auto torque = [&](const auto& law) {
      ph::step_memory<std::remove_cvref_t<decltype(law)>> memory;
      return ph::vector<double, 3>(
          ph::step(planar_arm<3>(particle_brake), ph::unlimited_brakes(), touched, law, state, memory)
              .torque);
    };
    const ph::vector<double, 3> plain = torque(ph::no_direct_control());
    EXPECT_LE((torque(ph::on_off_control()) - plain).norm(), 1e-12 * plain.norm()) << k;
    held += !plain.isZero(0);
  }
  EXPECT_GT(held, 140);
}

// A law whose torque is no number releases all brakes, also where no set of brakes displays anything.
struct broken_law {
  static constexpr bool commands_torques = true;
  template <class M, class E, int D, int N, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, E, B>&, const ph::contacts<D, N>&) const noexcept {
    return ph::brake_vector<M>::Constant(std::numeric_limits<double>::quiet_NaN());
  }
};

TEST(self_motion, of_a_law_without_numbers_is_a_fault) {
  using M = arm<3>;
  std::mt19937_64 engine(20040627);
  std::normal_distribution<double> gauss;
  for (int k = 0; k < 200; ++k) {
    ph::device_state<M> state;
    state.time = 0;
    for (double& q : state.q) q = gauss(engine);
    for (double& qd : state.qd) qd = gauss(engine);
    ph::contacts<2, 1> touched;
    touched.push_back(
        {.normal = ph::point<2>(gauss(engine), gauss(engine)).normalized(), .depth = 1, .stiffness = 3});
    ph::step_memory<broken_law> memory;
    const auto result =
        ph::step(planar_arm<3>(particle_brake), ph::brakes_of<M>(), touched, broken_law(), state, memory);
    ASSERT_EQ(result.outcome, ph::status::result_not_finite) << k;
    ASSERT_TRUE(result.capacity.isZero(0)) << k;
  }
}
