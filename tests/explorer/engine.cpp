// The engine of the explorer: what it shows is what the library's own functions return.
#include <device.hpp>
#include <laws.hpp>
#include <outline.hpp>
#include <presets.hpp>

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/shapes/convex_polygon.hpp>
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

const explorer::preset& preset_of(const std::string& id) {
  const auto* found = std::find_if(std::begin(explorer::presets), std::end(explorer::presets),
                                   [&](const auto& p) { return p.id == id; });
  EXPECT_NE(found, std::end(explorer::presets)) << id;
  return *found;
}

// The numbers of a value.
std::vector<double> value_of(explorer::value_table& table, const std::string& id) {
  for (const auto& v : table.names())
    if (id == v.id) return {table.data() + v.offset, table.data() + v.offset + v.size};
  ADD_FAILURE() << "no value " << id;
  return {};
}
std::vector<double> value_of(device& of, const std::string& id) { return value_of(of.values(), id); }

std::string refusal(const std::string& text) {
  try {
    explorer::make_device(settings(text));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(explorer, presets_are_valid_and_their_settings_make_them_again) {
  std::vector<std::string> ids;
  for (const auto& p : explorer::presets) {
    const auto made = explorer::make_device(settings(p.settings));
    made->evaluate();
    EXPECT_EQ(value_of(*made, "status")[0], 0) << p.id;
    EXPECT_NE(std::string(p.look), "") << p.id;
    ids.emplace_back(p.id);
    const auto again = explorer::make_device(made->changed());
    again->evaluate();
    ASSERT_EQ(made->values().size(), again->values().size());
    for (int i = 0; i < made->values().size(); ++i)
      EXPECT_EQ(made->values().data()[i], again->values().data()[i]) << p.id << " " << i;
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

// The slider of step 4: a law of a user with a constant alpha.
struct constant_scale {
  static constexpr bool needs_hand_force = true;
  double alpha;

  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    return T(alpha);
  }
};

// A controller of the library, as a user writes it, decides what the explorer shows.
TEST(explorer, values_are_those_of_a_controller) {
  const ph::tendon_two_link<double> arm;
  const ph::brakes_of<ph::tendon_two_link<double>> brakes;
  const auto made = explorer::make_device(settings(preset_of("wall").settings));
  const double* s = made->state();
  const ph::device_state<ph::tendon_two_link<double>> state{0, {s[0], s[1]}, {s[2], s[3]}, {s[4], s[5]}};
  const auto compare = [&](const auto& law, double alpha) {
    made->set(settings("alpha=" + std::to_string(alpha)));
    made->evaluate();
    const ph::half_space<2> plane({0, 0.225}, {0, -1});
    ph::controller control(arm, brakes, ph::scene(ph::wall(plane)), law);
    const auto r = control(state);
    ASSERT_NE(r.power, ph::power_class::none);
    const ph::vector<double, 2> Fr = state.hand_force + ph::force_generators(arm, state.q) * r.torque;
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(value_of(*made, "capacity")[std::size_t(i)], r.capacity[i]);
      EXPECT_EQ(value_of(*made, "torque")[std::size_t(i)], r.torque[i]);
      EXPECT_EQ(value_of(*made, "Fd")[std::size_t(i)], r.desired_force[i]);
      EXPECT_NEAR(value_of(*made, "Fr")[std::size_t(i)], Fr[i], 1e-12);  // Fr[1] is the normal part
    }
    EXPECT_EQ(value_of(*made, "alpha")[0], r.alpha);
    EXPECT_EQ(value_of(*made, "gamma")[0], r.approximation_angle());
    EXPECT_EQ(value_of(*made, "display")[0], int(r.display));
    EXPECT_EQ(value_of(*made, "power")[0], int(r.power));
  };
  compare(ph::direct_control(), -1);
  for (int k = 0; k <= 100; ++k) compare(constant_scale{k / 100.0}, k / 100.0);
}

TEST(explorer, a_handle_that_is_pulled_off_has_not_bounced) {
  const auto made = explorer::make_device(settings(
      "mechanism=tendon_two_link\nlaw=velocity_direct_control\nq=1.7783850056991168,-1.2684323440621927"));
  made->evaluate();
  const double x = value_of(*made, "x")[0];
  const auto simulation = made->simulate();
  simulation->step(500, {x, 0.24, 0}, true);
  EXPECT_GT(value_of(simulation->row(), "depth")[0], 0);
  simulation->step(500, {x, 0.2, 0}, true);
  EXPECT_LT(value_of(simulation->row(), "depth")[0], -1e-3);
  EXPECT_EQ(simulation->figures()[0], 0);
}

// What the paper says of its figures.
TEST(explorer, figures_are_those_of_the_paper) {
  const auto evaluated = [](const char* id) {
    auto made = explorer::make_device(settings(preset_of(id).settings));
    made->evaluate();
    return made;
  };
  const auto exact = evaluated("fig3-Fd1"), near_by = evaluated("fig3-Fd2"), active = evaluated("fig3-Fd3");
  EXPECT_EQ(value_of(*exact, "display")[0], int(ph::display_class::exact));
  EXPECT_EQ(value_of(*exact, "power")[0], int(ph::power_class::passive_1));
  EXPECT_EQ(value_of(*exact, "gamma")[0], 0);
  EXPECT_EQ(value_of(*exact, "region")[0], 1);  // passive FME 2
  EXPECT_EQ(value_of(*near_by, "display")[0], int(ph::display_class::approximate));
  EXPECT_EQ(value_of(*near_by, "power")[0], int(ph::power_class::passive_2));
  EXPECT_NEAR(value_of(*near_by, "Fc")[0], 0, 1e-15);  // R2- is (0, sqrt 2)
  EXPECT_NEAR(value_of(*near_by, "gamma")[0], std::atan2(0.4, 0.8), 1e-14);
  EXPECT_EQ(value_of(*active, "power")[0], int(ph::power_class::active));
  EXPECT_EQ(value_of(*active, "display")[0], int(ph::display_class::none));

  const ph::vector<double, 2> n(0.5, -0.8660254037844386);
  const auto normal_part = [&](device& of) {
    const auto F = value_of(of, "Fr");
    return F[0] * n[0] + F[1] * n[1];
  };
  EXPECT_LT(normal_part(*evaluated("fig5a")), -0.1);      // into the wall
  EXPECT_GT(normal_part(*evaluated("fig5b")), 0.1);       // the pull-back
  EXPECT_NEAR(normal_part(*evaluated("fig6")), 0, 1e-3);  // Fd is printed with four digits
  const auto direct = evaluated("fig6");
  EXPECT_GT(value_of(*direct, "alpha")[0], 0);
  EXPECT_LT(value_of(*direct, "alpha")[0], 1);
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
  int displayed = 0;
  for (std::size_t k = 0; k < 1000; ++k) {
    const auto& entry = explorer::mechanisms()[k % explorer::mechanisms().size()];
    const int n = entry.joints, d = entry.dimension, m = entry.brakes;
    if (n > d) continue;
    settings text(std::string("mechanism=") + entry.id +
                  "\ndesired=given\nlaw=" + explorer::laws[k / 8 % std::size(explorer::laws)].id);
    text.set("brakes.torque_limit", numbers(m, [&] { return std::pow(10, number(random)); }));
    text.set("brakes.present", numbers(m, [&] { return number(random) > -0.9 ? 1 : 0; }));
    text.set("Fh", numbers(d, [&] { return number(random); }));
    text.set("Fd", numbers(d, [&] { return number(random) * (k % 2 == 0 ? 10 : 100); }));
    const auto made = explorer::make_device(text);
    double *q = made->state(), *qd = q + n;
    for (int i = 0; i < n; ++i)
      q[i] += 0.3 * number(random), qd[i] = i == 0 && k % 5 == 0 ? 0 : number(random);
    made->evaluate();
    const auto F = value_of(*made, "displayed"), J = value_of(*made, "J");
    const auto capacity = value_of(*made, "capacity"), signs = value_of(*made, "signs");
    displayed += F[0] != 0 || F[1] != 0 || F[2] != 0 ? 1 : 0;
    for (int j = 0; j < n; ++j) {
      std::fill_n(qd, n, 0.0);
      qd[j] = 1;
      made->evaluate();
      const auto rates = value_of(*made, "w");  // column j of T
      double t = 0;
      for (int i = 0; i < d; ++i) t += J[std::size_t(i * n + j)] * F[std::size_t(i)];
      for (std::size_t i = 0; i < rates.size(); ++i) t += rates[i] * signs[i] * capacity[i];
      EXPECT_NEAR(t, 0, 1e-9) << made->changed().text();
    }
  }
  EXPECT_GT(displayed, 300);
}

TEST(explorer, inverse_kinematics_reach_where_the_handle_was) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(-0.004, 0.004);
  for (const auto& entry : explorer::mechanisms()) {
    const auto made = explorer::make_device(settings(std::string("mechanism=") + entry.id));
    made->evaluate();
    auto x = value_of(*made, "x");
    made->move({0.03, -0.02, 0});
    made->evaluate();
    EXPECT_NEAR(value_of(*made, "v")[0], 0.03, 1e-12) << entry.id;
    EXPECT_NEAR(value_of(*made, "v")[1], -0.02, 1e-12) << entry.id;
    for (int k = 0; k < 50; ++k) {
      const std::vector<double> to = {x[0] + step(random), x[1] + step(random),
                                      entry.dimension == 3 ? x[2] + step(random) : 0.0};
      const bool is_reached = made->reach({to[0], to[1], to[2]});
      made->evaluate();
      const auto found = value_of(*made, "x");
      for (int i = 0; is_reached && i < entry.dimension; ++i)
        EXPECT_NEAR(found[std::size_t(i)], to[std::size_t(i)], 1e-9) << entry.id;
      EXPECT_TRUE(is_reached || k > 0) << entry.id;
      if (k % 10 == 9) x = found;
    }
    EXPECT_EQ(made->reach({10, 10, 10}), std::string(entry.id) == "xy_table") << entry.id;
    made->reach({std::nan(""), 0, 0});
    for (int i = 0; i < entry.joints; ++i) EXPECT_TRUE(std::isfinite(made->state()[i])) << entry.id;
  }
}

TEST(explorer, the_other_elbow_has_the_handle_at_one_place) {
  const auto made = explorer::make_device(settings("mechanism=two_link"));
  made->evaluate();
  const auto before = value_of(*made, "x");
  const double q2 = made->state()[1];
  ASSERT_TRUE(made->flip());
  made->evaluate();
  EXPECT_NEAR(made->state()[1], -q2, 1e-12);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(value_of(*made, "x")[i], before[i], 1e-12);
  EXPECT_FALSE(explorer::make_device(settings("mechanism=xy_table"))->flip());
}

TEST(explorer, refuses_with_the_words_of_the_library) {
  const auto of_arm = [](const char* line) { return refusal(std::string("mechanism=two_link\n") + line); };
  EXPECT_EQ(of_arm("mechanism.length_1=-1"),
            "passive_haptics: length_1 [m] = -1, expected a finite number > 0");
  EXPECT_EQ(of_arm("mechanism.length_1=abc"), "mechanism.length_1 = 'abc', expected a number");
  EXPECT_EQ(of_arm("q=1"), "q = '1', expected 2 numbers with commas between");
  EXPECT_EQ(of_arm("q=1e300,1").substr(0, 23), "passive_haptics: q[0] [");
  EXPECT_EQ(of_arm("lenght=1"), "setting = 'lenght', expected a name of the device's form");
  EXPECT_EQ(of_arm("scene=plane:1,2").substr(0, 46), "scene = 'plane:1,2', expected none, plane:X,Y,");
  for (const char* line : {"scene=solid:0,0,-1", "scene=edge:0,0,1,0,2,0", "scene=outline:0,0,1,1,1,0,0,1",
                           "q=nan,1", "law=magic", "no equals sign"})
    EXPECT_NE(of_arm(line), "") << line;
  EXPECT_NE(refusal("mechanism=hexapod"), "");
  EXPECT_EQ(of_arm("law.depth_gain=20\nlaw=direct_control"), "");  // of another law
}

TEST(explorer, refused_settings_change_nothing) {
  const auto made = explorer::make_device(settings("mechanism=two_link\nlaw=velocity_direct_control"));
  const std::string before = made->changed().text();
  EXPECT_THROW(made->set(settings("mechanism.length_1=0.2\nmechanism.length_2=-1")), std::invalid_argument);
  EXPECT_THROW(made->set(settings("mechanism.length_1=0.2\nscene=plane")), std::invalid_argument);
  EXPECT_EQ(made->changed().text(), before);
}

// A record is a log of the library: replayed under the same settings it commands the same capacities.
TEST(explorer, a_record_replays_to_the_last_digit) {
  for (const char* law :
       {"no_direct_control", "direct_control", "saturated_direct_control", "velocity_direct_control"}) {
    const std::string text =
        std::string("mechanism=tendon_two_link\nlaw=") + law + "\nq=1.7783850056991168,-1.2684323440621927";
    const auto made = explorer::make_device(settings(text));
    const auto simulation = made->simulate();
    simulation->record(true);
    simulation->step(400, {0.1, 0.235, 0}, true);
    simulation->record(false);
    const auto replayed = made->replay(simulation->log());
    EXPECT_EQ(replayed->count(), 400) << law;
    EXPECT_EQ(replayed->agreement()[1], 400) << law;
    EXPECT_EQ(replayed->agreement()[0], 400) << law;
    EXPECT_NE(simulation->device_file(), "") << law;
    EXPECT_EQ(value_of(replayed->row(399), "t")[0], 0.399) << law;
  }
  const auto made = explorer::make_device(settings("mechanism=two_link"));
  EXPECT_THROW(made->replay("t,q1\n0,1\n"), std::runtime_error);
  EXPECT_THROW(made->replay(""), std::runtime_error);
}

TEST(explorer, without_direct_control_it_bounces_and_with_velocity_control_it_glides) {
  const auto separations = [](const char* id) {
    const auto simulation = explorer::make_device(settings(preset_of(id).settings))->simulate();
    simulation->step(2500, {0, 0, 0}, false);
    EXPECT_LE(simulation->figures()[6], 1e-15) << id;  // no brake gives power
    return simulation->figures()[0];
  };
  EXPECT_GE(separations("bounce"), 3);
  EXPECT_EQ(separations("glide"), 0);
}

TEST(explorer, a_simulation_takes_other_settings_while_it_runs) {
  const auto simulation = explorer::make_device(settings("mechanism=two_link"))->simulate();
  simulation->step(100, {0.1, 0.23, 0}, true);
  const auto x = value_of(simulation->row(), "x");
  simulation->set(settings("law=velocity_direct_control\nbrakes.torque_limit=0.5,0.5"));
  simulation->step(1, {0.1, 0.23, 0}, true);
  EXPECT_NEAR(value_of(simulation->row(), "x")[0], x[0], 1e-3);
  EXPECT_EQ(simulation->cycles(), 101);
  EXPECT_THROW(simulation->set(settings("hand=along\nscene=none")), std::invalid_argument);
  EXPECT_THROW(simulation->set(settings("hand.damping=1e5")), std::invalid_argument) << "of 0.1 ms a step";
}

TEST(explorer, the_outline_of_a_convex_body_is_a_convex_polygon) {
  const std::vector<ph::point<2>> corners = {{0, 0}, {2, 0}, {2, 1}, {0.5, 1.5}};
  const explorer::outline outline(corners);
  const ph::convex_polygon<4> polygon({{0, 0}, {2, 0}, {2, 1}, {0.5, 1.5}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 3);
  for (int k = 0; k < 2000; ++k) {
    const ph::point<2> x(place(random), place(random));
    EXPECT_NEAR(outline.distance(x), polygon.distance(x), 1e-12);
    EXPECT_LT((outline.gradient(x) - polygon.gradient(x)).norm(), 1e-9);
  }
  EXPECT_TRUE(std::isnan(outline.distance({std::nan(""), 0})));
}

// A map has the library's figures, and NaN where the device does not reach.
TEST(explorer, a_map_ends_at_the_reach) {
  const auto made = explorer::make_device(settings("mechanism=two_link"));
  const auto map = made->map(31, 31, {-0.4, -0.4}, {0.4, 0.4});
  EXPECT_EQ(map->advance(10), 10);
  EXPECT_EQ(map->advance(100), 31);
  for (int k = 0; k < 31 * 31; ++k) {
    const double x = -0.4 + 0.8 * (k % 31) / 30, y = -0.4 + 0.8 * (k / 31) / 30, cosine = map->figure(0)[k];
    const double square = x * x + y * y;
    EXPECT_TRUE(square <= 0.3 * 0.3 || std::isnan(cosine)) << x << " " << y;
    EXPECT_TRUE(square > 0.3 * 0.3 || square < 1e-4 || (cosine >= 0 && cosine <= 1)) << x << " " << y;
  }
  EXPECT_THROW(map->figure(6), std::invalid_argument);
}

}  // namespace
