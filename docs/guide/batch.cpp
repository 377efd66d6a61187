#include <passive_haptics/passive_haptics.hpp>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <vector>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;
  const ph::half_space<2> wall({0, 0.225}, {0, -1});

  // A map: the handle is pushed along the wall from 1000 places, 1 mm deep
  const std::size_t n = 1000;
  std::vector<double> q1(n), q2(n), w1(n), w2(n), push_x(n, 2.0), push_y(n, 1.0);
  for (std::size_t k = 0; k < n; ++k) {
    const auto pose = arm.inverse({0.05 + 0.12 * double(k) / double(n), 0.226}, ph::elbow::left).q;
    q1[k] = pose[0];
    q2[k] = pose[1];
    w1[k] = -0.5;
  }

  const ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(wall)), ph::direct_control());

  std::vector<double> capacity_1(n), capacity_2(n), angle_cosine(n);
  std::vector<ph::status> outcome(n);
  std::vector<ph::display_class> display(n);
  const ph::batch_states<device> states{.q = {q1, q2}, .qd = {w1, w2}, .hand_force = {push_x, push_y}};
  const ph::batch_results<device> results{.capacity = {capacity_1, capacity_2},
                                          .outcome = outcome,
                                          .display = display,
                                          .approximation_cosine = angle_cosine};
  control.batch(states, results);
  const auto approximate = std::count(display.begin(), display.end(), ph::display_class::approximate);
  std::cout << approximate << " of " << n << " places display the wall approximately\n";

  // Parts of the arrays, such as one for each thread
  const std::size_t parts = 4;
  const auto run_part = [&](std::size_t part) {
    const std::size_t first = n * part / parts, count = n * (part + 1) / parts - first;
    control.batch(part_of(states, first, count), part_of(results, first, count));
  };
  for (std::size_t part = 0; part < parts; ++part) run_part(part);  // in any order, also at once

  const bool all_ok = std::count(outcome.begin(), outcome.end(), ph::status::ok) == std::ptrdiff_t(n);
  return all_ok && approximate > 0 ? 0 : 1;
}
