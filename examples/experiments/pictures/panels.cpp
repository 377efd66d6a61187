#include "panels.hpp"

#include "picture_style.hpp"

#include <output.hpp>

#include <sstream>
#include <stdexcept>

namespace experiments {

namespace {

constexpr double left = 95, head = 85, foot = 60, between = 90, key_line = 19;  // of a picture [px]

std::vector<std::string> laws_of(const panels& p) {
  std::vector<std::string> laws;
  for (const panel& one : p.all) {
    for (const std::string& law : style::distinct(one.curves, [](const curve& c) { return c.law; }))
      if (std::find(laws.begin(), laws.end(), law) == laws.end()) laws.push_back(law);
  }
  return laws;
}

std::size_t key_lines(const panels& p) {
  std::size_t most = 0;
  for (const panel& one : p.all) {
    const auto named =
        std::count_if(one.curves.begin(), one.curves.end(), [](const curve& c) { return !c.name.empty(); });
    most = std::max(most, static_cast<std::size_t>(named));
  }
  return most;
}

// Later curves are thinner, so that coinciding curves stay visible.
std::string how(const panels& p, const curve& c, std::size_t place) {
  std::ostringstream text;
  const double thinner = 0.9 * static_cast<double>(std::min<std::size_t>(place, 3));
  constexpr std::array<int, 5> shapes{5, 7, 9, 11, 13};
  switch (p.style) {
    case line_style::lines: text << "lines lw 1.6"; break;
    case line_style::steps: text << "steps lw 2.2"; break;
    case line_style::points_on_lines:
      text << "linespoints pt " << shapes[place % shapes.size()] << " ps " << 1.2 - 0.2 * thinner << " lw "
           << 4 - thinner;
  }
  text << (c.dashed ? " dt (6,4)" : "") << " lc rgb '" << style::colour_of(c.law) << "' "
       << (c.name.empty() ? "notitle" : "title " + style::quoted(c.name));
  return text.str();
}

}  // namespace

void draw_panels(const std::filesystem::path& directory, const panels& p) {
  const std::vector<std::string> laws = laws_of(p);
  if (laws.empty()) throw std::invalid_argument("no rows to draw in " + p.name);
  style::table csv;
  style::range x, y;
  for (const panel& one : p.all) {
    for (const curve& c : one.curves) {
      csv.start_block(one.title + ", " + c.law + (c.dashed ? ", " + p.dashed_means : ""),
                      one.x_label + ", " + one.y_label);
      for (const auto& [a, b] : c.points) {
        csv.add({a, b});
        x.add(a);
        y.add(b);
      }
    }
  }
  example::write_file(directory / (p.name + ".csv"), csv.str());

  const std::size_t columns = static_cast<std::size_t>(p.columns),
                    rows = (p.all.size() + columns - 1) / columns;
  const double keys = key_line * static_cast<double>(key_lines(p));
  const double height = head + foot + static_cast<double>(rows) * (p.row_height + keys) +
                        static_cast<double>(rows - 1) * between;
  std::vector<style::entry> entries;
  // A panel's own key has the names of its laws
  for (const std::string& law : keys > 0 ? std::vector<std::string>() : laws)
    entries.push_back({law, style::colour_of(law)});
  if (!p.dashed_means.empty()) entries.push_back({p.dashed_means, "#666666", "(6,4)"});

  std::ostringstream script;
  script << style::terminal(p.width, static_cast<int>(height)) << "data = '" << p.name
         << ".csv'\nset multiplot layout " << rows << "," << p.columns << " margins " << left / p.width << ","
         << 1 - 25.0 / p.width << "," << (foot + keys) / height << "," << 1 - head / height << " spacing "
         << (p.common_y ? 20.0 : 80.0) / p.width << "," << (between + keys) / height << " title "
         << style::quoted(p.title) << " font ',16'\n"
         << (p.log_x ? "set logscale x\n" : "") << (p.log_y ? "set logscale y\n" : "")
         << "set format '%g'\nset key at graph 0," << -52.0 / p.row_height
         << " left top Left reverse samplen 2\n"
         << p.settings;
  if (p.common_y && p.log_y) {
    script << "set yrange [" << std::pow(10, std::floor(std::log10(y.lowest()))) << ":"
           << std::pow(10, std::ceil(std::log10(y.highest()))) << "]\n";
  }
  if (p.common_x)
    script << "set xrange [" << (p.log_x ? x.lowest() / 1.5 : x.low()) << ":"
           << (p.log_x ? 1.5 * x.highest() : x.high()) << "]\n";
  script << style::legend(entries, 1 - 42 / height, left / p.width);
  std::size_t block = 0;
  for (std::size_t k = 0; k < p.all.size(); ++k) {
    const panel& one = p.all[k];
    const bool first_column = k % columns == 0;
    script << "set title " << style::quoted(one.title) << " offset 0,-0.6\nset xlabel "
           << style::quoted(one.x_label) << " offset 0,0.3\nset ylabel "
           << style::quoted(first_column || !p.common_y ? one.y_label : "") << "\n"
           << (first_column || !p.common_y ? "" : "set format y ''\n") << "plot ";
    if (one.curves.empty()) script << "[1:2] [1:2] NaN notitle";
    for (std::size_t c = 0; c < one.curves.size(); ++c, ++block) {
      const auto place = std::find(laws.begin(), laws.end(), one.curves[c].law) - laws.begin();
      script << (c == 0 ? "" : ", \\\n     ") << "data index " << block << " using 1:2 with "
             << how(p, one.curves[c], static_cast<std::size_t>(place));
    }
    script << "\n" << (k == 0 ? style::no_legend(entries.size()) : "") << "set format y '%g'\n";
  }
  script << "unset multiplot\n";
  example::draw(directory, p.name, script.str());
}

}  // namespace experiments
