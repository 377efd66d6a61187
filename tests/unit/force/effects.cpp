// slow
#include <passive_haptics/passive_haptics.hpp>
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

template <class Check>
void for_each_effect_scalar_and_dimension(Check&& check) {
  for_each_effect<double, 2>(check);
  for_each_effect<double, 3>(check);
  for_each_effect<float, 2>(check);
  for_each_effect<float, 3>(check);
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

TEST(an_effect, never_drives_the_handle) {
  for_each_effect_scalar_and_dimension([](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    using T = typename E::scalar;
    random_source random(seed);
    const vector_of<E> nobody = vector_of<E>::Zero();
    for (int k = 0; k < 20000; ++k) {
      const auto [x, v] = draw<E>(random, k);
      const vector_of<E> F = effect.force(x, v, nobody);
      ASSERT_LE(F.dot(v), ph::rounding_tolerance<T>(E::dimension) * F.norm() * v.norm())
          << name << ", seed " << seed << ", x = " << x.transpose() << ", v = " << v.transpose();
    }
  });
}

TEST(an_effect, drives_by_no_more_than_its_dead_band_when_a_hand_pushes) {
  for_each_effect_scalar_and_dimension([](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    using T = typename E::scalar;
    random_source random(seed);
    for (int k = 0; k < 20000; ++k) {
      const auto [x, v] = draw<E>(random, k);
      const vector_of<E> Fh = random.wide(T(1e-3), T(1e2)) * random.direction<T, E::dimension>();
      const vector_of<E> F = effect.force(x, v, Fh);
      const T rounding = ph::rounding_tolerance<T>(E::dimension) * F.norm() * v.norm();
      ASSERT_LE(F.dot(v), F.norm() * ph::default_velocity_dead_band<T> + rounding)
          << name << ", seed " << seed << ", x = " << x.transpose() << ", v = " << v.transpose();
    }
  });
}

TEST(an_effect, is_zero_at_rest_without_a_hand) {
  for_each_effect_scalar_and_dimension([](const char* name, const auto& effect) {
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
    for (int k = 0; k < 20000; ++k) {
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
  for_each_effect<double, 2>([](const char* name, const auto& effect) {
    using E = std::remove_cvref_t<decltype(effect)>;
    const vector_of<E> lost = vector_of<E>::Constant(std::numeric_limits<double>::quiet_NaN());
    for (const double speed : {-1.0, 0.0, 1.0}) {
      const vector_of<E> v = vector_of<E>::Constant(speed), zero = vector_of<E>::Zero();
      const bool position_matters = name[0] != 'v' && name[0] != 'w';
      EXPECT_TRUE(!position_matters || effect.force(lost, v, zero).hasNaN()) << name << ", speed " << speed;
    }
    EXPECT_TRUE(effect.force(vector_of<E>(0.3, 0.4), lost, vector_of<E>::Zero()).hasNaN()) << name;
  });
}

TEST(effects, add_up) {
  const auto detents = some_detents<double, 2>();
  const auto field = some_field<double, 2>();
  const ph::vector<double, 2> x(0.3, 0.105), v(0.2, 0.3), Fh(1, 2);
  EXPECT_EQ(ph::total_force(x, v, Fh, detents, field), detents.force(x, v, Fh) + field.force(x, v, Fh));
  EXPECT_EQ(ph::total_force(x, v, Fh, field), field.force(x, v, Fh));
}

TEST(resistance, has_its_limit_in_slip_and_a_slope_in_the_dead_band) {
  using vector = ph::vector<double, 2>;
  const vector nobody(0, 0);
  EXPECT_LE((ph::resistance<double, 2>(5, {0.3, -0.4}, 0.1, nobody) - vector(-3, 4)).norm(), 8 * eps);
  EXPECT_LE((ph::resistance<double, 2>(5, {0.03, -0.04}, 0.1, nobody) - vector(-1.5, 2)).norm(), 8 * eps);
  EXPECT_EQ((ph::resistance<double, 2>(0, {0.03, -0.04}, 0.1, {1, 1})).norm(), 0);
}

TEST(resistance, at_rest_holds_a_push_up_to_its_limit) {
  using vector = ph::vector<double, 2>;
  const vector rest(0, 0);
  EXPECT_EQ((ph::resistance<double, 2>(5, rest, 0.1, {1, 2})), vector(-1, -2));
  EXPECT_LE((ph::resistance<double, 2>(5, rest, 0.1, {30, 40}) - vector(-3, -4)).norm(), 8 * eps);
}

TEST(resistance, of_a_velocity_or_push_whose_square_overflows_has_its_limit) {
  const ph::vector<double, 2> along(0.6, 0.8), none(0, 0);
  for (const double huge : {1e155, 1e200, 1e307}) {
    EXPECT_LE((ph::resistance<double, 2>(5, huge * along, 0.1, none) + 5 * along).norm(), 8 * eps) << huge;
    EXPECT_LE((ph::resistance<double, 2>(5, none, 0.1, huge * along) + 5 * along).norm(), 8 * eps) << huge;
  }
  EXPECT_TRUE(std::isnan(ph::resistance<double, 2>(5, {std::nan(""), 1}, 0.1, none)[0]));
}

TEST(one_way_resistance, lets_the_other_way_free) {
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.2, 0.1, 0.0), 5);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.05, 0.1, 0.0), 2.5);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, 0.0), 0);
  EXPECT_EQ(ph::one_way_resistance(5.0, -0.05, 0.1, 0.0), 0);
  EXPECT_EQ(ph::one_way_resistance(5.0, -0.2, 0.1, 100.0), 0);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.2, 0.1, -9.0), 5) << "beyond the dead band no push counts";
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0125, 0.1, 0.0), 0.625);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, 3.0), 3);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, 7.0), 5);
  EXPECT_EQ(ph::one_way_resistance(5.0, 0.0, 0.1, -3.0), 0);
}

