// slow
// The controller without a force sensor, on paper: faults, which hand force it believes in, what it forgets,
// and which brakes it probes.
#include "../support.hpp"

#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/sensorless/sensorless_controller.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <algorithm>
#include <limits>
#include <utility>

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

constexpr ph::sensorless_parameters quick{.observer = {}, .probe = {.probe_period = 0.1, .probe_time = 0.05}};

// Brakes of 10 N, a wall that asks for 4 N along y where the handle is at x = 0.
struct blind_table {
  double wall_side = 1;  // of y, where the wall is
  ph::sensorless_parameters p = {.observer = {}, .probe = {.probe_period = 1}};
  double time_constant = 0;
  pair heard = {0, 0};
  double share = 1;
  ph::brakes_of<table> brakes = [this] {
    ph::brakes_of<table> b;
    b.torque_limit.setConstant(10);
    b.time_constant.setConstant(time_constant);
    b.rate_dead_band.setConstant(0.02);
    return b;
  }();
  ph::sensorless_controller<table, decltype(ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 4e3))),
                            listening_law>
      control{table(), brakes, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, -wall_side}), 4e3)),
              listening_law{&heard, &share}, p};
  double time = 0;

  // The brake along the wall slips.
  auto at(double depth, double rate) {
    return control(ph::device_state<table>{time, {0, depth * wall_side}, {1, rate * wall_side}, {0, 0}});
  }
  // One cycle: in the wall, at a rate into it; off it; with a rate that is no number.
  auto inside(double rate = 0) { return at(1e-3, rate); }
  void outside() { at(-1e-3, 0); }
  void fail() { at(1e-3, std::numeric_limits<double>::quiet_NaN()); }

  // This long at a constant rate.
  void move(double rate, double duration) {
    for (const double end = time + duration; time < end; time += 1e-3) {
      const auto result = inside(rate);
      ASSERT_EQ(result.outcome, ph::status::ok);
      EXPECT_NEAR(result.capacity[1], 4 * share, 1e-9);
      EXPECT_EQ(result.signs[1], rate < brakes.rate_dead_band[1] ? 0 : wall_side) << "no push tells a sign";
    }
  }
  // How long it rests until it is probed [s].
  double rests() {
    const double begin = time;
    for (; control.probing() == decltype(control)::probe_phase::watching; time += 1e-3) inside();
    return time - begin;
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

// While the estimate forgets the brake, what it sees and what is believed are told together; a jolt while the
// brake holds is seen, and is no more push than before.
TEST(sensorless_controller, hides_less_where_more_is_seen) {
  blind_table device;
  device.move(0.0201, 0.2);
  double least = 4;
  for (int k = 0; k < 20; ++k) {
    device.move(0.0199, 0.0005);
    EXPECT_NEAR(device.heard[1], 4, 0.1) << k;
    least = std::min(least, device.control.hand().force[1]);
  }
  EXPECT_LT(least, 2);
  device.move(0, 0.2);
  const double before = device.heard[1];
  EXPECT_GT(before, 3);
  device.move(0.0199, 0.01);
  EXPECT_GT(device.control.hand().force[1], 0.5);
  EXPECT_NEAR(device.heard[1], before, 1e-6);
}

TEST(sensorless_controller, believes_nothing_after_a_fault_or_a_reset) {
  for (const bool fault : {true, false}) {
    blind_table device{.time_constant = 0.05};
    device.move(0.0201, 0.2);
    if (fault) device.fail();
    else device.control.reset();
    device.move(0.0199, 0.02);
    EXPECT_EQ(device.heard[1], 0);
  }
}

TEST(sensorless_controller, forgets_what_its_law_remembers) {
  ph::sensorless_controller control(table(), ph::brakes_of<table>(),
                                    ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 4e3)),
                                    ph::on_off_control());
  double time = 0;
  const auto holds = [&](double depth) {
    return !control(ph::sensorless_device_state<table>{time += 1e-3, {0, -depth}, {0, -1e-3}})
                .capacity.isZero(0);
  };
  const ph::on_off_parameters p;
  EXPECT_FALSE(holds(p.reference_depth));
  EXPECT_TRUE(holds(2 * p.reference_depth));
  EXPECT_TRUE(holds(p.reference_depth)) << "as before";
  control.reset();
  EXPECT_FALSE(holds(p.reference_depth));
}

