// A cube of 1 m full of small shapes, and a hand that wanders in it; for the tests and the benchmark of large
// scenes.
#pragma once

#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace many_shapes {

namespace ph = passive_haptics;

// Half balls, half boxes, of size 1 to 5 mm, uniform in the unit cube, and the cube's faces from inside.
template <int D>
struct shapes {
  std::vector<ph::ball<D>> balls;
  std::vector<ph::box<D>> boxes;
  std::vector<ph::half_space<D>> faces;
  std::vector<std::pair<ph::point<D>, double>> ball_sizes;       // centre, radius
  std::vector<std::pair<ph::point<D>, ph::point<D>>> box_sizes;  // centre, half extents

  shapes(int count, ph::testing::random_source& random) {
    const auto size = [&] { return random.uniform(1e-3, 5e-3); };
    for (int i = 0; i < count; ++i) {
      const ph::point<D> centre = random.between<double, D>(ph::point<D>::Zero(), ph::point<D>::Constant(1));
      if (i % 2 == 0) {
        ball_sizes.emplace_back(centre, size());
        balls.emplace_back(centre, ball_sizes.back().second);
      } else {
        ph::point<D> half;
        for (int k = 0; k < D; ++k) half[k] = size();
        box_sizes.emplace_back(centre, half);
        boxes.emplace_back(centre, half);
      }
    }
    for (int k = 0; k < D; ++k) {
      const ph::point<D> e = ph::point<D>::Unit(k);
      faces.emplace_back(ph::point<D>::Zero(), e);
      faces.emplace_back(e, -e);
    }
  }

  std::size_t size() const { return balls.size() + boxes.size() + faces.size(); }

  // Calls f(shape) for each, in the order of the numbers that walls() gives them.
  template <class F>
  void for_each(const F& f) const {
    for (const auto& s : balls) f(s);
    for (const auto& s : boxes) f(s);
    for (const auto& s : faces) f(s);
  }

  ph::world_walls<D> walls() const {
    ph::world_walls<D> all;
    for_each([&](const auto& s) { all.add(ph::wall(s)); });
    return all;
  }
};

// The contacts of a look at everything, from a margin [m] off each wall on.
template <int Capacity, int D>
ph::contacts<D, Capacity> scan(const shapes<D>& all, const ph::point<D>& x, double margin = 0) {
  ph::strongest_contacts<D, Capacity> found;
  int number = 0;
  all.for_each([&](const auto& shape) {
    const double distance = shape.distance(x);
    if (!(distance >= margin)) {
      auto c = ph::contact_of(ph::wall(shape), x, distance);
      c.wall_number = number;
      found.add(c);
    }
    ++number;
  });
  return found.in_order();
}

// A hand at constant speed that turns at random and is sent back at the faces of the cube, some way beyond
// them.
template <int D>
class wandering_hand {
 public:
  wandering_hand(double step, ph::testing::random_source& random)
      : random_(random), step_(step), direction_(random.direction<double, D>()) {}

  ph::point<D> next() {
    direction_ = (direction_ + 0.05 * random_.normal_vector<double, D>()).normalized();
    x_ += step_ * direction_;
    for (int k = 0; k < D; ++k) {
      if (x_[k] < -1e-3) direction_[k] = std::abs(direction_[k]);
      if (x_[k] > 1 + 1e-3) direction_[k] = -std::abs(direction_[k]);
    }
    return x_;
  }

 private:
  ph::testing::random_source& random_;
  double step_;
  ph::point<D> direction_;
  ph::point<D> x_ = ph::point<D>::Constant(0.5);
};

// The same walls, depths and normals to the last bit.
template <int D, int A, int B>
bool same(const ph::contacts<D, A>& a, const ph::contacts<D, B>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& c, const auto& e) {
    return c.wall_number == e.wall_number && c.depth == e.depth && c.normal == e.normal &&
           c.stiffness == e.stiffness && c.sensed_at == e.sensed_at && c.curvature == e.curvature &&
           c.wall_velocity == e.wall_velocity;
  });
}

}  // namespace many_shapes
