// A header: its tokens, and which brackets belong together.
#pragma once

#include "tokens.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace mutants {

// What a pair of braces holds.
enum class scope { none, space, type, code, list };

struct source {
  std::string path, text;
  std::vector<token> tokens;
  std::vector<int> partner;    // of a bracket; -1 of all else
  std::vector<int> enclosing;  // the bracket around a token; -1 outside of all
  std::vector<scope> scopes;   // of an opening brace

  source(std::string path_, std::string text_) : path(std::move(path_)), text(std::move(text_)) {
    tokens = tokens_of(text);
    partner.assign(tokens.size(), -1);
    enclosing.assign(tokens.size(), -1);
    scopes.assign(tokens.size(), scope::none);
    match_brackets();
  }
  source(const source&) = delete;
  source& operator=(const source&) = delete;

  int size() const { return static_cast<int>(tokens.size()); }
  const token& operator[](int i) const { return tokens[static_cast<std::size_t>(i)]; }
  bool is(int i, std::string_view what) const { return i >= 0 && i < size() && (*this)[i].is(what); }
  int partner_of(int i) const { return partner[static_cast<std::size_t>(i)]; }
  int around(int i) const { return enclosing[static_cast<std::size_t>(i)]; }
  scope scope_of(int brace) const { return scopes[static_cast<std::size_t>(brace)]; }
  bool opens(int i) const { return partner_of(i) > i; }
  bool closes(int i) const { return partner_of(i) >= 0 && partner_of(i) < i; }
  bool opens_angle(int i) const { return opens(i) && is(i, "<"); }

  // The text of tokens first .. last in one line.
  std::string text_of(int first, int last) const {
    std::string line;
    for (int i = first; i <= last; ++i) {
      if (i > first && (*this)[i].spaced_before) line += ' ';
      line += (*this)[i].text;
    }
    return line;
  }
  // The line of a position in the text.
  long line_at(std::size_t at) const {
    return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  }

 private:
  void match_brackets() {
    std::vector<int> open;
    static const std::map<std::string_view, std::string_view> closing{
        {")", "("}, {"]", "["}, {"}", "{"}, {">", "<"}};
    for (int i = 0; i < size(); ++i) {
      const token& t = (*this)[i];
      enclosing[static_cast<std::size_t>(i)] = open.empty() ? -1 : open.back();
      if (t.kind != token_kind::symbol || is(i - 1, "operator")) continue;
      const bool angle = t.is("<") && !t.spaced_after;
      if (angle || t.is("(") || t.is("[") || t.is("{")) {
        if (t.is("{")) scopes[static_cast<std::size_t>(i)] = kind_of_brace(i);
        open.push_back(i);
        continue;
      }
      const auto found = closing.find(t.text);
      if (found == closing.end() || open.empty() || !is(open.back(), found->second)) continue;
      if (t.is(">") && t.spaced_before) continue;  // greater
      partner[static_cast<std::size_t>(i)] = open.back();
      partner[static_cast<std::size_t>(open.back())] = i;
      enclosing[static_cast<std::size_t>(i)] = around(open.back());
      open.pop_back();
    }
  }

  scope kind_of_brace(int brace) const {
    const int before = brace - 1;
    const bool parameters = is(before, ")");
    if (!(*this)[brace].spaced_before || is(before, "requires") ||
        (parameters && is(partner_of(before) - 1, "requires")))
      return scope::list;
    if (parameters || is(before, "]")) return scope::code;
    for (int i = before; i >= 0 && !is(i, ";") && !is(i, "{") && !is(i, "}"); --i) {
      if (closes(i)) i = partner_of(i);
      else if (is(i, "->") || is(i, "else")) return scope::code;
      else if (is(i, "namespace")) return scope::space;
      else if ((*this)[i].is_any({"enum", "=", "return"})) return scope::list;
      else if ((*this)[i].is_any({"class", "struct", "union"}) && !is(i - 1, "enum")) return scope::type;
    }
    return is(before, ",") || is(before, "(") || is(before, "{") ? scope::list : scope::code;
  }
};

}  // namespace mutants
