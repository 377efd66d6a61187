#include "space.hpp"

#include "rods.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace experiments {
namespace {

using space_vector = ph::vector<double, 3>;
constexpr double gap = 0.004, approach = 0.1,
                 speed = 0.05;  // at the start [m], [m/s], and along the wall [m/s]
constexpr double max_time = 8;  // [s]

// The place of the experiment: a mechanism, the middle and length of the path, nearby joint positions.
template <class M>
struct place {
  M mechanism;
  space_vector middle;
  double length;
  space_vector near_q;

  // Joint positions for the handle at x, by Newton's method.
  space_vector inverse(const space_vector& x) const {
    space_vector q = near_q;
    for (int k = 0; k < 50; ++k) {
      const ph::matrix<double, 3, 3> J(ph::jacobian(mechanism, q));
      q -= J.partialPivLu().solve(mechanism.position(q) - x);
    }
    if (!((mechanism.position(q) - x).norm() < 1e-9))
      throw std::logic_error("a path out of the device's reach");
    return q;
  }
};

// One wall: distance and normal at x.
struct touch {
  std::function<double(const space_vector&)> distance;
  std::function<space_vector(const space_vector&)> normal;
};

template <class Shape>
touch touch_of(const Shape& shape) {
  return {[shape](const space_vector& x) { return shape.distance(x); },
          [shape](const space_vector& x) { return shape.gradient(x); }};
}

// Force of the hand: along x at constant speed, with a push into each wall; held sideways at a single wall.
class hand {
 public:
  hand(const space_vector& start, double push) : start_(start), push_(push) {}

  space_vector force(double time, const space_vector& x, const space_vector& v,
                     const std::vector<touch>& walls) const {
    space_vector along = space_vector::UnitX(), total = space_vector::Zero();
    for (const touch& wall : walls) {
      const space_vector n = wall.normal(x);
      along -= n * n.dot(along);
      total -= (push_ + damping * v.dot(n)) * n;
    }
    along.normalize();
    const double lag = speed * time - (x - start_).x();
    total += (stiffness * lag / std::max(0.3, along.x()) + damping * (speed - v.dot(along))) * along;
    if (walls.size() == 1) {
      const space_vector side = walls[0].normal(x).cross(along);
      total -= (sideways * (x - start_).dot(side) + damping * v.dot(side)) * side;
    }
    return total;
  }

 private:
  static constexpr double stiffness = 200, sideways = 50, damping = 20;  // [N/m], [N/m], [N s/m]
  space_vector start_;
  double push_;
};

// Capacities [N m] of a controller of any law; runs are compiled once for all of them.
template <class M>
using any_control = std::function<space_vector(const ph::device_state<M>&)>;

template <class M>
ph::brakes_of<M> brakes_of(const setup& how) {
  ph::brakes_of<M> brakes;
  brakes.time_constant.setConstant(how.lag);
  return brakes;
}

template <class M>
space_result follow(const place<M>& at, const std::vector<touch>& walls, const any_control<M>& control,
                    const setup& how) {
  space_vector start = at.middle - at.length / 2 * space_vector::UnitX(), normal = space_vector::Zero();
  for (int k = 0; k < 50; ++k) {
    for (const touch& wall : walls) start += (gap - wall.distance(start)) * wall.normal(start);
  }
  for (const touch& wall : walls) normal += wall.normal(start);
  normal.normalize();
  const space_vector along = (space_vector::UnitX() - normal * normal.x()).normalized();

  ph::simulated_device plant(at.mechanism, brakes_of<M>(how), how.hand.mass, at.inverse(start));
  const ph::matrix<double, 3, 3> J(ph::jacobian(at.mechanism, plant.q()));
  plant.set_motion(plant.q(), J.partialPivLu().solve(speed * along - approach * normal));
  const hand person(start, how.hand.push);
  ph::joint_encoders<M> encoders(at.mechanism, {}, 1e-3);
  ph::force_sensor<double, 3> sensor({200, how.noise, how.seed});

  std::vector<ph::contact_meter> meters(walls.size(), ph::contact_meter(at.length, how.time_step));
  space_result result;
  const long steps = std::lround(max_time / how.time_step), cycle = std::lround(1e-3 / how.time_step);
  space_vector capacity = space_vector::Zero();
  for (long k = 0; k < steps; ++k) {
    const double time = static_cast<double>(k) * how.time_step;
    if (k % cycle == 0) {
      encoders.read(plant.q(), plant.qd());
      capacity = control({time, encoders.q(), encoders.qd(), sensor.read()});
    }
    const double friction_before = plant.energy().friction();
    plant.advance(how.time_step, capacity, person.force(time, plant.position(), plant.velocity(), walls));
    sensor.advance(how.time_step, plant.sensed_force());

    const double way = (plant.position() - start).x();
    std::vector<double> depths;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      depths.push_back(-walls[i].distance(plant.position()));
      meters[i].add(
          {way, depths[i], plant.rates()[1],
           -plant.brake_force().dot((space_vector::UnitX() - walls[i].normal(plant.position()) *
                                                                 walls[i].normal(plant.position()).x())
                                        .normalized()),
           plant.energy().friction() - friction_before, plant.brake_power().maxCoeff()});
    }
    if (k % (5 * cycle) == 0) result.trace.push_back({way, depths});
    if (way >= at.length) break;
  }
  for (const auto& meter : meters) result.figures.push_back(meter.result());
  result.energy = plant.energy();
  return result;
}

