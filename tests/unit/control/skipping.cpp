// slow
// What a cycle does not need, it does not do.
#include "../support.hpp"

#include <Eigen/LU>

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <limits>

namespace {

struct calls {
  int position = 0, jacobian = 0, transmission = 0, distance = 0, gradient = 0;
};

// The tendon device, but it counts the calls of its members.
struct counting_arm {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const {
    ++count->position;
    return arm.position(q);
  }
  ph::matrix<double, 2, 2> jacobian(const ph::vector<double, 2>& q) const {
    ++count->jacobian;
    return arm.jacobian(q);
  }
  ph::matrix<double, 2, 2> transmission() const {
    ++count->transmission;
    return arm.transmission();
  }
  calls* count;
  ph::tendon_two_link<double> arm{};
};

struct counting_wall {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const {
    ++count->distance;
    return plane.distance(x);
  }
  ph::point<2> gradient(const ph::point<2>& x) const {
    ++count->gradient;
    return plane.gradient(x);
  }
  calls* count;
  ph::half_space<2> plane{{0, 0.225}, {0, -1}};
};

using state = ph::device_state<counting_arm>;
using pair = ph::vector<double, 2>;

// A handle at (0.1, y) with velocity v beside the wall y >= 0.225.
state handle_at(double y, const pair& v, const pair& hand = {0, 1}) {
  const ph::tendon_two_link<double> arm;
  const pair q = arm.inverse({0.1, y}, ph::elbow::left).q;
  return {0.0, q, arm.jacobian(q).inverse() * v, hand};
}

struct skipping : ::testing::Test {
  calls count;
  ph::controller<counting_arm, ph::static_scene<counting_wall>, ph::direct_control> control{
      counting_arm{&count},
      ph::brakes_of<counting_arm>(),
      ph::scene(ph::wall(counting_wall{&count}, 1e4)),
      {}};

