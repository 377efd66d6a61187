// slow, optimised
// Every shape of the list in every kind of scene, followed by two hands under the recommended laws: as along
// the half-space or the analytic shape, or a stated limit. `examples/run experiments scenes` has all of it.
#include <experiments/scene_limits.cpp>
#include <experiments/scene_run.hpp>

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace {

using namespace experiments;

TEST(scenes, are_felt_as_the_analytic_shape_or_named_in_the_limits) {
  using M = ph::tendon_two_link<double>;
  const auto device = planar_scene_device();
  const scene_bench bench = bench_of<M>(
      device, {column<M>("velocity_direct_control", true, ph::velocity_direct_control()),
               column<M>("on_off_control", false, with_lead(ph::on_off_control(), device.brakes))});
  std::map<std::pair<std::size_t, surface>, scene_figures> alone;
  for (const scene_kind& kind : scene_kinds)
    for (std::size_t l = 0; l < bench.laws.size(); ++l) {
      std::map<surface, scene_figures> here;
      for (std::size_t s = 0; s < bench.specimens.size(); ++s) {
        const scene_cell cell{bench, kind, bench.specimens[s], bench.laws[l]};
        if (!unfit(cell).empty()) continue;
        const scene_figures figures = bench.run(kind, s, l, 2);
        const surface meant = cell.specimen.meant;
        const bool is_reference = here.emplace(meant, figures).second;
        if (is_reference) alone.emplace(std::pair(l, meant), figures);
        const std::string worse = worse_than(is_reference ? alone.at({l, meant}) : here.at(meant), figures);
        EXPECT_TRUE(worse.empty() || limit_of(cell, worse) != nullptr)
            << cell.specimen.name << ", " << kind.name << ", " << cell.law.name << ": " << worse << ", "
            << 1e3 * figures.max_depth << " mm, separations " << figures.separations;
      }
    }
}

}  // namespace
