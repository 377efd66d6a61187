// Memories of the walls that are touched, and the limit on their number.
#include "../support.hpp"

#include <passive_haptics/control/laws/contact_memory.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <cmath>
#include <initializer_list>
#include <utility>

namespace {

// The contacts of a cycle: a wall number and the angle of the normal [degrees] each.
ph::contacts<2, 8> touched_at(std::initializer_list<std::pair<int, double>> walls) {
  ph::contacts<2, 8> touched;
  for (const auto& [wall, angle] : walls)
    touched.push_back(
        {.normal = {std::cos(ph::radians(angle)), std::sin(ph::radians(angle))}, .wall_number = wall});
  return touched;
}

TEST(contact_memory, is_a_walls_own_while_it_is_touched) {
  ph::contact_memory<int, 8> memory;
  memory.begin_cycle(touched_at({{7, 90}, {9, 90}}));
  memory[0] = 70;
  memory[1] = 90;
  memory.begin_cycle(touched_at({{9, 90}, {7, 90}}));
  EXPECT_EQ(memory[0], 90);
  EXPECT_EQ(memory[1], 70);
  memory.begin_cycle(touched_at({{9, 80}}));
  memory.begin_cycle(touched_at({{7, 90}, {9, 75}}));
  EXPECT_EQ(memory[0], 0) << "it was not touched in between";
  EXPECT_EQ(memory[1], 90);
  memory.clear();
  memory.begin_cycle(touched_at({{9, 75}}));
  EXPECT_EQ(memory[0], 0);
}

TEST(contact_memory, is_each_faces_own_of_one_wall) {
  ph::contact_memory<int, 8> memory;
  memory.begin_cycle(touched_at({{7, 60}}));
  memory[0] = 60;
  memory.begin_cycle(touched_at({{7, 120}, {7, 62}}));
  EXPECT_EQ(memory[0], 0) << "another face of the same wall";
  EXPECT_EQ(memory[1], 60);
  memory[0] = 120;
  memory.begin_cycle(touched_at({{7, 150}}));
  EXPECT_EQ(memory[0], 120) << "the nearest normal, however far it turned";
}

// Between two blocks side by side: the second is near, with its flank, before its top takes over.
TEST(contact_memory, goes_on_across_a_seam) {
  ph::contact_memory<int, 8> memory;
  memory.begin_cycle(touched_at({{1, 90}, {2, 180}}));
  memory[0] = 90;
  memory[1] = 180;
  memory.begin_cycle(touched_at({{1, 0}, {2, 91}}));
  EXPECT_EQ(memory[0], 0);
  EXPECT_EQ(memory[1], 90);
  memory.begin_cycle(touched_at({{3, 130}}));
  EXPECT_EQ(memory[0], 0) << "no seam but an edge";
}

struct law_of_two_walls {
  static constexpr bool commands_torques = true;
  static constexpr int max_contacts = 2;
  template <class B>
  double margin(const B&) const noexcept {
    return 1e-2;
  }
  template <class Situation, class Contacts>
  auto torque(const Situation& now, const Contacts&) const noexcept {
    return (-now.s).eval();
  }
};

// Beyond max_contacts a law would share a memory between two walls. Walls that are only near do not count.
TEST(contact_memory, of_more_walls_than_a_law_remembers_releases_the_brakes) {
  using M = ph::xy_table<double>;
  const auto outcome = [](int walls, int near) {
    ph::contacts<2, 3> touched;
    for (int k = 0; k < walls + near; ++k)
      touched.push_back(
          {.normal = {0, -1}, .depth = k < near ? -1e-3 : 1e-3, .stiffness = 1e3, .wall_number = k});
    ph::step_memory<law_of_two_walls> memory;
    const auto result =
        ph::step(M(), ph::brakes_of<M>(), touched, law_of_two_walls(), state_of<M>({0, 0}, {0.3, 2}), memory);
    EXPECT_EQ(result.outcome == ph::status::ok, result.capacity.norm() > 0);
    return result.outcome;
  };
  EXPECT_EQ(outcome(2, 1), ph::status::ok);
  EXPECT_EQ(outcome(3, 0), ph::status::too_many_contacts);
}

}  // namespace
