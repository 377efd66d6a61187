// The figures of a device before it is built, and a run along a wall with its simulation.
#include "chains.hpp"

#include <passive_haptics/design/map/design_figures.hpp>
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>
#include <passive_haptics/plant/wall_following.hpp>

namespace reference {
namespace {

constexpr double push = 0.4;

// At each state the figures, where the handle moves as the hand pushes.
template <class M>
void write_figures(const M& mechanism, const task<M>& given, doubles_out& out) {
  const auto brakes = ph::hybrid_brakes<M>::with_limits(given.brakes.torque_limit);
  for (const auto& state : given.states) {
    const ph::path_point<M> at{state.q, state.hand_force, given.normal};
    const auto f = ph::design_figures_at(mechanism, at, brakes, push);
    for (const int whole : {int(f.outcome), int(f.display)}) out.add(double(whole));
    for (const double x : {f.cosine, f.drag, f.max_force, f.sink_slope, f.isotropy}) out.add(x);
  }
}

// Of the states after the edge cases: the depth to which a hand sinks on their way.
template <class M>
void write_depth(const M& mechanism, const task<M>& given, doubles_out& out) {
  constexpr int first = 70, samples = 20;
  const auto path = [&](double u) {
    const auto& state = given.states[std::size_t(first + int(u * samples))];
    return ph::path_point<M>{state.q, state.hand_force, given.normal};
  };
  out.add(ph::sink_depth(mechanism, path, given.brakes.torque_limit, push, samples));
}

// Runs along the wall, of ideal brakes and of brakes that stick: figures, and where each time step ends.
template <class M>
void write_runs(const M& mechanism, const task<M>& given, doubles_out& out) {
  constexpr int d = M::task_dimension;
  const ph::half_space<d> plane(given.point, given.normal);
  ph::wall_following_parameters p;
  p.max_duration = 0.5;
  p.path_end = 10;
  const auto& start = given.states[100];
  ph::vector<double, d> along = ph::vector<double, d>::Zero();
  along[0] = given.normal[1];
  along[1] = -given.normal[0];
  const auto run = [&](auto device) {
    ph::controller control(mechanism, given.brakes, given.scene(), ph::direct_control());
    const ph::following_hand<double, d> hand(along, device.position());
    const auto f = ph::follow_wall(device, control, plane, hand, p, [&](const auto& now) {
      out.add(now.time);
      out.add(now.depth);
      out.add(now.position);
      out.add(now.brake_torque);
      out.add(now.hand_force);
      out.add(now.control->capacity);
      out.add(now.control->alpha);
    });
    for (const double x : {f.depth_mean, f.depth_std, f.max_depth, f.stick_share, f.hand_force_std,
                           f.retarding_force, f.brake_energy, f.max_brake_power, f.duration})
      out.add(x);
  };
  run(ph::simulated_device<M>(mechanism, given.brakes, 0.5, start.q));
  ph::brake_models_of<M, ph::stribeck_brake<double>> sticking;
  for (auto& brake : sticking) brake.static_ratio = 1.3;
  run(ph::simulated_device(mechanism, sticking, 0.5, start.q));
}

template <class M>
bool write_all(const M& mechanism, const std::string& mode, const std::string& in, const std::string& to) {
  const task<M> given(in);
  doubles_out out(to);
  if (mode == "figures") write_figures(mechanism, given, out);
  else if (mode == "depth") write_depth(mechanism, given, out);
  else if (mode == "runs") write_runs(mechanism, given, out);
  else return false;
  return true;
}

}  // namespace
}  // namespace reference

bool reference::run_design(const std::string& device, const std::string& law, const std::string& mode,
                           const std::string& in, const std::string& to) {
  if (law != "design") return false;
  const auto with = [&](const auto& mechanism) { return write_all(mechanism, mode, in, to); };
  if (device == "tendon_two_link") return with(ph::tendon_two_link<double>());
  if (device == "delta") return with(ph::delta<double>());
  if (device == "planar_chain_3_with_inertia")
    return with(ph::serial_chain_with_inertia<double, 3, 2>(geometry<3, 2>(), inertia<3, 2>()));
  return false;
}
