// slow
// A mechanism that is known at run time only, and its plant.
#include "pairs.hpp"

#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

namespace {

using tendon = ph::tendon_two_link<double>;

template <class M>
void expect_as_itself(const M& own) {
  const rt::mechanism_model<M> any(own);
  EXPECT_EQ(any.sizes(), (rt::device_sizes{M::dof, M::task_dimension, M::brake_count}));
  EXPECT_EQ(any.has_inertia(), ph::Dynamics<M>);
  for (const auto& s : random_motion(own, 20)) {
    EXPECT_EQ(any.position(numbers(s.q)), rt::task_numbers(ph::mechanism_pose<M>(own, s.q).position()));
    EXPECT_EQ(any.brake_rates(numbers(s.q), numbers(s.qd)),
              rt::joint_numbers(ph::brake_rates(own, s.q, s.qd)));
    ph::jacobian_matrix<M> J;
    any.jacobian(numbers(s.q), {J.data(), static_cast<std::size_t>(J.size())});
    EXPECT_EQ(J, ph::jacobian_matrix<M>(ph::jacobian(own, s.q)));
    const ph::encoder_axes<M> axes(own);
    const auto maps = any.encoders();
    using T = ph::matrix<double, ph::encoder_axes<M>::count, M::dof>;
    const auto theta = axes.from_joints(s.q);
    EXPECT_LE((T(maps.from_joints.data()) * s.q - theta).norm(), 1e-15);
    using back = ph::matrix<double, M::dof, ph::encoder_axes<M>::count>;
    EXPECT_LE((back(maps.to_joints.data()) * theta - s.q).norm(), 1e-14);
  }
}

TEST(any_mechanism, is_as_the_mechanism_itself) {
  expect_as_itself(tendon());
  expect_as_itself(ph::xy_table<double>());
  expect_as_itself(ph::delta<double>());
}

TEST(any_mechanism, has_the_inverse_of_its_usual_branch_within_reach) {
  const rt::mechanism_model<tendon> arm(tendon{});
  const double near[] = {0.08, 0.2}, far[] = {1, 1};
  const rt::joint_numbers q = arm.inverse(near);
  ASSERT_EQ(q.size(), 2u);
  EXPECT_NEAR(arm.position(q)[0], 0.08, 1e-12);
  EXPECT_NEAR(arm.position(q)[1], 0.2, 1e-12);
  EXPECT_EQ(arm.inverse(far).size(), 0u);
  EXPECT_EQ(arm.solve(far, ph::elbow::left).outcome, ph::status::out_of_reach);
  EXPECT_GT(arm.solve(near, ph::elbow::right).q[1], 0);
}

TEST(any_plant, moves_as_the_simulated_device_itself) {
  using M = tendon;
  const M own;
  rt::catalogue all;
  all.compile_for<M>();
  const ph::joint_vector<M> q(1.9, -1.3);
  const ph::stribeck_brake<double> brake;
  ph::simulated_device device(own, std::array{brake, brake}, 0.3, q);
  const auto any =
      all.make_plant(rt::mechanism_model<M>(own), {2, rt::run_time_brake(brake)}, 0.3, numbers(q));
  ASSERT_TRUE(any);
  const ph::vector<double, 2> capacity(0.002, 0.01), push(3, -5);
  for (int k = 0; k < 500; ++k) {
    device.advance(1e-4, capacity, push);
    any->advance(1e-4, numbers(capacity), numbers(push));
  }
  EXPECT_EQ(any->q(), rt::joint_numbers(device.q()));
  EXPECT_EQ(any->qd(), rt::joint_numbers(device.qd()));
  EXPECT_EQ(any->rates(), rt::joint_numbers(device.rates()));
  EXPECT_EQ(any->position(), rt::task_numbers(device.position()));
  EXPECT_EQ(any->velocity(), rt::task_numbers(device.velocity()));
  EXPECT_EQ(any->sensed_force(), rt::task_numbers(device.sensed_force()));
  EXPECT_EQ(any->brake_torque(), rt::joint_numbers(device.brake_torque()));
  EXPECT_EQ(any->brake_power(), rt::joint_numbers(device.brake_power()));
  EXPECT_EQ(any->brake_force(), rt::task_numbers(device.brake_force()));
  EXPECT_EQ(any->min_mass(), device.min_mass());
  EXPECT_EQ(any->energy().brakes, device.energy().brakes);
  EXPECT_GT(device.qd().norm(), 0.1);
  any->set_motion(numbers(q), numbers(capacity));
  EXPECT_EQ(any->qd(), rt::joint_numbers(capacity));
}

TEST(any_controller, is_there_for_kinds_that_are_compiled) {
  rt::catalogue all;
  constexpr rt::named_law<ph::saturated_direct_control> law{"saturated_direct_control"};
  all.add_laws(law);
  all.compile_for<tendon>(law);
  EXPECT_TRUE(all.is_compiled(rt::mechanism_model<tendon>(tendon()), all.laws()[0]));
  EXPECT_FALSE(all.is_compiled(rt::mechanism_model<ph::delta<double>>(ph::delta<double>()), all.laws()[0]));
}

TEST(any_plant, is_there_where_it_is_compiled) {
  const double q[] = {0, 0};
  const std::vector<rt::run_time_brake> brakes(2, rt::run_time_brake(ph::coulomb_brake<double>()));
  EXPECT_FALSE(rt::catalogue().make_plant(rt::mechanism_model<tendon>(tendon()), brakes, 0.3, q));
}

TEST(braked_wall, has_the_numbers_of_the_mechanism_itself) {
  rt::catalogue all;
  all.compile_for<tendon>();
  const tendon own;
  const rt::mechanism_model<tendon> any(own);
  const ph::vector<double, 2> q(1.9, -1.3), v(0.05, 0.1), n(0, -1), residual(0.01, 0.02), count(1e-3, 2e-3);
  rt::brake_numbers brakes(2);
  brakes.torque_limit = {0.8, 1.2};
  const auto expected =
      ph::braked_wall_at(own, q, v, n, brakes.as<ph::switchable_brakes<tendon>>(), residual, count, 0.3);
  rt::wall_touch touch{numbers(q), numbers(v), numbers(n), numbers(residual), numbers(count), 0.3};
  const auto found = all.braked_wall_at(any, brakes, touch);
  ASSERT_TRUE(found);
  EXPECT_EQ(ph::to_text(*found), ph::to_text(expected));
  EXPECT_FALSE(rt::catalogue().braked_wall_at(any, brakes, touch));
  touch.residual_torque = {};
  EXPECT_THROW(all.braked_wall_at(any, brakes, touch), std::invalid_argument);
}

}  // namespace
