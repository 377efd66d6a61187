/// Shortest displacement to the front of a set of planes.
#pragma once

#include <passive_haptics/core/linear/cone.hpp>

namespace passive_haptics {

/// Shortest d with n_i . d >= g_i for K planes, by Lawson and Hanson's reduction to the projection of the
/// last unit vector on a cone in one more dimension (Solving Least Squares Problems, 1974, ch. 23). The
/// multipliers mu >= 0 give the direction N mu of d and its length mu . g / |N mu|. This dual value is a
/// lower bound, exact to second order in the error of mu.
template <class T, int D, int K>
struct least_distance {
  vector<T, K> multipliers;  ///< mu, up to a common factor.
  vector<T, D> way;          ///< N mu, parallel to d; 0 if the problem is infeasible.
  T residual;                ///< Norm of the projection, in [0, 1]; 0 if infeasible.

  /// N: unit normals by columns, or zero. g: distance of 0 behind each plane; at least one > 0.
  least_distance(const matrix<T, D, K>& N, const vector<T, K>& g) {
    constexpr T far_before = T(-1e100);  // in units of the largest g: keeps the squares finite
    matrix<T, D + 1, K> B;
    B.template topRows<D>() = N;
    B.row(D) = (g / g.maxCoeff()).cwiseMax(far_before).transpose();
    const auto nearest = project_onto_half_spaces<T, D + 1, K>(B, vector<T, D + 1>::Unit(D));
    multipliers = nearest.coefficients;
    way = N * multipliers;
    residual = nearest.point.norm();
  }
};

}  // namespace passive_haptics
