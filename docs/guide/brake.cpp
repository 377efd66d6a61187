#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

// A driver that limits the current itself, and a law that uses the lag.
struct lagging_brakes {
  static constexpr bool unlimited = true;                // there is no torque_limit, and none is missing
  ph::vector<double, 2> rate_dead_band = {0.02, 0.02};   // [rad/s]
  ph::vector<double, 2> time_constant = {0.020, 0.030};  // [s]
};
static_assert(ph::BrakesFor<lagging_brakes, device> && !ph::LimitedBrakes<lagging_brakes, double, 2>);

int main() {
  const device arm;
  const auto q = arm.inverse({0.12, 0.225}, ph::elbow::left).q;
  ph::brakes_of<device> brakes;
  brakes.torque_limit = {0.8, 0.8};  // [N m]

  const auto E = ph::brake_jacobian(arm, q);                         // v = E w, t = E^T F
  const ph::brake_vector<device> w(-0.3, 0.001);                     // brake 2 is slower than its dead band
  const auto th = ph::brake_torque(E, ph::vector<double, 2>(0, 2));  // torques of the hand on the brakes
  const auto s = ph::brake_signs(w, th, brakes);                     // -1, and the sign of th[1]
  const auto t = ph::passive_torque({0.5, 0.5}, w, th, brakes);      // their torques for 0.5 N m each
  std::cout << "s = " << s.transpose() << "\nt = " << t.transpose() << " N m\n";

  const auto wall = ph::scene(ph::wall(ph::half_space<2>({0, 0.2249}, {0, -1}), 1e4));
  ph::controller gliding(arm, lagging_brakes(), wall, ph::velocity_direct_control());
  ph::controller bare(arm, ph::unlimited_brakes(), wall, ph::no_direct_control());

  ph::switchable_brakes<device> some = brakes;  // all on
  some.switch_off(1);                           // brake 2 makes no torque; or make_positive, make_negative
  ph::controller clutched(arm, some, wall, ph::velocity_direct_control());
  ph::device_state<device> state{0, q, {-0.3, 0.1}, {0, 2}};
  const bool released = clutched(state).capacity[1] == 0;
  some.switch_on(1);
  clutched.set_brakes(some);  // from the next cycle on
  state.time += 1e-3;

  const ph::sensorless_device_state<device> blind{0, q, {-0.3, 0.1}};
  // Signs and torques of brakes at rest by the arm's inertia, in each cycle
  ph::torques_at_rest rest(arm, brakes);
  const auto inert = clutched(rest.update(state, ph::brake_vector<device>::Zero()));  // Zero: no command yet

  const bool run = inert.outcome == ph::status::ok && gliding(state).outcome == ph::status::ok &&
                   bare(blind).outcome == ph::status::ok;
  return run && released && (s.array() * t.array() <= 0).all() ? 0 : 1;
}
