// What the tool makes of small headers.
#include "generator/draw.hpp"
#include "generator/switches.hpp"
#include "runner/build.hpp"
#include "runner/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace mutants;
using strings = std::vector<std::string>;

// "operator: mutated line" of each.
strings mutants_in(const std::string& text) {
  strings all;
  const source s("brake/sample.hpp", text);
  for (const mutant& m : mutants_of(s)) all.push_back(m.name + ": " + m.mutated_line);
  return all;
}

// The body of a function
strings mutants_in_body(const std::string& body) {
  return mutants_in("inline void f() {\n" + body + "\n}\n");
}

TEST(operators, reverse_comparisons_and_shift_the_end_of_a_loop) {
  EXPECT_EQ(
      mutants_in_body("const bool less = a.b < c[k] + d;"),
      (strings{"comparison: const bool less = a.b > c[k] + d;", "sign: const bool less = a.b < c[k] - d;"}));
  EXPECT_EQ(mutants_in_body("for (; k < n; ++k) g(k);"),
            (strings{"comparison: for (; k > n; ++k) g(k);", "comparison: for (; k <= n; ++k) g(k);",
                     "removed statement: for (; k < n; ++k) ;"}));
}

TEST(operators, change_signs) {
  EXPECT_EQ(mutants_in_body("const T x = -a * b;"), strings{"sign: const T x = a * b;"});
  EXPECT_EQ(mutants_in_body("x -= y;"), (strings{"sign: x += y;", "removed statement: ;"}));
  EXPECT_EQ(mutants_in_body("return a - b - c;"),
            (strings{"sign: return a + b - c;", "sign: return a - b + c;"}));
}

TEST(operators, change_constants) {
  EXPECT_EQ(
      mutants_in_body("return 0 * 2u * 0.0 * 0.5 * 1e-9;"),
      (strings{"constant: return 1 * 2u * 0.0 * 0.5 * 1e-9;", "constant: return 0 * 3u * 0.0 * 0.5 * 1e-9;",
               "constant: return 0 * 2u * 1.0 * 0.5 * 1e-9;",
               "constant: return 0 * 2u * 0.0 * 2 * 0.5 * 1e-9;",
               "constant: return 0 * 2u * 0.0 * 0.5 * 10 * 1e-9;"}));
  EXPECT_EQ(mutants_in("struct a { bool b = true; };\n"), strings{"constant: struct a { bool b = false; };"});
}

TEST(operators, make_no_next_number_where_it_is_as_good) {
  EXPECT_EQ(mutants_in_body("return -1;"), strings{"sign: return 1;"});
  EXPECT_EQ(mutants_in_body("return n - 1;"), (strings{"sign: return n + 1;", "constant: return n - 2;"}));
  EXPECT_EQ(mutants_in_body("return rounding_tolerance<T>(1) * 2;"),
            strings{"constant: return rounding_tolerance<T>(1) * 3;"});
}

TEST(operators, leave_clamps_out) {
  EXPECT_EQ(mutants_in_body("return std::min(a, b);"),
            (strings{"missing clamp: return (a);", "missing clamp: return (b);"}));
  EXPECT_EQ(mutants_in_body("return std::clamp(a, b, c);"),
            (strings{"missing clamp: return (a);", "swapped argument: return std::clamp(b, a, c);",
                     "swapped argument: return std::clamp(a, c, b);"}));
  EXPECT_EQ(mutants_in_body("return t.cwiseMin(most);"), strings{"missing clamp: return t;"});
  EXPECT_EQ(mutants_in_body("return T::max();"), strings{});
}

TEST(operators, leave_checks_out) {
  EXPECT_EQ(mutants_in_body("if (!a || b) return;"),
            (strings{"missing check: if (true) return;", "missing check: if (false) return;",
                     "missing check: if (bool(a) || b) return;", "missing check: if (!a && b) return;"}));
  EXPECT_EQ(mutants_in_body("return a ? b : c;"),
            (strings{"missing check: return true ? b : c;", "missing check: return false ? b : c;"}));
}

TEST(operators, swap_arguments_that_look_alike) {
  EXPECT_EQ(
      mutants_in_body("return m(i, j) * g(a, b + c);"),
      (strings{"swapped argument: return m(j, i) * g(a, b + c);", "sign: return m(i, j) * g(a, b - c);"}));
  EXPECT_EQ(mutants_in("void f(T a, U b);\n"), strings{});
  EXPECT_EQ(mutants_in_body("std::swap(a, b);"), strings{"removed statement: ;"});
}

TEST(operators, remove_statements_that_do_something) {
  EXPECT_EQ(mutants_in_body(
                "const T a = b;\nT c(a);\nint d = k++;\na.b[k] = c;\nclear();\nv.reserve(n);\nreturn c;"),
            (strings{"removed statement: ;", "removed statement: ;"}));
}

