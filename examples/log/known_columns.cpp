#include <log/known_columns.hpp>

#include <algorithm>
#include <cctype>

namespace example {
namespace {

bool is_number(std::string_view part) {
  return !part.empty() && part.front() != '0' &&
         std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool names(const known_column& known, std::string_view name) {
  if (!name.starts_with(known.name)) return false;
  const std::string_view part = name.substr(known.name.size());
  switch (known.parts) {
    case column_parts::none: return part.empty();
    case column_parts::numbers: return is_number(part);
    case column_parts::axes: return part == "_x" || part == "_y" || part == "_z";
  }
  return false;
}

}  // namespace

const std::vector<known_column>& known_columns() {
  using enum column_parts;
  static const std::vector<known_column> all{
      {"t", none, {"s"}, true},
      {"q", numbers, {"rad", "m"}, true},
      {"qd", numbers, {"rad/s", "m/s"}, true},
      {"Fh", axes, {"N"}, true},
      {"status", none, {""}, false},
      {"power", none, {""}, false},
      {"display", none, {""}, false},
      {"gamma", none, {"rad"}, false},
      {"alpha", none, {"1"}, false},
      {"Fd", axes, {"N"}, false},
      {"Fc", axes, {"N"}, false},
      {"capacity", numbers, {"N m", "N"}, false},
      {"torque", numbers, {"N m", "N"}, false},
      {"x", none, {"m"}, false},
      {"y", none, {"m"}, false},
      {"z", none, {"m"}, false},
      {"cycle", none, {"1"}, false},
      {"state", none, {""}, false},
      {"reason", none, {""}, false},
      {"held_over", none, {""}, false},
      {"current", numbers, {"A"}, false},
      {"late", none, {"s"}, false},
      {"compute", none, {"s"}, false},
      {"depth", none, {"m"}, false},
      {"w", numbers, {"rad/s"}, false},
      {"true_Fh", axes, {"N"}, false},
      {"brake_torque", numbers, {"N m"}, false},
  };
  return all;
}

const known_column* find_known(std::string_view name) {
  const auto& all = known_columns();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const known_column& known) { return names(known, name); });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace example
