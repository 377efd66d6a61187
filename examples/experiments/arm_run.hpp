// Runs of any arm along walls.
#pragma once

#include "arms.hpp"
#include "batch.hpp"
#include "control_of.hpp"
#include "planar.hpp"
#include "rods.hpp"

#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/driver/rate_estimator.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace experiments {

inline constexpr double arm_torque_limit = 1;  // of all brakes [N m]
inline constexpr double arm_push = 2;          // of the hand, 10 mm deep [N]

// The wall at the handle.
enum class arm_wall { plane, outside_of_disc, inside_of_disc };
inline constexpr double small_radius = 0.1, large_radius = 0.3;  // of the discs [m]

template <class M>
struct arm_kind {
  std::string name;
  M arm;
  arm_wall wall = arm_wall::plane;
};

// Start and direction of a hand.
template <class M>
struct arm_start {
  ph::joint_vector<M> q;
  ph::task_vector<M> normal, direction;
};

// Wall number k of an arm: a random pose that is not nearly singular, a random normal and direction. With
// fewer brakes than joints, one at which a force of at least 4 N within 53 degrees of the normal is
// displayed.
template <class M>
arm_start<M> draw_start(const M& arm, std::size_t k) {
  constexpr std::uint64_t seed = 20040627;
  constexpr double min_reach = 0.056;  // geometric mean of the singular values of J [m]
  constexpr int d = M::task_dimension;
  auto bits = ph::random_bits(seed, k);
  const auto between = [&](double low, double high) { return low + (high - low) * ph::uniform_number(bits); };
  const auto any_direction = [&] {
    const auto normal = [&] { return ph::normal_number(bits); };
    const ph::task_vector<M> u = ph::task_vector<M>::NullaryExpr(normal);
    return ph::task_vector<M>(u.normalized());
  };
  while (true) {
    arm_start<M> start;
    for (int i = 0; i < M::dof; ++i)
      start.q[i] = i == 0 ? between(-std::numbers::pi, std::numbers::pi)
                          : between(0.5, 2.6) * (between(-1, 1) < 0 ? -1 : 1);
    start.normal = any_direction();
    const ph::task_vector<M> u = any_direction();
    start.direction = (u - start.normal * start.normal.dot(u)).normalized();
    const ph::jacobian_matrix<M> J(ph::jacobian(arm, start.q));
    if (std::pow((J * J.transpose()).determinant(), 0.5 / d) < min_reach) continue;
    if constexpr (M::brake_count == M::dof) return start;
    for (const double way : {1.0, -1.0}) {
      const auto found =
          ph::displayable(arm, start.q, ph::task_vector<M>(way * start.direction), start.normal,
                          ph::brake_vector<M>(ph::brake_vector<M>::Constant(arm_torque_limit)));
      start.direction *= way;
      if (ph::is_displayed(found.display) && std::cos(found.angle) >= 0.6 &&
          found.max_approximated_force >= 2 * arm_push)
        return start;
    }
  }
}

struct arm_result {
  ph::contact_metrics figures;
  double weak = 0;  // share of the path on which no set of brakes displays the push

  bool glides() const {
    return figures.touched && !figures.separates() && !figures.is_deep() && figures.arrived;
  }
};

// The wall 1 mm before the handle.
template <int D>
auto wall_before(const ph::point<D>& x, const ph::point<D>& n, arm_wall which) {
  constexpr double gap = 1e-3;  // [m]
  if constexpr (D == 2) {
    switch (which) {
      case arm_wall::plane: break;
      case arm_wall::outside_of_disc: return test_wall(ph::disc(x - (small_radius + gap) * n, small_radius));
      case arm_wall::inside_of_disc:
        return test_wall(ph::disc(x + (large_radius - gap) * n, large_radius, ph::filling::hollow));
    }
    return test_wall(ph::half_space<2>(x - gap * n, n));
  } else {
    return ph::half_space<D>(x - gap * n, n);
  }
}

// A controller with these brakes in front of this wall.
template <class M>
using arm_wall_of = decltype(wall_before<M::task_dimension>({}, {}, arm_wall::plane));
template <class M>
using arm_control = std::function<any_control<M>(const ph::brakes_of<M>&, const arm_wall_of<M>&)>;

