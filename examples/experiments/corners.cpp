#include "corners.hpp"

#include "batch.hpp"
#include "corner_run.hpp"
#include "markdown.hpp"
#include "rods.hpp"

namespace experiments {

namespace {

constexpr std::uint64_t corner_seed = 59;

struct corner_count {
  int corners = 0, not_there = 0, held = 0, sink = 0, left = 0, separations = 0, first_deeper = 0;
  std::vector<double> law, locked;  // deepest [m]
  void add(const corner_result& r) {
    ++corners;
    not_there += !r.arrived;
    first_deeper += r.first > r.first_alone + 0.3e-3;
    if (!r.arrived) return;
    separations += r.law.separations;
    left += r.law.left;
    if (r.locked.sink > 0.01e-3) return;
    ++held;
    sink += r.law.sink > 0.2e-3;
    law.push_back(r.law.deepest);
    locked.push_back(r.locked.deepest);
  }
  static double p95(std::vector<double> v) {
    if (v.empty()) return 0;
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(0.95 * static_cast<double>(v.size() - 1))];
  }
};

template <class M, class Law>
corner_count follow_all(const corner_device<M>& device, int walls, const Law& law, std::size_t count) {
  const auto results = on_all_cores(device.name, count, [&](std::size_t k) {
    return follow_corner(
        device, draw_corner(device, walls, 60, 150, corner_seed, k),
        [&](const auto& scene, const auto& brakes) {
          return [control = ph::controller(device.mechanism, brakes, scene, law)](const auto& state) mutable {
            return ph::brake_vector<M>(control(state).capacity);
          };
        });
  });
  corner_count all;
  for (const auto& r : results) all.add(r);
  return all;
}

template <class M>
std::string rows_of(const corner_device<M>& device, int walls, std::size_t count) {
  std::string rows;
  const auto row = [&](const char* law_name, const auto& law) {
    const corner_count n = follow_all(device, walls, law, count);
    const double p = 1e3 * corner_count::p95(n.law), b = 1e3 * corner_count::p95(n.locked);
    const std::string line = markdown_row(
        {device.name, law_name, written("%d", n.corners), written("%d", n.not_there), written("%d", n.held),
         written("%d", n.sink), written("%d", n.left), written("%d", n.separations),
         written("%.1f / %.1f", p, b), written("%.2f", p / b), written("%d", n.first_deeper)});
    std::fputs(line.c_str(), stdout);
    std::fflush(stdout);
    rows += line;
  };
  row("recommended_law", ph::recommended_law(device.mechanism, device.brakes));
  row("on_off_control", ph::on_off_control());
  return rows;
}

}  // namespace

std::string corner_table(std::size_t count) {
  const std::string head = markdown_head(
      {"device", "law", "corners", "never in the corner", "locked brakes hold", "sink", "a wall is left",
       "separations", "deepest, 95 % [mm]: law / locked", "ratio", "wall 1 deeper before"});
  std::fputs(head.c_str(), stdout);
  const corner_device<ph::tendon_two_link<double>> tendon{
      "tendon", ph::tendon_two_link<double>(), {{-3.1, -2.9}, {3.1, -0.4}, 0.025, 1, 25}};
  const corner_device<ph::five_bar<double, 2>> five{
      "five-bar", ph::five_bar<double, 2>(), {{1.5, 0}, {3.1, 1.6}, 0.015, 1, 25}};
  const corner_device<ph::five_bar<double, 4>> four{
      "five-bar, four brakes", ph::five_bar<double, 4>(), {{1.5, 0}, {3.1, 1.6}, 0.015, 1, 25}};
  corner_device<ph::xy_table<double>> table{
      "XY table", ph::xy_table<double>(), {{-0.1, -0.1}, {0.1, 0.1}, 0.025}};
  table.brakes.torque_limit.setConstant(10);
  table.brakes.rate_dead_band.setConstant(0.002);
  table.count *= 0.1;
  return head + rows_of(tendon, 2, count) + rows_of(five, 2, count) + rows_of(four, 2, count) +
         rows_of(table, 2, count);
}

}  // namespace experiments
