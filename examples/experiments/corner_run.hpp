// A hand in a corner, in closed loop: depths in the walls, and pulling out.
#pragma once

#include "corner.hpp"

#include <array>
#include <functional>

namespace experiments {

// Variations of hand and device.
struct corner_hand {
  double rise = 0;      // of the push, up to 21 N and nine tenths of the limits [N/s]
  double strength = 0;  // torque limits relative to those that locked brakes need [1]; 0: the device's own
  double gain = 1;      // of the force sensor [1]
  bool pulls_out = false;
};

// The figures of one hand.
struct corner_result {
  bool arrived = false;  // touched a second wall, or passed
  double first = 0,
         first_alone = 0;  // maximum depth in the first wall until then, and without the others [m]
  double max_depth = 0, max_locked_depth = 0;  // in any wall; with brakes locked from the touch on [m]
  bool held = false;                           // locked brakes hold
  bool sinks = false, left = false;            // under the law; a touched wall is left
  int separations = 0;
  // Directions of pulling; number of these as fast, and as light, as from one wall or with released brakes
  int pulls = 0, in_time = 0, no_heavier = 0;
};

// Device, sensors and control; a copy continues from the same state.
template <class M>
struct closed_loop {
  static constexpr double time_step = 1e-4;  // [s]; ten per cycle
  using capacities = std::function<ph::brake_vector<M>(const ph::device_state<M>&)>;
  capacities control;
  ph::simulated_device<M> plant;
  ph::joint_encoders<M> encoders;
  ph::force_sensor<double, M::task_dimension> sensor;
  ph::brake_vector<M> capacity = ph::brake_vector<M>::Zero();
  long steps = 0;

  double time() const { return static_cast<double>(steps) * time_step; }
  void advance(const ph::task_vector<M>& muscle_force) {
    if (steps % 10 == 0) {
      encoders.read(plant.q(), plant.qd());
      capacity = control({time(), encoders.q(), encoders.qd(), sensor.read()});
    }
    ++steps;
    plant.advance(time_step, capacity, muscle_force);
    sensor.advance(time_step, plant.sensed_force());
  }
};

// Makes the control of a run.
template <class M>
using control_maker =
    std::function<typename closed_loop<M>::capacities(const corner<M>&, const ph::brakes_of<M>&)>;

// One corner with one law.
template <class M>
class corner_run {
 public:
  using V = ph::task_vector<M>;
  corner_run(const corner_device<M>& device, const corner<M>& c, const corner_hand& hand,
             control_maker<M> make)
      : device_(device), corner_(c), hand_(hand), make_(std::move(make)) {
    if (hand_.strength > 0) {
      device_.brakes.torque_limit *= hand_.strength * corner_.need;
      corner_.need = 1 / hand_.strength;
    }
  }

  corner_result result() {
    corner_result r;
    moment now{loop_at(corner_, corner_.q)};
    while (now.loop.time() < max_time && !(r.arrived = has_arrived(now))) glide(corner_, now);
    r.first = now.max_depth[0];
    const corner<M> first = corner_.only(0);
    moment alone{loop_at(first, corner_.q)};
    while (alone.loop.steps < now.loop.steps) glide(first, alone);
    r.first_alone = std::max(alone.max_depth[0], corner_.edge ? behind_edge() : 0);
    if (r.arrived && !corner_.passes) stay(now, r);
    for (const ph::contact_meter& meter : now.meters) r.separations += meter.result().separations;
    return r;
  }

 private:
  static constexpr double max_time = 4, pushing = 3;  // [s]
  static constexpr double damping = 20;               // of a pushing or pulling hand [N s/m]
  struct moment {
    closed_loop<M> loop;
    V force = V::Zero();
    std::vector<ph::contact_meter> meters = std::vector(3, ph::contact_meter(1, closed_loop<M>::time_step));
    ph::vector<double, 3> depth = ph::vector<double, 3>::Zero(), max_depth = depth;  // in each wall [m]
    bool left = false;                                                               // a touched wall
  };
  struct way_out {
    double wait = 1;  // time to move the handle by 0.5 mm [s]
    double felt = 0;  // mean force against the hand in the first 0.1 s [N]
  };

