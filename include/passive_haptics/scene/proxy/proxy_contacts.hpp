/// The contacts of a handle with a proxy that rests on facets.
#pragma once

#include <passive_haptics/core/linear/least_distance.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/proxy/proxy_path.hpp>

#include <algorithm>
#include <bit>

namespace passive_haptics::detail {

/// Shares m >= 0 of the minimum displacement N m that brings a point in front of all K planes. N: unit
/// normals by column (or zero); depth: behind each plane, at least one > 0. Without a common front: the
/// depths.
template <int D, int K>
vector<double, K> shares_of_displacement(const matrix<double, D, K>& N, const vector<double, K>& depth) {
  const least_distance<double, D, K> least(N, depth);
  const double square = least.way.squaredNorm();
  if (!(square > 0)) return depth.cwiseMax(0);
  return least.multipliers * (least.multipliers.dot(depth) / square);
}

/// One contact for each smooth group of resting facets, also across adjacent surfaces.
template <class S>
class proxy_contacts {
  static constexpr int D = S::dimension;

 public:
  proxy_contacts(std::span<const placed_surface<S>> surfaces, const proxy_tracker<D>& tracker,
                 const point<D>& x) {
    const point<D> p(tracker.position.data());
    for (const facet_of_surface& f : tracker.resting()) {
      const auto* s = surface_of(surfaces, f.surface);
      const auto plane = s->plane(f.facet, p);
      const auto k = static_cast<std::size_t>(count_);
      normals_.col(count_) = plane.normal;
      depths_[count_++] = -plane.height(x);
      crease_cosines_[k] = s->surface->crease_cosine();
      numbers_[k] = f.surface;
    }
  }

  /// Calls add(normal, depth, number) for at most D contacts; number: the surface that the proxy met first.
  template <class Add>
  void add_to(Add&& add) const {
    if (!(depths_.maxCoeff() > 0)) return;
    if (count_ == 1) return add(point<D>(normals_.col(0)), depths_[0], numbers_[0]);
    const auto shares = shares_of_displacement<D, max_facets>(normals_, depths_);
    half_space_set left = 0;
    for (int k = 0; k < max_facets; ++k) {
      if (shares[k] > 0) left |= 1u << k;
    }
    while (left != 0) {
      const int first = std::countr_zero(left);
      const half_space_set group = smooth_group(first, left);
      left &= ~group;
      add_group(first, group, shares, add);
    }
  }

 private:
  static constexpr int max_facets = proxy_tracker<D>::max_facets;

  static bool holds(half_space_set set, int k) { return (set >> k & 1u) != 0; }

  bool are_smooth(int i, int j) const {
    const auto cosine = [this](int k) { return nth(crease_cosines_, k); };
    return normals_.col(i).dot(normals_.col(j)) > std::max(cosine(i), cosine(j));
  }

  // The first of `left` and all facets connected with it by angles below the crease angle.
  half_space_set smooth_group(int first, half_space_set left) const {
    half_space_set group = 1u << first;
    for (half_space_set before = 0; before != group;) {
      before = group;
      for (int i = 0; i < max_facets; ++i) {
        for (int j = 0; j < max_facets; ++j) {
          if (holds(group, i) && holds(left, j) && are_smooth(i, j)) group |= 1u << j;
        }
      }
    }
    return group;
  }

  // The shortest displacement to the front of the group's planes, limited to twice the group's share of the
  // whole displacement, so that at an obtuse edge a second surface begins with depth zero.
  template <class Add>
  void add_group(int first, half_space_set group, const vector<double, max_facets>& shares, Add&& add) const {
    matrix<double, D, max_facets> N = normals_;
    vector<double, max_facets> depths = depths_;
    for (int k = 0; k < max_facets; ++k) {
      if (holds(group, k)) continue;
      N.col(k).setZero();
      depths[k] = 0;
    }
    if (!(depths.maxCoeff() > 0)) return;
    const int number = nth(numbers_, first);
    if (group == 1u << first) {
      add(point<D>(N.col(first)), std::min(depths[first], 2 * shares[first]), number);
      return;
    }
    const point<D> way = N * shares_of_displacement<D, max_facets>(N, depths);
    const double depth = way.norm();
    if (depth > 0) add(point<D>(way / depth), std::min(depth, 2 * (N * shares).norm()), number);
  }

  int count_ = 0;
  std::array<double, std::size_t(max_facets)> crease_cosines_{};
  std::array<int, std::size_t(max_facets)> numbers_{};
  matrix<double, D, max_facets> normals_ = matrix<double, D, max_facets>::Zero();
  vector<double, max_facets> depths_ = vector<double, max_facets>::Zero();
};

}  // namespace passive_haptics::detail
