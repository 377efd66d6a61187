/// Triangulation of polygons.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/mesh/mesh_parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace passive_haptics::detail {

using index_triangle = std::array<int, 3>;

/// Ear clipping (G. H. Meisters, Polygons have ears, American Mathematical Monthly 82 (6), 1975, pp.
/// 648-651), seen along the area vector. The triangles fill the polygon exactly.
class ear_clipping {
 public:
  ear_clipping(const std::vector<point<3>>& vertices, std::span<const int> polygon)
      : vertices_(vertices), left_(polygon.begin(), polygon.end()) {
    for (std::size_t k = 1; k + 1 < left_.size(); ++k)
      whole_ += cross<double>(at(k) - at(0), at(k + 1) - at(0));
    rounding_ = 1e-9 * whole_.squaredNorm();
  }

  /// Returns false and adds nothing if the polygon crosses itself.
  bool add_to(std::vector<index_triangle>& triangles) {
    const std::size_t before = triangles.size();
    while (left_.size() > 3) {
      if (!find_tip()) break;
      triangles.push_back({corner(tip_ + left_.size() - 1), corner(tip_), corner(tip_ + 1)});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(tip_));
      tip_ %= left_.size();
    }
    if (left_.size() == 3 && turn(at(0), at(1), at(2)) >= -rounding_ && rounding_ > 0) {
      triangles.push_back({left_[0], left_[1], left_[2]});
      return true;
    }
    triangles.resize(before);
    return false;
  }

 private:
  int corner(std::size_t i) const { return left_[i % left_.size()]; }
  const point<3>& at(std::size_t i) const { return nth(vertices_, corner(i)); }
  // The next corner to cut off: first ears, then needles (rounding), then triangles without area (open mesh).
  bool find_tip() {
    constexpr double needle = 1e-4;  // height by length
    return find_next([&] { return is_ear(needle); }) || find_next([&] { return is_ear(0); }) ||
           find_next([&] { return std::abs(turn(before_tip(), at(tip_), at(tip_ + 1))) <= rounding_; });
  }
  template <class Condition>
  bool find_next(const Condition& holds) {
    for (std::size_t passed = 0; passed < left_.size(); ++passed, tip_ = (tip_ + 1) % left_.size())
      if (holds()) return true;
    return false;
  }
  const point<3>& before_tip() const { return at(tip_ + left_.size() - 1); }
  // Twice the area of a triangle times that of the polygon; > 0 for equal orientation
  double turn(const point<3>& a, const point<3>& b, const point<3>& c) const {
    return cross<double>(b - a, c - a).dot(whole_);
  }
  // True if the tip can be cut off, and no other corner is inside that triangle or too near to its sides
  bool is_ear(double narrowest) const {
    const point<3>&a = before_tip(), &b = at(tip_), &c = at(tip_ + 1);
    const double least = narrowest * whole_.norm();
    const double ab = least * (b - a).squaredNorm(), bc = least * (c - b).squaredNorm(),
                 ca = least * (a - c).squaredNorm();
    if (!(turn(a, b, c) > std::max({rounding_, ab, bc, ca}))) return false;
    for (std::size_t k = 2; k + 1 < left_.size(); ++k) {
      const point<3>& x = at(tip_ + k);
      const bool is_inside = turn(a, b, x) >= -ab && turn(b, c, x) >= -bc && turn(c, a, x) >= -ca;
      if (is_inside && x != a && x != b && x != c) return false;
    }
    return true;
  }

  const std::vector<point<3>>& vertices_;
  std::vector<int> left_;
  std::size_t tip_ = 1;                // index in `left_`
  point<3> whole_ = point<3>::Zero();  // twice the area, along the normal
  double rounding_;
};

enum class polygon_cut {
  exact,     ///< The triangles fill the polygon.
  twisted,   ///< A quad that crosses itself in every projection, cut along the diagonal that folds it less.
  crossing,  ///< The polygon crosses itself and was not cut.
};

/// Cosine between the normals of the two triangles of a quad that is cut from corner i, 0 or 1.
inline double flatness(const std::vector<point<3>>& vertices, std::span<const int> quad, std::size_t i) {
  const auto at = [&](std::size_t k) { return nth(vertices, quad[(i + k) % 4]); };
  return normal_of<3>({at(0), at(1), at(2)}).dot(normal_of<3>({at(2), at(3), at(0)}));
}

/// Adds the triangles of a polygon. Its corners must be three or more valid indices of finite vertices.
inline polygon_cut cut_polygon(const std::vector<point<3>>& vertices, std::span<const int> polygon,
                               std::vector<index_triangle>& triangles) {
  const std::size_t n = polygon.size();
  const auto add_fan = [&](std::size_t from) {
    for (std::size_t k = from + 1; k + 1 < from + n; ++k)
      triangles.push_back({polygon[from], polygon[k % n], polygon[(k + 1) % n]});
  };
  const auto has_no_area = [&] {
    const auto at = [&](std::size_t i) { return nth(vertices, polygon[i]); };
    std::size_t k = 1;
    while (k + 1 < n && !(slenderness<3>({at(0), at(k), at(k + 1)}) > min_slenderness)) ++k;
    return k + 1 == n;
  };
  if (n > 3 && ear_clipping(vertices, polygon).add_to(triangles)) return polygon_cut::exact;
  if (n == 3 || has_no_area()) {
    add_fan(0);
    return polygon_cut::exact;
  }
  if (n > 4) return polygon_cut::crossing;
  constexpr double min_fold_cosine = -0.99985;  // cos 179 deg: lying on each other
  const double first = flatness(vertices, polygon, 0), second = flatness(vertices, polygon, 1);
  if (!(first > min_fold_cosine || second > min_fold_cosine)) return polygon_cut::crossing;
  add_fan(first >= second ? 0 : 1);
  return polygon_cut::twisted;
}

}  // namespace passive_haptics::detail