  void SetUp() override {
    EXPECT_EQ(count.transmission, 1) << "its constant inverse is made once, outside of the loop";
    count = {};
  }
};

TEST_F(skipping, a_faulty_state_asks_nothing) {
  state s = handle_at(0.24, {0.5, 0.5});
  s.q[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(control(s).outcome, ph::status::state_not_finite);
  EXPECT_EQ(count.position + count.jacobian + count.transmission + count.distance, 0);
}

TEST_F(skipping, free_space_needs_one_position_and_one_distance) {
  EXPECT_EQ(control(handle_at(0.2, {0.5, 0.5})).wall_number, -1);
  EXPECT_EQ(count.position, 1);
  EXPECT_EQ(count.distance, 1);
  EXPECT_EQ(count.jacobian + count.transmission + count.gradient, 0);
}

TEST_F(skipping, a_contact_needs_each_quantity_once) {
  const auto result = control(handle_at(0.23, {0.5, 0.5}));
  EXPECT_GT(result.capacity.norm(), 0);
  EXPECT_EQ(count.position, 1);
  EXPECT_EQ(count.distance, 1);
  EXPECT_EQ(count.gradient, 1);
  EXPECT_EQ(count.jacobian, 1);
  EXPECT_EQ(count.transmission, 1) << "for w";
}

TEST_F(skipping, an_exact_force_is_the_desired_one) {
  // Every brake turns against the torque that it is to give: w = -E^T n
  const ph::tendon_two_link<double> arm;
  const auto E = ph::brake_jacobian(arm, handle_at(0.23, {0, 0}).q);
  const auto result = control(handle_at(0.23, -20 * (E * E.transpose() * pair(0, -1))));
  ASSERT_EQ(result.display, ph::display_class::exact);
  EXPECT_EQ(result.control_force, result.desired_force);
}

// A law that counts its calls.
struct counting_law {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    ++*called;
    return T(1);
  }
  int* called;
};

TEST_F(skipping, a_law_is_called_once_for_a_wall_that_demands_a_force) {
  int called = 0;
  ph::controller counted(counting_arm{&count}, ph::brakes_of<counting_arm>(),
                         ph::scene(ph::wall(counting_wall{&count}, 1e4)), counting_law{&called});
  ASSERT_EQ(counted(handle_at(0.2, {0.5, 0.5})).wall_number, -1);
  EXPECT_EQ(called, 0) << "in free space";
  ASSERT_EQ(counted(handle_at(0.23, {0.5, 0.1})).display, ph::display_class::approximate);
  EXPECT_EQ(called, 1);
  ASSERT_EQ(counted(handle_at(0.23, {0, -0.5})).display, ph::display_class::none);
  EXPECT_EQ(called, 2)
      << "also where nothing can be displayed: a branch around a law costs more than the law";
}

TEST_F(skipping, a_wall_without_stiffness_needs_no_jacobian) {
  ph::controller soft(counting_arm{&count}, ph::brakes_of<counting_arm>(),
                      ph::scene(ph::wall(counting_wall{&count}, 0.0)), ph::direct_control{});
  EXPECT_EQ(soft(handle_at(0.23, {0, 0.5})).wall_number, -1);
  EXPECT_EQ(count.jacobian, 0);
}

TEST_F(skipping, a_held_scene_measures_no_distance_between_its_samples) {
  ph::controller held(counting_arm{&count}, ph::brakes_of<counting_arm>(),
                      ph::held_scene(ph::scene(ph::wall(counting_wall{&count})), 0.05), ph::direct_control{});
  for (int k = 0; k < 500; ++k) {
    state s = handle_at(0.23, {0.5, 0.5});
    s.time = k * 1e-3;
    held(s);
  }
  EXPECT_EQ(count.distance, 10);
  EXPECT_EQ(count.gradient, 10);
  EXPECT_EQ(count.jacobian, 500);
}

// The same device without the hints: dense matrices that depend on the pose.
template <class T>
struct dense_table {
  using scalar = T;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<T, 2> position(const ph::vector<T, 2>& q) const { return q; }
  ph::matrix<T, 2, 2> jacobian(const ph::vector<T, 2>&) const { return ph::matrix<T, 2, 2>::Identity(); }
};
template <class T>
struct diagonal_gears : ph::xy_table<T> {
  ph::diagonal_matrix<T, 2> transmission() const { return ph::diagonal_matrix<T, 2>(T(4), T(-0.3)); }
};
template <class T>
struct dense_gears : dense_table<T> {
  ph::matrix<T, 2, 2> transmission(const ph::vector<T, 2>&) const {
    return ph::matrix<T, 2, 2>{{T(4), T(0)}, {T(0), T(-0.3)}};
  }
};

template <class Hinted, class Dense>
void expect_twins() {
  using T = typename Hinted::scalar;
  ph::testing::random_source random(21);
  int seen[3] = {};
  for (int k = 0; k < 2000; ++k) {
    const ph::vector<T, 2> q = random.normal_vector<T, 2>(), hand = random.normal_vector<T, 2>();
    ph::vector<T, 2> qd = random.normal_vector<T, 2>();
    if (k % 3 == 0) qd[k % 2] = T(0);
    const ph::contact<2> wall{.normal = random.direction<double, 2>(), .depth = 1e-4, .stiffness = 1e4};
    const auto a = step_once<ph::direct_control>(Hinted(), {}, state_of<Hinted>(q, qd, hand), wall);
    const auto b = step_once<ph::direct_control>(Dense(), {}, state_of<Dense>(q, qd, hand), wall);
    SCOPED_TRACE(::testing::Message() << "seed 21, trial " << k);
    EXPECT_EQ(a.display, b.display);
    EXPECT_EQ(a.power, b.power);
    EXPECT_EQ(a.signs, b.signs);
    EXPECT_EQ(a.saturated, b.saturated);
    const double size =
        1 / static_cast<double>(a.display == ph::display_class::none ? T(1) : a.approximation_cosine);
    expect_near(a.capacity, b.capacity, size * size);
    expect_near(a.torque, b.torque, size * size);
    EXPECT_NEAR(a.alpha, b.alpha, ph::rounding_tolerance<T>(2));
    ++seen[static_cast<int>(a.display)];
  }
  for (const int n : seen) EXPECT_GT(n, 0) << "a display class was not met";
}

template <class T>
struct hints : ::testing::Test {};
TYPED_TEST_SUITE(hints, scalars);

TYPED_TEST(hints, a_diagonal_jacobian_changes_nothing_but_the_cost) {
  expect_twins<ph::xy_table<TypeParam>, dense_table<TypeParam>>();
}

TYPED_TEST(hints, a_diagonal_transmission_changes_nothing_but_the_cost) {
  expect_twins<diagonal_gears<TypeParam>, dense_gears<TypeParam>>();
}

// The account is all that command() leaves out.
TEST(command, is_that_of_the_whole_cycle_and_its_warm_start) {
  constexpr unsigned seed = 31;
  using M = ph::tendon_two_link<double>;
  const auto corner = ph::scene(ph::wall(ph::half_space<2>({0, 0.2}, {0, -1}), 1e4),
                                ph::wall(ph::half_space<2>({0.1, 0}, {-1, 0.2}), 1e3));
  ph::controller whole(M(), ph::brakes_of<M>(), corner, ph::direct_control{});
  ph::controller lean = whole;
  ph::testing::random_source random(seed);
  int in_contact = 0, faults = 0;
  for (int k = 0; k < 10'000; ++k) {
    ph::device_state<M> s;
    s.time = 0;
    s.q = M().inverse({random.uniform(0.05, 0.15), random.uniform(0.15, 0.21)}, ph::elbow::left).q;
    s.qd = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    s.hand_force = {random.uniform(-1.0, 1.0), random.uniform(-3.0, 3.0)};
    if (k % 100 == 0) s.qd[0] = std::numeric_limits<double>::quiet_NaN();
    const auto expected = whole(s);
    const auto got = lean.command(s);
    ASSERT_EQ(got.outcome, expected.outcome) << "seed " << seed << ", state " << k;
    ASSERT_EQ(got.capacity, expected.capacity) << "seed " << seed << ", state " << k;
    in_contact += expected.capacity.isZero(0) ? 0 : 1;
    faults += got.outcome == ph::status::ok ? 0 : 1;
  }
  EXPECT_GT(in_contact, 1000);
  EXPECT_EQ(faults, 100);
}

}  // namespace
