// slow
// A cycle calls no function whose value it does not need.
#include "../support.hpp"

#include <Eigen/LU>

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <limits>

namespace {

struct calls {
  int position = 0, jacobian = 0, transmission = 0, distance = 0, gradient = 0, velocity = 0;
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

struct counting_conveyor : counting_wall {
  ph::point<2> velocity(const ph::point<2>&) const {
    ++count->velocity;
    return {0, 0};
  }
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

TEST_F(skipping, free_space_needs_one_position_and_a_distance_of_each_wall) {
  const counting_wall wall{&count};
  ph::controller two(counting_arm{&count}, ph::brakes_of<counting_arm>(),
                     ph::scene(ph::wall(wall), ph::wall(counting_conveyor{wall})), ph::direct_control{});
  count = {};
  EXPECT_EQ(two(handle_at(0.2, {0.5, 0.5})).wall_number, -1);
  EXPECT_EQ(count.position, 1);
  EXPECT_EQ(count.distance, 2);
  EXPECT_EQ(count.jacobian + count.transmission + count.gradient + count.velocity, 0);
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

TEST_F(skipping, a_second_wall_costs_its_distance_and_a_wall_that_can_move_its_velocity) {
  counting_wall far{&count};
  far.plane = ph::half_space<2>({-10, 0}, {1, 0});
  ph::controller two(counting_arm{&count}, ph::unlimited_brakes(),
                     ph::scene(ph::wall(counting_conveyor{{&count}}, 1e4), ph::wall(far)),
                     ph::no_direct_control{});
  count = {};
  EXPECT_GT(two(handle_at(0.23, {0.5, 0.5})).capacity.norm(), 0);
  EXPECT_EQ(count.position, 1);
  EXPECT_EQ(count.distance, 2);
  EXPECT_EQ(count.gradient, 1);
  EXPECT_EQ(count.velocity, 1);
  EXPECT_EQ(count.jacobian, 1);
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
}

}  // namespace
