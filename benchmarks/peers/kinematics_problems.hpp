// Problem: the handle's position and its Jacobian, of a spatial arm with six revolute joints.
#pragma once

#include "comparison.hpp"

#include <passive_haptics/mechanism/chains/denavit_hartenberg.hpp>
#include <passive_haptics/mechanism/chains/serial_chain.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace peers {

namespace ph = passive_haptics;

// UR5, lengths in m. Source: Universal Robots, DH parameters for calculations of kinematics and dynamics.
inline std::array<ph::dh_joint<double>, 6> arm_table() {
  constexpr double right = std::numbers::pi / 2;
  const auto joint = [](double length, double twist, double offset) {
    return ph::dh_joint<double>{ph::joint_kind::revolute, length, twist, offset, 0};
  };
  return {joint(0, right, 0.089159), joint(-0.425, 0, 0),       joint(-0.39225, 0, 0),
          joint(0, right, 0.10915),  joint(0, -right, 0.09465), joint(0, 0, 0.0823)};
}

using arm_pose = ph::vector<double, 6>;

inline std::vector<arm_pose> arm_poses() {
  ph::testing::random_source random(seed);
  std::vector<arm_pose> all(16384);
  for (arm_pose& q : all)
    q = random.between<double, 6>(arm_pose::Constant(-std::numbers::pi),
                                  arm_pose::Constant(std::numbers::pi));
  return all;
}

// A solver has `solve(q)`, whose results stay in it (timed), and from these `handle()` [m] and `jacobian()`
// [m/rad].
template <class Solver>
bool add_kinematics_solver(const std::string& name) {
  const auto check = []() -> errors {
    constexpr double tolerance = 1e-12;
    const ph::serial_chain<double, 6, 3> arm(ph::from_denavit_hartenberg(arm_table()));
    Solver solver;
    double worst = 0;
    for (const arm_pose& q : arm_poses()) {
      solver.solve(q);
      const double off =
          std::max((solver.handle() - arm.position(q)).norm(), (solver.jacobian() - arm.jacobian(q)).norm());
      worst = std::max(worst, off);
      if (off <= tolerance) continue;
      std::ostringstream error;
      error << "seed " << seed << ", q = " << q.transpose() << " rad: handle or Jacobian differ by " << off
            << " from the library's: expected at most " << tolerance << ". Is it the same chain?";
      throw std::runtime_error(error.str());
    }
    return {{"difference", worst}};
  };
  const auto run = [](benchmark::State& state) {
    const std::vector<arm_pose> poses = arm_poses();
    Solver solver;
    Solver* const kept = &solver;
    benchmark::DoNotOptimize(kept);
    while (state.KeepRunningBatch(benchmark::IterationCount(poses.size()))) {
      for (const arm_pose& q : poses) {
        solver.solve(q);
        benchmark::ClobberMemory();  // its results count as read
      }
    }
  };
  rows().push_back({"position and Jacobian of a 6R arm", name, check, run});
  return true;
}

}  // namespace peers
