// A header with its mutants behind switches, and with one of them alone. Lines keep their numbers.
#pragma once

#include "operators.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

namespace detail {

// Text begin .. end stands between two others; so do the parts in it.
struct bracketed {
  std::size_t begin, end;
  std::string before, after;
};

inline bracketed switch_of(const mutant& m, int number) {
  const std::string active = "passive_haptics_mutants::active(" + std::to_string(number) + ")";
  switch (m.how) {
    case form::condition: return {m.begin, m.end, "(" + active + " ? " + m.mutated + " : bool(", "))"};
    case form::value:
      return {m.begin, m.end, "passive_haptics_mutants::either(" + active + ", " + m.mutated + ", ", ")"};
    case form::lazy:
      return {m.begin, m.end,
              "passive_haptics_mutants::either_of(" + active +
                  ", [&] { return passive_haptics_mutants::value_of(" + m.mutated +
                  "); }, [&] { return passive_haptics_mutants::value_of(",
              "); })"};
    case form::statement: return {m.begin, m.end, "{ if (!" + active + ") ", " }"};
    default: return {m.begin, m.end, "(" + active + " ? (" + m.mutated + ") : (", "))"};
  }
}

// first .. last stand in begin .. end, outer before inner.
inline std::string bracketed_text(const std::string& text, std::size_t begin, std::size_t end,
                                  std::vector<bracketed>::const_iterator first,
                                  std::vector<bracketed>::const_iterator last) {
  std::string all;
  while (first != last) {
    const auto inner_end =
        std::find_if(first + 1, last, [&](const bracketed& b) { return b.begin >= first->end; });
    all += text.substr(begin, first->begin - begin) + first->before +
           bracketed_text(text, first->begin, first->end, first + 1, inner_end) + first->after;
    begin = first->end;
    first = inner_end;
  }
  return all + text.substr(begin, end - begin);
}

// The declarations around a token that say constexpr, as positions of that word.
inline std::vector<int> constexprs_around(const source& s, int i) {
  std::vector<int> found;
  for (; i >= 0; i = s.around(i)) {
    for (int k = i; k > s.around(i) && !s.is(k, ";"); --k) {
      if (s.is(k, "constexpr") && !s.is(k - 1, "if")) found.push_back(k);
      if (!s.closes(k)) continue;
      if (s.is(k, "}") && s.scope_of(s.partner_of(k)) != scope::list) break;
      k = s.partner_of(k);
    }
  }
  return found;
}

// Those around a mutant.
inline std::vector<int> constexprs_around(const source& s, const mutant& m) {
  const auto at =
      std::find_if(s.tokens.begin(), s.tokens.end(), [&](const token& t) { return t.begin == m.begin; });
  return constexprs_around(s, static_cast<int>(at - s.tokens.begin()));
}

// What a declaration says instead of constexpr, once it holds a switch.
inline std::string not_constexpr(const source& s, int at) {
  if (in_code(s, at)) return "const";
  for (int i = at + 1;; ++i) {
    if (s.is(i, "(")) return "inline";
    if (s[i].is_any({"=", "{", ";"})) break;
    if (s.opens(i)) i = s.partner_of(i);
  }
  return s.is(at - 1, "static") ? "inline const" : "const";
}

}  // namespace detail

// chosen: numbers and mutants, of which none is form::compiled.
inline std::string with_switches(const source& s, const std::map<int, mutant>& chosen) {
  std::map<std::size_t, std::size_t> plain;  // begin and end of each constexpr
  std::vector<detail::bracketed> parts;
  for (const auto& [number, m] : chosen) {
    parts.push_back(detail::switch_of(m, number));
    for (const int k : detail::constexprs_around(s, m)) {
      if (plain.emplace(s[k].begin, s[k].end).second)
        parts.push_back({s[k].begin, s[k].end, detail::not_constexpr(s, k) + " /*", "*/"});
    }
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return std::pair(a.begin, b.end) < std::pair(b.begin, a.end);
  });
  std::string text = detail::bracketed_text(s.text, 0, s.text.size(), parts.begin(), parts.end());
  const std::string once = "#pragma once\n";
  const auto at = text.find(once + '\n');
  return at == std::string::npos
             ? text
             : text.replace(at + once.size(), 1, "#include <passive_haptics_mutants/active.hpp>\n");
}

// Whether both can stand behind switches in one text: one within the other, or apart.
inline bool fit(const mutant& a, const mutant& b) {
  if (a.file != b.file || a.end <= b.begin || b.end <= a.begin) return true;
  return (a.begin <= b.begin && b.end <= a.end) || (b.begin <= a.begin && a.end <= b.end);
}

inline std::string mutated_text(const source& s, const mutant& m) {
  return std::string(s.text).replace(m.begin, m.end - m.begin, m.mutated);
}

}  // namespace mutants
