/// Points of a task, at which a device is examined before it is built.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/design/path_point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace passive_haptics {

/// Maximum number of points of points_of(); with their design_map they take about 12 GB.
inline constexpr std::size_t max_task_points = 100'000'000;

/// Points of a task of mechanism M.
template <class M>
class task_points {
 public:
  using T = typename M::scalar;  ///< Scalar of the mechanism.

  /// Appends a point with the end effector at x [m]. reached: status of the joint positions q; the map has
  /// this status and no figures if it is not ok.
  void append(const path_point<M>& at, const task_vector<M>& x, status reached = status::ok) {
    points_.push_back(at);
    x_.push_back(x);
    reached_.push_back(reached);
  }
  /// Appends a point with the position by the mechanism.
  void append(const M& mechanism, const path_point<M>& at) {
    const bool is_there = all_finite(at.q);
    append(at,
           is_there ? task_vector<M>(mechanism.position(at.q))
                    : task_vector<M>::Constant(std::numeric_limits<T>::quiet_NaN()),
           is_there ? status::ok : status::state_not_finite);
  }

  std::size_t size() const { return reached_.size(); }                         ///< Number of points.
  const path_point<M>& operator[](std::size_t k) const { return points_[k]; }  ///< Point k.
  /// End effector at point k [m], base frame.
  const task_vector<M>& position(std::size_t k) const { return x_[k]; }
  /// ok, out_of_reach or state_not_finite for point k.
  status reached(std::size_t k) const { return reached_[k]; }

 private:
  std::vector<path_point<M>> points_;
  std::vector<task_vector<M>> x_;
  std::vector<status> reached_;
};

/// A grid over a box of the workspace, including its corners.
template <class T, int D>
struct task_grid {
  vector<T, D> lower;                                  ///< Minimum coordinates [m], base frame.
  vector<T, D> upper;                                  ///< Maximum coordinates [m].
  std::array<int, static_cast<std::size_t>(D)> count;  ///< Points along each axis, >= 2.

  /// Number of points, saturated at the maximum of the type; 0 if a count is not positive.
  std::size_t size() const {
    constexpr std::size_t max = std::numeric_limits<std::size_t>::max();
    std::size_t n = 1;
    for (const int c : count) {
      const auto along = std::size_t(std::max(c, 0));
      n = along > 0 && n > max / along ? max : n * along;
    }
    return n;
  }
  /// Point k; the first coordinate changes fastest.
  vector<T, D> operator[](std::size_t k) const {
    vector<T, D> x;
    for (int i = 0; i < D; ++i) {
      const auto n = std::size_t(nth(count, i));
      x[i] = lower[i] + (upper[i] - lower[i]) * T(k % n) / T(n - 1);
      k /= n;
    }
    return x;
  }
};

namespace detail {
inline void require_task_size(std::size_t size, const char* name) {
  refuse_unless(size <= max_task_points, name, size,
                indexed("at most ", max_task_points, "; map the task in parts"));
}
}  // namespace detail

/// Points of a grid with one direction of motion and one wall normal (base frame). inverse(x): a
/// joint_solution for the end effector at x. Throws std::invalid_argument for fewer than 2 points along an
/// axis, more than max_task_points, or corners that are not finite.
template <class M, class Inverse>
task_points<M> points_of(const M&, const task_grid<typename M::scalar, M::task_dimension>& grid,
                         const Inverse& inverse, const task_vector<M>& direction,
                         const task_vector<M>& normal) {
  for (int i = 0; i < M::task_dimension; ++i) {
    detail::refuse_unless(nth(grid.count, i) >= 2, detail::indexed("count[", i, "] of a task_grid"),
                          nth(grid.count, i), "2 or more points along each axis");
    detail::refuse_unless(std::isfinite(grid.lower[i]), detail::indexed("lower[", i, "] of a task_grid"),
                          grid.lower[i], "a finite number [m]");
    detail::refuse_unless(std::isfinite(grid.upper[i]), detail::indexed("upper[", i, "] of a task_grid"),
                          grid.upper[i], "a finite number [m]");
  }
  detail::require_task_size(grid.size(), "size of a task_grid");
  task_points<M> points;
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const task_vector<M> x = grid[k];
    const auto there = inverse(x);
    points.append({there.q, direction, normal}, x, there.outcome);
  }
  return points;
}

/// `count` points of a path, at the middles of equal parts; path(u) returns the path_point<M> at u in (0, 1).
/// Throws std::invalid_argument for a count below 1 or above max_task_points.
template <class M, class Path>
task_points<M> points_of(const M& mechanism, Path&& path, int count) {
  detail::refuse_unless(count >= 1, "count of the points of a path", count, "1 or more");
  detail::require_task_size(std::size_t(count), "count of the points of a path");
  task_points<M> points;
  for (int k = 0; k < count; ++k) points.append(mechanism, path((k + 0.5) / count));
  return points;
}

}  // namespace passive_haptics
