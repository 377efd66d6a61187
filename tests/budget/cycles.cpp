// What callgrind counts: control cycles and projections over fixed random input, one row a run. Without an
// argument it lists the rows.
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr int inputs = 64, rounds = 100;

using row = std::function<void()>;  // one pass over the inputs

// A value that the optimiser must take for used
template <class X>
void use(const X& x) {
  asm volatile("" : : "g"(&x) : "memory");
}

enum class account { whole, command_alone };

template <account Account = account::whole, class M>
row cycles(const M& mechanism, bool in_contact) {
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension;
  ph::testing::random_source random(seed);
  const ph::point<d> out = ph::point<d>::Unit(0);
  std::vector<ph::device_state<M>> states;
  while (states.size() < inputs) {
    ph::device_state<M> s;
    s.q = T(1.2) * random.direction<T, n>();
    s.qd = random.direction<T, n>();
    s.hand_force = T(2) * random.direction<T, d>();
    if (ph::all_finite(mechanism.position(s.q))) states.push_back(s);
  }
  const ph::half_space<d> wall((in_contact ? 10 : -10) * out, out);  // everything lies behind it, or nothing
  ph::controller control(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(wall, 1e3)), ph::direct_control());
  return [states, control]() mutable {
    for (const auto& s : states) {
      if constexpr (Account == account::whole) use(control(s));
      else use(control.command(s));
    }
  };
}

template <int N>
row projections(bool warm) {
  ph::testing::random_source random(seed);
  struct problem {
    ph::matrix<double, N, N> B;
    ph::vector<double, N> f;
    ph::half_space_set start;
  };
  std::vector<problem> all(inputs);
  for (problem& p : all) {
    for (int j = 0; j < N; ++j) p.B.col(j) = random.normal_vector<double, N>();
    p.f = random.direction<double, N>();
    p.start = warm ? ph::project_onto_half_spaces(p.B, p.f).active : 0u;
  }
  return [all] {
    for (const problem& p : all) use(ph::project_onto_half_spaces(p.B, p.f, p.start));
  };
}

template <class M>
void add(std::map<std::string, std::function<row()>>& rows, const std::string& name, const M& mechanism) {
  rows[name + "/free"] = [=] { return cycles(mechanism, false); };
  rows[name + "/contact"] = [=] { return cycles(mechanism, true); };
}

std::map<std::string, std::function<row()>> all_rows() {
  std::map<std::string, std::function<row()>> rows;
  add(rows, "two_link", ph::two_link<double>());
  add(rows, "tendon_two_link", ph::tendon_two_link<double>());
  rows["tendon_two_link/command"] = [] {
    return cycles<account::command_alone>(ph::tendon_two_link<double>(), true);
  };
  add(rows, "tendon_two_link_float", ph::tendon_two_link<float>());
  add(rows, "xy_table", ph::xy_table<double>());
  add(rows, "five_bar", ph::five_bar<double>());
  add(rows, "delta", ph::delta<double>());
  rows["cone_2"] = [] { return projections<2>(false); };
  rows["cone_3"] = [] { return projections<3>(false); };
  rows["cone_4"] = [] { return projections<4>(false); };
  rows["cone_6"] = [] { return projections<6>(false); };
  rows["cone_7"] = [] { return projections<7>(false); };
  rows["cone_3_warm"] = [] { return projections<3>(true); };
  rows["cone_4_warm"] = [] { return projections<4>(true); };
  rows["cone_6_warm"] = [] { return projections<6>(true); };
  rows["cone_7_warm"] = [] { return projections<7>(true); };
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
