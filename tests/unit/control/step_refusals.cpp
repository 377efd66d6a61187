// One control cycle: what it refuses.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <cmath>
#include <limits>

namespace {

using table = ph::xy_table<double>;
constexpr double nan_of_a_step = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity_of_a_step = std::numeric_limits<double>::infinity();

const ph::contact<2> good_contact{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e7, .sensed_at = {0, 0}};

// Of one wall, of several, and next to a good one.
template <class L>
void expect_refused(const ph::contact<2>& bad) {
  const auto moving_in = state_of<table>({0, 0}, {0, -1}, {0, -1});
  for (const ph::step_result<table>& result :
       {step_once<L>(table(), {}, moving_in, bad), step_once<L>(table(), {}, moving_in, bad, bad),
        step_once<L>(table(), {}, moving_in, good_contact, bad),
        step_once<L>(table(), {}, moving_in, bad, good_contact)}) {
    EXPECT_EQ(result.outcome, ph::status::contact_invalid)
        << "normal " << bad.normal.transpose() << ", depth " << bad.depth << ", stiffness " << bad.stiffness;
    EXPECT_TRUE(result.capacity.isZero(0));
  }
}

template <class L>
void expect_invalid_contacts_refused() {
  auto bad = good_contact;
  for (const double length : {0.0, 0.5, 1 - 1e-5, 1 + 1e-5, 3.0, 1e154, 1e200, 1.7e308}) {
    bad.normal = {0, length};
    expect_refused<L>(bad);
  }
  bad = good_contact;
  for (const double depth : {nan_of_a_step, -infinity_of_a_step}) {
    bad.depth = depth;
    expect_refused<L>(bad);
  }
  for (const double depth : {1e-3, -1e-3}) {
    bad.depth = depth;
    bad.stiffness = -1e7;
    expect_refused<L>(bad);
  }
}

TEST(step, refuses_a_normal_that_is_no_unit_vector_a_depth_that_is_none_and_a_negative_stiffness) {
  expect_invalid_contacts_refused<ph::no_direct_control>();
  expect_invalid_contacts_refused<ph::velocity_direct_control>();
  auto in_float = good_contact;
  in_float.normal = ph::vector<float, 2>(0.6f, 0.8f).cast<double>();
  EXPECT_EQ(step_once<ph::no_direct_control>(table(), {}, state_of<table>({0, 0}, {0, -1}), in_float).outcome,
            ph::status::ok)
      << "a normal that was computed in float";
}

TEST(step, refuses_a_contact_without_sensed_at_under_a_law_that_reads_it) {
  ph::contact<2> wall{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e7};
  expect_refused<ph::velocity_direct_control>(wall);
  const auto moving_in = state_of<table>({0, 0}, {0, -1}, {0, -1});
  EXPECT_EQ(step_once<ph::direct_control>(table(), {}, moving_in, wall).outcome, ph::status::ok);
  const auto set = step_once<ph::velocity_direct_control>(table(), {}, moving_in, good_contact);
  EXPECT_EQ(set.outcome, ph::status::ok);
  EXPECT_GT(set.capacity[1], 0);
}

TEST(step, refuses_a_time_that_does_not_rise_under_a_law_that_uses_differences) {
  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1})));
  ph::controller control(table(), ph::brakes_of<table>(), floor, ph::velocity_direct_control());
  ph::controller other(table(), ph::brakes_of<table>(), floor, ph::direct_control());
  const auto at = [](double time, double y) {
    auto state = state_of<table>({0, y}, {0, -1}, {0, -1});
    state.time = time;
    return state;
  };
  for (const double y : {-1e-3, 1.0}) {  // in the wall and in free space
    control.reset();
    EXPECT_EQ(control(at(5, y)).outcome, ph::status::ok);
    EXPECT_EQ(control(at(5, -1e-3)).outcome, ph::status::time_not_rising) << "it stands still";
    EXPECT_EQ(control(at(5, y)).outcome, ph::status::time_not_rising);
    EXPECT_EQ(control(at(5.001, y)).outcome, ph::status::ok);
    const auto back = control(at(4, -1e-3));
    EXPECT_EQ(back.outcome, ph::status::time_not_rising) << "it goes back";
    EXPECT_TRUE(back.capacity.isZero(0));
    EXPECT_EQ(control(at(4.001, y)).outcome, ph::status::ok) << "it rises again";
    control.reset();
    EXPECT_EQ(control(at(0, y)).outcome, ph::status::ok) << "another motion";
    for (const double time : {5.0, 5.0, 4.0}) EXPECT_EQ(other(at(time, y)).outcome, ph::status::ok);
  }
}

