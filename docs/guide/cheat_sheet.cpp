#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <iostream>

namespace ph = passive_haptics;

int main() {
  // A mechanism, its brakes, walls, a law: a controller
  using device = ph::tendon_two_link<double>;
  const device arm;
  ph::brakes_of<device> brakes;
  brakes.torque_limit = {1, 1};  // [N m]
  const ph::half_space<2> plane({0, 0.225}, {0, -1});
  const ph::disc ball({0.1, 0.2}, 0.01);
  const auto scene = ph::scene(ph::wall(plane), ph::wall(ball, 1e5));  // [N/m]
  ph::controller control(arm, brakes, scene, ph::recommended_law(arm, brakes));

  // Each millisecond: the state in, the brakes' capacities out
  ph::device_state<device> state;
  state.time = 0;                                            // of any clock [s]
  state.q = arm.inverse({0.12, 0.2251}, ph::elbow::left).q;  // [rad]
  state.qd = {-0.36, 0.41};                                  // [rad/s]
  state.hand_force = {0.8, 1.5};                             // [N]
  const auto all = control(state);
  state.time += 1e-3;
  const auto only = control.command(state);  // the next cycle: capacities and outcome only, faster
  std::cout << all.capacity.transpose() << " N m, " << to_string(all.outcome) << ", " << display_text(all)
            << ", alpha " << all.alpha << "\n";

  // The layers one by one
  const auto J = ph::jacobian(arm, state.q);
  const auto E = ph::brake_jacobian(arm, state.q);         // v = E w, t = E^T F
  const auto w = ph::brake_rates(arm, state.q, state.qd);  // [rad/s]
  const auto s = ph::brake_signs(w, ph::brake_torque(E, state.hand_force), brakes);
  const auto touched = ph::sense(scene, ph::point<2>(arm.position(state.q)));
  const ph::vector<double, 2> Fd = touched[0].stiffness * touched[0].depth * touched[0].normal;
  const auto Fp = ph::nearest_force(E, s, Fd);  // of all forces in the cone
  std::cout << "v = " << (J * state.qd).transpose() << " m/s, Fp = " << Fp.force.transpose() << " N\n";

  // Without hardware
  const ph::following_hand<double, 2> hand({1, 0}, arm.position(state.q));
  ph::simulated_device<device> simulated(arm, brakes, hand.parameters().mass, state.q);
  control.reset();  // a motion of its own, which begins at time 0
  const auto figures = ph::follow_wall(simulated, control, plane, hand, {.path_end = 0.05});
  std::cout << figures.separations << " separations\n";

  return figures.separations == 0 && only.outcome == all.outcome ? 0 : 1;
}
