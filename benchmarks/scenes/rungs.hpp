// A ladder of static scenes: each rung adds one need to the one before. What a rung does not need must cost
// it nothing. benchmarks/scenes times it, tests/budget counts its instructions.
#pragma once

#include "table_by_hand.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ladder {

namespace ph = passive_haptics;

constexpr unsigned seed = 20040627;
constexpr int inputs = 64;
constexpr double period = 1e-3;    // of the cycles [s]
constexpr double stiffness = 1e3;  // [N/m]
const ph::point<2> normal(0.6,
                          0.8);  // slanted: some forces are displayed exactly, some nearly, some not at all
enum class place { free, contact };  // everything lies in front of the wall, or behind it

using row = std::function<void()>;  // one pass over the inputs

// A value that the optimiser must take for used
template <class X>
void use(const X& x) {
  asm volatile("" : : "g"(&x) : "memory");
}

struct rung {
  std::string name, adds;
  std::function<row(place)> make;
};

// ---- brakes of which the first rungs know only a part

struct limited_brakes {
  ph::vector<double, 2> torque_limit = ph::vector<double, 2>::Ones();
};
struct sticking_brakes : limited_brakes {
  ph::vector<double, 2> rate_dead_band = ph::vector<double, 2>::Constant(0.02);
};

// ---- states: random poses and rates, every eighth with one joint at rest

template <class State, class M>
std::vector<State> states() {
  constexpr int n = M::dof;
  ph::testing::random_source random(seed);
  std::vector<State> all(inputs);
  for (int k = 0; k < inputs; ++k) {
    State& s = all[static_cast<std::size_t>(k)];
    s.time = k * period;
    s.q = 1.2 * random.direction<double, n>();
    s.qd = random.direction<double, n>();
    if (k % 8 == 0) s.qd[k / 8 % n] = 0;
    const ph::vector<double, 2> push = 2 * random.direction<double, 2>();
    if constexpr (ph::HandForceState<State, M>) s.hand_force = push;
  }
  return all;
}

// ---- walls

inline ph::half_space<2> plane(place where) {
  return {(where == place::contact ? 10 : -10) * normal, normal};
}
// A second wall that is not touched
inline ph::half_space<2> far_plane() { return {ph::point<2>(-10, 0), ph::point<2>(1, 0)}; }

template <class State, class M, class Brakes, class Scene, class Law>
row cycles(const M& mechanism, const Brakes& brakes, const Scene& scene, const Law& law) {
  ph::controller control(mechanism, brakes, scene, law);
  return [all = states<State, M>(), control]() mutable {
    for (State& s : all) {
      if constexpr (ph::needs_rising_time<Law>) s.time += inputs * period;
      use(control.command(s));
    }
  };
}

inline row by_hand_cycles(place where) {
  using table = ph::xy_table<double>;
  const ph::point<2> surface = (where == place::contact ? 10 : -10) * normal;
  const by_hand::wall wall{normal[0], normal[1], surface[0], surface[1], stiffness};
  const double min_cosine = ph::step_options<double>().min_cosine;
  std::vector<by_hand::measurement> all;
  for (const auto& s : states<ph::sensorless_device_state<table>, table>())
    all.push_back({s.time, s.q[0], s.q[1], s.qd[0], s.qd[1]});
  return [all, wall, min_cosine] {
    for (const auto& at : all) use(by_hand::step(wall, min_cosine, at));
  };
}

// In the order of the ladder
inline std::vector<rung> rungs() {
  using table = ph::xy_table<double>;
  using arm = ph::two_link<double>;
  using tendons = ph::tendon_two_link<double>;
  using unsensed = ph::sensorless_device_state<table>;
  using sensed = ph::device_state<table>;

  const auto one = [](place where) { return ph::scene(ph::wall(plane(where), stiffness)); };
  const auto two = [](place where) {
    return ph::scene(ph::wall(plane(where), stiffness), ph::wall(far_plane(), stiffness));
  };
  const auto moving = [](place where) {
    ph::moving carried(plane(where));
    carried.set_motion({0, 0}, {0.01, 0.02});
    return ph::scene(ph::wall(carried, stiffness), ph::wall(far_plane(), stiffness));
  };
  const ph::no_direct_control whole;
  const ph::direct_control direct;

  return {
      {"by_hand", "XY table, one half-space, by hand", by_hand_cycles},
      {"unlimited", "the same by the library",
       [=](place p) { return cycles<unsensed>(table(), ph::unlimited_brakes(), one(p), whole); }},
      {"limits", "torque limits",
       [=](place p) { return cycles<unsensed>(table(), limited_brakes(), one(p), whole); }},
      {"dead_bands", "dead bands of the rates",
       [=](place p) { return cycles<unsensed>(table(), sticking_brakes(), one(p), whole); }},
      {"hand_force", "hand force, for brakes at rest",
       [=](place p) { return cycles<sensed>(table(), ph::brakes_of<table>(), one(p), whole); }},
      {"direct_control", "direct_control",
       [=](place p) { return cycles<sensed>(table(), ph::brakes_of<table>(), one(p), direct); }},
      {"second_wall", "a second wall, not touched",
       [=](place p) { return cycles<sensed>(table(), ph::brakes_of<table>(), two(p), direct); }},
      {"moving_wall", "a moving wall",
       [=](place p) { return cycles<sensed>(table(), ph::brakes_of<table>(), moving(p), direct); }},
      {"jacobian", "a Jacobian of the pose: two links",
       [=](place p) {
         return cycles<ph::device_state<arm>>(arm(), ph::brakes_of<arm>(), moving(p), direct);
       }},
      {"transmission", "a transmission: tendons",
       [=](place p) {
         return cycles<ph::device_state<tendons>>(tendons(), ph::brakes_of<tendons>(), moving(p), direct);
       }},
      {"velocity_control", "velocity_direct_control",
       [=](place p) {
         return cycles<ph::device_state<tendons>>(tendons(), ph::brakes_of<tendons>(), moving(p),
                                                  ph::velocity_direct_control());
       }},
  };
}

}  // namespace ladder
