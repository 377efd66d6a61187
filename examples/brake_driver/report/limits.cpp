#include <report/limits.hpp>

#include <catalogue/catalogue.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/driver/calibration/encoder_calibration.hpp>

#include <algorithm>
#include <cstdio>
#include <span>
#include <stdexcept>
#include <string_view>

namespace example {
namespace {

// A parameter of the law, or its default in velocity_direct_control.
double of_law(const configuration& c, std::string_view name, double otherwise) {
  ph::runtime::any_parameters law = c.device.law.parameters;
  for (const auto& f : law.fields())
    if (f.about.name == name) return *f.numbers();
  return otherwise;
}

// The wall at the home pose, approached at this speed [m/s].
ph::braked_wall wall_at_home(const configuration& c, double approach) {
  if (c.walls.empty())
    throw std::invalid_argument("walls = []: expected one or more for --limits, which is about the first");
  const spatial n = c.walls.front().gradient(c.mechanism.handle(c.home)),
                u = filled_up<spatial>(c.simulation.direction);
  const spatial along = u - n * n.dot(u);
  const spatial velocity = c.simulation.speed * along.stableNormalized() - approach * n;
  axis_numbers residual;
  for (std::size_t i = 0; i < c.curves.size(); ++i) residual.data()[i] = c.curves[i].residual_torque;
  const axis_numbers resolution = ph::encoder_calibration<max_axes>(c.encoders).resolution();
  const auto first = [](const auto& v, int count) {
    return std::span<const double>(v.data(), static_cast<std::size_t>(count));
  };
  const driven_mechanism& m = c.mechanism;
  const auto found = catalogue().braked_wall_at(m.of(), c.device.brakes,
                                                {.q = first(c.home, m.joints()),
                                                 .velocity = first(velocity, m.dimension()),
                                                 .normal = first(n, m.dimension()),
                                                 .residual_torque = first(residual, m.brakes()),
                                                 .resolution = first(resolution, m.encoders()),
                                                 .hand_mass = c.simulation.hand_mass});
  if (!found)
    throw std::invalid_argument("[mechanism] type = \"" + c.device.mechanism.name +
                                "\": expected one with inertia and no more joints than dimensions for "
                                "--limits");
  ph::braked_wall wall = *found;
  wall.push = c.simulation.push;
  wall.control_period = c.loop.period;
  wall.scene_period = std::max(c.loop.period, c.device.scene.period);
  const ph::velocity_direct_control_parameters usual;
  wall.reaction_time = of_law(c, "rate_lag", usual.rate_lag);
  wall.averaging_time = c.rates.window * c.loop.period + 2 * wall.reaction_time;
  wall.rest_depth = of_law(c, "rest_depth", usual.rest_depth);
  wall.depth_per_jump = of_law(c, "depth_per_jump", usual.depth_per_jump);
  return wall;
}

}  // namespace

void print_limits(const configuration& c) {
  const ph::braked_wall wall = wall_at_home(c, 0.1);
  std::printf(
      "The first wall at the home pose, the hand of [simulation]: %.2g kg, pushes with %.2g N\n"
      "brakes out of the wall  %.3g N, by force approximation %.3g N; without current %.2g N; rise %.3g ms\n"
      "device and hand         %.3g kg normal to it, %.2g mm a count\n"
      "least noticeable drift  %.2g mm/s off it or into it\n\n"
      "approach [m/s]  smallest depth [mm]  largest useful stiffness [N/m]\n",
      c.simulation.hand_mass, wall.push, wall.force, wall.approximated_force, wall.residual_force,
      1e3 * wall.time_constant, wall.inertia, 1e3 * wall.depth_resolution, 1e3 * limits_of(wall).drift);
  for (const double approach : {0.02, 0.05, 0.1, 0.2}) {
    const ph::wall_limits limits = limits_of(wall_at_home(c, approach));
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
      "it,\nwhich get half as deep again into it as into a rigid wall. Bands: docs/guide/design.md.\n");
}

}  // namespace example
