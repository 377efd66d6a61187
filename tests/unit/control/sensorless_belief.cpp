// Which hand force a law is told of where no sensor tells it, and what is forgotten with the motion.
#include "../support.hpp"

#include <passive_haptics/control/sensorless/sensorless_controller.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace {

using table = ph::xy_table<double>;
using pair = ph::vector<double, 2>;

// Displays a share of the wall and notes the hand force that it is told.
struct listening_law {
  static constexpr bool needs_hand_force = true;
  pair* heard = nullptr;
  const double* share = nullptr;
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    *heard = c.hand_force;
    return T(*share);
  }
};

// Brakes of 10 N without lag, a wall that asks for 4 N along y where the handle is at x = 0.
struct blind_table {
  double wall_side = 1;  // of y, where the wall is
  pair heard = {0, 0};
  double share = 1;
  ph::brakes_of<table> brakes = [] {
    ph::brakes_of<table> b;
    b.torque_limit.setConstant(10);
    b.time_constant.setZero();
    b.rate_dead_band.setConstant(0.02);
    return b;
  }();
  ph::sensorless_controller<table, decltype(ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 4e3))),
                            listening_law>
      control{table(),
              brakes,
              ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, -wall_side}), 4e3)),
              listening_law{&heard, &share},
              {.observer = {}, .probe = {.probe_period = 1}}};
  double time = 0;

  // This long at a constant rate, into the wall.
  void move(double rate, double duration) {
    for (const double end = time + duration; time < end; time += 1e-3) {
      const auto result =
          control(ph::device_state<table>{time, {0, 1e-3 * wall_side}, {0, rate * wall_side}, {0, 0}});
      ASSERT_EQ(result.outcome, ph::status::ok);
      EXPECT_NEAR(result.capacity[1], 4 * share, 1e-9);
    }
  }
};

// A hand that drags the handle against a brake of 4 N at a constant rate pushes with 4 N; when the brake
// holds, the momentum tells nothing, and it is believed to push on.
TEST(sensorless_controller, believes_that_a_hand_pushes_on_where_a_brake_holds) {
  for (const double side : {1.0, -1.0}) {
    blind_table device{side};
    device.move(0.0201, 0.2);
    EXPECT_NEAR(device.heard[1], 4 * side, 1e-6);
    device.move(0.0199, 0.06);
    EXPECT_NEAR(device.control.hand().force[1], 0, 0.01) << "if the brake made none";
    EXPECT_NEAR(device.heard[1], 4 * side, 0.1);
    EXPECT_EQ(device.heard[0], 0);
    device.share = 0.5;
    device.move(0.0199, 0.06);
    EXPECT_NEAR(device.heard[1], 2 * side, 0.01) << "a brake of 2 N hides no more";
  }
}

}  // namespace
