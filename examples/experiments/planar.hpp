// The planar experiments of section 5: runs of a hand along a wall with a simulated device.
#pragma once

#include "laws.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace experiments {

namespace ph = passive_haptics;
using plane_vector = ph::vector<double, 2>;

// One of several shapes, chosen at run time.
template <class First, class... Others>
class one_of {
 public:
  static constexpr int dimension = First::dimension;
  template <class Shape>
  explicit one_of(Shape shape) : shape_(std::move(shape)) {}

  double distance(const ph::point<dimension>& x) const {
    return std::visit([&](const auto& s) { return s.distance(x); }, shape_);
  }
  ph::point<dimension> gradient(const ph::point<dimension>& x) const {
    return std::visit([&](const auto& s) { return s.gradient(x); }, shape_);
  }
  ph::matrix<double, dimension, dimension> hessian(const ph::point<dimension>& x) const {
    return std::visit([&](const auto& s) { return ph::surface_curvature(s, x); }, shape_);
  }

 private:
  std::variant<First, Others...> shape_;
};

using test_wall = one_of<ph::half_space<2>, ph::disc>;
test_wall planar_wall(double slant = 0);  // through (0, 0.225) m, free below, slanted by this angle [rad]
test_wall concave_wall();                 // inside the circle of 0.325 m about (0.11, -0.10) m
test_wall convex_wall();                  // outside the circle of 0.325 m about (0.11, 0.55) m

// y [m] of the point below the wall at x [m] with this distance [m], by Newton's method from inside the
// device's workspace.
inline double height_before(const test_wall& wall, double x, double distance = 0) {
  plane_vector at(x, 0.2);
  for (int k = 0; k < 50; ++k) at[1] += (wall.distance(at) - distance) / std::max(0.2, -wall.gradient(at)[1]);
  return at[1];
}

// The simulation that moves the device.
enum class simulation { own, mujoco };

// What a run varies; the defaults are those of the paper's device.
struct setup {
  double environment_rate = 1000;                     // of the virtual environment [Hz]
  double time_step = 1e-4;                            // of the simulation [s]
  double lag = 0.020;                                 // of the brakes [s]
  std::optional<double> believed_lag = std::nullopt;  // known to the controller, if different [s]
  double limit = 1;                                   // of the brakes, known to the controller [N m]
  double gain = 1;                                    // of the brakes, unknown to the controller [1]
  double residual = 0;                                // torque of a released brake [N m]
  double inertia = 1;                                 // of the model, relative to the device
  double noise = 0;                                   // of the force sensor [N]
  std::uint64_t seed = 1;                             // of that noise
  double gap = 0.004;                                 // distance from the wall at the start [m]
  double approach = 0.1;                              // speed into the wall at the start [m/s]
  ph::following_hand_parameters<double> hand = {};
  simulation plant = simulation::own;
};

// One line of a run's trace, every 5 ms.
struct instant {
  double time, depth, alpha;
  plane_vector position, rates, capacity, brake_torque, hand_force, brake_force;
};

struct run_result {
  ph::contact_metrics figures;
  ph::energy_balance energy;
  double min_alpha = 1;  // over the run, during contact
  std::vector<instant> trace;
};

run_result follow_with_arm(law which, const test_wall& wall, const setup& how);  // the tendon device
// The XY table of Fig. 4, under law::none or law::velocity.
run_result follow_with_table(law which, const test_wall& wall, const setup& how);

}  // namespace experiments
