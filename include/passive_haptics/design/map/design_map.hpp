/// @file
/// A map of what a device can do over the points of a task, to compare designs by.
#pragma once

#include <passive_haptics/control/batch/batch_packs.hpp>
#include <passive_haptics/design/map/packed_figures.hpp>
#include <passive_haptics/design/map/task_points.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace passive_haptics {

/// The figures of a device at N points of a task, a structure of arrays: number k of each is that of point k,
/// and stands for what design_figures has there.
template <class M>
class design_map {
 public:
  using T = typename M::scalar;  ///< Scalar of the mechanism.
  /// Whether several points are computed at a time: as the cycles of a batch_controller are.
  static constexpr bool is_vectorised = detail::takes_packs_of_joints<M>;

  std::vector<status> outcome;         ///< ok, or why there are no figures.
  std::vector<display_class> display;  ///< How a force along the normal is displayed.
  std::vector<T> cosine;               ///< cos(gamma) [1].
  std::vector<T> drag;                 ///< For each newton that is displayed [1].
  std::vector<T> strongest;            ///< Largest n . F [N].
  std::vector<T> sink_slope;           ///< [1]
  std::vector<T> isotropy;             ///< Of E [1].

  /// Of brakes with these limits, and motors if there are any, against a hand that pushes with `push` [N].
  /// Figures agree with design_figures_at() to 1e-9 of their size; classes are equal, but where rounding
  /// decides. Throws std::invalid_argument where a limit is NaN or on the wrong side of 0, or the push is
  /// NaN. Cost: where is_vectorised, 1.1 to 1.6 times that of a batch of control cycles; else
  /// a design_figures_at() a point.
  design_map(const M& mechanism, const task_points<M>& points, const hybrid_brakes<M>& brakes, T push) {
    assign(mechanism, points, brakes, push);
  }
  /// An empty map.
  design_map() = default;

  /// Becomes the map of another device or task, as by the constructor. Allocates only for more points than
  /// before.
  void assign(const M& mechanism, const task_points<M>& points, const hybrid_brakes<M>& brakes, T push) {
    require_valid(brakes);
    detail::refuse_unless(!std::isnan(push), "push on a design_map [N]", push, "a number");
    const std::size_t n = points.size();
    outcome.resize(n);
    display.resize(n);
    for (auto* figures : {&cosine, &drag, &strongest, &sink_slope, &isotropy}) figures->resize(n);
    std::size_t first = 0;
    if constexpr (is_vectorised)
      if (can_all_resist(brakes)) first = store_packs(mechanism, points, brakes, push);
    for (std::size_t k = first; k < n; ++k) store_one(mechanism, points, brakes, push, k);
  }

  /// How many points there are.
  std::size_t size() const { return outcome.size(); }
  /// The figures of point k.
  design_figures<T> operator[](std::size_t k) const {
    return {outcome[k], display[k], cosine[k], drag[k], strongest[k], sink_slope[k], isotropy[k]};
  }

 private:
  static constexpr int width = native_pack_width<T>;

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

  // Brakes that are on, and work both ways
  static bool can_all_resist(const hybrid_brakes<M>& hybrid) {
    const switchable_brakes<M>& b = hybrid.brakes;
    return (b.torque_limit.array() > T(0)).all() && (b.torque_lower.array() < T(0)).all() &&
           (b.torque_upper.array() > T(0)).all();
  }

  void store_one(const M& mechanism, const task_points<M>& points, const hybrid_brakes<M>& brakes, T push,
                 std::size_t k) {
    design_figures<T> found;
    if (points.reached(k) == status::ok) found = design_figures_at(mechanism, points[k], brakes, push);
    else found.outcome = points.reached(k);
    outcome[k] = found.outcome;
    display[k] = found.display;
    cosine[k] = found.cosine;
    drag[k] = found.drag;
    strongest[k] = found.strongest;
    sink_slope[k] = found.sink_slope;
    isotropy[k] = found.isotropy;
  }

  // As many points as fill packs; returns their number.
  PASSIVE_HAPTICS_FLATTEN std::size_t store_packs(const M& mechanism, const task_points<M>& points,
                                                  const hybrid_brakes<M>& brakes, T push) {
    const brake_jacobian_evaluator<M> brake_jacobian(mechanism);
    const brake_vector<M> rest = brake_vector<M>::Zero();
    const torque_box<T, M::brake_count> at_rest = passive_haptics::torque_box_of(rest, brakes);
    const std::size_t end = points.size() - points.size() % std::size_t(width);
    const auto packs_of = [](const auto& columns, std::size_t k) PASSIVE_HAPTICS_INLINE {
      return vector<pack<T, width>, 2>(pack<T, width>::load(columns[0].data() + k),
                                       pack<T, width>::load(columns[1].data() + k));
    };
    for (std::size_t k = 0; k < end; k += std::size_t(width)) {
      const auto found = detail::packed_figures_at(
          mechanism, brake_jacobian, packs_of(points.q(), k), packs_of(points.direction(), k),
          packs_of(points.normal(), k), at_rest, brakes.motor_limit, push);
      const detail::whole_pack at{k};
      detail::store(std::span<display_class>(display), at, found.display);
      detail::store(std::span<T>(cosine), at, found.cosine);
      detail::store(std::span<T>(drag), at, found.drag);
      detail::store(std::span<T>(strongest), at, found.strongest);
      detail::store(std::span<T>(sink_slope), at, found.sink_slope);
      detail::store(std::span<T>(isotropy), at, found.isotropy);
      std::fill_n(outcome.begin() + std::ptrdiff_t(k), width, status::ok);
      bool are_reached = none(!found.are_valid);
      for (int j = 0; j < width; ++j)
        are_reached = are_reached && points.reached(k + std::size_t(j)) == status::ok;
      if (!are_reached) store_others(mechanism, points, brakes, push, k, found.are_valid);
    }
    return end;
  }

  // Of a pack's points those that need branches.
  [[gnu::noinline]] void store_others(const M& mechanism, const task_points<M>& points,
                                      const hybrid_brakes<M>& brakes, T push, std::size_t first,
                                      const truth_of<pack<T, width>>& are_valid) {
    for (int j = 0; j < width; ++j) {
      const std::size_t k = first + std::size_t(j);
      if (!are_valid[j] || points.reached(k) != status::ok) store_one(mechanism, points, brakes, push, k);
    }
  }
};

}  // namespace passive_haptics
