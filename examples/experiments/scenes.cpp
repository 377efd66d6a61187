#include "scenes.hpp"

#include "batch.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <tuple>

namespace experiments {

namespace {

// A cell of one kind of scene, for both devices.
struct numbered_cell {
  std::size_t bench, specimen, law;
};

class scene_tables {
 public:
  scene_tables() : benches_{planar_bench(), spatial_bench()} {
    for (std::size_t b = 0; b < benches_.size(); ++b)
      for (const auto& s : benches_[b].specimens)
        if (std::find(names_.begin(), names_.end(), s.name) == names_.end()) names_.push_back(s.name);
  }

  void fill() {
    for (const scene_kind& kind : scene_kinds) {
      const std::vector<numbered_cell> cells = cells_of(kind);
      const auto results = on_all_cores(kind.name, cells.size(), [&](std::size_t k) {
        return benches_[cells[k].bench].run(kind, cells[k].specimen, cells[k].law, scene_hands);
      });
      worse_.clear();
      for (std::size_t k = 0; k < cells.size(); ++k) judge(kind, cells[k], results[k]);
      std::printf("\n%s: what is worse than the reference\n\n%s", kind.name, (worse_head() + worse_).c_str());
      std::fflush(stdout);
    }
  }

  int unexplained() const {
    const auto found = limited_.find("");
    return found == limited_.end() ? 0 : found->second.cells;
  }
  // Table of limits; the number of cells per limit goes to stdout, since it varies between runs.
  std::string limits() const {
    std::string all = markdown_head({"where", "why"});
    for (const scene_limit& l : scene_limits()) {
      all += markdown_row({l.where, l.reason});
      const auto found = limited_.find(l.where);
      std::printf("%5d cells, up to %5.1f times as deep: %s\n",
                  found == limited_.end() ? 0 : found->second.cells,
                  found == limited_.end() ? 0.0 : found->second.ratio, l.where.c_str());
    }
    return all;
  }
  // Words for the comparison with docs/results.md: s for separations, ! for worse cells.
  std::string page_text(const scene_kind& kind, std::size_t b, const std::string& name,
                        std::size_t law) const {
    const auto found = results_.find({kind.name, b, name, law});
    if (found == results_.end()) return "-";
    const judged& j = found->second;
    return written("%.1f", j.ratio) + (j.figures.separations > 0 ? " s" : "") + (j.worse.empty() ? "" : " !");
  }
  // One law, with shapes that feel alike in one row.
  std::string by_kind(std::size_t law) const {
    std::vector<std::string> head{"shape"};
    for (const auto& kind : scene_kinds) head.push_back(kind.name);
    std::vector<std::pair<std::string, std::vector<std::string>>> rows;
    for (const auto& name : names_) {
      std::vector<std::string> cells;
      for (const auto& kind : scene_kinds)
        cells.push_back(page_text(kind, 0, name, law) + " / " + page_text(kind, 1, name, law));
      const auto same =
          std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.second == cells; });
      if (same == rows.end()) rows.push_back({name, cells});
      else same->first += "; " + name;
    }
    std::string all = markdown_head(head);
    for (auto& [name, cells] : rows) {
      cells.insert(cells.begin(), name);
      all += markdown_row(cells);
    }
    return all;
  }

 private:
  struct judged {
    scene_figures figures;
    double ratio = 0;
    std::string worse;
  };
  scene_cell cell_of(const scene_kind& kind, const numbered_cell& c) const {
    return {benches_[c.bench], kind, benches_[c.bench].specimens[c.specimen], benches_[c.bench].laws[c.law]};
  }
  std::vector<numbered_cell> cells_of(const scene_kind& kind) const {
    std::vector<numbered_cell> cells;
    for (std::size_t b = 0; b < benches_.size(); ++b)
      for (std::size_t s = 0; s < benches_[b].specimens.size(); ++s)
        for (std::size_t l = 0; l < benches_[b].laws.size(); ++l)
          if (unfit(cell_of(kind, {b, s, l})).empty()) cells.push_back({b, s, l});
    return cells;
  }
  void judge(const scene_kind& kind, const numbered_cell& c, const scene_figures& figures) {
    const scene_cell cell = cell_of(kind, c);
    const auto& all = cell.bench.specimens;
    const auto first =
        std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.meant == cell.specimen.meant; });
    judged now{figures, 1, ""};
    const char* where = &*first == &cell.specimen ? scene_kinds[0].name : kind.name;
    if (const auto found = results_.find({where, c.bench, first->name, c.law}); found != results_.end()) {
      now.ratio = figures.max_depth / found->second.figures.max_depth;
      now.worse = worse_than(found->second.figures, figures);
    }
    if (!now.worse.empty()) {
      const scene_limit* limit = limit_of(cell, now.worse);
      limited& count = limited_[limit == nullptr ? "" : limit->where];
      ++count.cells;
      count.ratio = std::max(count.ratio, now.ratio);
      worse_ +=
          markdown_row({cell.bench.device, cell.specimen.name, kind.name,
                        cell.law.name + (cell.law.has_sensor ? "" : ", no sensor"), now.worse,
                        written("%.2f", now.ratio), written("%d", figures.separations),
                        written("%.2f", 1e3 * figures.max_depth), written("%.2f", 1e3 * figures.deviation),
                        written("%.2f", figures.drag), written("%.0f", 1e3 * figures.leave),
                        written("%d / %d / %d", figures.arrived, figures.through, figures.not_left),
                        limit == nullptr ? "unexplained" : limit->where});
    }
    results_[{kind.name, c.bench, cell.specimen.name, c.law}] = now;
  }
  static std::string worse_head() {
    return markdown_head({"device", "shape", "scene", "law", "worse", "depth ratio", "separations",
                          "deepest [mm]", "deviation [mm]", "drag [N]", "to leave [ms]",
                          "arrived / through / not left", "reason"});
  }
  std::vector<scene_bench> benches_;
  std::vector<std::string> names_;
  std::map<std::tuple<std::string, std::size_t, std::string, std::size_t>, judged> results_;
  std::string worse_;
  struct limited {
    int cells = 0;
    double ratio = 0;
  };
  std::map<std::string, limited> limited_;  // by where; "" for those without a reason
};

}  // namespace

page_tables follow_scenes(int& unexplained) {
  scene_tables tables;
  tables.fill();
  unexplained = tables.unexplained();
  std::printf("\nWorse cells by their limits; %d without a reason\n\n", unexplained);
  return {{"scenes", tables.by_kind(0)}, {"scene_limits", tables.limits()}};
}

}  // namespace experiments
