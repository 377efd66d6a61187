// Cones that are hard to project onto, and forces where rounding decides which half-spaces are active.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace adversarial {

namespace ph = passive_haptics;

// { p : B^T p <= 0 } and a unit vector f.
template <class T, int Rows, int Columns>
struct cone_problem {
  ph::matrix<T, Rows, Columns> B;
  ph::vector<T, Rows> f;
};

// The largest b . p / |b|, in long double: how far p lies outside of a half-space.
template <class T, int Rows, int Columns>
double violation(const ph::matrix<T, Rows, Columns>& B, const ph::vector<T, Rows>& p) {
  long double worst = 0;
  for (int j = 0; j < Columns; ++j) {
    const ph::vector<long double, Rows> b = B.col(j).template cast<long double>();
    const long double length = b.norm(), outside = b.dot(p.template cast<long double>());
    if (length > 0 && outside > worst * length) worst = outside / length;
  }
  return static_cast<double>(worst);
}

template <class T, int Rows, int Columns>
class cones {
 public:
  explicit cones(std::uint64_t seed) : random_(seed) {}

  // Of a condition from 1 to beyond what T resolves.
  cone_problem<T, Rows, Columns> draw() {
    const double hair = random_.positive(0.05 * eps, 1.0);
    matrix B = random_.coin() ? with_singular_values_down_to(hair) : nearly_dependent(hair);
    if (random_.coin()) {
      for (int j = 0; j < Columns; ++j) B.col(j) *= random_.wide(1e-3, 1e3);
    }
    const vector f = force(B);
    return {B.template cast<T>(), f.template cast<T>()};
  }

 private:
  static constexpr double eps = static_cast<double>(std::numeric_limits<T>::epsilon());
  static constexpr int least = std::min(Rows, Columns);
  using matrix = ph::matrix<double, Rows, Columns>;
  using vector = ph::vector<double, Rows>;

  int below(int n) { return static_cast<int>(random_.uniform(0.0, static_cast<double>(n))); }

  matrix with_singular_values_down_to(double last) {
    const auto U = random_.orthogonal_directions<Rows, least>();
    const auto V = random_.orthogonal_directions<Columns, least>();
    ph::vector<double, least> values;
    for (int i = 0; i < least; ++i) values[i] = std::pow(last, static_cast<double>(i) / (least - 1));
    return U * values.asDiagonal() * V.transpose();
  }

  // Each column may be a hair from a combination of a few before it: parallel, opposed, in a plane, ...
  matrix nearly_dependent(double hair) {
    matrix B;
    for (int j = 0; j < Columns; ++j) {
      const vector own = random_.direction<double, Rows>();
      vector b = vector::Zero();
      if (j > 0 && random_.coin()) {
        for (int k = below(3); k >= 0; --k) b += random_.uniform(-1.0, 1.0) * B.col(below(j));
      }
      B.col(j) = b.norm() > 0 ? vector(b.normalized() + hair * own) : own;
    }
    return B;
  }

  // Anywhere, or a hair from a face, an edge or the apex.
  vector force(const matrix& B) {
    vector f = random_.direction<double, Rows>();
    if (random_.coin()) return f;
    const double hair = random_.positive(0.05 * eps, 1.0);
    for (int j = 0; j < Columns; ++j) {
      if (random_.coin()) continue;
      const vector b = B.col(j).normalized();
      f -= (1 + random_.uniform(-hair, hair)) * f.dot(b) * b;
    }
    for (int j = 0; j < Columns; ++j) {
      if (random_.coin()) f += random_.uniform(0.0, hair) * B.col(j).normalized();
    }
    return f.norm() > 0 ? vector(f.normalized()) : vector(vector::Unit(0));
  }

  ph::testing::random_source random_;
};

}  // namespace adversarial
