// slow
// Memory of a contact under velocity_direct_control: the force that it learns, and how coarsely it sees.
#include "velocity_floor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

// The law on a slide that is held in one state, a cycle each millisecond.
struct held_slide {
  constants p = unfiltered();
  law control{p};
  ph::step_memory<law> memory = {};
  ph::brakes_of<table> brakes = without_lag();
  double time = 0;

  static constants unfiltered() {
    constants p;
    p.rate_lag = 0;
    p.depth_per_jump = 0;
    return p;
  }
  // Over a floor at this height [m]
  double cycle(double depth, double v, double Fh = 0, double height = 0) {
    ph::contacts<2, 1> touched;
    if (depth > 0) touched.push_back(floor_at(0, -depth));
    for (auto& c : touched) c.sensed_at[1] += height;
    auto state = state_of<table>({0, height - depth}, {0, v}, {0, Fh});
    state.time = time += 1e-3;
    return ph::step(table(), brakes, touched, control, state, memory).capacity[1];
  }
};

TEST(velocity_direct_control, learns_the_force_that_is_missing) {
  held_slide slide;
  const auto& p = slide.p;
  const double first = slide.cycle(p.rest_depth, -0.05), c = force_per_speed(p);
  EXPECT_NEAR(first, 0.05 * c, 1e-12);
  for (int k = 1; k <= 50; ++k)
    EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first * (1 + (k - 1) * 1e-3 / p.integral_time), 1e-9);
  // Leaving with a brake that slips, it unlearns as fast
  for (int k = 0; k < 50; ++k) EXPECT_LE(slide.cycle(p.rest_depth, 0.05), first);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9);
  slide.cycle(-1, 0);  // free
  for (int k = 0; k < 50; ++k) slide.cycle(p.rest_depth, -0.05);
  slide.cycle(-1, 0);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9) << "a wall that was left is forgotten";
}

// What the brakes cannot make is not learned, and what was learned is kept within what they can.
TEST(velocity_direct_control, learns_no_more_than_its_brakes_can_make) {
  held_slide slide;
  const auto& p = slide.p;
  const double first = slide.cycle(p.rest_depth, -0.05);
  slide.brakes.torque_limit.setConstant(first - 0.5);
  for (int k = 0; k < 50; ++k) EXPECT_EQ(slide.cycle(p.rest_depth, -0.05), first - 0.5);
  slide.brakes.torque_limit.setConstant(100);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9);
  // Learned 6 N, then for a cycle at most 3 N, of which phi 5 N are fed forward; or 1 N of phi 10 N
  for (const auto& [limit, push] : {std::pair(3.0, 5.0), std::pair(1.0, 10.0)}) {
    for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, -0.05);
    slide.brakes.torque_limit.setConstant(limit);
    slide.cycle(p.rest_depth, -0.05, -push);
    slide.brakes.torque_limit.setConstant(100);
    EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first + std::max(limit - push * p.force_share, 0.0), 1e-9);
  }
  // A pull is not learned either
  slide.cycle(-1, 0);
  slide.cycle(p.rest_depth, 0.01, 10);
  slide.cycle(p.rest_depth, 0.01, 10);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9);
}

TEST(velocity_direct_control, smooths_rates_in_contact_alone) {
  held_slide slide;
  slide.p.rate_lag = constants().rate_lag;
  slide.p.integral_time = 1e9;  // nothing is learned
  slide.control = law(slide.p);
  const double c = force_per_speed(slide.p), fresh = -std::expm1(-1e-3 / slide.p.rate_lag);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.05), 0.05 * c, 1e-9);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.1), (0.05 + 0.05 * fresh) * c, 1e-6);
  slide.cycle(-1, 0);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.1), 0.1 * c, 1e-9);
}

// A push that is measured but not there: b undoes all that is fed forward for it, and no more.
TEST(velocity_direct_control, unlearns_a_push_that_is_not_there) {
  held_slide slide;
  const auto& p = slide.p;
  constexpr double push = 10;  // [N]
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05, -push), 0.05 * force_per_speed(p) + push * p.force_share,
              1e-9);
  for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, 0.05, -push);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05, -push), 0.05 * force_per_speed(p), 1e-9);
}

// Brakes that lag make nothing any more where the next contact begins.
TEST(velocity_direct_control, knows_that_brakes_are_let_go_in_free_space) {
  held_slide slide;
  slide.brakes.time_constant.setConstant(0.02);
  const double first = slide.cycle(slide.p.rest_depth, -0.05);
  for (int k = 0; k < 100; ++k) slide.cycle(slide.p.rest_depth, -0.05);
  slide.cycle(-1, 0);
  slide.time += 1;
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.05), first, 1e-9);
}

