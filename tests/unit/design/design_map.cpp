// Maps of what a device can do: figures on paper, points of a grid and of a path, errors, the table as text.
#include <passive_haptics/design/map/design_map_csv.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <gtest/gtest.h>

#include <array>

#include <cmath>
#include <limits>
#include <string>

namespace ph = passive_haptics;

namespace {

using table = ph::xy_table<double>;
using paper = ph::tendon_two_link<double>;
using V = ph::vector<double, 2>;

ph::switchable_brakes<table> limits(double x, double y) {
  ph::switchable_brakes<table> brakes;
  brakes.torque_limit = {x, y};
  return brakes;
}

TEST(design_map, figures_of_a_table_are_those_on_paper) {
  ph::task_points<table> points;
  const table device;
  const V n(0.6, 0.8), t(0.8, -0.6);
  for (const V& direction : {t, V(-t), V(n), V(-n)}) points.append(device, {V(0, 0), direction, n});
  const ph::design_map map(device, points, limits(1, 2), 2.0);
  ASSERT_EQ(map.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(map.outcome[k], ph::status::ok);
    EXPECT_EQ(map.isotropy[k], 1);
  }
  // Along t the x brake would drive: the y brake alone makes Fc = (0, 1.25), of 1 N along n
  EXPECT_EQ(map.display[0], ph::display_class::approximate);
  EXPECT_NEAR(map.cosine[0], 0.8, 1e-15);
  EXPECT_NEAR(map.drag[0], 0.75, 1e-15) << "0.6 * 1.25";
  EXPECT_NEAR(map.max_force[0], 1.6, 1e-15);
  EXPECT_NEAR(map.sink_slope[0], 4.0 / 3, 1e-15);
  // Against t the y brake would drive
  EXPECT_EQ(map.display[1], ph::display_class::approximate);
  EXPECT_NEAR(map.cosine[1], 0.6, 1e-15);
  EXPECT_NEAR(map.drag[1], 4.0 / 3, 1e-15);
  EXPECT_NEAR(map.max_force[1], 0.6, 1e-15);
  EXPECT_NEAR(map.sink_slope[1], 0.75, 1e-15);
  // Out of the wall both would drive
  EXPECT_EQ(map.display[2], ph::display_class::none);
  EXPECT_EQ(map.cosine[2], 0);
  EXPECT_TRUE(std::isnan(map.drag[2]));
  EXPECT_EQ(map.max_force[2], 0);
  EXPECT_EQ(map.sink_slope[2], 0) << "a hand that does not move along the wall is held";
  // Into it none
  EXPECT_EQ(map.display[3], ph::display_class::exact);
  EXPECT_EQ(map.cosine[3], 1);
  EXPECT_EQ(map.drag[3], 0);
  EXPECT_NEAR(map.max_force[3], 2.2, 1e-15);
}

TEST(design_map, points_out_of_reach_have_that_status_and_no_figures) {
  const paper arm;
  const ph::task_grid<double, 2> grid{{-0.4, 0.05}, {0.4, 0.25}, {5, 3}};
  const auto points = ph::points_of(
      arm, grid, [&](const V& x) { return arm.inverse(x, ph::elbow::left); }, V(1, 0), V(0, -1));
  const ph::design_map map(arm, points, ph::switchable_brakes<paper>(), 1.0);
  ASSERT_EQ(map.size(), 15u);
  int reached = 0;
  for (std::size_t k = 0; k < map.size(); ++k) {
    const V x = grid[k];
    EXPECT_EQ(points.position(k), x);
    EXPECT_NEAR(x[0], -0.4 + 0.2 * double(k % 5), 1e-15);
    EXPECT_NEAR(x[1], 0.05 + 0.1 * double(k / 5), 1e-15);
    EXPECT_EQ(map.outcome[k], x.norm() <= 0.3 ? ph::status::ok : ph::status::out_of_reach) << k;
    if (map.outcome[k] != ph::status::ok) {
      EXPECT_EQ(map.display[k], ph::display_class::none);
      EXPECT_TRUE(std::isinf(map.sink_slope[k]));
      continue;
    }
    ++reached;
    EXPECT_LT((arm.position(points[k].q) - x).norm(), 1e-15);
    const auto one = ph::design_figures_at(arm, points[k], ph::switchable_brakes<paper>(), 1.0);
    EXPECT_EQ(map.display[k], one.display);
    EXPECT_NEAR(map.cosine[k], one.cosine, 1e-14);
  }
  EXPECT_EQ(reached, 7);
}

TEST(design_map, becomes_another_map_in_the_same_arrays) {
  ph::design_map<paper> map;
  EXPECT_EQ(map.size(), 0u);
  const ph::task_grid<double, 2> grid{{-0.1, 0.1}, {0.1, 0.2}, {7, 5}};
  for (const double k2 : {0.4, 2.0}) {
    const paper arm({.reduction_2 = k2});
    const auto points = ph::points_of(
        arm, grid, [&](const V& x) { return arm.inverse(x, ph::elbow::left); }, V(1, 0), V(0, -1));
    const double* const before = map.drag.data();
    map.assign(arm, points, ph::switchable_brakes<paper>(), 1.0);
    if (before != nullptr) {
      EXPECT_EQ(map.drag.data(), before);
    }
    const ph::design_map fresh(arm, points, ph::switchable_brakes<paper>(), 1.0);
    for (std::size_t k = 0; k < map.size(); ++k) {
      EXPECT_EQ(map.display[k], fresh.display[k]);
      EXPECT_EQ(map.max_force[k], fresh.max_force[k]);
    }
  }
}

TEST(design_map, of_a_path_at_the_middles_of_its_parts) {
  const paper arm;
  const auto path = [&](double u) -> ph::path_point<paper> {
    return {arm.inverse(V(-0.05 + 0.1 * u, 0.225), ph::elbow::left).q, {1, 0}, {0, -1}};
  };
  const auto points = ph::points_of(arm, path, 4);
  ASSERT_EQ(points.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_LT((points.position(k) - V(-0.0375 + 0.025 * double(k), 0.225)).norm(), 1e-15);
  const auto broken =
      ph::points_of(arm, [](double) -> ph::path_point<paper> { return {V(NAN, 0), {1, 0}, {0, -1}}; }, 1);
  EXPECT_EQ(ph::design_map(arm, broken, ph::switchable_brakes<paper>(), 1.0).outcome[0],
            ph::status::state_not_finite);
}

template <class F>
std::string message_of(const F& f) {
  try {
    f();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

TEST(design_map, refuses_what_cannot_be) {
  const table device;
  ph::task_points<table> points;
  points.append(device, {V(0, 0), V(1, 0), V(0, 1)});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
      message_of([&] { ph::design_map(device, points, limits(1, nan), 1.0); }),
      "passive_haptics: torque_limit[1] for a design_map [N m] = nan: expected a number >= 0, or infinity");
  EXPECT_EQ(message_of([&] { ph::design_map(device, points, limits(1, 1), nan); }),
            "passive_haptics: push on a design_map [N] = nan: expected a number");
  const auto grid_of = [&](int columns, double left) {
    return message_of([&] {
      ph::points_of(
          device, ph::task_grid<double, 2>{{left, 0}, {1, 1}, {columns, 2}},
          [](const V& x) { return ph::joint_solution<double, 2>{x}; }, V(1, 0), V(0, 1));
    });
  };
  EXPECT_EQ(grid_of(1, 0),
            "passive_haptics: count[0] of a task_grid = 1: expected 2 or more points along each axis");
  EXPECT_EQ(grid_of(2, nan), "passive_haptics: lower[0] of a task_grid = nan: expected a finite number [m]");
  EXPECT_EQ(message_of([&] { ph::points_of(device, [](double) { return ph::path_point<table>(); }, 0); }),
            "passive_haptics: count of the points of a path = 0: expected 1 or more");
  EXPECT_EQ(
      grid_of(2'000'000'000, 0),
      "passive_haptics: size of a task_grid = 4000000000: expected at most 100000000; map the task in parts");
  EXPECT_EQ(message_of([&] {
              ph::points_of(device, [](double) { return ph::path_point<table>(); }, 1'000'000'000);
            }),
            "passive_haptics: count of the points of a path = 1000000000: expected at most 100000000; map "
            "the task in "
            "parts");
  EXPECT_EQ(message_of([&] {
              ph::to_csv(ph::task_points<table>(), ph::design_map(device, points, limits(1, 1), 1.0));
            }),
            "passive_haptics: number of points = 0: expected 1, the size of their design_map");
}

TEST(task_grid, has_the_greatest_size_if_its_points_cannot_be_counted) {
  constexpr int most = std::numeric_limits<int>::max();
  const auto size = [](const std::array<int, 3>& count) {
    return ph::task_grid<double, 3>{{0, 0, 0}, {1, 1, 1}, count}.size();
  };
  EXPECT_EQ(size({most, most, most}), std::numeric_limits<std::size_t>::max());
  EXPECT_EQ(size({most, most, 2}), 2 * std::size_t(most) * std::size_t(most));
  EXPECT_EQ(size({most, most, -2}), 0U);
}

// Beyond 4.5e11 rad neighbouring numbers are more than 1e-4 rad apart.
TEST(design_map, of_joint_positions_without_a_meaningful_sine_has_no_figures) {
  ph::task_points<paper> points;
  for (const double turns : {0.0, 1e3, 1e11, 1e12, 1e300}) {
    points.append(paper(), {V(1.88, -1.3 + turns), V(1, 0), V(0, -1)});
    points.append(paper(), {V(1.88 - turns, -1.3), V(1, 0), V(0, -1)});
  }
  const ph::design_map map(paper(), points, ph::switchable_brakes<paper>(), 1.0);
  for (std::size_t k = 0; k < map.size(); ++k) {
    const auto alone = ph::design_figures_at(paper(), points[k], ph::switchable_brakes<paper>(), 1.0);
    EXPECT_EQ(map.outcome[k], k < 6 ? ph::status::ok : ph::status::pose_undefined) << k;
    EXPECT_EQ(alone.outcome, map.outcome[k]) << k;
  }
}

TEST(design_map, as_text) {
  const table device;
  ph::task_points<table> points;
  points.append(device, {V(0.1, 0.2), V(1, 0), V(0, 1)});
  points.append({V(0, 0), V(1, 0), V(0, 1)}, V(9, 9), ph::status::out_of_reach);
  EXPECT_EQ(ph::to_csv(points, ph::design_map(device, points, limits(1, 2), 1.0)),
            "x1 [m],x2 [m],q1,q2,outcome,display,gamma [rad],drag [1],max force [N],sink slope [1],"
            "isotropy [1]\n"
            "0.1,0.2,0.1,0.2,\"ok\",exact,0,0,2,0,1\n"
            "9,9,0,0,\"out of reach\",none,1.5707963267948966,nan,0,inf,0\n");
}

}  // namespace
