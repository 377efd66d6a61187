/// Figures of a device over the points of a task, to compare designs.
#pragma once

#include <passive_haptics/design/map/planar_figures.hpp>
#include <passive_haptics/design/map/task_points.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace passive_haptics {

/// design_figures at N points of a task as a structure of arrays: element k belongs to point k.
template <class M>
class design_map {
 public:
  using T = typename M::scalar;  ///< Scalar of the mechanism.
  /// True for planar devices with two joints and two brakes in double, which need no decomposition.
  static constexpr bool has_closed_form = detail::is_planar_with_two_brakes<M>;

  std::vector<status> outcome;         ///< ok, or the reason for no figures.
  std::vector<display_class> display;  ///< Display of a force along the normal.
  std::vector<T> cosine;               ///< cos(gamma) [1].
  std::vector<T> drag;                 ///< Per newton of normal force [1].
  std::vector<T> max_force;            ///< Maximum n . F [N].
  std::vector<T> sink_slope;           ///< [1]
  std::vector<T> isotropy;             ///< Of E [1].

  /// Figures for these brakes, including motors, and a hand that pushes with `push` [N]. They agree with
  /// design_figures_at() to a relative 1e-9. Throws std::invalid_argument if a limit is NaN or on the wrong
  /// side of 0, or the push is NaN. Ten times faster if has_closed_form and no brake is off or one-way.
  design_map(const M& mechanism, const task_points<M>& points, const hybrid_brakes<M>& brakes, T push) {
    assign(mechanism, points, brakes, push);
  }
  design_map() = default;  ///< An empty map.

  /// Replaces the map, as by the constructor. Allocates only for more points than before.
  void assign(const M& mechanism, const task_points<M>& points, const hybrid_brakes<M>& brakes, T push) {
    require_valid(brakes);
    detail::refuse_unless(!std::isnan(push), "push on a design_map [N]", push, "a number");
    const std::size_t n = points.size();
    outcome.resize(n);
    display.resize(n);
    for (auto* figures : {&cosine, &drag, &max_force, &sink_slope, &isotropy}) figures->resize(n);
    const auto store_all = [&](const auto& figures_at) {
      for (std::size_t k = 0; k < n; ++k)
        store(k, points.reached(k) == status::ok ? figures_at(points[k])
                                                 : design_figures<T>{.outcome = points.reached(k)});
    };
    if constexpr (has_closed_form)
      if (can_all_resist(brakes)) return store_all(detail::planar_figures<M>(mechanism, brakes, push));
    store_all([&](const path_point<M>& at) { return design_figures_at(mechanism, at, brakes, push); });
  }

  std::size_t size() const { return outcome.size(); }  ///< Number of points.
  /// Figures of point k.
  design_figures<T> operator[](std::size_t k) const {
    return {outcome[k], display[k], cosine[k], drag[k], max_force[k], sink_slope[k], isotropy[k]};
  }

 private:
  static void require_valid(const hybrid_brakes<M>& hybrid) {
    const auto expect = [](const char* name, const brake_vector<M>& limits, T sign, const char* expected) {
      for (int i = 0; i < M::brake_count; ++i)
        detail::refuse_unless(sign * limits[i] >= T(0), detail::indexed(name, i, "] for a design_map [N m]"),
                              limits[i], expected);
    };
    expect("torque_limit[", hybrid.brakes.torque_limit, T(1), "a number >= 0, or infinity");
    expect("torque_upper[", hybrid.brakes.torque_upper, T(1), "a number >= 0, or infinity");
    expect("torque_lower[", hybrid.brakes.torque_lower, T(-1), "a number <= 0, or -infinity");
    expect("motor_limit[", hybrid.motor_limit, T(1), "a number >= 0, or infinity");
  }

  // True if all brakes are on and work both ways
  static bool can_all_resist(const hybrid_brakes<M>& hybrid) {
    const switchable_brakes<M>& b = hybrid.brakes;
    return (b.torque_limit.array() > T(0)).all() && (b.torque_lower.array() < T(0)).all() &&
           (b.torque_upper.array() > T(0)).all();
  }

  void store(std::size_t k, const design_figures<T>& found) {
    outcome[k] = found.outcome;
    display[k] = found.display;
    cosine[k] = found.cosine;
    drag[k] = found.drag;
    max_force[k] = found.max_force;
    sink_slope[k] = found.sink_slope;
    isotropy[k] = found.isotropy;
  }
};

}  // namespace passive_haptics