using any_wall = one_of<ph::half_space<3>, ph::ball<3>>;

template <class M, class... Walls>
space_result follow_walls(const place<M>& at, law which, const setup& how, const Walls&... shapes) {
  const auto under = [&](const auto& control_law) {
    const ph::held_scene scene(ph::scene(ph::wall(shapes)...), 1 / how.environment_rate);
    const any_control<M> control =
        [control = ph::controller(at.mechanism, brakes_of<M>(how), scene, control_law)](
            const ph::device_state<M>& state) mutable { return control(state).capacity; };
    return follow(at, {touch_of(shapes)...}, control, how);
  };
  switch (which) {
    case law::none: return under(ph::no_direct_control());
    case law::direct: return under(ph::direct_control());
    case law::velocity: return under(ph::velocity_direct_control());
    default: throw std::logic_error("not one of space_laws");
  }
}

template <class M>
space_result follow_at(const place<M>& at, space_wall wall, law which, const setup& how) {
  const space_vector& c = at.middle;
  const auto one = [&](const auto& shape) { return follow_walls(at, which, how, any_wall(shape)); };
  const auto edge = [&](double angle) {
    const double h = ph::radians(angle / 2);
    return follow_walls(at, which, how, ph::half_space<3>(c, {0, std::cos(h), std::sin(h)}),
                        ph::half_space<3>(c, {0, -std::cos(h), std::sin(h)}));
  };
  switch (wall) {
    case space_wall::plane: return one(ph::half_space<3>(c, {0, 0, 1}));
    case space_wall::solid_sphere: return one(ph::ball<3>(c - space_vector(0, 0, 0.1), 0.1));
    case space_wall::hollow_sphere:
      return one(ph::ball<3>(c + space_vector(0, 0, 0.2), 0.2, ph::filling::hollow));
    case space_wall::edge_90: return edge(90);
    case space_wall::edge_120: return edge(120);
  }
  throw std::logic_error("a wall without a case");
}

}  // namespace

std::string_view name_of(space_device which) { return which == space_device::delta ? "delta" : "3R arm"; }

std::string_view name_of(space_wall which) {
  switch (which) {
    case space_wall::plane: return "plane";
    case space_wall::solid_sphere: return "sphere";
    case space_wall::hollow_sphere: return "hollow sphere";
    case space_wall::edge_90: return "edge of 90 deg";
    case space_wall::edge_120: return "edge of 120 deg";
  }
  return "unknown wall";
}

space_result follow_in_space(space_device device, space_wall wall, law which, const setup& how) {
  if (device == space_device::delta) {
    const ph::delta<double> delta;
    const space_vector middle(0, 0, -0.14);
    return follow_at(place<ph::delta<double>>{delta, middle, 0.06, delta.inverse(middle).q}, wall, which,
                     how);
  }
  return follow_at(place<arm_3r>{arm_3r_of(1), {0.2, 0.03, 0.1}, 0.1, {0.2, 0.9, -1.5}}, wall, which, how);
}

}  // namespace experiments
