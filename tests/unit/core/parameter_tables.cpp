// What follows from a table of parameters: errors, remarks, text.
#include "../support.hpp"

#include <passive_haptics/core/parameter_text.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

using ph::member, ph::range;

enum class side { left, right };

struct spring {
  double stiffness = 100;
  std::array<double, 2> direction{3, 4};
  side where = side::right;

  static constexpr const char* type_name = "a spring";
  static constexpr auto members() {
    using p = spring;
    return ph::member_table(
        member("stiffness", &p::stiffness, "N/m", range::not_negative).remark_at_zero("it pulls nothing"),
        member("direction", &p::direction, "1", range::direction),
        ph::choice("where", &p::where, "left, right"));
  }
};

struct machine {
  double mass = 0.5;
  ph::vector<double, 2> limit{1, 2};
  ph::matrix<double, 2, 2> gain = ph::matrix<double, 2, 2>::Identity();
  std::array<spring, 2> springs{};
  std::array<ph::vector<double, 2>, 2> corners{ph::vector<double, 2>(0, 0), ph::vector<double, 2>(1, 1)};
  std::array<double, 1> turn{1};
  int cycles = 3;
  std::uint64_t seed = 1;
  bool on = true;
  std::string name = "bench";
  double unlisted = 0;

  static constexpr auto members() {
    using p = machine;
    return ph::member_table(
        member("mass", &p::mass, "kg", range::positive),
        member("limit", &p::limit, "N", range::finite).suspicious_below(0.5).suspicious_above(50),
        member("gain", &p::gain, "1", range::finite), member("springs", &p::springs),
        member("corners", &p::corners, "m", range::finite), member("turn", &p::turn, "rad"),
        member("cycles", &p::cycles, "", range::at_least(1)).suspicious_above(1000), member("seed", &p::seed),
        member("on", &p::on), member("name", &p::name));
  }
  std::string rules() const { return mass > 100 * cycles ? "too heavy: expected less" : ""; }
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

// Of a machine that was changed.
template <class Change>
std::string error(Change change) {
  machine m;
  change(m);
  return ph::validate(m);
}

TEST(parameter_table, names_each_wrong_value_where_it_stands) {
  EXPECT_EQ(error([](auto&) {}), "");
  EXPECT_EQ(error([](auto& m) { m.mass = -1; }), "mass [kg] = -1: expected a finite number > 0");
  EXPECT_EQ(error([](auto& m) { m.mass = nan; }), "mass [kg] = nan: expected a finite number > 0");
  EXPECT_EQ(error([](auto& m) { m.limit[1] = -infinity; }), "limit[1] [N] = -inf: expected a finite number");
  EXPECT_EQ(error([](auto& m) { m.gain(1, 0) = nan; }), "gain(1, 0) [1] = nan: expected a finite number");
  EXPECT_EQ(error([](auto& m) { m.springs[1].stiffness = -2; }),
            "springs[1].stiffness of a spring [N/m] = -2: expected a finite number >= 0");
  EXPECT_EQ(error([](auto& m) { m.springs[0].direction = {0, 0}; }),
            "|springs[0].direction| of a spring = 0: expected a direction");
  EXPECT_EQ(error([](auto& m) { m.corners[1][0] = nan; }),
            "corners[1][0] [m] = nan: expected a finite number");
  EXPECT_EQ(error([](auto& m) { m.cycles = 0; }), "cycles = 0: expected a whole number >= 1");
  EXPECT_EQ(error([](auto& m) { m.unlisted = nan; }), "");
  EXPECT_EQ(error([](auto& m) { m.mass = infinity, m.cycles = 0; }),
            "mass [kg] = inf: expected a finite number > 0")
      << "the first of them";
  EXPECT_EQ(error([](auto& m) { m.mass = 301; }), "too heavy: expected less") << "rules() of valid members";
  machine wrong;
  wrong.cycles = -1;
  EXPECT_EQ(thrown_by([&] { ph::require_valid(wrong); }),
            "passive_haptics: cycles = -1: expected a whole number >= 1");
}

TEST(parameter_table, finds_values_of_no_device_by_magnitude_and_names_them) {
  machine m;
  std::string all;
  const auto find = [&] {
    all.clear();
    ph::for_each_suspicious(
        m, [&](const auto& about, const std::string& text) { all += about.name + (" " + text) + "\n"; });
    return all;
  };
  EXPECT_EQ(find(), "");
  m.limit << 50, 0;
  m.cycles = 1000;
  EXPECT_EQ(find(), "");
  m.limit << 50.5, -infinity;
  m.cycles = std::numeric_limits<int>::min();
  EXPECT_EQ(find(),
            "limit limit[0] [N] = 50.5: expected at most 50\nlimit limit[1] [N] = -inf: expected at most 50\n"
            "cycles cycles = -2147483648: expected at most 1000\n");
  m.limit << 0.25, -0.25;
  m.cycles = 1;
  EXPECT_EQ(find(),
            "limit limit[0] [N] = 0.25: expected at least 0.5\nlimit limit[1] [N] = -0.25: expected at least "
            "0.5\n");
  // By its unit; a component of a point may be any rounding of 0
  m = {};
  m.mass = 1e30;
  m.corners[0] << 6e-17, 150;
  m.turn[0] = 90;
  EXPECT_EQ(
      find(),
      "mass mass [kg] = 1e30: expected at most 1000\ncorners corners[0][1] [m] = 150: expected at most 100\n"
      "turn turn[0] [rad] = 90: expected at most 6.28319; this looks like degrees: in radians it is "
      "1.5708\n");
  m = {};
  m.limit << nan, 0;
  EXPECT_EQ(find(), "") << "a NaN is wrong, not large";
}

TEST(parameter_table, remarks_on_what_looks_like_another_unit) {
  machine m;
  EXPECT_EQ(ph::remarks(m), "");
  m.mass = 1000;  // of which nothing is said
  m.springs[0].stiffness = 0;
  m.springs[1].stiffness = 10;
  m.corners[0] << 5, -5;
  m.corners[1] << 0, -150;
  m.turn[0] = 90;
  EXPECT_EQ(ph::remarks(m),
            "springs[0].stiffness of a spring [N/m] = 0: it pulls nothing\n"
            "springs[1].stiffness of a spring [N/m] = 10, usually 100 to 1e9: N/mm?\n"
            "corners[1][1] [m] = -150, usually within 5 m: millimetres?\n"
            "turn[0] [rad] = 90, usually within two turns: degrees?\n");
  m = {};
  m.turn[0] = std::numeric_limits<double>::quiet_NaN();  // an error, not a remark
  EXPECT_EQ(ph::remarks(m), "");
}

TEST(parameter_table, lists_all_values) {
  EXPECT_EQ(ph::to_text(machine()),
            "mass [kg] = 0.5\nlimit[0] [N] = 1\nlimit[1] [N] = 2\n"
            "gain(0, 0) [1] = 1\ngain(0, 1) [1] = 0\ngain(1, 0) [1] = 0\ngain(1, 1) [1] = 1\n"
            "springs[0].stiffness of a spring [N/m] = 100\nsprings[0].direction[0] of a spring [1] = 3\n"
            "springs[0].direction[1] of a spring [1] = 4\nsprings[0].where of a spring = right\n"
            "springs[1].stiffness of a spring [N/m] = 100\nsprings[1].direction[0] of a spring [1] = 3\n"
            "springs[1].direction[1] of a spring [1] = 4\nsprings[1].where of a spring = right\n"
            "corners[0][0] [m] = 0\ncorners[0][1] [m] = 0\ncorners[1][0] [m] = 1\ncorners[1][1] [m] = 1\n"
            "turn[0] [rad] = 1\ncycles = 3\nseed = 1\non = true\n"
            "name = \"bench\"\n");
}

TEST(parameter_table, gives_members_to_read_and_to_write) {
  machine m;
  ph::for_each_member(m, [](const auto& described, auto& value) {
    if constexpr (std::is_same_v<decltype(value), double&>) {
      EXPECT_STREQ(described.name, "mass");
      value = 7.0;
    }
  });
  EXPECT_EQ(m.mass, 7.0);
  int count = 0;
  ph::for_each_member(std::as_const(m), [&](const auto&, const auto&) { ++count; });
  EXPECT_EQ(count, 10);
}

// Users' own types go on as they are
struct own {
  int value = 0;
};
std::string validate(const own& o) { return o.value < 0 ? "value = " + std::to_string(o.value) : ""; }

struct own_and_described {
  int value = 0;
  static constexpr auto members() { return ph::member_table(member("value", &own_and_described::value)); }
};
std::string validate(const own_and_described&) { return "my own"; }

TEST(a_type_of_a_user, may_have_its_own_validate) {
  EXPECT_EQ(ph::require_valid(own{2}).value, 2);
  EXPECT_THROW(ph::require_valid(own{-1}), std::invalid_argument);
  EXPECT_THROW(ph::require_valid(own_and_described{}), std::invalid_argument);
  static_assert(!ph::Parameters<own> && ph::Parameters<own_and_described> && !ph::Parameters<int>);
}

}  // namespace
