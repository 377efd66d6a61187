// Pictures of panels with a curve per law.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace experiments {

struct curve {
  std::string law;
  std::vector<std::pair<double, double>> points;
  std::string name = {};  // in the panel's own key, none if empty
  bool dashed = false;
};

struct panel {
  std::string title, x_label, y_label;
  std::vector<curve> curves;
};

enum class line_style { lines, points_on_lines, steps };

struct panels {
  std::string name, title;  // of the file, above the picture
  int columns = 1;
  int width = 1200, row_height = 400;  // [px]
  line_style style = line_style::lines;
  bool log_x = false, log_y = false;
  bool common_x = false;
  bool common_y = false;          // one scale for all, at the left
  std::string dashed_means = {};  // in the legend
  std::string settings = {};      // additional gnuplot commands
  std::vector<panel> all = {};
};

void draw_panels(const std::filesystem::path& directory, const panels& p);

}  // namespace experiments
