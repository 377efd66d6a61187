#include <passive_haptics/design/map/design_map_csv.hpp>
#include <passive_haptics/passive_haptics.hpp>

#include <algorithm>
#include <iostream>
#include <string>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const ph::task_grid<double, 2> where{.lower = {-0.2, 0.1}, .upper = {0.2, 0.3}, .count = {81, 41}};
  const ph::vector<double, 2> along(1, 0), out(0, -1);  // the handle moves along x, the wall lies above
  ph::switchable_brakes<device> brakes;
  brakes.torque_limit = {1, 1};  // [N m]
  const double push = 2;         // of the hand, into the wall [N]

  const auto map_of = [&](double k2) {
    const device arm({.reduction_2 = k2});
    const auto inverse = [&](const auto& x) { return arm.inverse(x, ph::elbow::left); };
    return ph::design_map(arm, ph::points_of(arm, where, inverse, along, out), brakes, push);
  };

  for (const double k2 : {0.4, 1.0}) {
    const auto map = map_of(k2);
    const auto held = std::count(map.sink_slope.begin(), map.sink_slope.end(), 0.0);
    const auto reached = std::count(map.outcome.begin(), map.outcome.end(), ph::status::ok);
    std::cout << "k2 = " << k2 << ": the hand is held at " << held << " of " << reached << " places\n";
  }

  const device arm;
  const auto inverse = [&](const auto& x) { return arm.inverse(x, ph::elbow::left); };
  const auto points = ph::points_of(arm, where, inverse, along, out);
  const std::string table = ph::to_csv(points, map_of(0.4));  // a row for each place
  return std::count(table.begin(), table.end(), '\n') == std::ptrdiff_t(where.size()) + 1 ? 0 : 1;
}
