// Common style of the pictures: colours, text, tables for gnuplot.
#pragma once

#include "../laws.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace experiments::style {

inline std::string colour_of(const std::string& law) {
  const char* colour = "#666666";
  const auto look = [&](const auto& row) {
    if (law == row.name) colour = row.colour;
  };
  std::apply([&](const auto&... row) { (look(row), ...); }, compared_laws);
  return colour;
}

// Text between single quotes of a gnuplot script.
inline std::string quoted(const std::string& text) {
  std::string q = "'";
  for (const char c : text) q += c == '\'' ? std::string("''") : std::string(1, c);
  return q + "'";
}

// No markup: names may contain underscores.
inline std::string terminal(int width, int height) {
  std::ostringstream script;
  script << "set encoding utf8\nset terminal svg noenhanced size " << width << "," << height
         << " font 'sans,13' background 'white'\nset output output\nset datafile separator ','\n"
         << "set grid lc rgb '#dddddd' lt 1\nset border lc rgb '#666666'\nset tics textcolor rgb 'black'\n";
  return script.str();
}

// A legend over the whole width of a picture, set before its first panel and removed after it, because
// gnuplot's key is as narrow as a panel.
struct entry {
  std::string name, colour, dashes = "solid";
  int width = 3;  // an area takes area_width
};
inline constexpr int area_width = 12;
inline constexpr const char* wall_colour = "#e6e6e6";
inline std::string legend(const std::vector<entry>& entries, double height, double left = 0.08) {
  std::ostringstream script;
  double letters = 0;
  const auto width = [](const entry& e) { return 8 + static_cast<double>(e.name.size()); };  // with its line
  for (const entry& e : entries) letters += width(e);
  double x = left;
  for (std::size_t k = 0; k < entries.size(); x += (1 - left) * width(entries[k]) / letters, ++k) {
    script << "set arrow " << 100 + k << " nohead from screen " << x << "," << height << " to screen "
           << x + 0.025 << "," << height << " lw " << entries[k].width << " dt " << entries[k].dashes
           << " lc rgb '" << entries[k].colour << "'\nset label " << 100 + k << " " << quoted(entries[k].name)
           << " at screen " << x + 0.032 << "," << height << " left\n";
  }
  return script.str();
}
inline std::string no_legend(std::size_t entries) {
  std::ostringstream script;
  for (std::size_t k = 0; k < entries; ++k)
    script << "unset arrow " << 100 + k << "\nunset label " << 100 + k << "\n";
  return script.str();
}

// Blocks of numbers in one CSV file; gnuplot's `index` counts them from 0.
class table {
 public:
  void start_block(const std::string& name, const std::string& columns) {
    if (!text_.str().empty()) text_ << "\n\n";
    text_ << "# " << name << "\n# " << columns << "\n";
  }
  void add(const std::vector<double>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) text_ << (i == 0 ? "" : ", ") << row[i];
    text_ << "\n";
  }
  std::string str() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

// `set yrange` for the added values, with a margin.
class range {
 public:
  void add(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  double low() const { return low_ - margin(); }
  double high() const { return high_ + margin(); }
  double lowest() const { return low_; }
  double highest() const { return high_; }
  double width() const { return high_ - low_; }
  bool empty() const { return high_ < low_; }
  std::string str() const {
    std::ostringstream text;
    text << "[" << low() << ":" << high() << "]";
    return text.str();
  }

 private:
  double margin() const { return high_ > low_ ? 0.06 * (high_ - low_) : 0.1 * std::abs(high_) + 1e-9; }
  double low_ = HUGE_VAL, high_ = -HUGE_VAL;
};

// Throws std::invalid_argument without data.
template <class Runs>
void require_traces(const std::string& name, const Runs& runs) {
  bool all = !runs.empty();
  for (const auto& r : runs) all = all && !r.run.trace.empty();
  if (!all) throw std::invalid_argument("no runs to draw in " + name);
}

// The distinct names in order of appearance.
template <class Rows, class Name>
auto distinct(const Rows& rows, Name name) {
  std::vector<std::decay_t<decltype(name(rows.front()))>> found;
  for (const auto& row : rows)
    if (std::find(found.begin(), found.end(), name(row)) == found.end()) found.push_back(name(row));
  return found;
}

}  // namespace experiments::style
