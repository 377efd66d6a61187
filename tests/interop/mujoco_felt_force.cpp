// What a stiff hand feels of settled forces, against MuJoCo: planar arms of three and four
// joints, brakes as dry friction on the joints, a spring and a damper that lead the handle at a constant
// velocity.
#include "mujoco_model.hpp"

#include <experiments/felt_force.hpp>
#include <experiments/rods.hpp>

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>
#include <string>

namespace {

namespace ph = passive_haptics;
using experiments::felt_row;
using experiments::felt_state;

constexpr std::size_t states = 150;
constexpr double time_step = 1e-4;                // [s]
constexpr double stiffness = 2e4, damping = 150;  // of the hand [N/m], [N s/m]
constexpr double handle_mass = 0.1;               // [kg]

// The arm of planar_rods in MuJoCo, with friction on all joints.
template <std::size_t N>
std::string description(const std::array<double, N>& lengths) {
  std::ostringstream x;
  x.precision(17);
  x << "<mujoco><compiler angle='radian'/><option timestep='" << time_step
    << "' solver='Newton' iterations='100' tolerance='1e-12' gravity='0 0 0'/><worldbody>";
  double before = 0;
  for (const double length : lengths) {
    const double mass = 0.2 * length / 0.15, about = mass * length * length / 12;
    x << "<body pos='" << before << " 0 0'><joint type='hinge' axis='0 0 1' armature='5e-5' frictionloss='1' "
      << "solimpfriction='0.9999 0.9999 0.001' solreffriction='0.0004 1'/><inertial pos='" << length / 2
      << " 0 0' mass='" << mass << "' diaginertia='" << about << " " << about << " " << about << "'/>";
    before = length;
  }
  x << "<body name='handle' pos='" << before << " 0 0'><inertial pos='0 0 0' mass='" << handle_mass
    << "' diaginertia='1e-10 1e-10 1e-10'/></body>";
  for (std::size_t i = 0; i < N; ++i) x << "</body>";
  x << "</worldbody></mujoco>";
  return x.str();
}

// In MuJoCo: brake i is on joint i, the joints after the last brake are free.
template <class M>
class mujoco_arm {
 public:
  explicit mujoco_arm(const std::string& text)
      : model_(load(text)), data_(model_ ? mj_makeData(model_.get()) : nullptr) {}

  bool is_loaded() const { return data_ != nullptr; }

  experiments::felt<M> feel(const felt_state<M>& state, const ph::brake_vector<M>& capacity) const {
    mjData& d = *data_;
    mj_resetData(model_.get(), &d);
    const int handle = mj_name2id(model_.get(), mjOBJ_BODY, "handle");
    for (int i = 0; i < M::dof; ++i) {
      model_->dof_frictionloss[i] = i < M::brake_count ? capacity[i] : 0;
      d.qpos[i] = state.q[i];
      d.qvel[i] = state.qd[i];
    }
    mj_kinematics(model_.get(), &d);
    const ph::vector<double, 2> start = place(handle);
    const long steps = std::lround(experiments::felt_until / time_step),
               first = std::lround(experiments::felt_from / time_step);
    experiments::felt<M> result;
    ph::vector<double, 2> last = start - time_step * state.v;
    for (long k = 0; k < steps; ++k) {
      mj_kinematics(model_.get(), &d);
      const ph::vector<double, 2> x = place(handle), v = (x - last) / time_step,
                                  hand =
                                      stiffness * (start + static_cast<double>(k) * time_step * state.v - x) +
                                      damping * (state.v - v);
      last = x;
      d.xfrc_applied[6 * handle] = hand[0];
      d.xfrc_applied[6 * handle + 1] = hand[1];
      mj_step(model_.get(), &d);
      if (k == first)
        for (int i = 0; i < M::brake_count; ++i) result.rates[i] = d.qvel[i];
      if (k >= first) result.force -= hand.dot(state.n) / static_cast<double>(steps - first);
    }
    return result;
  }

 private:
  ph::vector<double, 2> place(int body) const { return {data_->xpos[3 * body], data_->xpos[3 * body + 1]}; }

  std::unique_ptr<mjModel, deleter> model_;
  std::unique_ptr<mjData, deleter> data_;
};

template <class M>
felt_row feel(const char* name, const mujoco_arm<M>& mujoco, const M& arm) {
  const felt_row row = experiments::feel_with(
      arm, states, [&](const felt_state<M>& state, const ph::brake_vector<M>& capacity) {
        return mujoco.feel(state, capacity);
      });
  std::printf("%-30s displayed %3.0f %%, median %5.2f N, within 10 %%: %3.0f %%; others %zu, %zu, %zu\n",
              name, 100 * row.displayed_share(), row.median, 100 * row.within_share(), row.unknown_sign,
              row.not_at_rest, row.pose);
  return row;
}

template <class M>
void expect_settled(const char* name, const std::string& text, const M& arm) {
  const mujoco_arm<M> mujoco(text);
  ASSERT_TRUE(mujoco.is_loaded());
  const felt_row settled = feel(name, mujoco, arm);
  EXPECT_NEAR(settled.median, 1, 0.02);
  EXPECT_GE(settled.within_share(), 0.85);
}

constexpr std::array three{0.15, 0.15, 0.1};
constexpr std::array four{0.12, 0.12, 0.1, 0.08};

TEST(mujoco_felt_force, three_joints) {
  expect_settled("3R", description(three), experiments::planar_rods(three));
}

TEST(mujoco_felt_force, three_joints_with_two_brakes) {
  expect_settled("3R, brakes 1 and 2", description(three),
                 experiments::with_brakes<0, 1>(experiments::planar_rods(three)));
}

TEST(mujoco_felt_force, four_joints) {
  expect_settled("4R", description(four), experiments::planar_rods(four));
}

}  // namespace
