// slow
// Effects: the laws of all, and each by hand. Friction of walls: resistance.cpp. Of joints: end_stops.cpp.
#include <passive_haptics/force/effect.hpp>
#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

namespace ph = passive_haptics;
using ph::testing::random_source;

namespace {

constexpr unsigned seed = 1985;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double band = ph::default_velocity_dead_band<double>;

template <class T, int D>
ph::detents<T, D> some_detents() {
  return ph::detents<T, D>({.origin = ph::vector<T, D>::Constant(T(0.1)),
                            .direction = ph::vector<T, D>::LinSpaced(T(1), T(2)),
                            .spacing = T(0.02),
                            .strength = T(3)});
}

template <class T, int D, ph::guide_along Along>
ph::guide<T, D> some_guide() {
  return ph::guide<T, D>({.along = Along,
                          .point = ph::vector<T, D>::Constant(T(0.1)),
                          .direction = ph::vector<T, D>::LinSpaced(T(1), T(2)),
                          .stiffness = T(500),
                          .tolerance = T(0.02),
                          .viscosity = T(5)});
}

template <class T, int D>
ph::viscous_field<T, D> some_field() {
  ph::matrix<T, D, D> B = ph::vector<T, D>::LinSpaced(T(0), T(20)).asDiagonal();
  B(0, 1) = T(7);  // across the motion
  B(1, 0) = T(-7);
  return ph::viscous_field<T, D>({.viscosity = B});
}

// Friction of a wall through the origin, as an effect.
template <class T, int D>
struct rough_wall {
  using scalar = T;
  static constexpr int dimension = D;
  ph::vector<T, D> force(const ph::vector<T, D>&, const ph::vector<T, D>& v,
                         const ph::vector<T, D>& Fh) const {
    const ph::vector<T, D> n = ph::vector<T, D>::LinSpaced(T(1), T(2)).normalized();
    return ph::wall_friction({.coefficient = T(0.4), .viscosity = T(3)}, n, T(6), v, Fh);
  }
};

template <class T, int D, class Check>
void for_each_effect(Check&& check) {
  check("detents", some_detents<T, D>());
  check("line guide", some_guide<T, D, ph::guide_along::line>());
  check("plane guide", some_guide<T, D, ph::guide_along::plane>());
  check("viscous field", some_field<T, D>());
  check("wall friction", rough_wall<T, D>());
}

template <class E>
using vector_of = ph::vector<typename E::scalar, E::dimension>;

// A position within 0.5 m, and a velocity of any size, one in eight along an axis.
template <class E>
std::pair<vector_of<E>, vector_of<E>> draw(random_source& random, int k) {
  using T = typename E::scalar;
  constexpr int D = E::dimension;
  const vector_of<E> x =
      random.between<T, D>(vector_of<E>::Constant(T(-0.5)), vector_of<E>::Constant(T(0.5)));
  const vector_of<E> way = k % 8 == 0 ? vector_of<E>::Unit(k % D) : random.direction<T, D>();
  return {x, random.wide(T(1e-6), T(1e2)) * way};
}

static_assert(ph::Effect<ph::detents<float, 2>> && ph::Effect<ph::guide<double, 3>>);
static_assert(ph::Effect<ph::viscous_field<double, 2>> && !ph::Effect<ph::end_stops<double, 2>>);
static_assert(ph::JointEffect<ph::end_stops<double, 2>> && !ph::JointEffect<ph::guide<double, 2>>);
static_assert(ph::WallEffect<ph::rough_walls<float, 3>> && !ph::Effect<ph::rough_walls<float, 3>>);
static_assert(!ph::Effect<ph::box<2>>);

}  // namespace

// It never drives the handle; by no more than its dead band while a hand pushes.
TEST(an_effect, takes_energy) {
  const auto check = [](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    using T = typename E::scalar;
    random_source random(seed);
    for (int k = 0; k < 4000; ++k) {
      const auto [x, v] = draw<E>(random, k);
      const vector_of<E> push = random.wide(T(1e-3), T(1e2)) * random.direction<T, E::dimension>();
      SCOPED_TRACE(::testing::Message() << name << ", seed " << seed << ", x = " << x.transpose()
                                        << ", v = " << v.transpose() << ", Fh = " << push.transpose());
      const vector_of<E> alone = effect.force(x, v, vector_of<E>::Zero()), F = effect.force(x, v, push);
      const T rounding = ph::rounding_tolerance<T>(E::dimension) * v.norm();
      ASSERT_LE(alone.dot(v), rounding * alone.norm());
      ASSERT_LE(F.dot(v), F.norm() * (ph::default_velocity_dead_band<T> + rounding));
    }
  };
  for_each_effect<double, 3>(check);
  for_each_effect<float, 2>(check);
}