TEST(step, keeps_the_stiffness_where_the_new_one_is_none) {
  const ph::half_space<2> floor({0, 0}, {0, 1});
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(ph::wall(floor), ph::wall(floor)),
                         ph::no_direct_control());
  const auto state = state_of<table>({0, -1e-4}, {0, -1});
  const auto held = control(state).capacity;
  EXPECT_GT(held.norm(), 0);
  auto& one = control.scene().get<0>();
  for (const double none : {-1e7, -1e-300, infinity_of_a_step, -infinity_of_a_step, nan_of_a_step}) {
    EXPECT_FALSE(one.set_stiffness(none)) << none;
    EXPECT_EQ(one.stiffness(), 1e7);
    EXPECT_EQ(control(state).capacity, held);
  }
  EXPECT_TRUE(one.set_stiffness(0) && control.scene().get<1>().set_stiffness(0));
  EXPECT_TRUE(control(state).capacity.isZero(0));
}

// A custom wall with a gradient of length 3.
struct steep_floor {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const { return x[1]; }
  ph::point<2> gradient(const ph::point<2>&) const { return {0, 3}; }
};

TEST(step, refuses_a_shape_whose_gradient_is_no_unit_vector) {
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(ph::wall(steep_floor())),
                         ph::no_direct_control());
  EXPECT_EQ(control(state_of<table>({0, 1}, {0, -1})).outcome, ph::status::ok) << "in free space";
  const auto inside = state_of<table>({0, -1e-4}, {0, -1});
  EXPECT_EQ(control(inside).outcome, ph::status::contact_invalid);
  EXPECT_TRUE(control(inside).capacity.isZero(0));
}

// A law that answers with what it was made with.
struct scale_of {
  double value = 0;
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    return static_cast<T>(value);
  }
};

template <int Walls>
void expect_scales_outside_zero_and_one_refused() {
  ph::contacts<2, Walls> touched;
  for (int j = 0; j < Walls; ++j) touched.push_back(good_contact);
  for (const double value : {-0.1, 1.001, nan_of_a_step, 0.0, 0.5, 1.0}) {
    ph::step_memory<scale_of> memory;
    const auto result = ph::step(table(), ph::brakes_of<table>(), touched, scale_of{value},
                                 state_of<table>({0, 0}, {0, -1}), memory);
    const bool is_share = value >= 0 && value <= 1;
    EXPECT_EQ(result.outcome, is_share ? ph::status::ok : ph::status::scale_out_of_range) << value;
    EXPECT_EQ(result.capacity.isZero(0), !(value > 0 && is_share)) << value;
  }
}

TEST(step, refuses_a_scale_outside_zero_and_one) {
  expect_scales_outside_zero_and_one_refused<1>();
  expect_scales_outside_zero_and_one_refused<2>();
}

// Only brake 1 helps, at 60 deg from the wall's normal: twice the desired force.
TEST(step, releases_the_brakes_where_the_force_overflows_in_the_approximation) {
  const auto run = [](double share) {
    return step_once<ph::no_direct_control>(
        table(), {}, state_of<table>({0, 0}, {-1, 1}),
        ph::contact<2>{.normal = {0.5, std::sqrt(0.75)},
                       .depth = share * std::numeric_limits<double>::max(),
                       .stiffness = 1});
  };
  EXPECT_EQ(run(0.4).outcome, ph::status::ok);
  EXPECT_GT(run(0.4).capacity.norm(), 0);
  EXPECT_EQ(run(0.6).outcome, ph::status::result_not_finite);
  EXPECT_TRUE(run(0.6).capacity.isZero(0) && run(0.6).torque.isZero(0));
}

TEST(step, at_a_pose_without_position_or_jacobian_is_a_fault_that_no_scene_sees) {
  using M = hyperbola<double>;
  const auto bare = step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 1}, {1, 1}), good_contact);
  EXPECT_EQ(bare.outcome, ph::status::pose_undefined);
  EXPECT_TRUE(bare.capacity.isZero(0) && bare.torque.isZero(0));

  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 3}, {0, 1}), 1.0));
  ph::controller control(M(), ph::brakes_of<M>(), ph::held_scene(floor, 1), ph::no_direct_control{});
  const auto at = [&](double time, double q) {
    return control(ph::device_state<M>{time, {1, q}, {0, 1}, {0, 0}});
  };
  EXPECT_EQ(at(0, 1).desired_force[1], 2);
  EXPECT_EQ(at(5, 0).outcome, ph::status::pose_undefined);
  EXPECT_EQ(at(0.5, 0.5).desired_force[1], 2) << "still held";
}

}  // namespace
