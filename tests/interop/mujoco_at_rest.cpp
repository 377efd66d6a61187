// The torques on brakes at rest, against those of the friction constraints of MuJoCo: planar arms of two and
// three joints, brakes on joints or on tendons, all at rest or some, with and without gravity.
#include <passive_haptics/brake/at_rest/hand_torque_at_rest.hpp>
#include <passive_haptics/interop/mujoco.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

namespace {

namespace ph = passive_haptics;

constexpr unsigned seed = 20040627;
constexpr double strong = 1e3;  // [N m]: a brake that holds

template <int N, int Brakes>
struct tendon_arm : ph::serial_chain_with_inertia<double, N, 2> {
  static constexpr int brake_count = Brakes;
  ph::matrix<double, Brakes, N> all_tendons;
  const ph::matrix<double, Brakes, N>& transmission() const { return all_tendons; }
};

// An arm of random links under this transmission, gravity or none.
template <int N, int Brakes>
tendon_arm<N, Brakes> random_arm(ph::testing::random_source& random,
                                 const ph::matrix<double, Brakes, N>& transmission, bool gravity) {
  ph::serial_chain_parameters<double, N, 2> geometry;
  ph::serial_chain_inertia<double, N, 2> inertia;
  inertia.handle_mass = 0;
  ph::vector<double, 2> at = ph::vector<double, 2>::Zero();
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double length = random.uniform(0.08, 0.2), mass = random.uniform(0.05, 0.4);
    const ph::vector<double, 2> end = at + ph::vector<double, 2>(length, 0);
    geometry.joints[k] = ph::revolute_joint<double>(at);
    inertia.links[k] = ph::uniform_rod<double, 2>(mass, at, end);
    inertia.rotor_inertia[i] = random.uniform(1e-5, 1e-4);
    at = end;
  }
  geometry.handle = at;
  if (gravity) inertia.gravity = {1, -9.81};
  return {{geometry, inertia}, transmission};
}

struct account {
  int brakes_at_rest = 0, static_sign_wrong = 0;
  double worst = 0;  // error of th, relative to all torques
};

// Random motions of random arms: some brakes at rest and held, the others slip.
template <int N, int Brakes>
account compare(const ph::matrix<double, Brakes, N>& transmission, bool gravity) {
  using joints = ph::vector<double, N>;
  using brakes = ph::vector<double, Brakes>;
  ph::testing::random_source random(seed);
  account seen;
  for (int k = 0; k < 10; ++k) {
    const auto chain = random_arm<N, Brakes>(random, transmission, gravity);
    const auto model = ph::detail::mujoco_load(ph::mujoco_model(chain, 0));
    const std::unique_ptr<mjData, ph::detail::mujoco_deleter> data(mj_makeData(model.get()));
    const ph::matrix<double, N, Brakes> Tt = ph::transposed(transmission);
    const ph::matrix<double, N, Brakes> inverse =
        ph::orthogonal_decomposition<double, Brakes, N>(transmission, 0).pseudo_inverse();
    for (int round = 0; round < 40; ++round) {
      const joints q = 2.5 * random.direction<double, N>();
      const ph::vector<double, 2> Fh = 5 * random.direction<double, 2>();
      // Which brakes are at rest: each set in turn but the empty one
      const int set = 1 + round % ((1 << Brakes) - 1);
      ph::vector<bool, Brakes> at_rest;
      brakes w, slipping = brakes::Zero();
      for (int i = 0; i < Brakes; ++i) {
        at_rest[i] = (set >> i & 1) != 0;
        w[i] = at_rest[i] ? 0 : random.wide(0.5, 3.0);
        const double friction = random.uniform(0.02, 0.4);
        if (!at_rest[i]) slipping[i] = -std::copysign(friction, w[i]);
        model->tendon_frictionloss[i] = at_rest[i] ? strong : friction;
      }
      // These rates of the brakes, any rates of what they leave free
      joints qd = 3 * random.direction<double, N>();
      qd += inverse * (w - transmission * qd);

      const ph::matrix<double, 2, N> J = chain.jacobian(q);
      const joints load_of_hand = J.transpose() * Fh;
      for (int i = 0; i < N; ++i) {
        data->qpos[i] = q[i];
        data->qvel[i] = qd[i];
        data->qfrc_applied[i] = load_of_hand[i];
      }
      mj_forward(model.get(), data.get());
      bool all_slip = true;
      brakes friction, softness;
      for (int i = 0; i < Brakes; ++i) {
        friction[i] = data->efc_force[i];
        softness[i] = at_rest[i] ? data->efc_R[i] * friction[i] : 0;
        if (!at_rest[i]) all_slip = all_slip && std::abs(friction[i] - slipping[i]) < 1e-9;
      }
      if (!all_slip) continue;

      // Its constraints are soft, wd = -R t: the library's are that much stiffer, by its function for wd = 0
      const joints drive = load_of_hand - chain.bias_torque(q, qd) + Tt * slipping;
      const auto M = chain.mass_matrix(q);
      const brakes th = ph::hand_torque_at_rest<double, N, Brakes>(M, Tt, drive, softness, at_rest);
      const double size = load_of_hand.norm() + chain.bias_torque(q, qd).norm() + slipping.norm();
      const brakes still = brakes(inverse.transpose() * load_of_hand);
      for (int i = 0; i < Brakes; ++i) {
        if (!at_rest[i]) continue;
        ++seen.brakes_at_rest;
        seen.worst = std::max(seen.worst, std::abs(th[i] + friction[i]) / size);
        seen.static_sign_wrong += (still[i] > 0) != (th[i] > 0);
      }
    }
  }
  return seen;
}

template <int N, int Brakes>
void expect_agreement(const char* name, const ph::matrix<double, Brakes, N>& transmission) {
  for (const bool gravity : {false, true}) {
    SCOPED_TRACE(name);
    const account seen = compare<N, Brakes>(transmission, gravity);
    EXPECT_LT(seen.worst, 1e-9);
    EXPECT_GT(seen.brakes_at_rest, 300);
    EXPECT_GT(seen.static_sign_wrong, 0);
    std::printf("%s%s: %d brakes at rest, worst error %.1e, static sign wrong in %.0f %%\n", name,
                gravity ? " under gravity" : "", seen.brakes_at_rest, seen.worst,
                100.0 * seen.static_sign_wrong / seen.brakes_at_rest);
  }
}

TEST(torques_on_brakes_at_rest, are_those_of_mujoco) {
  expect_agreement<2, 2>("2R, a brake a joint", ph::matrix<double, 2, 2>{{1, 0}, {0, 1}});
  expect_agreement<2, 1>("2R, one tendon", ph::matrix<double, 1, 2>{{0.7, 1.3}});
  expect_agreement<3, 3>("3R, tendons", ph::matrix<double, 3, 3>{{1, 0, 0}, {1, 0.8, 0}, {1, 0.8, -1.2}});
  expect_agreement<3, 2>("3R, two tendons", ph::matrix<double, 2, 3>{{1, 0.5, 0}, {0, 1, -0.7}});
}

}  // namespace
