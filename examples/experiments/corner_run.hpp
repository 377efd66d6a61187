// A hand in a corner, in closed loop: what it does to the walls.
#pragma once

#include "corner.hpp"

#include <functional>
#include <limits>

namespace experiments {

constexpr double time_step = 1e-4;  // [s]

// Device, sensors and control; a copy goes on from the same moment.
template <class M>
struct closed_loop {
  using capacities = std::function<ph::brake_vector<M>(const ph::device_state<M>&)>;
  capacities control;
  ph::simulated_device<M> plant;
  ph::joint_encoders<M> encoders;
  ph::force_sensor<double, M::task_dimension> sensor;
  ph::brake_vector<M> capacity = ph::brake_vector<M>::Zero();
  long steps = 0;

  double time() const { return static_cast<double>(steps) * time_step; }
  void advance(const ph::task_vector<M>& muscle_force) {
    if (steps++ % 10 == 0) {
      encoders.read(plant.q(), plant.qd());
      capacity = control({time(), encoders.q(), encoders.qd(), sensor.read()});
    }
    plant.advance(time_step, capacity, muscle_force);
    sensor.advance(time_step, plant.sensed_force());
  }
};

// Of one hand, from the touch of the second wall on.
struct push_figures {
  double deepest = 0;  // in any wall [m]
  double sink = 0;     // growth of a wall's depth in the last second [m]
  int separations = 0;
  bool left = false;  // a wall that was touched is left in the last second
};

struct corner_result {
  bool arrived = false;               // touched a second wall
  double first = 0, first_alone = 0;  // largest depth of wall 0 before that; without the other walls [m]
  push_figures law, locked;
};

// Depths of the handle in walls, and when it leaves them.
template <class M>
class wall_watch {
 public:
  explicit wall_watch(const corner<M>& c) : c_(&c), state_(c.out.size()) {}
  double depth(std::size_t wall, const ph::task_vector<M>& x) const {
    return -c_->out[wall].dot(x - c_->apex);
  }
  void add(const ph::task_vector<M>& x) {
    for (std::size_t j = 0; j < state_.size(); ++j) {
      wall& w = state_[j];
      w.depth = depth(j, x);
      w.deepest = std::max(w.deepest, w.depth);
      if (w.depth > 0) w.touched = true;
      if (w.depth > gap) w.in = true;
      if (w.depth < -gap && w.in) w.in = false, ++separations;
    }
  }
  struct wall {
    double depth = 0, deepest = 0;
    bool touched = false, in = false;
  };
  const wall& operator[](std::size_t j) const { return state_[j]; }
  std::size_t size() const { return state_.size(); }
  bool second_touched() const {
    return std::any_of(state_.begin() + 1, state_.end(), [](const wall& w) { return w.touched; });
  }
  static constexpr double gap = ph::contact_meter::hysteresis;
  int separations = 0;

 private:
  const corner<M>* c_;
  std::vector<wall> state_;
};

// The scene of a corner, with the walls [from, to) of it; others are 10 m away.
template <class M>
auto corner_scene(const corner<M>& c, std::size_t from, std::size_t to) {
  constexpr int d = M::task_dimension;
  const auto wall = [&](std::size_t j) {
    const auto n = j < c.out.size() ? c.out[j] : c.out[0];
    const bool there = from <= j && j < to && j < c.out.size();
    return ph::wall(ph::half_space<d>(there ? c.apex : ph::point<d>(c.apex - 10 * n), n));
  };
  if constexpr (d == 2) return ph::scene(wall(0), wall(1));
  else return ph::scene(wall(0), wall(1), wall(2));
}

// `controls(scene, brakes)` makes the control of a run.
template <class M, class Controls>
corner_result follow_corner(const corner_device<M>& device, const corner<M>& c, Controls&& controls) {
  using V = ph::task_vector<M>;
  const ph::brakes_of<M>& brakes = device.brakes;
  const auto loop_with = [&](std::size_t to) {
    return closed_loop<M>{controls(corner_scene(c, 0, to), brakes),
                          ph::simulated_device<M>(device.mechanism, brakes, 0.5, c.q),
                          ph::joint_encoders<M>(device.mechanism, {device.count, 50}, 1e-3),
                          ph::force_sensor<double, M::task_dimension>()};
  };
  const V way = c.apex - c.start, direction = way - c.out[0] * c.out[0].dot(way);
  const ph::following_hand<double, M::task_dimension> hand(direction, c.start);
  V force = V::Zero();
  const auto glide = [&](closed_loop<M>& loop, wall_watch<M>& walls) {
    const V x = loop.plant.position();
    force = hand.force(loop.time(), x, loop.plant.velocity(), c.out[0], walls.depth(0, x));
    loop.advance(force);
    walls.add(loop.plant.position());
  };

  corner_result result;
  auto loop = loop_with(c.out.size());
  wall_watch<M> walls(c), wall(c);
  const double longest = 4;  // [s]
  while (!walls.second_touched() && loop.time() < longest) glide(loop, walls);
  result.arrived = walls.second_touched();
  result.first = walls[0].deepest;
  const V last = force;
  for (auto alone = loop_with(1); alone.steps < loop.steps;) glide(alone, wall);
  result.first_alone = wall[0].deepest;
  if (!result.arrived) return result;

  const long touched = loop.steps, end = touched + 30000, late = end - 10000;
  const auto go_on = [&](closed_loop<M>& now, wall_watch<M>& seen, long until, push_figures& f) {
    static thread_local std::vector<double> before;
    while (now.steps < until) {
      const double share = std::min(1.0, static_cast<double>(now.steps - touched) * time_step / 0.1);
      now.advance((1 - share) * last + share * (2 * c.push - 20 * now.plant.velocity()));
      seen.add(now.plant.position());
      if (now.steps == late) {
        before.clear();
        for (std::size_t j = 0; j < seen.size(); ++j) before.push_back(seen[j].depth);
      }
      for (std::size_t j = 0; j < seen.size(); ++j) {
        f.deepest = std::max(f.deepest, seen[j].depth);
        if (now.steps >= late && seen[j].touched && seen[j].depth < -seen.gap) f.left = true;
        if (now.steps == end) f.sink = std::max(f.sink, seen[j].depth - before[j]);
      }
    }
    f.separations = seen.separations;
  };
  go_on(loop, walls, touched + 50, result.law);
  auto locked = loop;
  auto seen = walls;
  locked.control = [&](const auto&) { return brakes.torque_limit; };
  go_on(locked, seen, end, result.locked);
  go_on(loop, walls, end, result.law);
  return result;
}

}  // namespace experiments
