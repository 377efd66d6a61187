// The engine of the explorer: what it shows is what the library's own functions return.
#include <device.hpp>
#include <map.hpp>
#include <presets.hpp>
#include <replay.hpp>
#include <simulation.hpp>

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

namespace ph = passive_haptics;
using explorer::device;
using explorer::settings;

device device_of(const std::string& text) { return explorer::make_device(settings(text)); }

const explorer::preset& preset_of(const std::string& id) {
  const auto* found = std::find_if(std::begin(explorer::presets), std::end(explorer::presets),
                                   [&](const auto& p) { return p.id == id; });
  EXPECT_NE(found, std::end(explorer::presets)) << id;
  return *found;
}

// The numbers of a value.
std::vector<double> value_of(explorer::value_table& table, const std::string& id) {
  const auto found = table.value(id);
  EXPECT_FALSE(found.empty()) << id;
  return {found.begin(), found.end()};
}
std::vector<double> value_of(device& of, const std::string& id) { return value_of(of.values(), id); }
device evaluated(const std::string& text) {
  device made = device_of(text);
  made.evaluate();
  return made;
}

std::string refusal(const std::string& text) {
  try {
    device_of(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(explorer, presets_are_valid_and_their_settings_make_them_again) {
  for (const auto& p : explorer::presets) {
    device made = evaluated(p.settings);
    EXPECT_EQ(value_of(made, "status")[0], 0) << p.id;
    device again = evaluated(made.changed().text());
    for (int i = 0; i < made.values().size(); ++i)
      EXPECT_EQ(made.values().data()[i], again.values().data()[i]) << p.id << " " << i;
  }
}

// A controller of the library, as a user writes it, decides what the explorer shows.
TEST(explorer, values_are_those_of_a_controller) {
  const ph::tendon_two_link<double> arm;
  const ph::brakes_of<ph::tendon_two_link<double>> brakes;
  device made = device_of(preset_of("wall").settings);
  const double* s = made.state();
  const ph::device_state<ph::tendon_two_link<double>> state{0, {s[0], s[1]}, {s[2], s[3]}, {s[4], s[5]}};
  const auto compare = [&](const auto& law, double alpha) {
    made.set(settings("alpha=" + std::to_string(alpha)));
    made.evaluate();
    const ph::half_space<2> plane({0, 0.225}, {0, -1});
    ph::controller control(arm, brakes, ph::scene(ph::wall(plane)), law);
    const auto r = control(state);
    ASSERT_NE(r.power, ph::power_class::none);
    const ph::vector<double, 2> Fr = state.hand_force + ph::force_generators(arm, state.q) * r.torque;
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(value_of(made, "capacity")[std::size_t(i)], r.capacity[i]);
      EXPECT_EQ(value_of(made, "torque")[std::size_t(i)], r.torque[i]);
      EXPECT_EQ(value_of(made, "Fd")[std::size_t(i)], r.desired_force[i]);
      EXPECT_NEAR(value_of(made, "Fr")[std::size_t(i)], Fr[i], 1e-12);  // Fr[1] is the normal part
    }
    EXPECT_EQ(value_of(made, "alpha")[0], r.alpha);
    EXPECT_EQ(value_of(made, "gamma")[0], r.approximation_angle());
    EXPECT_EQ(value_of(made, "display")[0], int(r.display));
    EXPECT_EQ(value_of(made, "power")[0], int(r.power));
  };
  compare(ph::direct_control(), -1);
  for (int k = 0; k <= 100; ++k)
    compare(explorer::constant_scale{k / 100.0}, k / 100.0);  // the slider of step 4
}

TEST(explorer, a_handle_that_is_pulled_off_has_not_bounced) {
  device made = evaluated(
      "mechanism=tendon_two_link\nlaw=velocity_direct_control\nq=1.7783850056991168,-1.2684323440621927");
  const double x = value_of(made, "x")[0];
  explorer::simulation simulation(made.parts().settings);
  simulation.step(500, {x, 0.24, 0}, true);
  EXPECT_GT(value_of(simulation.row(), "depth")[0], 0);
  simulation.step(500, {x, 0.2, 0}, true);
  EXPECT_LT(value_of(simulation.row(), "depth")[0], -1e-3);
  EXPECT_EQ(simulation.figures()[0], 0);
}

// Statements of the paper about its figures.
TEST(explorer, figures_are_those_of_the_paper) {
  const auto value = [](const char* id, const char* name) {
    device made = evaluated(preset_of(id).settings);
    return value_of(made, name);
  };
  EXPECT_EQ(value("fig3-Fd1", "display")[0], int(ph::display_class::exact));
  EXPECT_EQ(value("fig3-Fd1", "power")[0], int(ph::power_class::passive_1));
  EXPECT_EQ(value("fig3-Fd1", "gamma")[0], 0);
  EXPECT_EQ(value("fig3-Fd1", "region")[0], 1);  // passive FME 2
  EXPECT_EQ(value("fig3-Fd2", "display")[0], int(ph::display_class::approximate));
  EXPECT_EQ(value("fig3-Fd2", "power")[0], int(ph::power_class::passive_2));
  EXPECT_NEAR(value("fig3-Fd2", "Fc")[0], 0, 1e-15);  // R2- is (0, sqrt 2)
  EXPECT_NEAR(value("fig3-Fd2", "gamma")[0], std::atan2(0.4, 0.8), 1e-14);
  EXPECT_EQ(value("fig3-Fd3", "power")[0], int(ph::power_class::active));
  EXPECT_EQ(value("fig3-Fd3", "display")[0], int(ph::display_class::none));

  const auto normal_part = [&](const char* id) {
    const auto F = value(id, "Fr");
    return F[0] * 0.5 - F[1] * 0.8660254037844386;
  };
  EXPECT_LT(normal_part("fig5a"), -0.1);      // into the wall
  EXPECT_GT(normal_part("fig5b"), 0.1);       // the pull-back
  EXPECT_NEAR(normal_part("fig6"), 0, 1e-3);  // Fd is printed with four digits
  EXPECT_GT(value("fig6", "alpha")[0], 0);
  EXPECT_LT(value("fig6", "alpha")[0], 1);
}

// The displayed force is that of the commanded capacities, each against its brake's motion: J^T F = T^T t.
TEST(explorer, the_displayed_force_is_that_of_the_capacities) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto numbers = [](int count, const auto& draw) {
    std::string text = std::to_string(draw());
    for (int i = 1; i < count; ++i) text.append(",").append(std::to_string(draw()));
    return text;
  };
  const auto& all = explorer::catalogue();
  int displayed = 0;
  for (std::size_t k = 0; k < 1000; ++k) {
    const auto& entry = all.mechanisms()[k % all.mechanisms().size()];
    const auto [n, d, m] = entry.sizes;
    if (n > d) continue;
    settings text("mechanism=" + entry.name +
                  "\ndesired=given\nlaw=" + all.laws()[k / 8 % all.laws().size()].name);
    text.set("brakes.torque_limit", numbers(m, [&] { return std::pow(10, number(random)); }));
    text.set("brakes.present", numbers(m, [&] { return number(random) > -0.9 ? 1 : 0; }));
    text.set("Fh", numbers(d, [&] { return number(random); }));
    text.set("Fd", numbers(d, [&] { return number(random) * (k % 2 == 0 ? 10 : 100); }));
    device made = explorer::make_device(text);
    double *q = made.state(), *qd = q + n;
    for (int i = 0; i < n; ++i)
      q[i] += 0.3 * number(random), qd[i] = i == 0 && k % 5 == 0 ? 0 : number(random);
    made.evaluate();
    const auto F = value_of(made, "displayed"), J = value_of(made, "J");
    const auto capacity = value_of(made, "capacity"), signs = value_of(made, "signs");
    displayed += F[0] != 0 || F[1] != 0 || F[2] != 0 ? 1 : 0;
    for (int j = 0; j < n; ++j) {
      std::vector<double> unit(static_cast<std::size_t>(n));
      unit[std::size_t(j)] = 1;
      const auto rates = made.parts().mechanism->brake_rates({q, unit.size()}, unit);  // column j of T
      double t = 0;
      for (int i = 0; i < d; ++i) t += J[std::size_t(i * n + j)] * F[std::size_t(i)];
      for (std::size_t i = 0; i < rates.size(); ++i) t += rates[i] * signs[i] * capacity[i];
      EXPECT_NEAR(t, 0, 1e-9) << made.changed().text();
    }
  }
  EXPECT_GT(displayed, 300);
}

TEST(explorer, inverse_kinematics_reach_where_the_handle_was) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(-0.004, 0.004);
  for (const auto& entry : explorer::catalogue().mechanisms()) {
    device made = evaluated("mechanism=" + entry.name);
    auto x = value_of(made, "x");
    made.move({0.03, -0.02, 0});
    made.evaluate();
    EXPECT_NEAR(value_of(made, "v")[0], 0.03, 1e-12) << entry.name;
    EXPECT_NEAR(value_of(made, "v")[1], -0.02, 1e-12) << entry.name;
    for (int k = 0; k < 50; ++k) {
      const explorer::place to(x[0] + step(random), x[1] + step(random),
                               entry.sizes.task_dimension == 3 ? x[2] + step(random) : 0.0);
      const bool is_reached = made.reach(to);
      made.evaluate();
      const auto found = value_of(made, "x");
      for (int i = 0; is_reached && i < 3; ++i) EXPECT_NEAR(found[std::size_t(i)], to[i], 1e-9) << entry.name;
      EXPECT_TRUE(is_reached || k > 0) << entry.name;
      if (k % 10 == 9) x = found;
    }
    EXPECT_EQ(made.reach({10, 10, 10}), entry.name == "xy_table") << entry.name;
    made.reach({std::nan(""), 0, 0});
    for (int i = 0; i < entry.sizes.dof; ++i) EXPECT_TRUE(std::isfinite(made.state()[i])) << entry.name;
  }
}

