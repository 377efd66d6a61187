// Conditions under which a cell of the scene tables may be worse than its reference.
#include "laws.hpp"
#include "scenes.hpp"

#include <algorithm>

namespace experiments {

void scene_figures::add(const scene_figures& other) {
  for (const auto m : {&scene_figures::hands, &scene_figures::arrived, &scene_figures::through,
                       &scene_figures::not_left, &scene_figures::separations})
    this->*m += other.*m;
  for (const auto m :
       {&scene_figures::max_depth, &scene_figures::deviation, &scene_figures::drag, &scene_figures::leave})
    this->*m = std::max(this->*m, other.*m);
}

std::string unfit(const scene_cell& cell) {
  const bool is_slot = cell.specimen.walls > 1 && cell.specimen.name.find("slot") == 0;
  if (!cell.kind.is_world && cell.specimen.is_surface) return "a mesh_surface needs a world";
  if (cell.kind.has_bar && is_slot) return "a slot is narrower than the bar";
  if (!cell.kind.is_world && cell.specimen.is_thin && cell.law.name == "velocity_direct_control")
    return "a controller rejects walls that are thinner than three times the law's rest depth";
  const int walls = cell.specimen.walls + (cell.kind.has_bar || cell.kind.has_mesh);
  if (walls > cell.law.max_walls) return "the law takes one wall";
  return "";
}

std::string worse_than(const scene_figures& reference, const scene_figures& figures) {
  if (figures.through > reference.through) return "passed through";
  if (figures.not_left > reference.not_left) return "never left";
  if (figures.arrived < reference.arrived) return "stuck";
  if (figures.separations > 0 && reference.separations == 0) return "separates";
  if (figures.max_depth > 1.5 * reference.max_depth) return "deep";
  return "";
}

namespace {

bool starts(const std::string& text, const char* with) { return text.rfind(with, 0) == 0; }
std::string quoted(law which) { return std::string("`").append(name_of(which)).append("`"); }
bool is_smooth(const scene_law& law) {
  return law.name == name_of(law::velocity) || law.name == name_of(law::on_off);
}

}  // namespace

const std::vector<scene_limit>& scene_limits() {
  using cell = const scene_cell&;
  using text = const std::string&;
  static const std::vector<scene_limit> limits{
      {"a wall moves towards the hand at 2 cm/s",
       "brakes cannot push a hand back: it is as deep as the wall moves in the time that the hand takes to "
       "stop",
       [](cell c, text) { return c.kind.speed > 0; }},
      {"a law without a margin at 20 Hz",
       "it meets the wall up to 50 ms late: a hand at 10 cm/s is 5 mm deep or through a wall of 3 mm by then",
       [](cell c, text worse) {
         return c.kind.is_slow && c.law.name.find("direct_control") != std::string::npos &&
                !starts(c.law.name, "velocity") && worse == "passed through";
       }},
      {quoted(law::coercive) + " and " + quoted(law::velocity_ratio),
       "a hand that stops along the wall sinks, also at the half-space",
       [](cell c, text worse) {
         return (starts(c.law.name, "coercive") || starts(c.law.name, "velocity_ratio")) &&
                worse == "passed through";
       }},
      {"a law other than " + quoted(law::velocity) + " and " + quoted(law::on_off),
       "it bounces along the half-space, too: depth and separations differ from one surface to the next",
       [](cell c, text worse) { return !is_smooth(c.law) && worse != "passed through"; }},
      {"two shapes side by side in a scene",
       "a scene has no proxy: at the seam the nearest face is the one between them; use a world",
       [](cell c, text) { return starts(c.specimen.name, "two ") && !c.kind.is_world; }},
      {quoted(law::on_off) + " at two mesh_solids side by side at 20 Hz",
       "until the next sample the side of the second one is a wall ahead; use a proxy that is updated in "
       "each "
       "cycle, so a world that is not held",
       [](cell c, text) {
         return starts(c.law.name, "on_off") && starts(c.specimen.name, "two ") && c.kind.is_slow;
       }},
      {quoted(law::on_off) + " at a 90 degree edge at 20 Hz",
       "the face beyond the edge is met up to 50 ms late",
       [](cell c, text worse) {
         return starts(c.law.name, "on_off") && c.specimen.meant == surface::edge && c.kind.is_slow &&
                worse == "separates";
       }},
      {"a shape of 3 mm in a scene", "thinner than three times the depth of the hand; use a world",
       [](cell c, text) { return c.specimen.is_thin && !c.kind.is_world; }},
      {"a 90 degree edge of a mesh in a world",
       "the proxy leaves the first face late: the hand separates once; a mesh_solid in a scene does not",
       [](cell c, text) {
         return c.specimen.is_mesh && c.specimen.meant == surface::edge && c.kind.is_world;
       }},
      {"a 90 degree edge that moves away at 2 cm/s", "the hand has to follow the edge down with 2 N",
       [](cell c, text worse) {
         return c.specimen.meant == surface::edge && c.kind.speed < 0 && worse == "separates";
       }},
      {"a polygon of 12 sides instead of a circle of 60 mm",
       "edges of 30 degrees; use a ball or a finer mesh",
       [](cell c, text) { return c.specimen.name.find("of 12") != std::string::npos; }},
      {"a mesh_surface at 20 Hz",
       "it gives no contact before the touch, which is seen up to 50 ms late; a mesh_solid does",
       [](cell c, text worse) {
         return c.specimen.is_surface && c.kind.is_slow && worse != "passed through";
       }},
      {quoted(law::on_off) + " without a force sensor",
       "its ripple reaches the surface: ten hands separate up to twice along the half-space, too",
       [](cell c, text worse) {
         return starts(c.law.name, "on_off") && !c.law.has_sensor && worse == "separates";
       }},
      {quoted(law::on_off) + " at a wall that moves away at 2 cm/s",
       "it holds until the handle is 0.3 mm less deep than its reference; the hand then follows with 2 N",
       [](cell c, text worse) {
         return starts(c.law.name, "on_off") && c.kind.speed < 0 && worse == "separates";
       }},
  };
  return limits;
}

const scene_limit* limit_of(const scene_cell& cell, const std::string& worse) {
  for (const scene_limit& l : scene_limits())
    if (l.holds(cell, worse)) return &l;
  return nullptr;
}

}  // namespace experiments
