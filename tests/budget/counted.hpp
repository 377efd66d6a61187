// What callgrind counts: control cycles over fixed random input, one row a run.
#pragma once

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace budget {

namespace ph = passive_haptics;

inline constexpr unsigned seed = 20040627;
inline constexpr int inputs = 64, rounds = 100;
inline constexpr double period = 1e-3;  // of the cycles [s]

using row = std::function<void()>;  // one pass over the inputs
using rows_by_name = std::map<std::string, std::function<row()>>;

// A value that the optimiser must take for used
template <class X>
void use(const X& x) {
  asm volatile("" : : "g"(&x) : "memory");
}

enum class account { whole, command_alone };

template <class M>
std::vector<ph::device_state<M>> random_states(const M& mechanism) {
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension;
  ph::testing::random_source random(seed);
  std::vector<ph::device_state<M>> states;
  while (states.size() < inputs) {
    ph::device_state<M> s;
    s.time = period * static_cast<double>(states.size());
    s.q = T(1.2) * random.direction<T, n>();
    s.qd = random.direction<T, n>();
    s.hand_force = T(2) * random.direction<T, d>();
    if (ph::all_finite(mechanism.position(s.q))) states.push_back(s);
  }
  return states;
}

// Everything lies behind the walls, or nothing.
template <account Account = account::whole, class Law = ph::direct_control, class M, class... Walls>
row cycles(const M& mechanism, const Walls&... walls) {
  ph::controller control(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(walls, 1e3)...), Law());
  return [states = random_states(mechanism), control]() mutable {
    for (auto& s : states) {
      if constexpr (ph::needs_rising_time<Law>) s.time += inputs * period;
      if constexpr (Account == account::whole) use(control(s));
      else use(control.command(s));
    }
  };
}

// In front of a wall and behind it.
template <class M>
void add(rows_by_name& rows, const std::string& name, const M& mechanism) {
  using wall = ph::half_space<M::task_dimension>;
  const ph::point<M::task_dimension> out = ph::point<M::task_dimension>::Unit(0);
  rows[name + "/free"] = [=] { return cycles(mechanism, wall(-10 * out, out)); };
  rows[name + "/contact"] = [=] { return cycles(mechanism, wall(10 * out, out)); };
}

}  // namespace budget

// By its name callgrind finds it; a program includes this file once.
extern "C" [[gnu::noinline]] void counted(const budget::row& pass) {
  for (int k = 0; k < budget::rounds; ++k) pass();
}

namespace budget {

// Runs the row that the argument names; without one it lists them. The exit status.
inline int run(const rows_by_name& rows, int argc, char** argv) {
  if (argc != 2 || !rows.contains(argv[1])) {
    for (const auto& [name, make] : rows) std::printf("%s\n", name.c_str());
    return argc == 1 ? 0 : 2;
  }
  counted(rows.at(argv[1])());
  std::printf("cycles: %d\n", inputs * rounds);
  return 0;
}

}  // namespace budget