TEST(operators, leave_types_and_texts_alone) {
  EXPECT_EQ(mutants_in_body("return vector<T, 2>(\"1 < 2\");  // 3 < 4"), strings{});
  EXPECT_EQ(mutants_in("#if 1\ntemplate <class T, int N = 2>\nvoid f() noexcept(1 < 2);\n"), strings{});
}

TEST(operators, know_what_the_compiler_is_asked) {
  const source s("brake/sample.hpp",
                 "static_assert(N > M);\ninline bool f() { return n > m; }\n"
                 "template <class X>\nconcept c = !requires(X a) { f(a, b); } || requires { g(a, b); };\n");
  const auto all = mutants_of(s);
  std::multiset<form> forms;
  for (const mutant& m : all) forms.insert(m.how);
  EXPECT_EQ(forms.count(form::compiled), all.size() - 1);
  EXPECT_EQ(forms.count(form::choice), 1u);
  EXPECT_GE(all.size(), 4u);
}

std::string switched(const std::string& text) {
  const source s("brake/sample.hpp", text);
  std::map<int, mutant> chosen;
  for (const mutant& m : mutants_of(s)) {
    if (m.how != form::compiled) chosen.emplace(static_cast<int>(chosen.size()), m);
  }
  return with_switches(s, chosen);
}

TEST(switches, stand_one_within_the_other) {
  EXPECT_EQ(switched("bool f() { return a < b + c; }\n"),
            "bool f() { return (passive_haptics_mutants::active(0) ? (a > b + c) : (a < "
            "passive_haptics_mutants::either(passive_haptics_mutants::active(1), b - c, b + c))); }\n");
}

TEST(switches, call_what_they_are_given_once) {
  EXPECT_EQ(
      switched("int g(const F& f) { return f() - cut(1); }\n"),
      "int g(const F& f) { return passive_haptics_mutants::either_of(passive_haptics_mutants::active(0), "
      "[&] { return passive_haptics_mutants::value_of(f() + cut(1)); }, "
      "[&] { return passive_haptics_mutants::value_of(f() - "
      "cut((passive_haptics_mutants::active(1) ? (2) : (1)))); }); }\n");
}

TEST(switches, take_all_of_what_is_added) {
  EXPECT_NE(switched("void f() {\n  x += a ? b : c;\n}\n").find(" ? (x -= a ? b : c) : (x += "),
            std::string::npos)
      << switched("void f() {\n  x += a ? b : c;\n}\n");
}

TEST(switches, keep_an_if_and_its_else_together) {
  EXPECT_NE(switched("void f() {\n  if constexpr (a) g();\n  else h();\n}\n").find("g(); }\n  else { if (!"),
            std::string::npos);
}

TEST(switches, take_constexpr_from_what_holds_them) {
  EXPECT_TRUE(switched("inline constexpr int a = 1;\n").starts_with("inline const /*constexpr*/ int a = ("));
  EXPECT_TRUE(switched("struct s { static constexpr int a = 1; };\n")
                  .starts_with("struct s { static inline const /*"));
  EXPECT_TRUE(
      switched("constexpr int f() { return 1; }\n").starts_with("inline /*constexpr*/ int f() { return ("));
  EXPECT_TRUE(
      switched("void f() { constexpr T a(1); }\n").starts_with("void f() { const /*constexpr*/ T a(("));
}

// What the compiler says of a class whose constant a concept asks for: never the constant's line.
TEST(switches, are_blamed_where_the_compiler_names_their_class_alone) {
  sources headers;
  const std::string text = "struct square {\n  static constexpr int dimension = 2;\n  int corners = 4;\n};\n";
  const source& s =
      *headers.emplace("scene/square.hpp", std::make_unique<source>("scene/square.hpp", text)).first->second;
  std::map<int, mutant> chosen;
  for (const mutant& m : mutants_of(s)) chosen.emplace(static_cast<int>(chosen.size()), m);
  ASSERT_EQ(chosen.size(), 2u);
  const std::string asked = "x.cpp:1:2: error: static assertion failed\n";
  EXPECT_EQ(numbers_in_errors(asked + "[with S = ns::square<3>]\n", headers, chosen), std::set<int>{0});
  EXPECT_TRUE(numbers_in_errors(asked + "[with S = ns::round]\n", headers, chosen).empty());
  const std::string line = "/include/passive_haptics/scene/square.hpp:3:4: error: ns::square\n";
  EXPECT_EQ(numbers_in_errors(asked + line, headers, chosen), std::set<int>{1});
}

