#include <configuration/home.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace example {
namespace {

constexpr double min_remarked = 5e-5;  // [m], half of the last printed digit

spatial home_position(const configuration& c) { return c.mechanism.handle(c.home); }

// The first numbers as "(0.0800, 0.2245)".
template <class Numbers>
std::string numbers_in_words(const char* format, const Numbers& v, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    std::array<char, 50> text{};
    std::snprintf(text.data(), text.size(), format, v[i]);
    all.append(i == 0 ? "(" : ", ").append(text.data());
  }
  return all + ")";
}

// "12.0 mm"
std::string millimetres(double metres) {
  std::array<char, 50> text{};
  std::snprintf(text.data(), text.size(), "%.1f mm", 1e3 * metres);
  return text.data();
}

// The word for rotating or sliding joints, or both in their order.
std::string for_joints(const configuration& c, const std::string& rotating, const std::string& sliding) {
  const joint_motion joints(c.mechanism);
  if (joints.all(false)) return rotating;
  if (joints.all(true)) return sliding;
  return joints.slides[0] ? sliding + " and " + rotating : rotating + " and " + sliding;
}

std::string angles_in_words(const configuration& c) {
  return numbers_in_words("%.6g", c.home, c.mechanism.joints()) + " " + for_joints(c, "rad", "m");
}

// "q (1.8812, -1.3055) rad, handle at (0.0800, 0.2245) m"
std::string pose_in_words(const configuration& c) {
  return angles_in_words(c) + ", handle at " +
         numbers_in_words("%.4f", home_position(c), c.mechanism.dimension()) + " m";
}

// Rotating joints do not start beyond a full turn.
bool looks_like_degrees(const configuration& c) {
  const joint_motion joints(c.mechanism);
  for (int i = 0; i < joints.joints; ++i)
    if (!joints.slides[static_cast<std::size_t>(i)] && std::abs(c.home[i]) > 2 * std::numbers::pi)
      return true;
  return false;
}

std::string likely_cause(const configuration& c, const std::string& free_side) {
  if (looks_like_degrees(c)) {
    const joint_motion joints(c.mechanism);
    axis_numbers radians = c.home;
    for (int i = 0; i < joints.joints; ++i)
      if (!joints.slides[static_cast<std::size_t>(i)]) radians[i] *= std::numbers::pi / 180;
    return "; angles beyond a turn look like degrees: in radians they are " +
           numbers_in_words("%.4f", radians, joints.joints);
  }
  return "; " + free_side + "; check that the pose is that of this device, in " +
         for_joints(c, "radians, not degrees", "metres, not millimetres") + ", and the position of the wall";
}

}  // namespace

wall_depth deepest_wall(const std::vector<named_wall>& walls, const spatial& x) noexcept {
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
  const spatial x = home_position(c);
  std::string text = "home  q " + pose_in_words(c) + "\n";
  int number = 0;
  for (const named_wall& wall : c.walls) {
    const double distance = wall.distance(x);
    text += "wall " + std::to_string(++number) + " (" + wall.type + "): ";
    if (std::isinf(distance)) text += "an open surface, without an inside\n";
    else if (distance >= 0) text += millimetres(distance) + " in front of it\n";
    else
      text += millimetres(-distance) + " inside it" +
              (distance > -min_remarked ? "\n" : ": " + wall.free_side + "\n");
  }
  return text;
}

std::string home_error(const configuration& c) {
  const spatial x = home_position(c);
  const std::string pose = "pose = " + pose_in_words(c);
  if (!ph::all_finite(x))
    return "pose = " + angles_in_words(c) +
           ": expected a pose that the mechanism can take; check its lengths and the pose";
  if (const wall_depth deepest = deepest_wall(c.walls, x); deepest.is_over(c.start.max_start_depth)) {
    const named_wall& wall = c.walls[static_cast<std::size_t>(deepest.number - 1)];
    return pose + ", " + millimetres(deepest.depth) + " inside wall " + std::to_string(deepest.number) +
           " (" + wall.type + "): expected at most max_start_depth, " +
           ph::detail::number_text(1e3 * c.start.max_start_depth) + " mm" + likely_cause(c, wall.free_side);
  }
  if (looks_like_degrees(c)) return pose + ": expected angles within a turn" + likely_cause(c, "");
  return "";
}

std::string not_activated_in_words(const wall_depth& deepest) {
  if (!std::isfinite(deepest.depth)) return "not activated: the position of the handle is unknown";
  return "not activated: the handle is " + millimetres(deepest.depth) + " inside wall " +
         std::to_string(deepest.number) + ", more than max_start_depth; move it out";
}

}  // namespace example
