/// @file
/// The shortest way to in front of planes.
#pragma once

#include <passive_haptics/core/linear/cone.hpp>

namespace passive_haptics {

/// The least |d| with n_i . d >= g_i for K planes.
///
/// Lawson and Hanson (Solving Least Squares Problems, 1974, ch. 23) turn it into the projection of the last
/// unit vector on a cone in one dimension more. Its multipliers mu >= 0 give the direction N mu and the
/// length mu . g / |N mu|, the dual value: never too large, and exact to second order in the error of mu.
template <class T, int D, int K>
struct least_distance {
  vector<T, K> multipliers;  ///< mu, to a common factor.
  vector<T, D> way;          ///< N mu, along d; 0 where nothing is in front of all planes.
  T residual;                ///< |projection|, in [0, 1]; 0 where nothing is.

  /// N: unit normals by columns, zero for no plane. g: how far 0 is behind each; one of them must be > 0.
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
