#include "paper_reading.hpp"

#include "batch.hpp"
#include "markdown.hpp"
#include "plants.hpp"

namespace experiments {

bool reproduces(const ph::contact_metrics& without, const ph::contact_metrics& with) {
  return without.separations >= 3 && with.separations <= 1 && with.depth_std < without.depth_std &&
         with.stick_share < without.stick_share && with.hand_force_std < without.hand_force_std &&
         with.retarding_force < without.retarding_force;
}

std::vector<reading_cell> read_the_paper(std::uint64_t seed, double time_step, bool bands_only,
                                         simulation plant) {
  const std::pair<const char*, test_wall> walls[] = {
      {"planar", planar_wall()}, {"concave", concave_wall()}, {"convex", convex_wall()}};
  std::vector<reading_cell> cells;
  for (const auto& [name, wall] : walls) {
    if (bands_only && name != walls[0].first) break;
    for (const double rate : {1000.0, 20.0}) {
      const std::size_t first = cells.size();
      for (const law which : reading_laws) {
        if (bands_only && which == law::velocity) continue;
        const std::string title = std::string(name) + ", " + std::string(name_of(which));
        reading_cell cell{name, rate, which, {}, 0};
        cell.figures = on_all_cores(title, hand_count, [&, &wall = wall](std::size_t k) {
          setup how = yielding_hand(seed, k);
          how.environment_rate = rate;
          how.time_step = time_step;
          how.plant = plant;
          return follow_with_arm(which, wall, how).figures;
        });
        cells.push_back(std::move(cell));
        for (std::size_t k = 0; k < hand_count; ++k)
          cells.back().reproduced += reproduces(cells[first].figures[k], cells.back().figures[k]);
      }
    }
  }
  return cells;
}

std::string reading_table(const std::vector<reading_cell>& cells) {
  using m = ph::contact_metrics;
  std::string table = markdown_head({"wall", "law", "reproduces", "separations", "deepest [mm]",
                                     "mean depth [mm]", "standard deviation [mm]", "brake 2 sticks",
                                     "F_h [N], deviation", "retarding force [N]"});
  for (const auto& c : cells) {
    table += markdown_row({written("%s, %.0f Hz", c.wall.c_str(), c.rate), std::string(name_of(c.which)),
                           c.which == law::none ? "" : written("%d of %zu", c.reproduced, c.figures.size()),
                           written("%.0f", median(values_of(c.figures, &m::separations))),
                           written("%.1f", 1e3 * median(values_of(c.figures, &m::max_depth))),
                           written("%.1f", 1e3 * median(values_of(c.figures, &m::depth_mean))),
                           written("%.2f", 1e3 * median(values_of(c.figures, &m::depth_std))),
                           written("%.0f %%", 100 * median(values_of(c.figures, &m::stick_share))),
                           written("%.2f", median(values_of(c.figures, &m::hand_force_std))),
                           written("%.2f", median(values_of(c.figures, &m::retarding_force)))});
  }
  return table;
}

std::string plant_table(const std::vector<reading_cell>& own, const std::vector<reading_cell>& mujoco) {
  using m = ph::contact_metrics;
  std::string table = markdown_head({"wall", "law", "separations", "MuJoCo", "mean depth [mm]", "MuJoCo",
                                     "standard deviation [mm]", "MuJoCo", "retarding force [N]", "MuJoCo"});
  for (std::size_t k = 0; k < own.size(); ++k) {
    std::vector<std::string> row{written("%s, %.0f Hz", own[k].wall.c_str(), own[k].rate),
                                 std::string(name_of(own[k].which))};
    const auto add = [&](int digits, double unit, auto member) {
      for (const auto* cells : {&own, &mujoco})
        row.push_back(written("%.*f", digits, median(values_of((*cells)[k].figures, member)) / unit));
    };
    add(0, 1, &m::separations);
    add(2, 1e-3, &m::depth_mean);
    add(3, 1e-3, &m::depth_std);
    add(3, 1, &m::retarding_force);
    table += markdown_row(row);
  }
  return table;
}

}  // namespace experiments