TEST(explorer, refuses_with_the_words_of_the_library) {
  const auto of_arm = [](const char* line) { return refusal(std::string("mechanism=two_link\n") + line); };
  EXPECT_EQ(of_arm("mechanism.length_1=abc"), "mechanism.length_1 = 'abc': expected a number");
  EXPECT_EQ(of_arm("q=1"), "q = '1': expected 2 numbers with commas between");
  EXPECT_EQ(of_arm("q=1e300,1").substr(0, 23), "passive_haptics: q[0] [");
  EXPECT_EQ(of_arm("lenght=1"), "setting = 'lenght': expected a name of the device's form");
  EXPECT_EQ(of_arm("scene=plane:1,2").substr(0, 46), "scene = 'plane:1,2': expected none, plane:X,Y,");
  for (const char* line :
       {"scene=solid:0,0,-1", "scene=outline:0,0,1,1,2,2", "q=nan,1", "law=magic", "no equals sign"})
    EXPECT_NE(of_arm(line), "") << line;
  EXPECT_NE(refusal("mechanism=hexapod"), "");
  EXPECT_EQ(of_arm("law.depth_gain=20\nlaw=direct_control"), "");  // of another law
  device made = device_of("mechanism=two_link\nlaw=velocity_direct_control");
  const std::string before = made.changed().text();
  for (const char* line : {"mechanism.length_2=-1", "scene=plane"})
    EXPECT_THROW(made.set(settings(std::string("mechanism.length_1=0.2\n") + line)), std::invalid_argument);
  EXPECT_EQ(made.changed().text(), before);
}

