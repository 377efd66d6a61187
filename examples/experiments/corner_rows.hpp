// Rows of the tables of corners: all corners of a device under a law.
#pragma once

#include "batch.hpp"
#include "control_of.hpp"
#include "corner_run.hpp"
#include "corners.hpp"
#include "laws.hpp"

#include <cstdio>

namespace experiments {

// Edges: includes convex edges, which need another scene type, hence another controller type.
template <bool Edges = false, class M, class Control>
control_maker<M> maker(const M& mechanism, const Control& control_of) {
  return [=](const corner<M>& c, const ph::brakes_of<M>& brakes) -> typename closed_loop<M>::capacities {
    const auto with = [&](const auto&... walls) {
      return [control = control_of(mechanism, brakes, ph::scene(ph::wall(walls)...))](
                 const auto& state) mutable { return ph::brake_vector<M>(control(state).capacity); };
    };
    if constexpr (Edges)
      if (c.edge) return with(*c.edge);
    if constexpr (M::task_dimension == 2) return with(c.walls[0], c.walls[1]);
    else return with(c.walls[0], c.walls[1], c.walls[2]);
  };
}

// All hands of one row.
struct corner_row {
  std::vector<corner_result> hands;

  template <class F>
  int count(F&& is) const {
    return static_cast<int>(std::count_if(hands.begin(), hands.end(), is));
  }
  int held() const {
    return count([](const auto& r) { return r.held; });
  }
  int sinking() const {
    return count([](const auto& r) { return r.held && r.sinks; });
  }
  int leaving() const {
    return count([](const auto& r) { return r.held && r.left; });
  }
  int total(int corner_result::* member) const {
    int sum = 0;
    for (const auto& r : hands) sum += r.*member;
    return sum;
  }
  template <class F>
  double quantile(double share, F&& figure) const {
    std::vector<double> values;
    for (const auto& r : hands) values.push_back(figure(r));
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  }
};

// The tables while they fill.
struct corner_tables {
  std::string by_law;
  std::vector<std::string> devices;
  std::vector<std::vector<std::string>> corners, others;  // variations, each with a cell per device
};

template <class M>
class corner_columns {
 public:
  corner_columns(corner_tables& tables, const corner_device<M>& device, int walls = 2)
      : tables_(tables), device_(device), walls_(walls) {}

  template <class Control>
  void add_law(const std::string& name, const Control& control) {
    const corner_row row =
        follow({.walls = walls_}, {.pulls_out = true}, maker(device_.mechanism, control), 1);
    const double law = row.quantile(0.95, [](const auto& r) { return r.max_depth; }),
                 locked = row.quantile(0.95, [](const auto& r) { return r.max_locked_depth; });
    const auto percent = [&](int corner_result::* member) {
      return 100.0 * row.total(member) / std::max(row.total(&corner_result::pulls), 1);
    };
    const std::string line = markdown_row(
        {device_.name, name, written("%d", row.held()), written("%d", row.sinking()),
         written("%d", row.leaving()), written("%d", row.total(&corner_result::separations)),
         written("%.1f / %.1f", 1e3 * law, 1e3 * locked), written("%.2f", law / locked),
         written("%d", row.count([](const auto& r) { return r.first > r.first_alone + 0.3e-3; })),
         written("%.0f / %.0f", percent(&corner_result::in_time), percent(&corner_result::no_heavier))});
    std::fputs(line.c_str(), stdout);
    std::fflush(stdout);
    tables_.by_law += line;
  }

  // Other obstacles, under one law.
  template <class Control>
  void add_variations(const Control& control) {
    const auto make = maker<true>(device_.mechanism, control);
    std::size_t corner = 0, other = 0;
    const auto add = [](auto& rows, std::size_t& at, const char* name, std::string cell) {
      if (rows.size() <= at) rows.push_back({name});
      rows[at++].push_back(std::move(cell));
    };
    const auto add_corner = [&](const char* name, double least, double largest, const corner_hand& hand) {
      const auto row = follow({.min_angle = least, .max_angle = largest, .walls = walls_}, hand, make, share);
      add(tables_.corners, corner, name, written("%d / %d of %d", row.sinking(), row.leaving(), row.held()));
    };
    add_corner("30 to 60 deg", 30, 60, {});
    add_corner("150 to 170 deg", 150, 170, {});
    add_corner("push rises by 10 N/s", 60, 150, {.rise = 10});
    add_corner("brakes 1.1 times what is needed", 60, 150, {.strength = 1.1});
    add_corner("brakes 3 times", 60, 150, {.strength = 3});
    add_corner("brakes 10 times", 60, 150, {.strength = 10});
    add_corner("sensor reads 0.8 N for 1 N", 60, 150, {.gain = 0.8});
    add_corner("sensor reads 1.2 N for 1 N", 60, 150, {.gain = 1.2});
    const auto add_other = [&](const char* name, const obstacle& what) {
      const auto row = follow(what, {}, make, share);
      const auto ratio = [](const auto& r) { return r.first / r.first_alone; };
      add(tables_.others, other, name,
          written("%.2f / %.2f / %d / %d", row.quantile(0.5, ratio), row.quantile(0.95, ratio),
                  row.total(&corner_result::separations),
                  row.count([](const auto& r) { return !r.arrived; })));
    };
    using enum obstacle::kind;
    add_other("slot, half width 3 mm", {.what = opposite_wall, .distance = 6e-3});
    add_other("bar 5 mm above", {.what = opposite_wall, .distance = 5e-3});
    add_other("second floor 3 mm below", {.what = wall_below, .distance = 3e-3});
    add_other("convex edge", {.what = convex_edge});
    tables_.devices.push_back(device_.name);
  }

 private:
  static constexpr double share = 0.5;  // of the corners, for variations
  corner_row follow(const obstacle& what, const corner_hand& hand, const control_maker<M>& make,
                    double part) {
    const auto count = static_cast<std::size_t>(std::ceil(part * static_cast<double>(corner_count)));
    return {on_all_cores(device_.name, count, [&](std::size_t k) {
      return corner_run<M>(device_, draw_corner(device_, what, corner_seed, k), hand, make).result();
    })};
  }

  corner_tables& tables_;
  corner_device<M> device_;
  int walls_;
};

// Every law that any device can use, then the variations under the recommended one.
template <class M>
void add_device(corner_tables& tables, const corner_device<M>& device, int walls = 2) {
  corner_columns<M> columns(tables, device, walls);
  const with_sensor recommended{ph::recommended_law(device.mechanism, device.brakes)};
  columns.add_law("recommended_law", recommended);
  for_laws<law::direct, law::on_off>(
      [&](const std::string& name, const auto& l) { columns.add_law(name, with_sensor{l}); });
  for_laws<law::velocity>([&](const std::string& name, const auto& l) {
    columns.add_law(name + ", no sensor", without_sensor{l});
  });
  if (walls == 2) columns.add_variations(recommended);
}

// In separate files, compiled in parallel.
void add_planar_devices(corner_tables& tables);
void add_other_devices(corner_tables& tables);

}  // namespace experiments
