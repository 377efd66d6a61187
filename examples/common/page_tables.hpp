/// Comparison of pages of the docs with printed tables.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace example {

namespace detail {
inline std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}
}  // namespace detail

/// True for equal words, or numbers that differ by at most 30 % or one unit of the last printed digit:
/// bouncing is chaotic, and mathematics libraries round differently.
inline bool same_figure(const std::string& a, const std::string& b) {
  if (a == b) return true;
  char *end_a = nullptr, *end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
  if (end_a == a.c_str() || end_b == b.c_str() || *end_a != '\0' || *end_b != '\0') return false;
  const std::size_t dot = a.find('.');
  const double unit = dot == std::string::npos ? 1 : std::pow(10, -double(a.size() - dot - 1));
  return std::abs(x - y) <= std::max(0.3 * std::max(std::abs(x), std::abs(y)), 1.001 * unit);
}

/// The first different word in both texts; empty if they agree.
inline std::string first_difference(const std::string& printed, const std::string& page) {
  const auto a = detail::words(printed), b = detail::words(page);
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    if (!same_figure(a[k], b[k])) return "'" + b[k] + "', printed is '" + a[k] + "'";
  if (a.size() == b.size()) return {};
  return std::to_string(b.size()) + " words, printed are " + std::to_string(a.size());
}

/// A page with tables between `<!-- table: NAME -->` and `<!-- end -->`.
class page_of_tables {
 public:
  explicit page_of_tables(std::filesystem::path path) : path_(std::move(path)) {
    std::ifstream in(path_);
    text_.assign(std::istreambuf_iterator<char>(in), {});
    if (!in) throw std::runtime_error("cannot read '" + path_.string() + "'");
  }

  /// The first difference between this table and the printed one; empty if they agree.
  std::string difference(const std::string& name, const std::string& printed) const {
    return first_difference(printed, table(name));
  }

  std::string table(const std::string& name) const {
    const auto [from, length] = place(name);
    return text_.substr(from, length);
  }

  void replace(const std::string& name, const std::string& printed) {
    const auto [from, length] = place(name);
    text_.replace(from, length, "\n" + printed + "\n");
  }

  const std::string& text() const { return text_; }

 private:
  std::pair<std::size_t, std::size_t> place(const std::string& name) const {
    const std::string begin = "<!-- table: " + name + " -->\n";
    const std::size_t at = text_.find(begin), from = at + begin.size(), to = text_.find("<!-- end -->", at);
    if (at == std::string::npos || to == std::string::npos)
      throw std::runtime_error("'" + path_.string() + "' has no '" + begin.substr(0, begin.size() - 1) +
                               "' with an '<!-- end -->' after it");
    return {from, to - from};
  }

  std::filesystem::path path_;
  std::string text_;
};

}  // namespace example
