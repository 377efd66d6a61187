// Shapes as a user of the library would write them: a class with a distance and a gradient, nothing else.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <cmath>

namespace custom {
namespace ph = passive_haptics;

// A ring of radius R and thickness 2 r about the z axis.
class torus {
 public:
  static constexpr int dimension = 3;
  torus(double ring_radius, double tube_radius) : ring_(ring_radius), tube_(tube_radius) {}
  double distance(const ph::point<3>& x) const { return from_ring(x).norm() - tube_; }
  ph::point<3> gradient(const ph::point<3>& x) const { return from_ring(x).normalized(); }

 private:
  ph::point<3> from_ring(const ph::point<3>& x) const {
    const double rho = std::hypot(x.x(), x.y());
    return {x.x() * (1 - ring_ / rho), x.y() * (1 - ring_ / rho), x.z()};
  }
  double ring_, tube_;
};

// Two shapes as one wall; the nearer one is felt.
template <class A, class B>
class either {
 public:
  static constexpr int dimension = A::dimension;
  either(A a, B b) : a_(a), b_(b) {}
  double distance(const ph::point<dimension>& x) const { return std::fmin(a_.distance(x), b_.distance(x)); }
  ph::point<dimension> gradient(const ph::point<dimension>& x) const {
    return a_.distance(x) < b_.distance(x) ? a_.gradient(x) : b_.gradient(x);
  }

 private:
  A a_;
  B b_;
};

}  // namespace custom
