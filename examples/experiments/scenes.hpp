// Every shape in every kind of scene under every law, in a hand's closed loop: figures, verdicts and the
// table of limits.
#pragma once

#include "markdown.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace experiments {

struct scene_kind {
  const char* name;
  double speed = 0;  // outward, of the wall [m/s]
  bool is_world = false, is_slow = false, has_bar = false, has_mesh = false;
};
inline constexpr std::array<scene_kind, 9> scene_kinds{{
    {.name = "by itself"},
    {.name = "below a bar", .has_bar = true},
    {.name = "world", .is_world = true},
    {.name = "world with a mesh", .is_world = true, .has_mesh = true},
    {.name = "20 Hz", .is_slow = true},
    {.name = "world, 20 Hz", .is_world = true, .is_slow = true},
    {.name = "moves away", .speed = -0.02},
    {.name = "moves away in a world with a mesh", .speed = -0.02, .is_world = true, .has_mesh = true},
    {.name = "moves towards the hand", .speed = 0.02},
}};

// The surface that a specimen represents: it defines the hand's path and the reference.
enum class surface { plane, solid, hollow, edge };

struct scene_specimen {
  std::string name;
  surface meant = surface::plane;
  bool is_thin = false;     // less than twice a hand's depth
  bool is_surface = false;  // a mesh_surface, which requires a world
  bool is_mesh = false;
  int walls = 1;
};

struct scene_law {
  std::string name;
  bool has_sensor = true;
  int max_walls = 1000;  // maximum number of walls
};

// Figures of one hand, or the worst of several.
struct scene_figures {
  int hands = 0, arrived = 0, through = 0, not_left = 0, separations = 0;
  double max_depth = 0, deviation = 0, drag = 0, leave = 0;  // [m], [m], [N], [s]

  void add(const scene_figures& other);
};

// A device with its laws, for any mechanism.
struct scene_bench {
  std::string device;
  std::vector<scene_specimen> specimens;
  std::vector<scene_law> laws;
  // Runs this number of hands at specimen i under law j.
  std::function<scene_figures(const scene_kind&, std::size_t i, std::size_t j, std::uint64_t hands)> run;
};
scene_bench planar_bench();
scene_bench spatial_bench();

struct scene_cell {
  const scene_bench& bench;
  const scene_kind& kind;
  const scene_specimen& specimen;
  const scene_law& law;
};
// Reason why there is no such scene; empty if there is one.
std::string unfit(const scene_cell& cell);
// Properties that are worse than at the reference, the first specimen of the same surface in the same kind of
// scene. Empty if there are none.
std::string worse_than(const scene_figures& reference, const scene_figures& figures);
// A row of the table of limits: a condition under which a cell may be worse.
struct scene_limit {
  std::string where;
  const char* reason;
  bool (*holds)(const scene_cell& cell, const std::string& worse);
};
const std::vector<scene_limit>& scene_limits();
// The first limit that applies; nullptr for none.
const scene_limit* limit_of(const scene_cell& cell, const std::string& worse);

inline constexpr std::uint64_t scene_hands = 10;

// Prints the table of each kind of scene and the cells worse than their reference; returns the tables of
// docs/results.md. `unexplained` counts worse cells without a reason.
page_tables follow_scenes(int& unexplained);

}  // namespace experiments