TEST(wall_friction, is_mu_times_the_load_against_the_motion_along_the_wall) {
  const ph::wall_friction_parameters<double> rough{.coefficient = 0.5};
  using vector = ph::vector<double, 3>;
  const vector n(0, 0, 1), v(0.3, 0.4, -7);
  EXPECT_LE((ph::wall_friction(rough, n, 8, v) - vector(-2.4, -3.2, 0)).norm(), 8 * eps);
  EXPECT_EQ(ph::wall_friction(rough, n, 0, v).norm(), 0);
  const ph::wall_friction_parameters<double> wet{.coefficient = 0.5, .viscosity = 10};
  EXPECT_LE((ph::wall_friction(wet, n, 8, v) - vector(-5.4, -7.2, 0)).norm(), 16 * eps);
}

TEST(wall_friction, takes_the_load_that_the_hand_presses) {
  EXPECT_EQ((ph::pressing_force(ph::vector<double, 2>(0, 1), {3, -2})), 2);
  EXPECT_EQ((ph::pressing_force(ph::vector<double, 2>(0, 1), {3, -0.5})), 0.5);
  EXPECT_EQ((ph::pressing_force(ph::vector<double, 2>(0, 1), {3, 2})), 0);
}

TEST(rough_walls, have_the_friction_of_each_touched_wall) {
  const ph::wall_friction_parameters<double> p{.coefficient = 0.5, .viscosity = 10};
  const ph::rough_walls<double, 2> rough(p);
  const ph::vector<double, 2> v(0.3, -0.2), Fh(-4, -7), first(0, 1), second(1, 0), moving(0.1, 0.4);
  ph::contacts<2, 3> touched;
  EXPECT_EQ(rough.force_at(touched, v, Fh), (ph::vector<double, 2>(0, 0)));
  touched.push_back({.normal = first, .depth = 1e-3, .stiffness = 1e3});
  EXPECT_EQ(rough.force_at(touched, v, Fh), ph::wall_friction(p, first, 7, v, Fh));
  touched.push_back({.normal = second, .depth = 1e-3, .stiffness = 1e3, .wall_velocity = moving});
  const ph::vector<double, 2> both = ph::wall_friction(p, first, 7, v, Fh) +
                                     ph::wall_friction(p, second, 4, ph::vector<double, 2>(v - moving), Fh);
  EXPECT_LE((rough.force_at(touched, v, Fh) - both).norm(), 16 * eps);
}

// A mass of 0.5 kg on the wall, pushed along it for a second at 10 kHz: how far it gets [m].
static double slid_way(double push, bool hand_is_known) {
  const ph::wall_friction_parameters<double> rough{.coefficient = 0.5};
  const ph::vector<double, 2> n(0, 1), Fh(push, -8);
  ph::vector<double, 2> x(0, 0), v(0, 0);
  constexpr double mass = 0.5, step = 1e-4;
  for (int k = 0; k < 10000; ++k) {
    const auto known = hand_is_known ? Fh : ph::vector<double, 2>(0, 0);
    const auto F = ph::wall_friction(rough, n, ph::pressing_force(n, Fh), v, known);
    v.x() += step * (push + F.x()) / mass;
    x += step * v;
  }
  return x.x();
}