// A record is a log of the library: replayed under the same settings it commands the same capacities.
TEST(explorer, a_record_replays_to_the_last_digit) {
  for (const auto& law : explorer::catalogue().laws()) {
    device made = device_of("mechanism=tendon_two_link\nlaw=" + law.name +
                            "\nq=1.7783850056991168,-1.2684323440621927");
    explorer::simulation simulation(made.parts().settings);
    simulation.record(true);
    simulation.step(400, {0.1, 0.235, 0}, true);
    explorer::replayed_log replayed(made.parts(), simulation.log());
    const auto& rows = replayed.rows();
    ASSERT_EQ(rows.size(), 400 * std::size_t(replayed.row().size())) << law.name;
    EXPECT_EQ(rows[399 * std::size_t(replayed.row().size())], 0.399) << law.name;
    EXPECT_EQ(replayed.agreement()[1], 400) << law.name;
    EXPECT_EQ(replayed.agreement()[0], 400) << law.name;
  }
  device made = device_of("mechanism=two_link");
  for (const char* log : {"t,q1\n0,1\n", ""})
    EXPECT_THROW(explorer::replayed_log(made.parts(), log), std::runtime_error);
}

TEST(explorer, a_simulation_takes_other_settings_while_it_runs) {
  explorer::simulation simulation(device_of("mechanism=two_link").parts().settings);
  simulation.step(100, {0.1, 0.23, 0}, true);
  const auto x = value_of(simulation.row(), "x");
  simulation.set(settings("law=velocity_direct_control\nbrakes.torque_limit=0.5"));
  simulation.step(1, {0.1, 0.23, 0}, true);
  EXPECT_NEAR(value_of(simulation.row(), "x")[0], x[0], 1e-3);
  EXPECT_EQ(value_of(simulation.row(), "t")[0], 0.1);
  EXPECT_THROW(simulation.set(settings("hand=along\nscene=none")), std::invalid_argument);
  EXPECT_THROW(simulation.set(settings("hand.damping=1e5")), std::invalid_argument) << "of 0.1 ms a step";
}

// A map has classes of displayed forces, and NaN where the device does not reach.
TEST(explorer, a_map_ends_at_the_reach) {
  explorer::figure_map map(device_of("mechanism=two_link").parts().settings, 31, 31, {-0.4, -0.4, 0},
                           {0.4, 0.4, 0});
  EXPECT_EQ(map.advance(10), 10);
  EXPECT_EQ(map.advance(100), 31);
  for (int k = 0; k < 31 * 31; ++k) {
    const double radius = std::hypot(-0.4 + 0.8 * (k % 31) / 30, -0.4 + 0.8 * (k / 31) / 30);
    const double cosine = map.figure(0)[std::size_t(k)];
    EXPECT_TRUE(radius > 0.3 ? std::isnan(cosine) : radius < 0.01 || (cosine >= 0 && cosine <= 1)) << radius;
  }
}

}  // namespace
