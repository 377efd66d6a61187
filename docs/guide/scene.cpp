#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

// A custom shape: a ripple in the floor, 1-Lipschitz after division by the largest slope.
struct ripple {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const {
    return (x[1] - 0.01 * std::sin(50 * x[0])) / std::sqrt(1.25);
  }
  ph::point<2> gradient(const ph::point<2>& x) const {
    return ph::point<2>(-0.5 * std::cos(50 * x[0]), 1).normalized();
  }
};
static_assert(ph::Shape<ripple>);

int main() {
  const auto scene = ph::scene(ph::wall(ph::half_space<2>({0, 0.3}, {0, -1}), 1e5),
                               ph::wall(ph::disc({0.1, 0.2}, 0.05)), ph::wall(ripple(), 2e4));
  const auto touched = ph::sense(scene, ph::point<2>(0.1, 0.16));
  for (const auto& c : touched) {
    std::cout << "wall " << c.wall_number << ": depth " << c.depth << " m, normal " << c.normal.transpose()
              << "\n";
  }
  return touched.size() == 1 ? 0 : 1;
}
