// Parameters by name.
#include "../support.hpp"

#include <passive_haptics/mechanism/chains/serial_chain_parameters.hpp>
#include <passive_haptics/runtime/any_parameters.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>

namespace {

namespace rt = ph::runtime;

struct inner {
  double depth = 0.5;
  static constexpr auto members() { return ph::member_table(ph::member("depth", &inner::depth, "m")); }
};
struct everything {
  inner within;
  ph::matrix<double, 2, 3> rows = ph::matrix<double, 2, 3>::Zero();
  int count = 3;
  bool on = true;
  std::string name = "x";
  std::vector<ph::point<2>> corners;
  static constexpr auto members() {
    using p = everything;
    return ph::member_table(ph::member("within", &p::within), ph::member("rows", &p::rows, "1"),
                            ph::member("count", &p::count), ph::member("on", &p::on),
                            ph::member("name", &p::name), ph::member("corners", &p::corners, "m"));
  }
};

TEST(any_parameters, lists_each_member_by_name_and_type) {
  rt::any_parameters p{everything()};
  const rt::field_list all = p.fields();
  using kind = rt::field::kind;
  const std::vector<std::pair<std::string, kind>> expected{
      {"depth", kind::numbers}, {"rows", kind::numbers}, {"count", kind::whole},
      {"on", kind::truth},      {"name", kind::text},    {"corners", kind::points}};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].about.name, expected[i].first);
    EXPECT_EQ(all[i].type, expected[i].second) << all[i].about.name;
  }
  EXPECT_EQ(all[1].rows, 2);
  EXPECT_EQ(all[1].columns, 3);
}

TEST(any_parameters, is_written_through_its_fields) {
  rt::any_parameters p{everything()};
  const rt::field_list all = p.fields();
  *all[0].numbers() = 0.25;
  all[1].numbers()[3] = 7;
  all[2].set(all[2].at, 8);
  all[3].set(all[3].at, 0);
  all[4].text() = "y";
  double* corners = all[5].resize(all[5].at, 2);
  corners[3] = 9;
  EXPECT_EQ(all[5].size(all[5].at), 2U);
  const auto& now = p.as<everything>();
  EXPECT_EQ(now.within.depth, 0.25);
  EXPECT_EQ(now.rows(1, 1), 7);
  EXPECT_EQ(now.count, 8);
  EXPECT_FALSE(now.on);
  EXPECT_EQ(now.name, "y");
  EXPECT_EQ(now.corners.at(1)[1], 9);
  EXPECT_EQ(all[2].get(all[2].at), 8);
}

TEST(any_parameters, copies_are_values) {
  rt::any_parameters a{inner()};
  rt::any_parameters b = a, c;
  c = a;
  *a.fields()[0].numbers() = 2;
  EXPECT_EQ(b.as<inner>().depth, 0.5);
  EXPECT_EQ(c.as<inner>().depth, 0.5);
  EXPECT_THROW(c.as<everything>(), std::logic_error);
  EXPECT_TRUE(rt::any_parameters().fields().empty());
}

TEST(any_parameters, says_what_is_wrong_unusual_or_suspicious) {
  ph::ball_parameters<2> ball;
  ball.radius = -1;
  EXPECT_EQ(rt::any_parameters(ball).error(), ph::validate(ball));
  ball.radius = 50;
  EXPECT_EQ(rt::any_parameters(ball).remarks("wall: "), ph::remarks(ball, "wall: "));
  ball.radius = 500;
  std::vector<std::string> names;
  rt::any_parameters(ball).for_each_suspicious(
      [&](const char* name, const std::string&) { names.emplace_back(name); });
  EXPECT_EQ(names, std::vector<std::string>{"radius"});
}

TEST(any_parameters, a_choice_is_a_number_and_a_list_of_structs_one_of_tables) {
  rt::any_parameters p{ph::serial_chain_parameters<double, 3, 2>()};
  const rt::field_list all = p.fields();
  ASSERT_EQ(all[0].type, rt::field::kind::tables);
  ASSERT_EQ(all[0].tables.size(), 3u);
  const rt::field& kind = all[0].tables[1][0];
  EXPECT_EQ(kind.type, rt::field::kind::choice);
  kind.set(kind.at, 1);
  using parameters = ph::serial_chain_parameters<double, 3, 2>;
  EXPECT_EQ(p.as<parameters>().joints[1].kind, ph::joint_kind::prismatic);
}

}  // namespace
