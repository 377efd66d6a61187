// Pictures of 10_design.
#pragma once

#include "task_figures.hpp"

#include <passive_haptics/design/map/design_map_csv.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace design {

// Start of each picture: size in pixels, colours of a map with white for points without figures.
std::string picture_of(int width, int height);

// Panels of one map: drag, maximum normal force, sink slope and isotropy. csv: text of to_csv.
void draw_map(const std::filesystem::path& directory, const std::string& name, const std::string& title,
              const std::string& csv);

// The sink slopes of several devices, each on its own scale. maps: a title and the text of to_csv.
void draw_devices(const std::filesystem::path& directory, const std::string& name, const std::string& title,
                  const std::vector<std::pair<std::string, std::string>>& maps);

// Figures of the whole task over the reduction k2.
void draw_reductions(const std::filesystem::path& directory, const std::string& name,
                     const std::vector<std::pair<double, task_figures>>& by_reduction);

}  // namespace design