TEST(wall_friction, holds_a_handle_that_is_pushed_less_than_its_limit) {
  EXPECT_EQ(slid_way(3.9, true), 0);
  EXPECT_GT(slid_way(4.5, true), 0.4);
  // Without a hand force it creeps, no faster than the dead band.
  EXPECT_GT(slid_way(3.9, false), 0.5 * band);
  EXPECT_LT(slid_way(3.9, false), band);
}

TEST(viscous_field, is_minus_B_v) {
  ph::viscous_field_parameters<double, 2> p;
  p.viscosity << 4, 0, 0, 1;
  const ph::viscous_field<double, 2> field(p);
  EXPECT_EQ(field.force({9, 9}, {0.5, 2}), (ph::vector<double, 2>(-2, -2)));
}

TEST(viscous_field, of_any_strength_drives_no_motion) {
  for (const double size : {1e-9, 1.0, 1e9}) {
    using field = ph::viscous_field_parameters<double, 2>;
    EXPECT_EQ(validate(field{.viscosity = size * ph::matrix<double, 2, 2>{{1, 2}, {-2, 0}}}), "");
    EXPECT_NE(validate(field{.viscosity = size * ph::matrix<double, 2, 2>{{1, 2}, {2, 0}}}), "") << size;
  }
}

TEST(viscous_field, may_be_free_along_a_direction) {
  random_source random(seed);
  for (int k = 0; k < 1000; ++k) {
    const auto n = random.direction<double, 3>();
    const ph::viscous_field<double, 3> field({.viscosity = random.positive(1e-9, 1e9) * n * n.transpose()});
    const auto across = n.unitOrthogonal().eval();
    EXPECT_LE(field.force({0, 0, 0}, across).norm(), 8 * eps * field.force({0, 0, 0}, n).norm());
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

TEST(detents, take_the_same_work_each_and_return_none) {
  const double spacing = 0.02, strength = 3;
  const ph::detents<double, 2> knob({.spacing = spacing, .strength = strength});
  for (const double way : {1.0, -1.0}) {
    double work = 0;
    constexpr int steps = 10000;
    for (int k = 0; k < steps; ++k) {
      const double s = way * (k + 0.5) * 5 * spacing / steps;
      const double power = knob.force({s, 0}, {way, 0}).x() * way;
      EXPECT_LE(power, 0);
      work += power * 5 * spacing / steps;
    }
    EXPECT_NEAR(work, -5 * strength * spacing / std::numbers::pi, 1e-6);  // 5 times f P / pi
  }
}

TEST(end_stops, resist_each_joint_beyond_its_limits_on_the_way_out) {
  const ph::end_stops<double, 3> stops({.lower = {-1, -2, -std::numeric_limits<double>::infinity()},
                                        .upper = {1, std::numeric_limits<double>::infinity(), 3},
                                        .stiffness = {10, 20, 30}});
  using vector = ph::vector<double, 3>;
  EXPECT_EQ(stops.torque({0, 50, -50}, {1, 1, -1}), vector(0, 0, 0));
  EXPECT_LE((stops.torque({1.5, -2.5, 3.25}, {1, -1, 1}) - vector(-5, 10, -7.5)).norm(), 16 * eps);
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {-1, 1, -1}), vector(0, 0, 0));
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {0, 0, 0}), vector(0, 0, 0));
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {0, 0, 0}, {2, -3, 100}), vector(-2, 3, -7.5));
  EXPECT_EQ(stops.torque({1.5, -2.5, 3.25}, {0, 0, 0}, {-2, 3, -100}), vector(0, 0, 0));
}

TEST(end_stops, never_drive_a_joint) {
  random_source random(seed);
  const ph::end_stops<float, 2> stops({.lower = {-1, -2}, .upper = {1, 0}, .stiffness = {10, 20}});
  for (int k = 0; k < 20000; ++k) {
    const ph::vector<float, 2> q = 3 * random.normal_vector<float, 2>();
    const ph::vector<float, 2> qd(random.wide(1e-6f, 1e2f), random.wide(1e-6f, 1e2f));
    const auto t = stops.torque(q, qd);
    ASSERT_LE(t[0] * qd[0], 0);
    ASSERT_LE(t[1] * qd[1], 0);
  }
}

