#include "arms.hpp"

#include "felt_forces.hpp"
#include "results_page.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace experiments {

namespace {

// "a / b / c" of the settings from `first`; "-" for one that was not measured.
std::string of_settings(const arm_row& row, std::size_t first, std::size_t count, auto&& text) {
  std::string all;
  for (std::size_t i = first; i < first + count; ++i) {
    if (i > first) all += " / ";
    all += row.cells[i] ? text(*row.cells[i]) : "-";
  }
  return all;
}

std::string of_encoders(const arm_row& row, auto&& text) {
  return of_settings(row, 1, 1, text) + " / " + of_settings(row, 1 + arm_lags.size(), 1, text);
}

// The start of a table line: arm and law.
std::string key_of(const std::string& line) {
  std::size_t at = 0;
  for (int bars = 0; bars < 3 && at != std::string::npos; ++bars) at = line.find('|', at) + 1;
  return line.substr(0, at);
}

// A line with missing values from another line.
std::string filled(const std::string& line, const std::string& other) {
  const std::string key = key_of(line);
  std::istringstream words(line.substr(key.size())), others(other.substr(key_of(other).size()));
  std::string filled = key, word, there;
  while (words >> word) {
    others >> there;
    filled += " " + (word == "-" ? there : word);
  }
  return filled + "\n";
}

std::string line_of(const arm_row& row) {
  const auto gliding = [](const arm_cell& c) { return written("%d", c.gliding); };
  return markdown_row(
      {row.arm, row.law, of_settings(row, 0, arm_lags.size(), gliding),
       of_settings(row, arm_lags.size(), arm_lags.size(), gliding),
       of_encoders(row, [](const arm_cell& c) { return written("%d", c.separating); }),
       of_encoders(row, [](const arm_cell& c) { return written("%.2f", 1e3 * c.median_std); }),
       of_settings(row, 1, 1, [](const arm_cell& c) { return written("%d", c.too_weak); })});
}

// Maximum power of a brake on its device in a time step of these runs [W].
double max_power(const std::vector<arm_row>& rows) {
  double largest = 0;
  for (const arm_row& row : rows)
    for (const auto& cell : row.cells)
      if (cell) largest = std::max(largest, cell->max_power);
  return largest;
}

std::string arm_head() {
  return markdown_head({"arm", "law", "glide of 60: exact encoders, 5 / 20 / 40 ms",
                        "4096 counts, 5 / 20 / 40 ms", "separate at 20 ms: exact / counts",
                        "median deviation at 20 ms [mm]: exact / counts", "brakes too weak, exact, 20 ms"});
}

// A table with these rows replaced; values that were not measured are kept.
std::string with_rows(const std::string& table, const std::vector<arm_row>& rows) {
  std::istringstream lines(table);
  std::string all, line;
  std::vector<bool> found(rows.size());
  while (std::getline(lines, line)) {
    if (line.empty()) continue;
    std::string put = line + "\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::string measured = line_of(rows[k]);
      if (key_of(measured) != key_of(line)) continue;
      put = filled(measured, line);
      found[k] = true;
    }
    all += put;
  }
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (!found[k]) all += line_of(rows[k]);
  return all;
}

}  // namespace

std::string arm_lines(const std::vector<arm_row>& rows) {
  std::string lines;
  for (const arm_row& row : rows) lines += line_of(row);
  return lines;
}

bool follow_with_arms(page_tables& page) {
  page["felt_forces"] = felt_forces();
  std::printf("\nWhat a stiff hand feels of 1 N, 50 to 100 ms after it began\n\n%s",
              page["felt_forces"].c_str());
  std::printf("\nArms along %zu random walls each; \"-\": not measured without --arms\n\n%s", arm_walls,
              arm_head().c_str());
  std::vector<arm_row> rows;
  follow_with_3r(rows);
  follow_with_4r(rows);
  follow_with_some_brakes(rows);
  if constexpr (built_extent == arm_extent::all) follow_with_4r_in_space(rows);
  page["arms"] = built_extent == arm_extent::all
                     ? arm_head() + arm_lines(rows)
                     : with_rows(example::page_of_tables(results_page).table("arms"), rows);
  constexpr double rounding = 1e-15;  // [W]
  const double power = max_power(rows);
  std::printf("\nThe most power that a brake gave to its arm in any time step: %.0e W\n", power);
  if (!(power < rounding)) std::printf("FAILS: over %.0e W\n", rounding);
  std::fflush(stdout);
  return power < rounding;
}

}  // namespace experiments
