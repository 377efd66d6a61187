// When a cell of the tables of scenes is worse than its reference, and why it may be.
#include "scenes.hpp"

#include <algorithm>

namespace experiments {

void scene_figures::add(const scene_figures& other) {
  for (const auto m : {&scene_figures::hands, &scene_figures::arrived, &scene_figures::through,
                       &scene_figures::not_left, &scene_figures::separations})
    this->*m += other.*m;
  for (const auto m :
       {&scene_figures::deepest, &scene_figures::deviation, &scene_figures::drag, &scene_figures::leave})
    this->*m = std::max(this->*m, other.*m);
}

void effect_figures::add(const effect_figures& other) {
  hands += other.hands;
  not_left += other.not_left;
  for (const auto m :
       {&effect_figures::moved, &effect_figures::creep, &effect_figures::deepest, &effect_figures::leave})
    this->*m = std::max(this->*m, other.*m);
}

std::string unfit(const scene_cell& cell) {
  const bool is_slot = cell.specimen.walls > 1 && cell.specimen.name.find("slot") == 0;
  if (!cell.kind.is_world && cell.specimen.is_surface) return "a mesh_surface needs a world";
  if (cell.kind.has_bar && is_slot) return "a slot is narrower than the bar";
  if (!cell.kind.is_world && cell.specimen.is_thin && cell.law.name == "velocity_direct_control")
    return "a controller rejects walls that are thinner than three times the law's rest depth";
  const int walls = cell.specimen.walls + (cell.kind.has_bar || cell.kind.has_mesh);
  if (walls > cell.law.most_walls) return "the law takes one wall";
  return "";
}

std::string worse_than(const scene_figures& reference, const scene_figures& figures) {
  if (figures.through > reference.through) return "passed through";
  if (figures.not_left > reference.not_left) return "never left";
  if (figures.arrived < reference.arrived) return "stuck";
  if (figures.separations > 0 && reference.separations == 0) return "separates";
  if (figures.deepest > 1.5 * reference.deepest) return "deep";
  return "";
}

namespace {

struct limit {
  const char* reason;
  bool (*holds)(const scene_cell& cell, const std::string& worse);
};

// The table of limits: the first row that holds gives the reason.
const limit limits[] = {
    {"nothing", [](const scene_cell&, const std::string&) { return false; }},
};

}  // namespace

std::string reason_for(const scene_cell& cell, const std::string& worse) {
  for (const limit& l : limits)
    if (l.holds(cell, worse)) return l.reason;
  return "unexplained";
}

}  // namespace experiments
