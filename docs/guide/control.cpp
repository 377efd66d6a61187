#include <passive_haptics/passive_haptics.hpp>

#include <algorithm>
#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

// A law of your own: direct control that also eases the brakes while the handle moves in slowly.
struct soft_landing {
  static constexpr bool needs_hand_force = true, nulls_normal_force = true;
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    const T full = c.normal_velocity < T(-0.02) ? T(1) : T(0.5);  // faster than 2 cm/s
    return std::min(full, ph::direct_control().scale(c));
  }
};
static_assert(ph::ControlLaw<soft_landing>);

int main() {
  const device arm;
  const ph::half_space<2> top({0, 0.225}, {0, -1}), right({0.13, 0}, {-1, 0});
  const ph::brakes_of<device> brakes;
  ph::controller control(arm, brakes, ph::scene(ph::wall(top), ph::wall(right)), soft_landing());

  ph::device_state<device> state;
  state.time = 0;                                              // [s]
  state.q = arm.inverse({0.1301, 0.2251}, ph::elbow::left).q;  // in the corner, inside both walls
  state.qd = {-0.3, 0.4};
  state.hand_force = {1, 1};
  const auto result = control(state);
  for (int j = 0; j < result.contact_count; ++j) {
    const auto& report = result.contacts[static_cast<std::size_t>(j)];
    std::cout << "wall " << report.wall_number << ": required " << report.wanted << " N, displayed "
              << report.displayed << " N\n";
  }

  // It sees walls before they are touched, so that lagging brakes begin in time: here for hands of 0.2 m/s
  ph::controller gliding(arm, brakes, ph::scene(ph::wall(top)),
                         ph::velocity_direct_control({.approach_speed = 0.2}));

  ph::on_off_control relay;
  relay.parameters = {.reference_depth = 1e-3, .hysteresis = 0.1e-3, .lead = 0.02};
  ph::controller by_relay(arm, brakes, ph::scene(ph::wall(top)), relay);
  const bool relay_runs = by_relay(state).outcome == ph::status::ok;

  ph::sensorless_controller sensorless(arm, brakes, ph::scene(ph::wall(top)), ph::direct_control());
  const ph::sensorless_device_state<device> felt{state.time, state.q, state.qd};
  const auto command = sensorless(felt);
  const auto& hand = sensorless.hand();
  std::cout << "pressing with " << hand.force[1] << " N, give or take " << hand.half_width({0, 1}) << " N\n";

  const bool runs = result.outcome == ph::status::ok && relay_runs && command.outcome == ph::status::ok;
  return runs && result.contact_count == 2 ? 0 : 1;
}
