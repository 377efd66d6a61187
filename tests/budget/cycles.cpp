// Cycles and projections.
#include "counted.hpp"

#include <cmath>
#include <utility>

namespace {

using namespace budget;

// A wall with its normal at this angle to the x axis, behind which everything lies
ph::half_space<2> wall_around(double degrees) {
  const ph::point<2> out(std::cos(ph::radians(degrees)), std::sin(ph::radians(degrees)));
  return {10 * out, out};
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

rows_by_name all_rows() {
  rows_by_name rows;
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

int main(int argc, char** argv) { return run(all_rows(), argc, argv); }
