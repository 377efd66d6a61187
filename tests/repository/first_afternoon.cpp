// The first table of docs/guide/troubleshooting.md: each mistake of a first afternoon is made, and says what
// stands there.
#include "headers.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace ph = passive_haptics;
using device = ph::two_link<double>;

const std::filesystem::path root = PASSIVE_HAPTICS_SOURCE_DIR;

// ---- what a compiler says: the regex that the first line of a file in tests/compile_fail expects

std::string expected_of(const std::string& name) {
  const std::string text = repository::read(root / "tests/compile_fail" / (name + ".cpp"));
  const std::string start = "// expect: ";
  EXPECT_EQ(text.rfind(start, 0), 0u) << name;
  const std::string line = text.substr(start.size(), text.find('\n') - start.size());
  const std::string ours = "passive_haptics: ";
  EXPECT_EQ(line.rfind(ours, 0), 0u) << name << ": the message is the library's";
  return line.substr(ours.size());
}

// ---- what a program says

struct hyperbola {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return q.cwiseInverse(); }
  ph::matrix<double, 2, 2> jacobian(const ph::vector<double, 2>& q) const {
    return (-q.cwiseInverse().cwiseAbs2()).asDiagonal();
  }
};

struct transmission_misspelt : device {
  ph::matrix<double, 2, 2> transmision() const { return ph::matrix<double, 2, 2>::Identity(); }
};

const ph::half_space<2> plane({0, 0.25}, {0, -1});
const ph::vector<double, 2> start(0.3, 1.2);  // the handle is under the plane, in free space

template <class M, class Scene>
std::string outcome_of(const M& mechanism, const Scene& scene, const ph::device_state<M>& state) {
  ph::controller control(mechanism, ph::brakes_of<M>(), scene, ph::no_direct_control());
  return std::string(to_string(control(state).outcome));
}

template <class Make>
std::string exception_of(const Make& make) {
  try {
    make();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

template <class M>
std::string at_the_start(const M& mechanism, const ph::half_space<2>& shape, const ph::joint_vector<M>& q,
                         double stiffness = 1e7) {
  return ph::plausibility(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(shape, stiffness)), q);
}

template <class Change>
std::string of_a_recording(const Change& change) {
  ph::simulated_device<device> simulated(device(), ph::brakes_of<device>(), 0.1, start);
  std::vector<ph::device_state<device>> states;
  for (int k = 0; k < 2000; ++k) {
    const double t = 1e-3 * k;
    const ph::vector<double, 2> push(0.6 * std::cos(9 * t), 0.5 * std::sin(7 * t));
    states.push_back({t, simulated.q(), simulated.qd(), push});
    simulated.advance(1e-3, {0, 0}, push);
  }
  for (auto& state : states) change(state);
  return ph::plausibility(device(), states);
}

std::string of_another_clock() {
  ph::scene_exchange exchange(ph::scene(ph::wall(plane)), 1.7e9);
  return outcome_of(device(), ph::latest_scene(exchange), {10, start, {0, 0}, {0, 0}});
}

struct steep_wall {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const { return x[1] - 100; }
  ph::point<2> gradient(const ph::point<2>&) const { return {0, 3}; }
};

const std::map<std::string, std::function<std::string()>> said{
    {"a misspelt optional member, `transmision()`",
     [] { return to_text(ph::describe(transmission_misspelt())); }},
    {"the time is never set",
     [] { return outcome_of(device(), ph::scene(ph::wall(plane)), ph::device_state<device>()); }},
    {"a normal of another length than 1",
     [] { return outcome_of(device(), ph::scene(ph::wall(steep_wall())), {0, start, {0, 0}, {0, 0}}); }},
    {"a position that divides by zero",
     [] { return outcome_of(hyperbola(), ph::scene(ph::wall(plane)), {0, {0, 1}, {0, 0}, {0, 0}}); }},
    {"a scene dated by another clock", of_another_clock},
    {"a negative stiffness", [] { return exception_of([] { ph::wall(plane, -1000); }); }},
    {"lengths in millimetres",
     [] { return at_the_start(device({.length_1 = 150, .length_2 = 150}), plane, start); }},
    {"joint positions in degrees", [] { return at_the_start(device(), plane, {35, 80}); }},
    {"a stiffness in N/mm", [] { return at_the_start(device(), plane, start, 10); }},
    {"a normal that points into the wall",
     [] {
       const ph::point<2> x = device().position(start);
       return at_the_start(device(), ph::half_space<2>({0, x[1] + 0.1}, {0, 1}), start);
     }},
    {"one state, never filled anew", [] { return of_a_recording([](auto& s) { s.time = 7; }); }},
    {"the time in milliseconds", [] { return of_a_recording([](auto& s) { s.time *= 1000; }); }},
    {"joint rates in degrees", [] { return of_a_recording([](auto& s) { s.qd *= ph::degrees(1.0); }); }},
    {"an encoder that counts backwards in the rates alone",
     [] { return of_a_recording([](auto& s) { s.qd *= -1; }); }},
    {"the force on the hand for the force on the handle",
     [] { return of_a_recording([](auto& s) { s.hand_force *= -1; }); }},
    {"a hand force in the frame of the sensor",
     [] { return of_a_recording([](auto& s) { s.hand_force = {-s.hand_force[1], s.hand_force[0]}; }); }},
};
const std::map<std::string, std::string> does_not_compile{
    {"the arguments of a controller in another order", "controller_with_brakes_first"},
    {"a controller without a law", "controller_without_a_law"},
    {"a shape without a wall", "shape_without_a_wall"},
    {"the radius of a ball before its centre", "ball_with_the_radius_first"},
    {"brakes of another size than the mechanism", "brakes_of_wrong_size"},
    {"`std::cos(q[0])` in `position`", "position_with_std_functions"},
    {"a task with orientation, of more than three components", "pose_task_in_space"},
    {"the time as a whole number of nanoseconds", "state_in_nanoseconds"},
    {"a law that needs a force sensor, a state without", "law_without_its_hand_force"},
};

TEST(first_afternoon, says_what_the_page_has) {
  static const std::regex row(R"(^\| ([^|]+) \| ([^|]+) \| `+ ?(.+?) ?`+ \|$)");
  std::istringstream page(repository::read(root / "docs/guide/troubleshooting.md"));
  std::size_t rows = 0;
  for (std::string line; std::getline(page, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    ++rows;
    const std::string mistake = match[1], message = match[3];
    if (does_not_compile.contains(mistake)) {
      EXPECT_TRUE(std::regex_search(message, std::regex(expected_of(does_not_compile.at(mistake)))))
          << message << "\nexpected: " << expected_of(does_not_compile.at(mistake));
    } else {
      ASSERT_TRUE(said.contains(mistake)) << mistake;
      EXPECT_NE(said.at(mistake)().find(message), std::string::npos)
          << mistake << ": " << said.at(mistake)() << "\nthe page: " << message;
    }
  }
  EXPECT_EQ(rows, said.size() + does_not_compile.size());
}

TEST(first_afternoon, has_nothing_to_say_where_all_is_right) {
  EXPECT_EQ(at_the_start(device(), plane, start), "");
  EXPECT_EQ(of_a_recording([](auto&) {}), "");
  EXPECT_EQ(outcome_of(device(), ph::scene(ph::wall(plane)), {0, start, {0, 0}, {0, 0}}), "ok");
}

}  // namespace