TEST(an_effect, is_zero_at_rest_without_a_hand) {
  for_each_effect<double, 3>([](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    random_source random(seed);
    const vector_of<E> zero = vector_of<E>::Zero();
    for (int k = 0; k < 1000; ++k) {
      ASSERT_TRUE(effect.force(draw<E>(random, k).first, zero, zero).isZero(0)) << name;
    }
  });
}

TEST(an_effect, is_continuous_without_a_hand) {
  for_each_effect<double, 3>([](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    random_source random(seed);
    const vector_of<E> nobody = vector_of<E>::Zero();
    constexpr double step = 1e-9;
    // The steepest of all: 500 N/m at 0.9 m over the dead band, and 3 N 2 pi / 0.02 m.
    constexpr double steepest = 500 * 0.9 / band + 3 * 2 * std::numbers::pi / 0.02 + 500 + 25;
    for (int k = 0; k < 4000; ++k) {
      auto [x, v] = draw<E>(random, k);
      if (k % 2 == 0) v *= band / v.norm();  // at the edge of the dead band
      const vector_of<E> dx = step * random.direction<double, 3>(), dv = step * random.direction<double, 3>();
      const double jump = (effect.force(x + dx, v + dv, nobody) - effect.force(x, v, nobody)).norm();
      ASSERT_LE(jump, 2 * steepest * step)
          << name << ", seed " << seed << ", x = " << x.transpose() << ", v = " << v.transpose();
    }
  });
}

TEST(an_effect, of_a_nan_is_not_silent) {
  for_each_effect<double, 3>([](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    const vector_of<E> lost = vector_of<E>::Constant(std::numeric_limits<double>::quiet_NaN());
    for (const double speed : {-1.0, 0.0, 1.0}) {
      const vector_of<E> v = vector_of<E>::Constant(speed), zero = vector_of<E>::Zero();
      const bool position_matters = name[0] != 'v' && name[0] != 'w';
      EXPECT_TRUE(!position_matters || effect.force(lost, v, zero).hasNaN()) << name << ", speed " << speed;
    }
    EXPECT_TRUE(effect.force(vector_of<E>::Constant(0.3), lost, vector_of<E>::Zero()).hasNaN()) << name;
  });
}

TEST(effects, add_up) {
  const auto detents = some_detents<double, 2>();
  const auto field = some_field<double, 2>();
  const ph::vector<double, 2> x(0.3, 0.105), v(0.2, 0.3), Fh(1, 2);
  EXPECT_EQ(ph::total_force(x, v, Fh, detents, field), detents.force(x, v, Fh) + field.force(x, v, Fh));
  EXPECT_EQ(ph::total_force(x, v, Fh, field), field.force(x, v, Fh));
}

TEST(viscous_field, is_minus_B_v_of_a_B_that_drives_no_motion) {
  using parameters = ph::viscous_field_parameters<double, 2>;
  const ph::viscous_field<double, 2> field(parameters{ph::matrix<double, 2, 2>{{4, 0}, {0, 1}}});
  EXPECT_EQ(field.force({9, 9}, {0.5, 2}), (ph::vector<double, 2>(-2, -2)));
  random_source random(seed);
  for (const double size : {1e-9, 1.0, 1e9}) {
    EXPECT_EQ(validate(parameters{size * ph::matrix<double, 2, 2>{{1, 2}, {-2, 0}}}), "") << size;
    EXPECT_NE(validate(parameters{size * ph::matrix<double, 2, 2>{{1, 2}, {2, 0}}}), "") << size;
    const auto n = random.direction<double, 2>();  // free across it
    EXPECT_EQ(validate(parameters{size * n * n.transpose()}), "") << size << ", n = " << n.transpose();
  }
}

