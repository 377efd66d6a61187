// Skipping by hand, for balls, upright boxes and planes in space only, without a bound of its worst
// cycle: all shapes whose boxes are within a radius are gathered from a tree whenever the handle has moved
// that far, each with the way at which it is due again.
#pragma once

#include "../../tests/unit/scene/many_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace by_hand {

namespace ph = passive_haptics;
using real3 = std::array<double, 3>;
enum class kind { ball, plane, box };

// ball: a centre, b[0] radius; plane: a normal, b[0] offset; box: a centre, b half extents
struct shape {
  kind what;
  real3 a, b;
};

inline double distance(const shape& s, const double* x) {
  if (s.what == kind::ball) {
    const double u = x[0] - s.a[0], v = x[1] - s.a[1], w = x[2] - s.a[2];
    return std::sqrt(u * u + v * v + w * w) - s.b[0];
  }
  if (s.what == kind::plane) return s.a[0] * x[0] + s.a[1] * x[1] + s.a[2] * x[2] - s.b[0];
  const double u = std::abs(x[0] - s.a[0]) - s.b[0], v = std::abs(x[1] - s.a[1]) - s.b[1],
               w = std::abs(x[2] - s.a[2]) - s.b[2];
  const double u0 = std::max(u, 0.0), v0 = std::max(v, 0.0), w0 = std::max(w, 0.0);
  return std::sqrt(u0 * u0 + v0 * v0 + w0 * w0) + std::min(std::max(u, std::max(v, w)), 0.0);
}

class skipping_scene {
 public:
  skipping_scene(std::vector<shape> all, double radius) : shapes_(std::move(all)), radius_(radius) {
    for (int i = 0; i < static_cast<int>(shapes_.size()); ++i)
      (shapes_[std::size_t(i)].what == kind::plane ? planes_ : items_).push_back(i);
    if (!items_.empty()) build(0, static_cast<int>(items_.size()));
    candidates_.reserve(4096);
  }

  // Calls touched(number, distance)
  template <class F>
  void step(const double* x, F touched) {
    if (squared(x, centre_) >= radius_ * radius_ * 0.998) gather(x);
    travelled_ += std::sqrt(squared(x, last_)) * (1 + 1e-12);
    std::copy(x, x + 3, last_.begin());
    if (travelled_ < first_due_) return;
    first_due_ = std::numeric_limits<double>::infinity();
    for (candidate& c : candidates_) {
      if (c.due <= travelled_) {
        const double d = distance(shapes_[std::size_t(c.number)], x);
        if (d <= 0) touched(c.number, d);
        c.due = travelled_ + std::max(d, 0.0);
      }
      first_due_ = std::min(first_due_, c.due);
    }
  }

 private:
  struct node {
    float lower[3], upper[3];
    int left, right;  // a leaf: -first - 1 and last
  };
  struct candidate {
    double due;
    int number;
  };

  static double squared(const double* x, const real3& y) {
    const double u = x[0] - y[0], v = x[1] - y[1], w = x[2] - y[2];
    return u * u + v * v + w * w;
  }

  int build(int first, int last) {
    const int me = static_cast<int>(nodes_.size());
    nodes_.push_back({});
    real3 lower{1e9, 1e9, 1e9}, upper{-1e9, -1e9, -1e9};
    for (int k = first; k < last; ++k) {
      const shape& s = shapes_[std::size_t(items_[std::size_t(k)])];
      for (std::size_t i = 0; i < 3; ++i) {
        const double half = s.what == kind::ball ? s.b[0] : s.b[i];
        lower[i] = std::min(lower[i], s.a[i] - half);
        upper[i] = std::max(upper[i], s.a[i] + half);
      }
    }
    std::size_t axis = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      nodes_[std::size_t(me)].lower[i] = std::nextafter(static_cast<float>(lower[i]), -1e9f);
      nodes_[std::size_t(me)].upper[i] = std::nextafter(static_cast<float>(upper[i]), 1e9f);
      if (upper[i] - lower[i] > upper[axis] - lower[axis]) axis = i;
    }
    if (last - first <= 4) {
      nodes_[std::size_t(me)].left = -first - 1;
      nodes_[std::size_t(me)].right = last;
      return me;
    }
    const int middle = (first + last) / 2;
    std::nth_element(
        items_.begin() + first, items_.begin() + middle, items_.begin() + last,
        [&](int i, int j) { return shapes_[std::size_t(i)].a[axis] < shapes_[std::size_t(j)].a[axis]; });
    const int left = build(first, middle), right = build(middle, last);
    nodes_[std::size_t(me)].left = left;
    nodes_[std::size_t(me)].right = right;
    return me;
  }

  void gather(const double* x) {
    candidates_.clear();
    for (const int i : planes_) candidates_.push_back({0, i});
    const float r = static_cast<float>(radius_) * 1.0001f;
    const float at[3] = {static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])};
    int stack[64], size = 0;
    if (!nodes_.empty()) stack[size++] = 0;
    while (size > 0) {
      const node& n = nodes_[std::size_t(stack[--size])];
      if (at[0] < n.lower[0] - r || at[0] > n.upper[0] + r || at[1] < n.lower[1] - r ||
          at[1] > n.upper[1] + r || at[2] < n.lower[2] - r || at[2] > n.upper[2] + r)
        continue;
      if (n.left < 0) {
        for (int k = -n.left - 1; k < n.right; ++k) candidates_.push_back({0, items_[std::size_t(k)]});
      } else {
        stack[size++] = n.left;
        stack[size++] = n.right;
      }
    }
    std::copy(x, x + 3, centre_.begin());
    std::copy(x, x + 3, last_.begin());
    travelled_ = first_due_ = 0;
  }

  std::vector<shape> shapes_;
  double radius_;  // [m]
  std::vector<int> items_, planes_;
  std::vector<node> nodes_;
  std::vector<candidate> candidates_;
  real3 centre_{1e9, 1e9, 1e9}, last_{};
  double travelled_ = 0, first_due_ = 0;
};

// Of the tests' generator
inline std::vector<shape> shapes_of(const many_shapes::shapes<3>& all) {
  const auto three = [](const ph::point<3>& v) { return real3{v[0], v[1], v[2]}; };
  std::vector<shape> same;
  for (const auto& [centre, radius] : all.ball_sizes)
    same.push_back({kind::ball, three(centre), {radius, 0, 0}});
  for (const auto& [centre, half] : all.box_sizes) same.push_back({kind::box, three(centre), three(half)});
  for (const auto& f : all.faces) {
    const ph::point<3> n = f.gradient(ph::point<3>::Zero());
    same.push_back({kind::plane, three(n), {-f.distance(ph::point<3>::Zero()), 0, 0}});
  }
  return same;
}

}  // namespace by_hand