TEST(sensorless_controller, counts_a_rest_from_where_it_began) {
  constexpr double cycles = 3e-3;
  blind_table device{.p = quick};
  EXPECT_NEAR(device.rests(), 0.1, cycles);
  // In free space, by a fault or a reset it ends, and so does a probe
  for (const auto end : {+[](blind_table& d) { d.outside(); }, +[](blind_table& d) { d.fail(); },
                         +[](blind_table& d) { d.control.reset(); }}) {
    end(device);
    EXPECT_EQ(device.control.probing(), decltype(device.control)::probe_phase::watching);
    for (int k = 0; k < 90; ++k, device.time += 1e-3) device.inside();
    end(device);
    EXPECT_NEAR(device.rests(), 0.1, cycles);
  }
  // By a slip of 30 ms, too, but not by one of 15 ms
  for (const auto& [slip, left] : {std::pair(0.015, 0.035), std::pair(0.030, 0.1)}) {
    device.outside();
    for (int k = 0; k < 50; ++k, device.time += 1e-3) device.inside();
    device.move(0.0201, slip);
    EXPECT_NEAR(device.rests(), left, cycles) << slip;
  }
}

TEST(sensorless_controller, releases_the_brakes_on_faults) {
  blind_table device;
  device.move(0.0201, 0.005);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using state = ph::sensorless_device_state<table>;
  for (const state& bad :
       {state{nan, {0, 1e-3}, {1, 0}}, state{1, {nan, 1e-3}, {1, 0}}, state{1, {0, 1e-3}, {1, nan}}}) {
    const auto result = device.control(bad);
    EXPECT_NE(result.outcome, ph::status::ok);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
  device.time = 0.007;
  EXPECT_EQ(device.inside().outcome, ph::status::ok);
  for (const double time : {0.007, 0.001, 0.001}) {  // it stands still, goes back, and stands still
    device.time = time;
    const auto result = device.inside();
    EXPECT_EQ(result.outcome, ph::status::time_not_rising);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
  device.time = 0.002;
  EXPECT_EQ(device.inside().outcome, ph::status::ok);
}

// As much more as brings a brake to what the law counts on in two cycles at 1 kHz, to a thousandth of its
// limit.
TEST(sensorless_controller, makes_up_for_a_probe_in_two_cycles) {
  constexpr double lag = 0.02, limit = 10;
  blind_table device{.p = quick, .time_constant = lag};
  using phase = decltype(device.control)::probe_phase;
  double counted_on = 0, made = 0, told = 0;
  int made_up = 0, probing = 0;
  for (; device.time < 1; device.time += 1e-3) {
    counted_on = ph::lagged(counted_on, device.time > 0 ? 4.0 : 0.0, 1e-3, lag);
    made = ph::lagged(made, told, 1e-3, lag);
    told = device.inside().capacity[1];
    if (device.control.probing() == phase::probing) {
      EXPECT_EQ(told, 0);
      ++probing;
      continue;
    }
    const double missing = counted_on - made;
    const bool is_missing = missing > 1e-3 * limit;
    const double more = is_missing ? missing * (1 / ph::lag_share(0.002, lag) - 1) : 0.0;
    ASSERT_NEAR(told, std::min(limit, 4 + more), 1e-9) << device.time;
    made_up += is_missing;
  }
  EXPECT_GT(made_up, 20);
  EXPECT_NEAR(probing, 1000 * 0.05 / 0.15, 40);
  // Nothing is left to make up for after a reset
  device.rests();
  for (int k = 0; k < 10; ++k, device.time += 1e-3) device.inside();
  device.control.reset();
  EXPECT_EQ(device.inside().capacity[1], 4);
  device.time += 1e-3;
  EXPECT_EQ(device.inside().capacity[1], 4);
}

// Slipping all the time, after free space and after a reset as well.
TEST(sensorless_controller, probes_no_brake_that_slips) {
  blind_table device{.p = quick};
  device.move(0.0201, 0.3);
  device.outside();
  device.time += 1e-3;
  device.move(0.0201, 0.3);
  device.control.reset();
  device.move(0.0201, 0.3);
  device.inside();
  device.control.reset();
  device.time = 0;  // before it was at rest
  device.move(0.0201, 0.3);
}

}  // namespace
