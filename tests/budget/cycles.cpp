// What callgrind counts: control cycles and projections over fixed random input, one row a run. Without an
// argument it lists the rows.
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr int inputs = 64, rounds = 100;
constexpr double period = 1e-3;  // of the cycles [s]

using row = std::function<void()>;  // one pass over the inputs

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

// A wall with its normal at this angle to the x axis, behind which everything lies
ph::half_space<2> wall_around(double degrees) {
  const ph::point<2> out(std::cos(ph::radians(degrees)), std::sin(ph::radians(degrees)));
  return {10 * out, out};
}

// Position and Jacobian of a chain of six joints, roughly a human arm
row poses() {
  const auto at = [](double x) { return ph::point<3>(x, 0, 0.1); };
  const auto X = ph::point<3>::UnitX(), Y = ph::point<3>::UnitY(), Z = ph::point<3>::UnitZ();
  const ph::serial_chain<double, 6, 3> arm(ph::serial_chain_parameters<double, 6, 3>{
      .joints = {ph::revolute_joint<double>(Z, at(0)), ph::revolute_joint<double>(Y, at(0)),
                 ph::revolute_joint<double>(X, at(0)), ph::revolute_joint<double>(Y, at(0.25)),
                 ph::revolute_joint<double>(Z, at(0.5)), ph::revolute_joint<double>(Y, at(0.5))},
      .handle = ph::point<3>(0.6, 0, 0.1)});
  return [arm, states = random_states(arm)] {
    for (const auto& s : states) {
      const ph::mechanism_pose here(arm, s.q);
      use(here.position());
      use(here.jacobian());
    }
  };
}

// Seven joints in space that turn about z, y and x in turns: 35 sets of brakes may come to rest
ph::serial_chain<double, 7, 3> seven_joints() {
  ph::serial_chain_parameters<double, 7, 3> p;
  for (int i = 0; i < 7; ++i)
    p.joints[std::size_t(i)] =
        ph::revolute_joint<double>(ph::point<3>::Unit(2 - i % 3), ph::point<3>(0.1 * i, 0, 0.02 * i));
  p.handle = {0.7, 0, 0.1};
  return ph::serial_chain<double, 7, 3>(p);
}

// Half-spaces to begin with: none, the right ones, those of another problem, as after a jump.
enum class start { none, right, wrong };

template <int N>
row projections(start with) {
  ph::testing::random_source random(seed);
  struct problem {
    ph::matrix<double, N, N> B;
    ph::vector<double, N> f;
    ph::half_space_start start;
  };
  std::vector<problem> all(inputs);
  ph::half_space_start before;
  for (problem& p : all) {
    for (int j = 0; j < N; ++j) p.B.col(j) = random.normal_vector<double, N>();
    p.f = random.direction<double, N>();
    ph::half_space_start own;
    ph::project_onto_half_spaces(p.B, p.f, own);
    if (with != start::none) p.start = with == start::right ? own : before;
    before = own;
  }
  return [all] {
    for (const problem& p : all) {
      ph::half_space_start begin = p.start;
      use(ph::project_onto_half_spaces(p.B, p.f, begin));
    }
  };
}

template <class M>
void add(std::map<std::string, std::function<row()>>& rows, const std::string& name, const M& mechanism) {
  using wall = ph::half_space<M::task_dimension>;
  const ph::point<M::task_dimension> out = ph::point<M::task_dimension>::Unit(0);
  rows[name + "/free"] = [=] { return cycles(mechanism, wall(-10 * out, out)); };
  rows[name + "/contact"] = [=] { return cycles(mechanism, wall(10 * out, out)); };
}

std::map<std::string, std::function<row()>> all_rows() {
  std::map<std::string, std::function<row()>> rows;
  add(rows, "two_link", ph::two_link<double>());
  add(rows, "tendon_two_link", ph::tendon_two_link<double>());
  const auto commands = [](const auto&... walls) {
    return cycles<account::command_alone>(ph::tendon_two_link<double>(), walls...);
  };
  const auto a = wall_around(10), b = wall_around(115), c = wall_around(200), d = wall_around(300);
  rows["tendon_two_link/command"] = [=] { return commands(wall_around(0)); };
  rows["tendon_two_link/command_of_velocity_control"] = [=] {
    return cycles<account::command_alone, ph::velocity_direct_control>(ph::tendon_two_link<double>(),
                                                                       wall_around(0));
  };
  rows["tendon_two_link/command_of_2_walls"] = [=] { return commands(a, b); };
  rows["tendon_two_link/command_of_3_walls"] = [=] { return commands(a, b, c); };
  rows["tendon_two_link/command_of_4_walls"] = [=] { return commands(a, b, c, d); };
  rows["tendon_two_link/2_walls"] = [=] { return cycles(ph::tendon_two_link<double>(), a, b); };
  rows["chain_of_6/pose_and_jacobian"] = poses;
  add(rows, "tendon_two_link_float", ph::tendon_two_link<float>());
  add(rows, "xy_table", ph::xy_table<double>());
  // Far from 8 and from 32 walls
  const auto far_from = []<int... k>(std::integer_sequence<int, k...>) {
    const auto wall = [](int i) { return ph::half_space<2>({-10, 0}, {1, 0.01 * i}); };
    return cycles<account::command_alone>(ph::xy_table<double>(), wall(k)...);
  };
  rows["xy_table/free_of_8_walls"] = [=] { return far_from(std::make_integer_sequence<int, 8>()); };
  rows["xy_table/free_of_32_walls"] = [=] { return far_from(std::make_integer_sequence<int, 32>()); };
  add(rows, "five_bar", ph::five_bar<double>());
  add(rows, "delta", ph::delta<double>());
  add(rows, "settled_3", ph::serial_chain<double, 3, 2>(ph::planar_arm<double>(std::array{0.15, 0.15, 0.1})));
  add(rows, "settled_7", seven_joints());
  rows["cone_2"] = [] { return projections<2>(start::none); };
  rows["cone_3"] = [] { return projections<3>(start::none); };
  rows["cone_4"] = [] { return projections<4>(start::none); };
  rows["cone_6"] = [] { return projections<6>(start::none); };
  rows["cone_7"] = [] { return projections<7>(start::none); };
  rows["cone_3_warm"] = [] { return projections<3>(start::right); };
  rows["cone_4_warm"] = [] { return projections<4>(start::right); };
  rows["cone_6_warm"] = [] { return projections<6>(start::right); };
  rows["cone_7_warm"] = [] { return projections<7>(start::right); };
  rows["cone_4_wrong"] = [] { return projections<4>(start::wrong); };
  rows["cone_6_wrong"] = [] { return projections<6>(start::wrong); };
  rows["cone_7_wrong"] = [] { return projections<7>(start::wrong); };
  return rows;
}

}  // namespace

extern "C" [[gnu::noinline]] void counted(const row& pass) {
  for (int k = 0; k < rounds; ++k) pass();
}

int main(int argc, char** argv) {
  const auto rows = all_rows();
  if (argc != 2 || !rows.contains(argv[1])) {
    for (const auto& [name, make] : rows) std::printf("%s\n", name.c_str());
    return argc == 1 ? 0 : 2;
  }
  counted(rows.at(argv[1])());
  std::printf("cycles: %d\n", inputs * rounds);
}
