// What the tokens of a header say: how far operands, names and statements reach, and what is a type or a
// declaration.
#pragma once

#include "source.hpp"

#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace mutants {

// ---- expressions

// How strongly a spaced operator binds; 0 for what ends an expression.
inline int binding(const token& t) {
  static const std::map<std::string_view, int> strengths{
      {"*", 11}, {"/", 11}, {"%", 11}, {"+", 10}, {"-", 10}, {"<<", 9}, {">>", 9}, {"<", 8},  {"<=", 8},
      {">", 8},  {">=", 8}, {"==", 7}, {"!=", 7}, {"&", 6},  {"^", 5},  {"|", 4},  {"&&", 3}, {"||", 2}};
  const auto found = strengths.find(t.text);
  return t.is_binary() && found != strengths.end() ? found->second : 0;
}

inline bool ends_expression(const token& t) {
  return t.is_any({";",  ",",  "?",   ":",      "=",    "+=", "-=",   "*=",    "/=",       "%=", "&=",
                   "|=", "^=", "<<=", "return", "else", "do", "case", "throw", "requires", "->"}) &&
         !(t.is("->") && !t.spaced_before);
}

// Whether the bracket that closes at i ends a block or a condition, and no expression.
inline bool closes_before_a_statement(const source& s, int i) {
  const int open = s.partner_of(i);
  if (s.is(i, "}")) return s.scope_of(open) != scope::list;
  return s.is(i, ")") && open > 0 && s[open - 1].is_any({"if", "for", "while", "switch", "constexpr"});
}

// First token of the operand to the left of an operator that binds so strongly.
inline int operand_begin(const source& s, int at, int strength) {
  int first = at;
  for (int i = at - 1; i >= 0; --i) {
    if (s.closes(i)) {
      if (closes_before_a_statement(s, i)) break;
      i = s.partner_of(i);
    } else if (s.opens(i) || ends_expression(s[i])) {
      break;
    } else if (const int b = binding(s[i]); b > 0 && b < strength) {
      break;
    }
    first = i;
  }
  return first;
}

// Last token of the operand to its right.
inline int operand_end(const source& s, int at, int strength) {
  int last = at;
  for (int i = at + 1; i < s.size(); ++i) {
    if (s.opens(i)) {
      if (s.is(i, "{") && s.scope_of(i) != scope::list) break;
      i = s.partner_of(i);
    } else if (s.closes(i) || ends_expression(s[i])) {
      break;
    } else if (const int b = binding(s[i]); b > 0 && b <= strength) {
      break;
    }
    last = i;
  }
  return last;
}

// The innermost brace around a token; -1 outside of all.
inline int brace_around(const source& s, int i) {
  i = s.around(i);
  while (i >= 0 && !s.is(i, "{")) i = s.around(i);
  return i;
}

// Whether a token is executed: it stands in a function's body.
inline bool in_code(const source& s, int i) {
  for (int b = brace_around(s, i); b >= 0; b = brace_around(s, b)) {
    if (s.scope_of(b) == scope::code) return true;
    if (s.scope_of(b) != scope::list) return false;
  }
  return false;
}

inline bool is_unary(const source& s, int i) {
  return !s[i].spaced_after && (s[i].spaced_before || s.opens(i - 1) || s.is(i - 1, "!"));
}

// What a unary operator applies to: names, members, calls and indices.
inline int unary_end(const source& s, int i) {
  int last = i + 1;
  if (s.opens(last)) last = s.partner_of(last);
  while (last + 1 < s.size() && !s[last + 1].spaced_before) {
    if (s.opens(last + 1)) last = s.partner_of(last + 1);
    else if (s[last + 1].is_any({".", "->", "::"})) last += 2;
    else break;
  }
  return last;
}

// First token of the name, with what it is a member of, that ends at i.
inline int name_begin(const source& s, int i) {
  for (;;) {
    if (s.closes(i) && !s.is(i, "}")) i = s.partner_of(i) - 1;
    else if (s[i].kind == token_kind::word && s[i - 1].is_any({".", "->", "::"}) && !s[i - 1].spaced_before &&
             i >= 2 && (s[i - 2].kind == token_kind::word || s.closes(i - 2)))
      i -= 2;
    else if (s[i].kind == token_kind::word && s.is(i - 1, "::")) return i - 1;
    else return i;
  }
}

// Whether what begins here is declared here: a type stands before it.
inline bool is_declared(const source& s, int begin) {
  static const std::set<std::string_view> no_types{"return", "else", "throw", "case", "do", "co_return"};
  const token& before = s[begin - 1];
  if (before.kind == token_kind::word) return !before.is_any(no_types);
  return (before.is(">") && s.closes(begin - 1)) ||
         (before.is_any({"&", "*", "&&"}) && !before.spaced_before) || before.is("~");
}

