/// @file
/// The contacts of a handle whose proxy rests on facets of a mesh.
#pragma once

#include <passive_haptics/core/linear/least_distance.hpp>
#include <passive_haptics/scene/mesh/proxy.hpp>

#include <algorithm>
#include <bit>

namespace passive_haptics::detail {

/// The shares m >= 0 of the least displacement N m that brings a point in front of all of K planes. N: the
/// unit normals by columns (zero: no plane); depth: how far the point is behind each, one of them > 0. If no
/// place is in front of all planes, the shares are the depths themselves.
template <int D, int K>
vector<double, K> shares_of_displacement(const matrix<double, D, K>& N, const vector<double, K>& depth) {
  const least_distance<double, D, K> least(N, depth);
  const double square = least.way.squaredNorm();
  if (!(square > 0)) return depth.cwiseMax(0);
  return least.multipliers * (least.multipliers.dot(depth) / square);
}

/// Facets of one smooth surface make one contact, others one each.
template <int D>
class proxy_contacts {
 public:
  /// Of a handle at x whose proxy rests on these facets. cos_crease: of the largest angle within a smooth
  /// surface.
  proxy_contacts(const mesh<D>& surface, const proxy_tracker<D>& tracker, const point<D>& x,
                 double cos_crease)
      : cos_crease_(cos_crease) {
    for (int k = 0; k < tracker.facet_count; ++k) {
      const auto& f = surface[tracker.facets[static_cast<std::size_t>(k)]];
      normals_.col(k) = f.normal;
      depths_[k] = -f.height(x);
    }
  }

  /// Calls add(normal, depth) for each, at most D: as many facets hold a point.
  template <class Add>
  void add_to(Add&& add) const {
    if (!(depths_.maxCoeff() > 0)) return;
    const auto shares = shares_of_displacement<D, max_facets>(normals_, depths_);
    half_space_set left = 0;
    for (int k = 0; k < max_facets; ++k) {
      if (shares[k] > 0) left |= 1u << k;
    }
    while (left != 0) {
      const half_space_set group = smooth_group(left);
      left &= ~group;
      add_group(group, shares, add);
    }
  }

 private:
  static constexpr int max_facets = proxy_tracker<D>::max_facets;

  static bool holds(half_space_set set, int k) { return (set >> k & 1u) != 0; }

  // The first of `left` and what is connected with it by angles less than the crease angle.
  half_space_set smooth_group(half_space_set left) const {
    half_space_set group = left & (~left + 1u);
    for (half_space_set before = 0; before != group;) {
      before = group;
      for (int i = 0; i < max_facets; ++i) {
        for (int j = 0; j < max_facets; ++j) {
          if (holds(group, i) && holds(left, j) && normals_.col(i).dot(normals_.col(j)) > cos_crease_)
            group |= 1u << j;
        }
      }
    }
    return group;
  }

  // Normal and depth are those of the way to in front of the group's own planes. The depth is no more than
  // the group's share of the whole displacement: at an obtuse edge a second surface that is reached at some
  // depth of the first then begins with depth zero.
  template <class Add>
  void add_group(half_space_set group, const vector<double, max_facets>& shares, Add&& add) const {
    matrix<double, D, max_facets> N = normals_;
    vector<double, max_facets> depths = depths_;
    for (int k = 0; k < max_facets; ++k) {
      if (holds(group, k)) continue;
      N.col(k).setZero();
      depths[k] = 0;
    }
    if (!(depths.maxCoeff() > 0)) return;
    if (std::has_single_bit(group)) {
      const int only = std::countr_zero(group);
      add(point<D>(N.col(only)), std::min(depths[only], shares[only]));
      return;
    }
    const point<D> way = N * shares_of_displacement<D, max_facets>(N, depths);
    const double depth = way.norm();
    if (depth > 0) add(point<D>(way / depth), std::min(depth, (N * shares).norm()));
  }

  double cos_crease_;
  matrix<double, D, max_facets> normals_ = matrix<double, D, max_facets>::Zero();
  vector<double, max_facets> depths_ = vector<double, max_facets>::Zero();
};

}  // namespace passive_haptics::detail
