// The XY table over a floor at y = 0, under velocity_direct_control.
#pragma once

#include "../support.hpp"

#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

namespace {

using table = ph::xy_table<double>;
using pair = ph::vector<double, 2>;
using law = ph::velocity_direct_control;
using constants = ph::velocity_direct_control_parameters;

// The handle at x, y; free above.
ph::contact<2> floor_at(double x, double y) {
  return {.normal = {0, 1}, .depth = -y, .stiffness = 1e7, .sensed_at = {x, y}};
}

ph::brakes_of<table> without_lag() {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(100);
  brakes.time_constant.setZero();
  return brakes;
}

// With the hand that the law expects
double slide_mass() { return table().mass_matrix({0, 0})(1, 1) + constants().hand_mass; }

// Force for each m/s that the handle is too fast
double force_per_speed(const constants& p) { return slide_mass() / p.velocity_lag; }

}  // namespace