// Where the arguments of a call stand: first and last token of each.
inline std::vector<std::pair<int, int>> arguments_of(const source& s, int open) {
  std::vector<std::pair<int, int>> all;
  int first = open + 1;
  for (int i = first; i <= s.partner_of(open); ++i) {
    if (i == s.partner_of(open) || s.is(i, ",")) {
      if (i > first) all.emplace_back(first, i - 1);
      first = i + 1;
    } else if (s.opens(i)) {
      i = s.partner_of(i);
    }
  }
  return all;
}

// Names, numbers, members and indices: what two arguments of one type mostly are.
inline bool is_plain(const source& s, std::pair<int, int> range) {
  for (int i = range.first; i <= range.second; ++i) {
    const bool index = s.is(i, "[") || s.is(i, "]");
    if (s[i].kind == token_kind::text ||
        (s[i].kind == token_kind::symbol && !index && !s[i].is_any({".", "->", "::"})))
      return false;
    if (i > range.first && s[i].kind == token_kind::word && is_declared(s, i)) return false;
  }
  return true;
}

// Whether tokens first .. last call a function that is an argument (F&& f) or a lambda (auto f = []).
inline bool calls_what_it_is_given(const source& s, int first, int last) {
  const auto is_given = [&](int at) {
    if (s[at - 1].is_any({"&", "&&"}) && !s[at - 1].spaced_before) return true;
    return s.is(at - 1, "auto") && s.is(at + 1, "=") && s.is(at + 2, "[");
  };
  for (int i = first; i < last; ++i) {
    if (s[i].kind != token_kind::word || !s.is(i + 1, "(") || s[i - 1].is_any({".", "->", "::"})) continue;
    for (int k = 1; k + 2 < s.size(); ++k) {
      if (s.is(k, s[i].text) && is_given(k)) return true;
    }
  }
  return false;
}

// ---- where a token stands

// Whether the compiler asks for a constant there: nothing at run time can stand for it.
inline bool is_asked_at_compile_time(const source& s, int i) {
  for (; i >= 0; i = s.around(i)) {
    if (s.is(i, "{") && s.scope_of(i) != scope::list) return false;
    if (s.is(i, "(") && i > 0 && s[i - 1].is_any({"static_assert", "constexpr"})) return true;
    for (int k = s.opens(i) ? i - 1 : i; k > s.around(i) && !s.is(k, ";") && !s.is(k, "{") && !s.is(k, "}");
         --k) {
      if (s[k].is_any({"concept", "requires"})) return true;
      if (s.closes(k)) k = s.partner_of(k);
    }
  }
  return false;
}

// Types, and what belongs to a declaration.
inline bool is_of_a_type(const source& s, int i) {
  for (i = s.around(i); i >= 0; i = s.around(i)) {
    if (s.opens_angle(i) || s.is(i + 1, "[") || s.is(i - 1, "[")) return true;
    if (s.is(i, "(") && i > 0 && s[i - 1].is_any({"noexcept", "alignas", "decltype", "sizeof", "explicit"}))
      return true;
  }
  return false;
}

// ---- statements

inline int statement_begin(const source& s, int end) {
  int first = end;
  for (int i = end - 1; i >= 0; --i) {
    if (s.closes(i)) {
      if (closes_before_a_statement(s, i)) break;
      i = s.partner_of(i);
    } else if (s.opens(i) || s[i].is_any({";", "else", "do"}) || (s.is(i, ":") && !s[i].spaced_before)) {
      break;
    }
    first = i;
  }
  return first;
}

inline bool has_an_effect(const source& s, int first, int end) {
  static const std::set<std::string_view> assignments{
      "=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<="};
  static const std::set<std::string_view> no_effect{"return",      "using",     "static_assert", "static",
                                                    "const",       "constexpr", "auto",          "typename",
                                                    "static_cast", "if",        "for",           "while"};
  if (s[first].is_any(no_effect)) return false;
  if (s[first].is_any({"throw", "break", "continue", "++", "--"})) return true;
  for (int i = first; i < end; ++i) {
    if (s[i].is_any(assignments))
      return i > first && name_begin(s, i - 1) == (s.is(first, "*") ? first + 1 : first);
    if (s.opens(i)) i = s.partner_of(i);
  }
  if (s[end - 1].is_any({"++", "--"})) return true;
  if (!s.is(end - 1, ")")) return false;
  int callee = s.partner_of(end - 1) - 1;
  if (s.is(callee, "reserve")) return false;  // of no effect but on time
  if (s.closes(callee)) callee = s.partner_of(callee) - 1;
  return callee >= first && name_begin(s, callee) == first;
}

}  // namespace mutants
