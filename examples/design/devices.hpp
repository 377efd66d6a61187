// The devices that 10_design compares: the paper's with other reductions, five-bars, an arm of three joints.
#pragma once

#include "task_figures.hpp"

#include <passive_haptics/mechanism/chains/serial_chain.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <cmath>

namespace design {

// The paper's device with a reduction k2 before its base
inline auto paper_device(double k2 = 0.4, int columns = 81, int rows = 41) {
  const ph::tendon_two_link<double> arm({.reduction_2 = k2});
  return candidate{arm, [arm](const plane& x) { return arm.inverse(x, ph::elbow::left); },
                   ph::task_grid<double, 2>{{-0.25, 0.05}, {0.25, 0.295}, {columns, rows}}};
}

// The Pantograph Mk-II, with a brake at each base joint or also at each elbow
template <int Brakes>
auto five_bar_device(int columns = 81, int rows = 41) {
  const ph::five_bar<double, Brakes> device;
  return candidate{device, [device](const plane& x) { return device.inverse(x); },
                   ph::task_grid<double, 2>{{-0.06, 0.03}, {0.085, 0.125}, {columns, rows}}};
}

// Three brakes for two dimensions: the third link points away from the base
inline auto three_joint_arm(int columns = 81, int rows = 41) {
  constexpr double l1 = 0.15, l2 = 0.1, l3 = 0.05;  // [m]
  const ph::serial_chain<double, 3, 2> arm(ph::planar_arm<double, 3>({l1, l2, l3}));
  const auto inverse = [](const plane& x) {
    const plane wrist = x * (1 - l3 / x.norm());
    const auto inner = ph::two_link_inverse(l1, l2, wrist, ph::elbow::left);
    const double last = std::atan2(x[1], x[0]) - inner.q[0] - inner.q[1];
    return ph::joint_solution<double, 3>{{inner.q[0], inner.q[1], last}, inner.outcome};
  };
  return candidate{arm, inverse, ph::task_grid<double, 2>{{-0.25, 0.05}, {0.25, 0.295}, {columns, rows}}};
}

}  // namespace design