TEST(end_stops, of_a_nan_are_not_silent) {
  const ph::end_stops<double, 1> stops(
      {.lower = ph::vector<double, 1>(-1), .upper = ph::vector<double, 1>(1)});
  const ph::vector<double, 1> lost(std::numeric_limits<double>::quiet_NaN());
  for (const double speed : {-1.0, 0.0, 1.0})
    EXPECT_TRUE(stops.torque(lost, ph::vector<double, 1>(speed)).hasNaN());
}

TEST(a_guide, leaves_motion_along_it_free) {
  const auto line = some_guide<double, 3, ph::guide_along::line>();
  const auto plane = some_guide<double, 3, ph::guide_along::plane>();
  const ph::vector<double, 3> along = ph::vector<double, 3>::LinSpaced(1, 2).normalized();
  const ph::vector<double, 3> x(0.4, -0.3, 0.2);
  EXPECT_LE(line.force(x, along).norm(), 1e-13);
  EXPECT_LE(plane.force(x, along.unitOrthogonal()).norm(), 1e-13);
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
  EXPECT_EQ(validate(ph::wall_friction_parameters<double>{}), "");
  EXPECT_EQ(validate(ph::wall_friction_parameters<double>{.coefficient = -1}),
            "coefficient of wall_friction = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(ph::wall_friction_parameters<double>{.viscosity = no_number}),
            "viscosity of wall_friction [N s/m] = nan, expected a finite number >= 0");
  EXPECT_EQ(validate(ph::wall_friction_parameters<double>{.velocity_dead_band = 0}),
            "velocity_dead_band of wall_friction [m/s] = 0, expected a finite number > 0");

  using detents = ph::detents_parameters<double, 2>;
  EXPECT_EQ(validate(detents{.spacing = 1}), "");
  EXPECT_EQ(validate(detents{.origin = {0, no_number}, .spacing = 1}),
            "origin[1] of detents [m] = nan, expected a finite number");
  EXPECT_EQ(validate(detents{.direction = {0, 0}, .spacing = 1}),
            "|direction| of detents = 0, expected a direction");
  EXPECT_EQ(validate(detents{}), "spacing of detents [m] = 0, expected a finite number > 0");
  EXPECT_EQ(validate(detents{.spacing = 1, .strength = -1}),
            "strength of detents [N] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(detents{.spacing = 1, .velocity_dead_band = 0}),
            "velocity_dead_band of detents [m/s] = 0, expected a finite number > 0");
  EXPECT_THROW((ph::detents<double, 2>(detents{})), std::invalid_argument);

  using stops = ph::end_stops_parameters<double, 2>;
  EXPECT_EQ(validate(stops{}), "");
  EXPECT_EQ(validate(stops{.lower = {0, 2}, .upper = {1, 2}}),
            "lower[1] of end_stops [rad] = 2, expected less than upper[1]");
  EXPECT_EQ(validate(stops{.lower = {no_number, 2}}),
            "lower[0] of end_stops [rad] = nan, expected less than upper[0]");
  EXPECT_EQ(validate(stops{.stiffness = {0, -1}}),
            "stiffness[1] of end_stops [N m/rad] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(stops{.rate_dead_band = {0, 1}}),
            "rate_dead_band[0] of end_stops [rad/s] = 0, expected a finite number > 0");

  using guide = ph::guide_parameters<double, 3>;
  EXPECT_EQ(validate(guide{}), "");
  EXPECT_EQ(validate(guide{.point = {0, 0, no_number}}),
            "point[2] of a guide [m] = nan, expected a finite number");
  EXPECT_EQ(validate(guide{.direction = {0, no_number, 0}}),
            "|direction| of a guide = nan, expected a direction");
  EXPECT_EQ(validate(guide{.stiffness = -1}),
            "stiffness of a guide [N/m] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(guide{.tolerance = -1}), "tolerance of a guide [m] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(guide{.viscosity = -1}),
            "viscosity of a guide [N s/m] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(guide{.velocity_dead_band = -1}),
            "velocity_dead_band of a guide [m/s] = -1, expected a finite number > 0");

  ph::viscous_field_parameters<double, 2> field;
  EXPECT_EQ(validate(field), "");
  field.viscosity << 1, 3, 3, 1;
  EXPECT_EQ(validate(field),
            "viscosity of a viscous_field would drive some motion, expected v . B v >= 0 for all v");
  field.viscosity << 1, 3, -3, 1;
  EXPECT_EQ(validate(field), "");
  field.viscosity << 1, 3, no_number, 1;
  EXPECT_EQ(validate(field), "viscosity(1, 0) of a viscous_field [N s/m] = nan, expected a finite number");
}
