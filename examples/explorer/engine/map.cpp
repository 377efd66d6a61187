#include "map.hpp"

#include <cmath>
#include <limits>

namespace explorer {

figure_map::figure_map(const configuration& c, int columns, int rows, const place& low, const place& high)
    : of_(c), columns_(columns), rows_(rows), low_(low), high_(high) {
  if (columns < 1 || rows < 1 || columns > 1000 || rows > 1000)
    refuse("map", std::to_string(columns) + " x " + std::to_string(rows), "1 to 1000 points a side");
  for (auto& f : figures_)
    f.assign(std::size_t(columns) * std::size_t(rows), std::numeric_limits<double>::quiet_NaN());
}

int figure_map::advance(int rows) {
  for (; rows > 0 && done_ < rows_; --rows, ++done_)
    for (int i = 0; i < columns_; ++i) compute(i, done_);
  return done_;
}

void figure_map::compute(int column, int row) {
  const auto at = [](double low, double high, int k, int count) {
    return count > 1 ? low + (high - low) * k / (count - 1) : (low + high) / 2;
  };
  const configuration& c = of_.settings;
  place x = of_.position(c.state.q);
  x[0] = at(low_[0], high_[0], column, columns_);
  x[1] = at(low_[1], high_[1], row, rows_);
  const auto reached = of_.inverse(x, c.state.q);
  if (reached.outcome != ph::status::ok) return;
  const auto f =
      of_.kind->displayable(reached.q, place_of(c.map.direction), place_of(c.map.normal), c.brakes.numbers());
  if (!f.is_known) return;
  const std::size_t k = std::size_t(row) * std::size_t(columns_) + std::size_t(column);
  figures_[0][k] = ph::is_displayed(f.display) ? std::cos(f.angle) : 0;
  figures_[1][k] = int(f.display);
}

}  // namespace explorer
