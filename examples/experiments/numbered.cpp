#include "numbered.hpp"

#include "batch.hpp"
#include "plants.hpp"
#include "table_row.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string_view>

namespace experiments {

namespace {

struct cell {
  const char* wall;
  test_wall (*shape)();
  double rate;
  law which;
};

test_wall unslanted_wall() { return planar_wall(); }

// The settings of one plant in order.
std::vector<cell> cells() {
  std::vector<cell> all;
  for (const auto& [name, shape] : {std::pair{"planar", &unslanted_wall}, std::pair{"concave", &concave_wall},
                                    std::pair{"convex", &convex_wall}})
    for (const double rate : {1000.0, 20.0})
      for (const law which : {law::none, law::direct, law::velocity})
        all.push_back({name, shape, rate, which});
  return all;
}

std::string numbered_head() { return "experiment, " + csv_head(); }

std::string numbered_line(std::uint64_t number, const cell& c, std::size_t plant) {
  setup how = random_plant(plant_seed, plant);
  how.environment_rate = c.rate;
  const run_result run = follow_with_arm(c.which, c.shape(), how);
  const std::string environment = std::to_string(static_cast<int>(c.rate)) + " Hz";
  return std::to_string(number) + ", " +
         csv_line({"tendon", c.wall, environment, std::string(name_of(c.which)), run.figures});
}

std::string text_of(number_range which) {
  return which.first == which.last
             ? "experiment " + std::to_string(which.first)
             : "experiments " + std::to_string(which.first) + " to " + std::to_string(which.last);
}

// A line of a part and its file.
struct placed_line {
  std::string_view text;
  const part_file* file;
};

// Number of a complete line.
std::uint64_t number_of(const placed_line& line, std::size_t place) {
  static const auto columns = std::ranges::count(numbered_head(), ',');
  std::size_t digits = line.text.find_first_not_of("0123456789");
  if (digits == 0 || digits > 18 || !line.text.substr(digits).starts_with(", ") ||
      std::ranges::count(line.text, ',') != columns || line.text.back() != '\n')
    throw std::invalid_argument("'" + line.file->name + "', line " + std::to_string(place) +
                                ": expected a whole line of experiments; copy the file again");
  return std::stoull(std::string(line.text.substr(0, digits)));
}

using lines_by_number = std::map<std::uint64_t, placed_line>;

void add_lines(const part_file& file, number_range which, lines_by_number& lines) {
  const std::string head = numbered_head();
  if (!file.content.starts_with(head))
    throw std::invalid_argument("'" + file.name + "': expected the head '" + head.substr(0, 40) +
                                "...' in line 1; merge files that this program wrote");
  std::string_view rest = std::string_view(file.content).substr(head.size());
  for (std::size_t place = 2; !rest.empty(); ++place) {
    const placed_line line{rest.substr(0, rest.find('\n') + 1), &file};
    const placed_line whole = line.text.empty() ? placed_line{rest, &file} : line;
    const std::uint64_t number = number_of(whole, place);
    if (number < which.first || number > which.last)
      throw std::invalid_argument("'" + file.name + "': experiment " + std::to_string(number) +
                                  ": expected " + text_of(which) +
                                  "; leave the file out, or give another --first and --last");
    if (const auto [there, is_new] = lines.emplace(number, whole); !is_new)
      throw std::invalid_argument("experiment " + std::to_string(number) + " is in '" +
                                  there->second.file->name + "' and in '" + file.name +
                                  "': expected it once; leave one of them out");
    rest.remove_prefix(whole.text.size());
  }
}

}  // namespace

std::string range_error(number_range which) {
  if (which.first > which.last)
    return "--first " + std::to_string(which.first) + " with --last " + std::to_string(which.last) +
           ": expected a first number that is not above the last; exchange them";
  return "";
}

std::string file_name(number_range which) {
  return "experiments_" + std::to_string(which.first) + "_" + std::to_string(which.last) + ".csv";
}

std::string run_by_number(number_range which) {
  const std::vector<cell> settings = cells();
  const std::size_t count = which.last - which.first + 1;
  if (count > max_of_a_part)
    throw std::invalid_argument(text_of(which) + ": expected a part of at most " +
                                std::to_string(max_of_a_part) + "; run smaller parts and merge them");
  progress_bar::plan(count);
  std::string table = numbered_head();
  on_all_cores(
      text_of(which), count,
      [&](std::size_t k) {
        const std::uint64_t number = which.first + k;
        return numbered_line(number, settings[number % settings.size()], number / settings.size());
      },
      [&](std::size_t, const std::string& line) { table += line; });
  return table;
}

std::string merged(const std::vector<part_file>& parts, number_range which) {
  lines_by_number lines;
  for (const part_file& file : parts) add_lines(file, which, lines);
  std::string table = numbered_head();
  std::uint64_t next = which.first;
  const auto check_gap = [&](std::uint64_t until) {
    if (next == until) return;
    const number_range gap{next, until - 1};
    throw std::invalid_argument("no file has " + text_of(gap) + ": expected " + text_of(which) +
                                "; run --first " + std::to_string(gap.first) + " --last " +
                                std::to_string(gap.last));
  };
  for (const auto& [number, line] : lines) {
    check_gap(number);
    table += line.text;
    next = number + 1;
  }
  check_gap(which.last + 1);
  return table;
}

}  // namespace experiments