  closed_loop<M> loop_at(const corner<M>& c, const ph::joint_vector<M>& q) const {
    return {make_(c, device_.brakes), ph::simulated_device<M>(device_.mechanism, device_.brakes, 0.5, q),
            ph::joint_encoders<M>(device_.mechanism, {device_.count, 50}, 1e-3),
            ph::force_sensor<double, M::task_dimension>({.scale = hand_.gain})};
  }
  void advance(const corner<M>& c, moment& now, const V& force) const {
    now.force = force;
    now.loop.advance(force);
    // If the hand passes, only the first wall counts
    for (int j = 0; j < (c.passes ? 1 : 3); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const double depth = now.depth[j] = c.depth(k, now.loop.plant.position());
      now.meters[k].add({.depth = depth});
      now.max_depth[j] = std::max(now.max_depth[j], depth);
      now.left = now.left || (now.max_depth[j] > 0 && depth < -ph::contact_meter::hysteresis);
    }
  }
  bool has_arrived(const moment& now) const {
    if (!corner_.passes) return now.max_depth.tail(2).maxCoeff() > 0;
    return corner_.direction.dot(now.loop.plant.position() - corner_.apex) > device_.where.path_length / 2;
  }
  void glide(const corner<M>& c, moment& now) const {
    const ph::following_hand<double, M::task_dimension> hand(c.direction, c.start);
    const V x = now.loop.plant.position();
    advance(c, now, hand.force(now.loop.time(), x, now.loop.plant.velocity(), c.normal(0, x), c.depth(0, x)));
  }
  // Maximum depth in the face behind an edge, without the other face [m].
  double behind_edge() const {
    corner<M> second = corner_.only(1);
    std::swap(second.walls[0], second.walls[1]);
    second.start = second.apex + corner_gap * second.normal(0, second.apex);
    ph::joint_vector<M> q = corner_.q;
    move_to<M>(device_, second.start, q);
    moment now{loop_at(second, q)};
    while (now.loop.time() < max_time && !has_arrived(now)) glide(second, now);
    return now.max_depth[0];
  }
  // Pushes between the normals until a time after the touch.
  void push(moment& now, const moment& touch, double until) const {
    for (double t = 0; (t = now.loop.time() - touch.loop.time()) < until - 1e-9;) {
      const double share = std::min(1.0, t / 0.1);
      const double most = hand_.rise > 0 ? std::min(21.0, 0.9 * corner_push / corner_.need) : corner_push;
      const V pushed = std::min(most, corner_push + hand_.rise * t) * corner_.push;
      advance(corner_, now,
              (1 - share) * touch.force + share * (pushed - damping * now.loop.plant.velocity()));
    }
  }
  void stay(moment& now, corner_result& r) const {
    // A rising push may increase the depth at any time
    const double from = hand_.rise > 0 ? 0.2 : pushing - 1,
                 growth = hand_.rise > 0 ? 0.5e-3 : 0.2e-3;  // [s], [m]
    const moment touch = now;
    push(now, touch, 0.005);
    moment locked = now;
    locked.loop.control = [limit = device_.brakes.torque_limit](const auto&) { return limit; };
    if (hand_.pulls_out) {
      push(now, touch, 1);
      pull_out(now, r);
    }
    const auto grows_by = [&](moment& one) {
      push(one, touch, from);
      one.left = false;
      const ph::vector<double, 3> depth = one.depth;
      push(one, touch, pushing);
      return (one.depth.cwiseMax(0.0) - depth.cwiseMax(0.0)).maxCoeff();  // of touched walls
    };
    r.held = grows_by(locked) < 0.05 * growth;
    r.sinks = grows_by(now) > growth;
    r.left = now.left;
    r.max_depth = now.max_depth.maxCoeff();
    r.max_locked_depth = locked.max_depth.maxCoeff();
  }
  // Pulls along the bisector and along each wall, away from the others.
  void pull_out(const moment& now, corner_result& r) const {
    V bisector = V::Zero();
    std::vector<V> ways{bisector};
    for (int j = 0; j < corner_.count; ++j) bisector += corner_.walls[std::size_t(j)].gradient(corner_.apex);
    ways[0] = bisector.normalized();
    for (int j = 0; j < corner_.count; ++j) {
      const V n = corner_.walls[std::size_t(j)].gradient(corner_.apex);
      ways.push_back((bisector - n * n.dot(bisector)).normalized());
    }
    closed_loop<M> released = now.loop;  // the fastest possible
    released.control = [](const auto&) { return ph::brake_vector<M>(ph::brake_vector<M>::Zero()); };
    std::vector<way_out> at_most;
    for (const V& way : ways) at_most.push_back(pull(released, way));
    for (int j = 0; j < corner_.count; ++j) {
      const moment at_one = at_wall(std::size_t(j));
      for (std::size_t k = 0; k < ways.size(); ++k) {
        const way_out one = pull(at_one.loop, ways[k]);
        at_most[k] = {std::max(at_most[k].wait, one.wait), std::max(at_most[k].felt, one.felt)};
      }
    }
    for (std::size_t k = 0; k < ways.size(); ++k) {
      const way_out out = pull(now.loop, ways[k]);
      ++r.pulls;
      r.in_time += out.wait <= at_most[k].wait + 0.020;
      r.no_heavier += out.felt <= at_most[k].felt + 0.05 * corner_push;
    }
  }
  // Pushes straight into one wall for a second.
  moment at_wall(std::size_t j) const {
    const corner<M> one = corner_.only(j);
    const V n = one.normal(j, one.apex);
    ph::joint_vector<M> q = corner_.q;
    move_to<M>(device_, one.apex + corner_gap * n, q);
    moment now{loop_at(one, q)};
    while (now.loop.time() < 1) advance(one, now, -corner_push * n - damping * now.loop.plant.velocity());
    return now;
  }
  static way_out pull(closed_loop<M> loop, const V& way) {
    constexpr double moved = 0.5e-3, feeling = 0.1;  // [m], [s]
    way_out out;
    const V x = loop.plant.position();
    const double start = loop.time();
    for (double t = 0; t < feeling || (t < 1 && out.wait == 1); t = loop.time() - start) {
      loop.advance(corner_push * way - damping * loop.plant.velocity());
      if (out.wait == 1 && way.dot(loop.plant.position() - x) > moved) out.wait = t;
      if (t < feeling) out.felt += loop.plant.sensed_force().dot(way) * loop.time_step / feeling;
    }
    return out;
  }

  corner_device<M> device_;
  corner<M> corner_;
  corner_hand hand_;
  control_maker<M> make_;
};

}  // namespace experiments
