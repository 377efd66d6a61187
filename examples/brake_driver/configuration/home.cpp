#include <configuration/home.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace example {
namespace {

constexpr double min_remarked = 5e-5;  // [m], half of the last digit that is printed

ph::point<2> home_position(const configuration& c) {
  if (c.mechanism == "xy_table") return ph::xy_table<double>(c.xy_table).position(c.home);
  if (c.mechanism == "five_bar") return ph::five_bar<double>(c.five_bar).position(c.home);
  return ph::tendon_two_link<double>(c.tendon_two_link).position(c.home);
}

std::string pair_in_words(const char* format, const ph::vector<double, 2>& v) {
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), format, v[0], v[1]);
  return text.data();
}

// "12.0 mm"
std::string millimetres(double metres) {
  std::array<char, 50> text{};
  std::snprintf(text.data(), text.size(), "%.1f mm", 1e3 * metres);
  return text.data();
}

// "q (1.8812, -1.3055) rad, handle at (0.0800, 0.2245) m"
std::string pose_in_words(const configuration& c) {
  const char* const format = c.mechanism == "xy_table" ? "(%.6g, %.6g) m" : "(%.6g, %.6g) rad";
  return pair_in_words(format, c.home) + ", handle at " + pair_in_words("(%.4f, %.4f) m", home_position(c));
}

// No joint that turns starts beyond a turn: a turn less is the same place.
bool looks_like_degrees(const configuration& c) {
  return c.mechanism != "xy_table" && c.home.cwiseAbs().maxCoeff() > 2 * std::numbers::pi;
}

// The question after the side on which a wall is free.
std::string free_side(const std::string& wall_type) {
  return wall_type == "ball" ? "is its filling right (solid: free outside, hollow: free inside)"
                             : "does its normal point to the free side";
}

std::string likely_cause(const configuration& c, const std::string& wall_type) {
  if (looks_like_degrees(c)) {
    const ph::vector<double, 2> radians = c.home * (std::numbers::pi / 180);
    return "; angles beyond a turn look like degrees: in radians they are " +
           pair_in_words("(%.4f, %.4f)", radians);
  }
  const char* const unit = c.mechanism == "xy_table" ? "metres, not millimetres" : "radians, not degrees";
  return "; " + free_side(wall_type) + "; is the pose that of this device, in " + unit +
         "; is the wall where it should be?";
}

}  // namespace

wall_depth deepest_wall(const std::vector<named_wall>& walls, const ph::point<2>& x) noexcept {
  wall_depth deepest;
  int number = 0;
  for (const named_wall& wall : walls) {
    const double depth = -wall.distance(x);
    ++number;
    if (deepest.number == 0 || !(depth <= deepest.depth)) deepest = {number, depth};
  }
  return deepest;
}

std::string home_in_words(const configuration& c) {
  const ph::point<2> x = home_position(c);
  std::string text = "home  q " + pose_in_words(c) + "\n";
  int number = 0;
  for (const named_wall& wall : c.named_walls) {
    const double distance = wall.distance(x);
    text += "wall " + std::to_string(++number) + " (" + wall.type + "): " + millimetres(std::abs(distance)) +
            (distance >= 0              ? " in front of it\n"
             : distance > -min_remarked ? " inside it\n"
                                        : " inside it: " + free_side(wall.type) + "?\n");
  }
  return text;
}

std::string home_error(const configuration& c) {
  const ph::point<2> x = home_position(c);
  const std::string pose = "pose = " + pose_in_words(c);
  if (!ph::all_finite(x))
    return "pose = " + pair_in_words("(%.6g, %.6g) rad", c.home) +
           ", expected one in which the mechanism has a handle; are lengths and pose those of this device?";
  if (const wall_depth deepest = deepest_wall(c.named_walls, x); deepest.is_over(c.start.max_start_depth)) {
    const std::string& type = c.named_walls[static_cast<std::size_t>(deepest.number - 1)].type;
    return pose + ", " + millimetres(deepest.depth) + " inside wall " + std::to_string(deepest.number) +
           " (" + type + "), expected at most max_start_depth, " +
           ph::detail::number_text(1e3 * c.start.max_start_depth) + " mm" + likely_cause(c, type);
  }
  if (looks_like_degrees(c)) return pose + ", expected angles within a turn" + likely_cause(c, "");
  return "";
}

std::string not_activated_in_words(const wall_depth& deepest) {
  if (!std::isfinite(deepest.depth)) return "not activated: it is not known where the handle is";
  return "not activated: the handle is " + millimetres(deepest.depth) + " inside wall " +
         std::to_string(deepest.number) + ", more than max_start_depth; move it out";
}

}  // namespace example
