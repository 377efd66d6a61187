/// @file
/// The design map of a device over a grid of points.
#pragma once

#include "device.hpp"
#include "pose_values.hpp"

#include <passive_haptics/design/map/design_figures.hpp>

#include <array>
#include <limits>

namespace explorer {

/// The figures of design_figures_at() at each point of a grid that E's device reaches.
template <class E>
class map_of final : public figure_map {
  using C = configuration<E>;
  using M = typename E::mechanism;
  static constexpr int d = C::d, figure_count = 6;

 public:
  /// Of columns x rows points from low to high, in space at the height of the present handle.
  map_of(const C& c, int columns, int rows, const ph::vector<double, 2>& low,
         const ph::vector<double, 2>& high)
      : c_(c), model_(E::make(c.mechanism)), columns_(columns), rows_(rows), low_(low), high_(high) {
    if (columns < 1 || rows < 1 || columns > 1000 || rows > 1000)
      refuse("map", std::to_string(columns) + " x " + std::to_string(rows), "1 to 1000 points a side");
    for (auto& f : figures_)
      f.assign(std::size_t(columns) * std::size_t(rows), std::numeric_limits<double>::quiet_NaN());
  }

  int advance(int rows) override {
    for (; rows > 0 && done_ < rows_; --rows, ++done_)
      for (int i = 0; i < columns_; ++i) compute(i, done_);
    return done_;
  }
  double* figure(int number) override {
    if (number < 0 || number >= figure_count)
      refuse("figure", std::to_string(number), "one of the catalogue, from 0");
    return figures_[std::size_t(number)].data();
  }

 private:
  void compute(int column, int row) {
    const auto at = [](double low, double high, int k, int count) {
      return count > 1 ? low + (high - low) * k / (count - 1) : (low + high) / 2;
    };
    ph::task_vector<M> x = model_.position(c_.top.q);
    x[0] = at(low_[0], high_[0], column, columns_);
    x[1] = at(low_[1], high_[1], row, rows_);
    const auto reached = E::inverse(model_, x, c_.top.q);
    if (reached.outcome != ph::status::ok) return;
    const ph::path_point<M> point{reached.q, c_.map.direction, c_.map.normal};
    const auto f = ph::design_figures_at(model_, point, ph::hybrid_brakes<M>(c_.switchable()), c_.map.push);
    if (f.outcome != ph::status::ok) return;
    const std::size_t k = std::size_t(row) * std::size_t(columns_) + std::size_t(column);
    const double all[figure_count] = {f.cosine,     f.drag,     f.max_force,
                                      f.sink_slope, f.isotropy, double(int(f.display))};
    for (std::size_t i = 0; i < figure_count; ++i) figures_[i][k] = all[i];
  }

  C c_;
  M model_;
  int columns_, rows_, done_ = 0;
  ph::vector<double, 2> low_, high_;
  std::array<std::vector<double>, figure_count> figures_;
};

}  // namespace explorer