TEST(detents, resist_leaving_and_let_in_freely) {
  const ph::detents<double, 2> knob(
      {.origin = {0.1, 5}, .direction = {2, 0}, .spacing = 0.08, .strength = 3, .velocity_dead_band = 0.01});
  const auto force = [&](double x, double speed) { return knob.force({x, -7}, {speed, 1}).x(); };
  for (const int detent : {-3, 0, 2}) {
    const double at = 0.1 + 0.08 * detent;
    EXPECT_NEAR(force(at, 1), 0, 1e-12);
    EXPECT_NEAR(force(at + 0.02, 1), -3, 1e-12);
    EXPECT_NEAR(force(at + 0.01, 1), -3 / std::sqrt(2), 1e-12);
    EXPECT_NEAR(force(at - 0.02, -1), 3, 1e-12);
    EXPECT_EQ(force(at + 0.02, -1), 0);
    EXPECT_EQ(force(at - 0.02, 1), 0);
    EXPECT_NEAR(force(at + 0.02, 0.005), -1.5, 1e-12);
    EXPECT_NEAR(force(at + 0.0399999, 1), 0, 1e-4);
    EXPECT_NEAR(knob.offset({at + 0.03, 9}), 0.03, 1e-12);
    EXPECT_NEAR(knob.offset({at + 0.05, 9}), -0.03, 1e-12);
  }
  EXPECT_EQ(knob.force({0.12, 0}, {1, 0}).y(), 0);
}

TEST(detents, hold_a_handle_between_two_of_them) {
  const ph::detents<double, 2> knob({.spacing = 0.08, .strength = 3});
  const ph::vector<double, 2> rest(0, 0), leaving(0.02, 0);
  EXPECT_EQ(knob.force(leaving, rest, {2, 5}).x(), -2);
  EXPECT_EQ(knob.force(leaving, rest, {4, 5}).x(), -3);
  EXPECT_EQ(knob.force(leaving, rest, {-2, 5}).x(), 0);  // the way back is free
  EXPECT_EQ(knob.force(-leaving, rest, {-2, 5}).x(), 2);
}

TEST(a_guide, resists_leaving_beyond_its_tolerance_and_does_not_pull_back) {
  using vector = ph::vector<double, 3>;
  const ph::guide<double, 3> line(
      {.direction = {0, 0, 5}, .stiffness = 100, .tolerance = 0.1, .viscosity = 2});
  EXPECT_LE((line.force({0.3, 0.4, 9}, {3, 4, 7}) - vector(-24 - 6, -32 - 8, 0)).norm(), 1e-13);
  EXPECT_LE((line.force({0.3, 0.4, 9}, {-3, -4, 7}) - vector(6, 8, 0)).norm(), 1e-13);
  EXPECT_LE((line.force({0.03, 0.04, 9}, {3, 4, 7}) - vector(-6, -8, 0)).norm(), 1e-13);
  EXPECT_EQ(line.force({0, 0, 1}, {3, 4, 7}), vector(-6, -8, 0));
  EXPECT_LE((line.deviation({0.3, 0.4, 9}) - vector(0.3, 0.4, 0)).norm(), eps);

  const ph::guide<double, 3> plane(
      {.along = ph::guide_along::plane, .point = {0, 0, 1}, .direction = {0, 0, 5}, .stiffness = 100});
  EXPECT_EQ(plane.force({5, 5, 1.5}, {3, 4, 7}), vector(0, 0, -50));
  EXPECT_EQ(plane.force({5, 5, 0.5}, {3, 4, -7}), vector(0, 0, 50));
  EXPECT_EQ(plane.force({5, 5, 1.5}, {3, 4, -7}), vector(0, 0, 0));
  EXPECT_EQ(plane.force({5, 5, 1.5}, {0, 0, 0}, {1, 2, 3}), vector(0, 0, -3));
}

TEST(an_effect, says_what_is_wrong_with_its_parameters) {
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(validate(ph::wall_friction_parameters<double>{.coefficient = -1}),
            "coefficient of wall_friction = -1: expected a finite number >= 0");
  using guide = ph::guide_parameters<double, 3>;
  EXPECT_EQ(validate(guide{.direction = {0, no_number, 0}}),
            "|direction| of a guide = nan: expected a direction");
  EXPECT_EQ(validate(guide{.velocity_dead_band = 0}),
            "velocity_dead_band of a guide [m/s] = 0: expected a finite number > 0");
  using detents = ph::detents_parameters<double, 2>;
  EXPECT_EQ(validate(detents{.spacing = 1}), "");
  EXPECT_EQ(validate(detents{}), "spacing of detents [m] = 0: expected a finite number > 0");
  EXPECT_THROW((ph::detents<double, 2>(detents{})), std::invalid_argument);

  ph::viscous_field_parameters<double, 2> field;
  EXPECT_EQ(validate(field), "");
  field.viscosity << 1, 3, 3, 1;
  EXPECT_EQ(validate(field),
            "viscosity of a viscous_field would drive some motion: expected v . B v >= 0 for all v");
  field.viscosity << 1, 3, -3, 1;
  EXPECT_EQ(validate(field), "");
}
