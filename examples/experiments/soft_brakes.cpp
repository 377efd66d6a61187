#include "soft_brakes.hpp"

#include "batch.hpp"
#include "markdown.hpp"
#include "random_plane.hpp"

#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace experiments {

namespace {

using tendon = ph::tendon_two_link<double>;
using brake = ph::presliding_brake<ph::coulomb_brake<double>>;
using device_here = ph::random_device<tendon>;

constexpr std::size_t count = 60;
const ph::workspace<tendon> where{{-3.1, -2.5}, {3.1, -0.6}, 0.1};

struct brake_row {
  double presliding, residual;  // [rad], [N m]
};
constexpr std::array<brake_row, 7> rows{
    {{0, 0}, {0.001, 0}, {0.003, 0}, {0.010, 0}, {0, 0.02}, {0, 0.05}, {0, 0.1}}};

struct outcome {
  ph::contact_metrics figures;
  bool held;      // its residual torque keeps the hand off the wall
  double pushed;  // the same according to the calculator, share of the path
};

// Share of the path on which the residual torques push out a sliding hand.
double pushed_out_share(const device_here& d, double residual) {
  constexpr int places = 40;
  const tendon real = tendon_of(d.inertia);
  using V = ph::vector<double, 2>;
  V q = d.plane.q;
  int pushed = 0;
  for (int i = 0; i < places; ++i) {
    ph::reach(real, where, V(d.plane.surface + (i + 0.5) / places * where.path_length * d.plane.direction),
              q);
    ph::braked_wall wall =
        ph::braked_wall_at(real, q, V(d.hand.speed * d.plane.direction), d.plane.normal, d.known_brakes,
                           V(V::Constant(residual)), V(V::Constant(d.run.encoder_resolution)), d.hand.mass);
    wall.push = d.hand.push + d.hand.normal_stiffness * d.hand.target_depth;
    pushed += limits_of(wall).pushed_out;
  }
  return static_cast<double>(pushed) / places;
}

outcome follow_one(const brake_row& row, std::uint64_t seed, std::size_t number) {
  ph::device_ranges ranges;
  ranges.residual_torque = {row.residual, row.residual};
  const device_here d = ph::draw_device(tendon_of(1), where, seed, number, ranges);
  ph::brake_models_of<tendon, brake> brakes;
  for (std::size_t i = 0; i < brakes.size(); ++i) {
    brakes[i].model = d.brakes[i];
    brakes[i].presliding = row.presliding;
  }
  const tendon real = tendon_of(d.inertia);
  return {follow_plane<tendon>(real, brakes, d, velocity_control(tendon_of(1), d.known_brakes, d)),
          is_held(real, brakes, d), pushed_out_share(d, row.residual)};
}

}  // namespace

std::string soft_brakes(std::uint64_t seed) {
  const auto outcomes = on_all_cores("soft brakes", rows.size() * count, [&](std::size_t k) {
    return follow_one(rows[k / count], seed, k % count);
  });
  std::string table =
      markdown_head({"presliding [mrad]", "residual torque [N m]", "arrived", "over 50 mm deep", "time over",
                     "held by residual torque", "pushed out on a quarter of the way", "of these held",
                     "separating", "never touching", "over 10 mm deep", "median deviation [mm]"});
  for (std::size_t j = 0; j < rows.size(); ++j) {
    std::array<int, 3> ends{};  // arrived, too deep, time over
    int held = 0, pushed = 0, both = 0, separating = 0, never = 0, deep = 0;
    std::vector<double> spread;
    for (std::size_t k = j * count; k < (j + 1) * count; ++k) {
      const auto& [figures, is_held, share] = outcomes[k];
      ends[0] += figures.end == ph::run_end::arrived;
      ends[1] += figures.end == ph::run_end::too_deep;
      ends[2] += figures.end == ph::run_end::time_over;
      const bool is_pushed = share >= 0.25;
      pushed += is_pushed;
      both += is_pushed && is_held;
      held += is_held;
      if (is_held) continue;
      separating += figures.separates();
      never += figures.never_touches();
      deep += figures.is_deep();
      if (!figures.is_deep()) spread.push_back(figures.depth_std);
    }
    table += markdown_row({written("%g", 1e3 * rows[j].presliding), written("%g", rows[j].residual),
                           written("%d", ends[0]), written("%d", ends[1]), written("%d", ends[2]),
                           written("%d", held), written("%d", pushed), written("%d", both),
                           written("%d", separating), written("%d", never), written("%d", deep),
                           written("%.3f", 1e3 * median(spread))});
  }
  return table;
}

}  // namespace experiments
