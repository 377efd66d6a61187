// The operators: from a header to all of its mutants.
#pragma once

#include "syntax.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mutants {

// How a mutant stands beside the original.
enum class form {
  choice,     // active(N) ? mutated : original
  condition,  // the same of bools
  value,      // either(active(N), mutated, original): the two may have types of their own
  lazy,       // the same of lambdas: it calls what it is given, which may do more than give a value
  statement,  // if (!active(N)) original
  compiled,   // not at all: the compiler has to know
};

// One change of one place.
struct mutant {
  std::string file;  // below include/passive_haptics
  std::string name;  // of the operator
  form how;
  std::size_t begin, end;  // what it replaces
  std::string mutated;     // by this
  long line;
  std::string original_line, mutated_line;
};

namespace detail {

inline std::string in_one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (!is_space(c)) line += c;
    else if (!line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

// Collects the mutants of a header.
class collector {
 public:
  explicit collector(const source& s) : s_(s) {}
  std::vector<mutant> mutants;

  // Tokens first .. last become this.
  void add(std::string_view name, form how, int first, int last, const std::string& mutated) {
    if (is_of_a_type(s_, first)) return;
    // The two values are both computed, so that nothing may happen in them
    const bool happens = mutated.find("++") != std::string::npos || mutated.find("--") != std::string::npos;
    if (how == form::value && happens) how = form::choice;
    if (how == form::value && in_code(s_, first) && calls_what_it_is_given(s_, first, last)) how = form::lazy;
    if (is_asked_at_compile_time(s_, first)) {
      if (how == form::statement) return;
      how = form::compiled;
    }
    const std::size_t begin = s_[first].begin, end = s_[last].end;
    const std::string& text = s_.text;
    const std::size_t line_begin = text.rfind('\n', begin) + 1, line_end = text.find('\n', end);
    const std::string head = text.substr(line_begin, begin - line_begin),
                      tail = text.substr(end, line_end - end);
    mutants.push_back({s_.path, std::string(name), how, begin, end, mutated, s_.line_at(begin),
                       in_one_line(head + text.substr(begin, end - begin) + tail),
                       in_one_line(head + mutated + tail)});
  }

  // An operator between two operands becomes another.
  void add_binary(std::string_view name, form how, int at, std::string_view other) {
    const int strength = binding(s_[at]), first = operand_begin(s_, at, strength),
              last = operand_end(s_, at, strength);
    if (first == at || last == at) return;
    add(name, how, first, last,
        s_.text_of(first, at - 1) + ' ' + std::string(other) + ' ' + s_.text_of(at + 1, last));
  }

 private:
  const source& s_;
};

// ---- the operators

inline void comparison(const source& s, int i, collector& found) {
  static const std::map<std::string_view, std::string_view> reversed{
      {"<", ">"}, {"<=", ">="}, {">", "<"}, {">=", "<="}, {"==", "!="}, {"!=", "=="}};
  static const std::map<std::string_view, std::string_view> shifted{
      {"<", "<="}, {"<=", "<"}, {">", ">="}, {">=", ">"}};
  if (!s[i].is_binary() || !reversed.contains(s[i].text)) return;
  found.add_binary("comparison", form::choice, i, reversed.at(s[i].text));
  // The end of a loop; a measured number never comes to stand on its bound
  const int open = s.around(i);
  if (open > 0 && s.is(open - 1, "for") && shifted.contains(s[i].text))
    found.add_binary("comparison", form::choice, i, shifted.at(s[i].text));
}

inline void sign(const source& s, int i, collector& found) {
  static const std::map<std::string_view, std::string_view> others{
      {"+", "-"}, {"-", "+"}, {"+=", "-="}, {"-=", "+="}};
  if (s[i].kind != token_kind::symbol || !others.contains(s[i].text)) return;
  if (binding(s[i]) > 0) {
    found.add_binary("sign", form::value, i, others.at(s[i].text));
  } else if (s[i].is("-") && is_unary(s, i)) {
    const int last = unary_end(s, i);
    found.add("sign", form::value, i, last, s.text_of(i + 1, last));
  } else if (s[i].text.size() == 2) {
    const int first = operand_begin(s, i, 1);
    int last = operand_end(s, i, 1);
    // A choice is added whole
    while (s.is(last + 1, "?") || s.is(last + 1, ":")) last = operand_end(s, last + 1, 1);
    found.add(
        "sign", form::choice, first, last,
        s.text_of(first, i - 1) + ' ' + std::string(others.at(s[i].text)) + ' ' + s.text_of(i + 1, last));
  }
}

// The word before this parenthesis and what may stand in < > between.
inline int callee_of(const source& s, int open) {
  const int before = open - 1;
  return before > 0 && s.closes(before) && s.is(before, ">") ? s.partner_of(before) - 1 : before;
}

// A margin of one rounding more is no mistake; and below 0, which often stands for none, the sign is one.
inline bool next_is_as_good(const source& s, int i) {
  if (i > 0 && s.is(i - 1, "-") && is_unary(s, i - 1)) return true;
  const int open = s.around(i);
  return open > 0 && s.is(open, "(") && s.is(callee_of(s, open), "rounding_tolerance");
}

// Another number: of integers the next, of others one that is noticed; a tolerance ten times as large.
inline void constant(const source& s, int i, collector& found) {
  const std::string text(s[i].text);
  if (s[i].is("true") || s[i].is("false")) {
    if (!is_asked_at_compile_time(s, i))
      found.add("constant", form::choice, i, i, s[i].is("true") ? "false" : "true");
    return;
  }
  if (s[i].kind != token_kind::number || text.starts_with("0x")) return;
  std::string other;
  if (text.find_first_of(".eE") == std::string::npos) {
    const std::size_t digits = text.find_first_not_of("0123456789");
    if (text.find('\'') != std::string::npos || next_is_as_good(s, i)) return;
    other = std::to_string(std::stol(text) + 1) + (digits == std::string::npos ? "" : text.substr(digits));
  } else if (std::stod(text) == 0) {
    other = "1.0";
  } else {
    other = (text.find('e') == std::string::npos ? "2 * " : "10 * ") + text;
  }
  found.add("constant", form::choice, i, i, other);
}

inline void missing_clamp(const source& s, int i, collector& found) {
  if (!s[i].is_any({"min", "max", "clamp", "cwiseMin", "cwiseMax"})) return;
  int open = i + 1;
  if (s.opens_angle(open)) open = s.partner_of(open) + 1;
  if (!s.is(open, "(") || !s.opens(open)) return;
  const int first = name_begin(s, i), last = s.partner_of(open);
  const auto arguments = arguments_of(s, open);
  if (s[i].text.starts_with("cwise")) {
    found.add("missing clamp", form::value, first, last, s.text_of(first, i - 2));
  } else if (s.is(i - 1, "::") && arguments.size() >= 2) {
    const std::size_t kept = s[i].is("clamp") ? 1 : 2;
    for (std::size_t k = 0; k < kept; ++k)
      found.add("missing clamp", form::value, first, last,
                '(' + s.text_of(arguments[k].first, arguments[k].second) + ')');
  }
}

inline void missing_check(const source& s, int i, collector& found) {
  const auto always = [&](int first, int last) {
    for (const char* answer : {"true", "false"})
      found.add("missing check", form::condition, first, last, answer);
  };
  if (s[i].is_any({"&&", "||"}) && binding(s[i]) > 0) {
    found.add_binary("missing check", form::choice, i, s[i].is("&&") ? "||" : "&&");
  } else if (s.is(i, "!") && is_unary(s, i)) {
    const int last = unary_end(s, i);
    found.add("missing check", form::condition, i, last, "bool(" + s.text_of(i + 1, last) + ')');
  } else if (s.is(i, "?") && s[i].is_binary()) {
    if (const int first = operand_begin(s, i, 1); first < i) always(first, i - 1);
  } else if (s.is(i, "(") && (s.is(i - 1, "if") || s.is(i - 2, "if"))) {
    int first = i + 1;
    const int last = s.partner_of(i) - 1;
    for (int k = first; k <= last; ++k) {
      if (s.opens(k)) k = s.partner_of(k);
      else if (s.is(k, ";")) first = k + 1;
    }
    for (int k = first; k <= last; ++k) {
      if (s.is(k, "=")) return;  // it declares something
    }
    always(first, last);
  }
}

// Arguments that stand beside each other in the other order; indices are the arguments of a matrix.
inline void swapped_arguments(const source& s, int i, collector& found) {
  if (!s.is(i, "(") || !s.opens(i) || s[i].spaced_before || i == 0) return;
  const int callee = callee_of(s, i);
  static const std::set<std::string_view> symmetric{"min",        "max",           "swap",   "hypot",
                                                    "all_finite", "static_assert", "sizeof", "decltype"};
  if (callee < 1 || s[callee].kind != token_kind::word || s[callee].is_any(symmetric)) return;
  const int first = name_begin(s, callee), last = s.partner_of(i);
  if (first < 1 || is_declared(s, first)) return;
  const auto arguments = arguments_of(s, i);
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k) {
    const auto a = arguments[k], b = arguments[k + 1];
    const std::string left = s.text_of(a.first, a.second), right = s.text_of(b.first, b.second);
    if (!is_plain(s, a) || !is_plain(s, b) || left == right) continue;
    const std::string head = s.text_of(first, a.first - 1) + (s[a.first].spaced_before ? " " : "");
    found.add("swapped argument", form::choice, first, last,
              head + right + ", " + left + s.text_of(b.second + 1, last));
  }
}

inline void removed_statement(const source& s, int i, collector& found) {
  if (!s.is(i, ";") || s.around(i) < 0 || !s.is(s.around(i), "{") || !in_code(s, i)) return;
  const int first = statement_begin(s, i);
  if (first < i && has_an_effect(s, first, i)) found.add("removed statement", form::statement, first, i, ";");
}

}  // namespace detail

// All mutants of a header.
inline std::vector<mutant> mutants_of(const source& s) {
  detail::collector found(s);
  for (int i = 0; i < s.size(); ++i) {
    for (const auto& apply : {detail::comparison, detail::sign, detail::constant, detail::missing_clamp,
                              detail::missing_check, detail::swapped_arguments, detail::removed_statement})
      apply(s, i, found);
  }
  return std::move(found.mutants);
}

}  // namespace mutants