// Runs one hand.
template <class M>
arm_result follow_arm(const arm_kind<M>& kind, const arm_control<M>& control_of, const arm_start<M>& start,
                      double lag, arm_encoders encoders) {
  constexpr int n = M::dof, d = M::task_dimension;
  constexpr double count = 2 * std::numbers::pi / 4096, period = 1e-3;  // [rad], [s]
  constexpr int window = 16;
  const bool counts = encoders == arm_encoders::counts;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(arm_torque_limit);
  brakes.time_constant.setConstant(lag);
  ph::following_hand_parameters<double> hand;
  hand.push = arm_push;
  hand.normal_stiffness = 100;
  hand.target_depth = 0.010;

  ph::simulated_device<M> plant(kind.arm, brakes, hand.mass, start.q);
  const ph::jacobian_matrix<M> J(ph::jacobian(kind.arm, start.q));
  const ph::matrix<double, n, d> by_inertia =
      ph::matrix<double, n, n>(kind.arm.mass_matrix(start.q)).inverse() * J.transpose();
  const ph::task_vector<M> v = hand.speed * start.direction - 0.02 * start.normal;
  plant.set_motion(start.q, by_inertia * ph::matrix<double, d, d>(J * by_inertia).partialPivLu().solve(v));
  const ph::task_vector<M> x0 = plant.position();
  const auto wall = wall_before<d>(x0, start.normal, kind.wall);

  if (counts) brakes.rate_dead_band.setConstant(ph::rate_dead_band(count, window, period));
  const any_control<M> control = control_of(brakes, wall);
  ph::rate_estimator<n> rates({.window = window});
  const auto read_and_control = [&](ph::device_state<M> state) {
    if (counts) {
      const ph::joint_vector<M> turned = (state.q / count).array().round();
      state.qd = rates.add(state.time, turned) * count;
    }
    return control(state);
  };

  ph::wall_following_parameters p;
  p.control_period = period;
  p.encoder_resolution = counts ? count : 0;
  p.path_end = start.direction.dot(x0) + 0.06;
  p.max_duration = 3;
  p.max_depth = 0.03;
  p.watched_brake = 0;
  const ph::brake_vector<M> limit = brakes.torque_limit;
  long steps = 0, looked = 0, weak = 0;
  arm_result result;
  result.figures = ph::follow_wall(
      plant, read_and_control, wall, ph::following_hand<double, d>(start.direction, x0, hand), p,
      [&](const auto& s) {
        if (steps++ % 200 != 0 || !(s.depth > 0)) return;
        const ph::task_vector<M> out = wall.gradient(s.position);
        const ph::task_vector<M> along = start.direction - out * out.dot(start.direction);
        ++looked;
        weak += !(ph::displayable(kind.arm, plant.q(), along, out, limit).max_force > arm_push);
      });
  result.weak = looked > 0 ? static_cast<double>(weak) / static_cast<double>(looked) : 0;
  return result;
}

inline arm_cell cell_of(const std::vector<arm_result>& results, std::size_t first, std::size_t count) {
  arm_cell cell;
  std::vector<double> spread;
  for (std::size_t k = first; k < first + count; ++k) {
    const arm_result& r = results[k];
    cell.gliding += r.glides();
    cell.separating += r.figures.separates();
    cell.too_weak += !r.glides() && r.weak > 0.1;
    spread.push_back(r.figures.depth_std);
    cell.max_power = std::max(cell.max_power, r.figures.max_brake_power);
  }
  cell.median_std = median(spread);
  return cell;
}

// A row: all walls at all settings, or the sampled one.
template <class M, class Law>
arm_row follow_row(const arm_kind<M>& kind, const std::string& law_name, const Law& law) {
  std::vector<std::size_t> settings{sampled_setting};
  if (built_extent == arm_extent::all) settings = {0, 1, 2, 3, 4, 5};
  std::vector<arm_start<M>> starts;
  for (std::size_t k = 0; k < arm_walls; ++k) starts.push_back(draw_start(kind.arm, k));
  const arm_control<M> control_of = [&](const auto& brakes, const auto& wall) {
    return ph::controller(kind.arm, brakes, ph::scene(ph::wall(wall)), law);
  };
  const auto results = on_all_cores(kind.name, settings.size() * arm_walls, [&](std::size_t k) {
    const std::size_t setting = settings[k / arm_walls];
    const auto encoders = setting < arm_lags.size() ? arm_encoders::exact : arm_encoders::counts;
    return follow_arm(kind, control_of, starts[k % arm_walls], arm_lags[setting % arm_lags.size()], encoders);
  });
  arm_row row{kind.name, law_name, {}};
  for (std::size_t i = 0; i < settings.size(); ++i)
    row.cells[settings[i]] = cell_of(results, i * arm_walls, arm_walls);
  std::printf("%s", arm_lines({row}).c_str());
  std::fflush(stdout);
  return row;
}

// All laws; the sample uses the recommended one.
template <class M>
void add_rows(std::vector<arm_row>& rows, const arm_kind<M>& kind) {
  const auto add = [&](const std::string& law_name, const auto& law) {
    rows.push_back(follow_row(kind, law_name, law));
  };
  if constexpr (built_extent == arm_extent::all)
    add("saturated_direct_control", ph::saturated_direct_control());
  add("velocity_direct_control", ph::velocity_direct_control());
}

}  // namespace experiments
