// slow
// Maps in closed form against the figures point by point; the share of exact display over all directions.
#include <passive_haptics/design/map/design_map.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ph = passive_haptics;

namespace {

// Random poses, directions and normals, every third direction oblique to the wall, and special ones
template <class M>
ph::task_points<M> random_points(const M& mechanism, int count) {
  ph::testing::random_source random(20260);
  ph::task_points<M> points;
  for (int k = 0; k < count; ++k) {
    ph::path_point<M> at;
    for (int i = 0; i < M::dof; ++i) at.q[i] = random.uniform(-2.0, 2.0);
    for (int i = 0; i < M::task_dimension; ++i) {
      at.direction[i] = random.uniform(-1.0, 1.0);
      at.normal[i] = random.uniform(-1.0, 1.0);
    }
    if (k % 3 != 0) at.direction -= at.normal * at.normal.dot(at.direction) / at.normal.squaredNorm();
    switch (k % 200) {
      case 1: at.q[M::dof - 1] = 0; break;  // straight: singular
      case 2: at.direction.setZero(); break;
      case 3: at.normal.setZero(); break;
      case 4: at.direction = at.normal; break;
      case 5: at.q[0] = std::numeric_limits<double>::quiet_NaN(); break;
      case 6: at.direction *= 1e-300; break;
      case 7: at.normal *= 1e200; break;
      case 8: at.q[M::dof - 1] = 1e-9; break;
      default: break;
    }
    points.append(mechanism, at);
  }
  return points;
}

template <class M>
void expect_the_figures_of_each_point(const M& mechanism, const ph::hybrid_brakes<M>& brakes, int count) {
  const auto points = random_points(mechanism, count);
  const double push = 3;
  const ph::design_map map(mechanism, points, brakes, push);
  int classes[4] = {};
  for (std::size_t k = 0; k < map.size(); ++k) {
    const auto one = ph::design_figures_at(mechanism, points[k], brakes, push);
    ASSERT_EQ(map.outcome[k], one.outcome) << k;
    ASSERT_EQ(map.display[k], one.display) << k;
    if (one.outcome != ph::status::ok) continue;
    ++classes[int(one.display)];
    const auto compare = [&](double x, double y) {
      if (x == y || (std::isnan(x) && std::isnan(y))) return;
      const double difference = std::abs(x - y) / (1 + std::abs(y));
      EXPECT_LT(difference, 1e-9) << k << ": " << x << " " << y;
    };
    compare(map.cosine[k], one.cosine);
    compare(map.drag[k], one.drag);
    compare(map.max_force[k], one.max_force);
    compare(map.sink_slope[k], one.sink_slope);
    compare(map.isotropy[k], one.isotropy);
    if (::testing::Test::HasFailure()) return;
  }
  const bool some_are_off = (brakes.brakes.torque_lower.array() == 0.0).any();
  EXPECT_EQ(classes[int(ph::display_class::exact)] > count / 50, !some_are_off);
  EXPECT_GT(classes[int(ph::display_class::approximate)], count / 50);
}

template <class M>
ph::hybrid_brakes<M> ordinary_brakes(double motor = 0) {
  ph::hybrid_brakes<M> brakes;
  for (int i = 0; i < M::brake_count; ++i) brakes.brakes.torque_limit[i] = 1 + i;
  brakes.motor_limit.setConstant(motor);
  return brakes;
}

// J by differentiation, and a transmission that depends on the pose
struct arm_of_ones_own {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, 2>& q) const {
    return ph::two_link<double>().position(q);
  }
  ph::matrix<double, 2, 2> transmission(const ph::vector<double, 2>& q) const {
    return ph::matrix_of<2, 2>(1.0, 0.4 * std::sin(q[1]), 0.0, 1.5 + 0.5 * std::cos(q[0]));
  }
};
static_assert(!ph::design_map<ph::two_link<float>>::has_closed_form, "its bounds are those of double");

TEST(design_map_points, of_devices_with_a_closed_form) {
  const auto compare = [](const auto& mechanism) {
    using M = std::remove_cvref_t<decltype(mechanism)>;
    static_assert(ph::design_map<M>::has_closed_form);
    for (const double motor : {0.0, 0.1})
      expect_the_figures_of_each_point(mechanism, ordinary_brakes<M>(motor), 2001);
    auto unlimited = ordinary_brakes<M>();
    unlimited.brakes.torque_limit.setConstant(std::numeric_limits<double>::infinity());
    expect_the_figures_of_each_point(mechanism, unlimited, 600);
    auto off = ordinary_brakes<M>();
    off.brakes.switch_off(0);
    expect_the_figures_of_each_point(mechanism, off, 600);
  };
  compare(ph::tendon_two_link<double>());
  compare(arm_of_ones_own());
}

TEST(design_map_points, of_all_others) {
  using M = ph::delta<double>;
  static_assert(!ph::design_map<M>::has_closed_form);
  expect_the_figures_of_each_point(M(), ordinary_brakes<M>(), 400);
}

// phi: the angle between the end effector's velocities by which only one of the brakes turns. The signs of a
// direction and of a force are independent, so a fraction of phi / pi of the directions has either pair of
// signs in common, and so on: the share of docs/guide/design.md.
TEST(design_map_points, exact_over_all_directions_of_motion_and_of_force) {
  using tendon = ph::tendon_two_link<double>;
  using pair = ph::vector<double, 2>;
  constexpr int directions = 300;
  const double pi = std::numbers::pi;
  const pair q(0.9, -1.7);
  const auto unit = [&](double k) {
    return pair(std::cos(2 * pi * k / directions), std::sin(2 * pi * k / directions));
  };
  ph::task_points<tendon> points;
  for (int i = 0; i < directions; ++i)
    for (int j = 0; j < directions; ++j) points.append({q, unit(i + 0.5), unit(j + 0.5)}, pair::Zero());
  const ph::design_map map(tendon(), points, ordinary_brakes<tendon>(), 1.0);
  const auto exact = std::count(map.display.begin(), map.display.end(), ph::display_class::exact);
  const auto E = ph::brake_jacobian(tendon(), q);
  const pair v1 = E.col(0), v2 = E.col(1);
  const double phi = std::atan2(std::abs(ph::cross_in_plane(v1, v2)), v1.dot(v2));
  EXPECT_NEAR(double(exact) / double(map.size()), phi * (pi - phi) / (pi * pi), 5e-3) << phi;
}

}  // namespace
