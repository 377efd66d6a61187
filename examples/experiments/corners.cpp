#include "corners.hpp"

#include "corner_rows.hpp"

namespace experiments {

page_tables follow_corners() {
  corner_tables tables;
  tables.by_law = markdown_head({"device", "law", "locked brakes hold", "sink", "a wall is left",
                                 "separations", "deepest, 95 % [mm]: law / locked", "ratio",
                                 "first wall deeper before", "gets out in time / no heavier [%]"});
  std::printf("%zu corners of each device, seed %llu\n\n%s", corner_count,
              static_cast<unsigned long long>(corner_seed), tables.by_law.c_str());
  add_planar_devices(tables);
  add_other_devices(tables);
  const auto table = [&](const char* what, const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::string> head{what};
    head.insert(head.end(), tables.devices.begin(), tables.devices.end());
    std::string all = markdown_head(head);
    for (const auto& row : rows) all += markdown_row(row);
    std::printf("\n%s", all.c_str());
    return all;
  };
  const std::string corners = table("corners: sink / a wall is left", tables.corners),
                    others = table("depth ratio, median / 95 % / separations / stuck", tables.others);
  return {{"corners", tables.by_law}, {"corner_variations", corners}, {"near_a_wall", others}};
}

}  // namespace experiments