// At rest it is held by 2 N: it is told twice that, and nothing is learned of it.
TEST(velocity_direct_control, a_brake_at_rest_is_told_little_more_than_what_holds_it) {
  held_slide slide;
  for (int k = 0; k < 50; ++k) EXPECT_NEAR(slide.cycle(5e-3, 0, -2), 4, 1e-9);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.05), 0.05 * force_per_speed(slide.p), 1e-9);
}

// Stuck as it leaves: b falls to a 1/e of itself on release_length.
TEST(velocity_direct_control, lets_a_brake_go_that_sticks_while_the_handle_leaves) {
  held_slide slide;
  const auto& p = slide.p;
  for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, -0.05);
  const double learned = slide.cycle(p.rest_depth, -0.05) - 0.05 * force_per_speed(p);
  constexpr double speed = 0.01;  // within the dead band
  constexpr int cycles = 10;
  constexpr double push = 10;  // [N]
  for (int k = 0; k < cycles; ++k) slide.cycle(p.rest_depth, speed, -push);
  const double left = slide.cycle(p.rest_depth, -0.05) - 0.05 * force_per_speed(p);
  const double forward = push * p.force_share, share = std::pow(1 - 1e-3 * speed / p.release_length, cycles);
  EXPECT_NEAR(left, std::max((learned + forward) * share - forward, -forward), 0.05 * learned);
}

// However long it sticks so, no more is let go than all that is wanted: what the hand pulls is still met.
TEST(velocity_direct_control, lets_no_more_go_than_there_is) {
  held_slide slide;
  const auto& p = slide.p;
  for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, -0.05);
  constexpr double pull = 10;  // [N], f_ff = -phi 10 N
  slide.time += 0.05;
  slide.cycle(p.rest_depth, 0.01, pull);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), 0.05 * force_per_speed(p) + pull * p.force_share, 1e-9);
}

// What the depth jumps by, beyond its motion, is a count of the encoders: it rests deeper. At depths whose
// reference is below v_max.
TEST(velocity_direct_control, rests_deeper_where_it_sees_coarsely) {
  const constants p;
  constexpr double depth = 0.004, v = -0.05, dt = 1e-3;
  for (const double jump : {0.1e-3, 0.5e-3, 1e-3, 5e-3}) {
    held_slide slide;
    slide.p.depth_per_jump = p.depth_per_jump;
    slide.control = law(slide.p);
    slide.cycle(depth, v);
    const double f = slide.cycle(depth + jump - 2 * v * dt, v);
    const double rest = std::max(p.rest_depth, std::min(p.depth_per_jump * jump, constants::max_rest_depth));
    const double wanted = p.depth_gain * (depth + jump - 2 * v * dt - rest);
    EXPECT_NEAR(f, (wanted - v) * force_per_speed(p), 1e-9) << jump;
  }
}

// A floor that rises by itself is no count of the encoders.
TEST(velocity_direct_control, rests_no_deeper_where_the_wall_jumps) {
  held_slide slide;
  slide.p.depth_per_jump = constants().depth_per_jump;
  slide.p.integral_time = 1e9;  // nothing is learned
  slide.control = law(slide.p);
  constexpr double v = -0.05, rise = 2e-3, moved = 1e-4;
  const double depth = slide.p.rest_depth;
  slide.cycle(depth, v);
  const double f = slide.cycle(depth + rise + moved, v, 0, rise);
  EXPECT_NEAR(f, (slide.p.depth_gain * (rise + moved) - v) * force_per_speed(slide.p), 1e-6);
}

// A jump is forgotten in jump_time, and a pause of more than that forgets no more than all.
TEST(velocity_direct_control, forgets_how_coarsely_it_saw) {
  constexpr double depth = 0.004, v = -0.05, dt = 1e-3, jump = 0.5e-3, forgotten_in = 2;
  held_slide slide;
  slide.p.depth_per_jump = constants().depth_per_jump;
  slide.p.rest_depth = 1e-3;
  slide.p.integral_time = 1e9;  // nothing is learned
  slide.control = law(slide.p);
  const auto rest = [&] {
    return depth - (slide.cycle(depth, v) / force_per_speed(slide.p) + v) / slide.p.depth_gain;
  };
  slide.cycle(depth - jump + 2 * v * dt, v);
  EXPECT_NEAR(rest(), slide.p.depth_per_jump * jump, 1e-9);
  EXPECT_NEAR(rest(), slide.p.depth_per_jump * jump * (1 - dt / forgotten_in), 1e-9);
  slide.time += 0.5;
  EXPECT_NEAR(rest(),
              slide.p.depth_per_jump * jump * (1 - dt / forgotten_in) * (1 - (0.5 + dt) / forgotten_in),
              1e-9);
  for (int k = 0; k < 3; ++k) {
    slide.time += 5;
    EXPECT_NEAR(rest(), slide.p.rest_depth, 1e-9) << k;
  }
}

}  // namespace
