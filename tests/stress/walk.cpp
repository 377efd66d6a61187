// A device carried about for a long time: pose, rates, hand and walls wander, jump now and then, and every
// cycle is checked. Full length, 1e8 cycles of the tendon device: PASSIVE_HAPTICS_STRESS=full.
#include "broken_law.hpp"
#include "devices.hpp"
#include "effort.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace stress {

// A scene whose contacts are given.
template <int D>
struct told_scene {
  static constexpr int dimension = D;
  using contacts_type = ph::contacts<D, 2>;
  contacts_type touched;
};
template <int D>
ph::contacts<D, 2> sense(const told_scene<D>& scene, const ph::point<D>&) {
  return scene.touched;
}

// What wanders, all by steps of some thousandth of its range.
template <class M>
class wanderer {
 public:
  using T = typename M::scalar;
  static constexpr int d = M::task_dimension;

  wanderer(const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper, std::uint64_t seed)
      : lower_(lower), upper_(upper), random_(seed) {
    jump();
  }

  void walk(ph::device_state<M>& state, ph::contacts<d, 2>& touched) {
    const unsigned dice = static_cast<unsigned>(random_.uniform(0.0, 1024.0));
    if (dice == 0) jump();
    for (int i = 0; i < M::dof; ++i) {
      q_[i] = bounced(q_[i] + step(upper_[i] - lower_[i]), lower_[i], upper_[i]);
      qd_[i] = bounced(qd_[i] + step(T(2)), T(-1), T(1));
    }
    for (int k = 0; k < d; ++k) hand_[k] = bounced(hand_[k] + step(T(20)), T(-10), T(10));
    turn_ += 1e-3 * random_.uniform(-1.0, 1.0);
    depth_ = bounced(depth_ + 1e-5 * random_.uniform(-1.0, 1.0), -1e-3, 1e-2);
    state.q = q_;
    state.qd = qd_;
    state.hand_force = hand_;
    if (dice == 1) state.qd[0] = T(0.02);  // the dead band
    if (dice == 2) state.qd.setZero();
    if (dice == 3) state.hand_force.setZero();
    if (dice == 4) state.q.setZero();  // straight
    touched = {};
    if (depth_ > 0) touched.push_back(wall(0, turn_, depth_));
    if (dice < 100 && depth_ > 0) touched.push_back(wall(1, other_, 0.1 * depth_));
  }

 private:
  T step(T range) { return T(1e-3) * range * random_.uniform(T(-1), T(1)); }
  template <class X>
  static X bounced(X x, X low, X high) {
    return x < low ? low + (low - x) : (x > high ? high - (x - high) : x);
  }

  void jump() {
    q_ = random_.template between<T, M::dof>(lower_, upper_);
    for (int i = 0; i < M::dof; ++i) qd_[i] = random_.uniform(T(-1), T(1));
    hand_ = random_.positive(T(1e-6), T(10)) * random_.template direction<T, d>();
    turn_ = random_.uniform(0.0, 2 * std::numbers::pi);
    other_ = random_.coin() ? turn_ + std::numbers::pi : random_.uniform(0.0, 2 * std::numbers::pi);
    stiffness_ = random_.positive(1e-2, 1e9);
    depth_ = random_.uniform(-1e-3, 1e-2);
  }

  ph::contact<d> wall(int number, double angle, double depth) const {
    ph::point<d> normal = ph::point<d>::Zero();
    normal[0] = std::cos(angle);
    normal[d - 1] = std::sin(angle);
    return {.normal = normal, .depth = depth, .stiffness = stiffness_, .wall_number = number};
  }

  ph::joint_vector<M> lower_, upper_, q_, qd_;
  ph::task_vector<M> hand_;
  double turn_ = 0, other_ = 0, depth_ = 0, stiffness_ = 0;
  ph::testing::random_source random_;
};

// Legs of a million cycles, each from its own seed, so that any can be repeated alone; the controller goes
// on.
TEST(walk, of_the_tendon_device) {
  using device = device_case<ph::tendon_two_link<double>>;
  using M = device::mechanism;
  const std::uint64_t cycles = effort(100000, 100000000);
  constexpr std::uint64_t leg = 1000000;
  const M mechanism = device::make();
  const ph::brakes_of<M> brakes;
  ph::controller control(mechanism, brakes, told_scene<M::task_dimension>{}, ph::direct_control());
  std::uint64_t seed = first_seed(), working = 0, limited = 0, faults = 0;
  ph::device_state<M> state;
  for (std::uint64_t done = 0; done < cycles; ++seed) {
    wanderer<M> way(device::lower(), device::upper(), seed);
    for (std::uint64_t k = 0; k < leg && done < cycles; ++k, ++done) {
      auto& touched = control.scene().touched;
      way.walk(state, touched);
      state.time = 1e-3 * static_cast<double>(done);
      const ph::step_result<M> result = control(state);
      working += !result.capacity.isZero(0);
      limited += result.saturated;
      faults += result.outcome != ph::status::ok;
      if (const char* law = broken_law(mechanism, brakes, state, touched.size(), result)) {
        FAIL() << law << ", but not in cycle " << k << " of PASSIVE_HAPTICS_STRESS_SEED=" << seed << ": q "
               << state.q.transpose() << ", qd " << state.qd.transpose() << ", torque "
               << result.torque.transpose() << ", capacity " << result.capacity.transpose()
               << ", control force " << result.control_force.transpose();
      }
    }
  }
  EXPECT_GT(working, cycles / 4);
  EXPECT_GT(limited, 0u);
  EXPECT_LT(faults, cycles / 4);
}

}  // namespace stress