// g(b, a) is of another type than g(a, b), and so is x behind a switch: h refuses it a line later.
TEST(switches, are_blamed_where_what_they_declare_is_used) {
  sources headers;
  const std::string text = "void f() {\n  const auto x = g(a, b);\n  h(x);\n}\n";
  const source& s =
      *headers.emplace("control/f.hpp", std::make_unique<source>("control/f.hpp", text)).first->second;
  const auto all = mutants_of(s);
  ASSERT_EQ(all.at(0).name, "swapped argument");
  const std::map<int, mutant> chosen{{7, all[0]}};
  EXPECT_EQ(numbers_in_errors("/include/passive_haptics/control/f.hpp:3:3: error: no h\n", headers, chosen),
            std::set<int>{7});
  EXPECT_TRUE(numbers_in_errors("/include/passive_haptics/control/g.hpp:3:3: error: no h\n", headers, chosen)
                  .empty());
}

// Functions 0 .. count - 1 that compare, and one that has a constant.
source comparing(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "bool f" + std::to_string(i) + "() { return a < b; }\n";
  return {"brake/sample.hpp", text + "int g() { return 1; }\n"};
}

strings keys_of(const std::vector<mutant>& all) {
  strings keys;
  for (const mutant& m : all) keys.push_back(key_of(m));
  return keys;
}

TEST(draw, repeats_itself_and_takes_turns) {
  const source s = comparing(100);
  const auto all = mutants_of(s), few = drawn(all, 1, 4);
  EXPECT_EQ(keys_of(few), keys_of(drawn(all, 1, 4)));
  EXPECT_NE(keys_of(few), keys_of(drawn(all, 2, 4)));
  EXPECT_EQ(few.size(), 4u);
  EXPECT_EQ(std::count_if(few.begin(), few.end(), [](const mutant& m) { return m.name == "constant"; }), 1);
}

TEST(draw, changes_by_what_is_changed_alone) {
  const strings before = keys_of(drawn(mutants_of(comparing(100)), 1, 40)),
                after = keys_of(drawn(mutants_of(comparing(101)), 1, 40));
  const std::set<std::string> kept(before.begin(), before.end());
  EXPECT_GE(std::count_if(after.begin(), after.end(), [&](const auto& key) { return kept.contains(key); }),
            38);
}

TEST(draw, is_of_files_and_operators_that_are_asked_for) {
  const auto all = mutants_of(comparing(3));
  EXPECT_EQ(those_of(all, "").size(), all.size());
  EXPECT_EQ(those_of(all, "^brake/sample.hpp [|] comparison$").size(), 3u);
  EXPECT_TRUE(those_of(all, "^force/").empty());
}

TEST(failures, are_found_by_object) {
  const auto found = failures_in(
      "[1/3] Building a.o\nFAILED: a.o \nc++ -o a.o\na.cpp:1: error: x\n[2/3] Building b.o\nb.cpp:2: note: "
      "y\n"
      "[3/3] Building c.o\nFAILED: c.o \nc.cpp:3: error: z\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NE(found.at("a.o").find("error: x"), std::string::npos);
  EXPECT_EQ(found.at("a.o").find("note: y"), std::string::npos);
  EXPECT_NE(found.at("c.o").find("error: z"), std::string::npos);
}

TEST(arguments, are_found_by_text_and_grow_stale) {
  const source s("brake/sample.hpp", "\n\nbool f() { return a < b; }\n");
  const auto all = mutants_of(s);
  const std::string key = "brake/sample.hpp | bool f() { return a < b; } | bool f() { return a > b; }";
  EXPECT_EQ(key_of(all[0]), key);
  EXPECT_EQ(keys_in("# why\n\n" + key + " | a is never b\n"),
            (std::map<std::string, std::string>{{key, "a is never b"}}));
  EXPECT_TRUE(stale({{key, ""}}, all).empty());
  EXPECT_EQ(stale({{key, ""}, {"brake/a.hpp | x | y", ""}}, all).size(), 1u);
}

TEST(table, counts_and_lists_survivors) {
  const source s("brake/sample.hpp", "bool f() { return a < b; }\n");
  const mutant m = mutants_of(s).at(0);
  std::ostringstream out;
  EXPECT_EQ(print_table(out, {{m, {true, ending::failed}}, {m, {true, ending::late}}, {m, {true}}, {m, {}}}),
            50.0);
  const std::string text = out.str();
  EXPECT_TRUE(
      text.starts_with("brake/sample.hpp:1: comparison\n  - bool f() { return a < b; }\n  + bool f() "
                       "{ return a > b; }\nbrake/sample.hpp:1: comparison, not reached\n"))
      << text;
  EXPECT_NE(
      text.find("all                          4         1         0         1         2\n50.0 % killed\n"),
      std::string::npos)
      << text;
}

}  // namespace
