// Tokens of a header in the style of .clang-format, which tells a product from a pointer by its spaces.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mutants {

enum class token_kind { word, number, text, symbol };

struct token {
  token_kind kind;
  std::size_t begin, end;  // in the header
  std::string_view text;
  bool spaced_before, spaced_after;

  bool is(std::string_view what) const { return text == what; }
  bool is_any(const std::set<std::string_view>& what) const { return what.contains(text); }
  // a < b, not vector<T>; a * b, not *a
  bool is_binary() const { return kind == token_kind::symbol && spaced_before && spaced_after; }
};

namespace detail {

inline bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
inline bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

inline std::size_t end_of_quoted(std::string_view s, std::size_t i) {
  const char quote = s[i++];
  while (s[i] != quote) i += s[i] == '\\' ? 2u : 1u;
  return i + 1;
}

inline std::size_t end_of_number(std::string_view s, std::size_t i) {
  const auto goes_on = [&](char c) { return is_word(c) || c == '.' || c == '\''; };
  const auto is_exponent = [&] { return (s[i] == '-' || s[i] == '+') && std::tolower(s[i - 1]) == 'e'; };
  while (i < s.size() && (goes_on(s[i]) || is_exponent())) ++i;
  return i;
}

inline std::size_t end_of_symbol(std::string_view s, std::size_t i) {
  static constexpr std::array<std::string_view, 21> symbols{
      "<<=", "...", "->", "::", "++", "--", "<=", ">=", "==", "!=", "&&",
      "||",  "+=",  "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<"};
  for (const auto symbol : symbols) {
    if (s.substr(i).starts_with(symbol)) return i + symbol.size();
  }
  return i + (s.substr(i).starts_with(">> ") ? 2 : 1);
}

// Past blanks, comments and the preprocessor's lines.
inline std::size_t skip_blanks(std::string_view s, std::size_t i) {
  for (;;) {
    if (i < s.size() && is_space(s[i])) ++i;
    else if (s.substr(i).starts_with("//") || (i < s.size() && s[i] == '#'))
      i = std::min(s.find('\n', i), s.size());
    else if (s.substr(i).starts_with("/*")) i = s.find("*/", i) + 2;
    else return i;
  }
}

}  // namespace detail

// The tokens of a header, which must outlive them.
inline std::vector<token> tokens_of(std::string_view s) {
  std::vector<token> all;
  for (std::size_t i = detail::skip_blanks(s, 0), end = i; i < s.size(); i = detail::skip_blanks(s, end)) {
    token_kind kind = token_kind::symbol;
    if (std::isdigit(static_cast<unsigned char>(s[i])) != 0) {
      kind = token_kind::number;
      end = detail::end_of_number(s, i);
    } else if (detail::is_word(s[i])) {
      kind = token_kind::word;
      end = i;
      while (end < s.size() && detail::is_word(s[end])) ++end;
    } else if (s[i] == '"' || s[i] == '\'') {
      kind = token_kind::text;
      end = detail::end_of_quoted(s, i);
    } else {
      end = detail::end_of_symbol(s, i);
    }
    all.push_back({kind, i, end, s.substr(i, end - i), i == 0 || detail::is_space(s[i - 1]),
                   end == s.size() || detail::is_space(s[end])});
  }
  return all;
}

}  // namespace mutants
