#include <report/limits.hpp>

#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/driver/calibration/encoder_calibration.hpp>

#include <cstdio>

namespace example {
namespace {

// The wall as the handle meets it at home, approached at this speed [m/s].
template <class M>
ph::braked_wall wall_at_home(const M& mechanism, const configuration& c, double approach) {
  using V = ph::vector<double, 2>;
  const V n = c.first_normal(mechanism.position(c.home)),
          u(c.simulation.direction[0], c.simulation.direction[1]);
  const V along = u - n * n.dot(u);
  const V velocity = c.simulation.speed * along.stableNormalized() - approach * n;
  const V residual(c.curves[0].residual_torque, c.curves[1].residual_torque);
  ph::braked_wall wall =
      ph::braked_wall_at(mechanism, c.home, velocity, n, c.brakes, residual,
                         ph::encoder_calibration<axes>(c.encoders).resolution(), c.simulation.hand_mass);
  wall.push = c.simulation.push;
  wall.control_period = wall.scene_period = c.loop.period;
  wall.averaging_time =
      c.rates.window * c.loop.period + 2 * ph::velocity_direct_control_parameters().rate_lag;
  return wall;
}

template <class M>
void print(const M& mechanism, const configuration& c) {
  const ph::braked_wall wall = wall_at_home(mechanism, c, 0.1);
  std::printf(
      "The first wall at the home pose, the hand of [simulation]: %.2g kg, pushes with %.2g N\n"
      "brakes out of the wall  %.3g N, by force approximation %.3g N; without current %.2g N; rise %.3g ms\n"
      "device and hand         %.3g kg normal to it, %.2g mm a count\n"
      "least noticeable drift  %.2g mm/s off it or into it\n\n"
      "approach [m/s]  smallest depth [mm]  largest useful stiffness [N/m]\n",
      c.simulation.hand_mass, wall.push, wall.force, wall.approximated_force, wall.residual_force,
      1e3 * wall.time_constant, wall.inertia, 1e3 * wall.depth_resolution, 1e3 * limits_of(wall).drift);
  for (const double approach : {0.02, 0.05, 0.1, 0.2}) {
    const ph::wall_limits limits = limits_of(wall_at_home(mechanism, c, approach));
    if (limits.holds()) std::printf("%14g  %19.1f  ", approach, 1e3 * limits.depth);
    else std::printf("%14g  %19s  ", approach, "not held");
    std::printf("%30.2g\n", limits.stiffness);
  }
  if (limits_of(wall).pushed_out)
    std::printf(
        "\nWithout current the brakes hold the hand off: they push it out with %.2g N where it slides.\n",
        wall.sliding_residual);
  std::printf(
      "\nDepth: velocity_direct_control that sees the wall once it is touched. Stiffness: the laws that use "
      "it,\nwhich get half as deep again into it as into a rigid wall. Bands: docs/guide/wall_limits.md.\n");
}

}  // namespace

void print_limits(const configuration& c) {
  if (c.mechanism == "xy_table") print(ph::xy_table<double>(c.xy_table), c);
  else if (c.mechanism == "five_bar") print(ph::five_bar<double>(c.five_bar), c);
  else print(ph::tendon_two_link<double>(c.tendon_two_link), c);
}

}  // namespace example
