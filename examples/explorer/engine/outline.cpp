#include "outline.hpp"

#include "settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace explorer {
namespace {

double turn(const ph::point<2>& a, const ph::point<2>& b, const ph::point<2>& c) {
  return ph::cross_in_plane(ph::point<2>(b - a), ph::point<2>(c - a));
}

bool cross(const ph::point<2>& a, const ph::point<2>& b, const ph::point<2>& c, const ph::point<2>& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

std::string text_of(const ph::point<2>& x) { return number_text(x[0]) + "," + number_text(x[1]); }

}  // namespace

outline::outline(const std::vector<ph::point<2>>& given) {
  std::vector<ph::point<2>> corners = given;
  const std::size_t n = corners.size();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) area += ph::cross_in_plane(corners[i], corners[(i + 1) % n]);
  if (!std::isfinite(area) || area == 0) refuse("scene outline", number_text(area), "corners about an area");
  if (area < 0) std::reverse(corners.begin(), corners.end());
  for (std::size_t i = 0; i < n; ++i) {
    const ph::point<2>&a = corners[i], &b = corners[(i + 1) % n];
    if (a == b) refuse("scene outline", text_of(a), "another corner than the one before");
    for (std::size_t j = i + 2; j < n; ++j)
      if (cross(a, b, corners[j], corners[(j + 1) % n]))
        refuse("scene outline", text_of(a), "sides that do not cross");
    const ph::point<2> along = ph::direction_of(ph::point<2>(b - a));
    sides_.push_back({a, along, {along[1], -along[0]}, (b - a).norm()});
  }
}

outline::result outline::nearest(const ph::point<2>& x) const {
  if (!x.allFinite()) return {std::numeric_limits<double>::quiet_NaN(), {1, 0}};
  double least = std::numeric_limits<double>::infinity();
  ph::point<2> away(1, 0), normal(1, 0);
  int winding = 0;  // > 0 inside
  for (const side& s : sides_) {
    const ph::point<2> r = x - s.start;
    const double along = std::clamp(s.along.dot(r), 0.0, s.length);
    const ph::point<2> from_side = r - along * s.along;
    const double d = from_side.norm();
    if (d < least) least = d, away = from_side, normal = s.normal;
    const double end = s.start[1] + s.length * s.along[1];
    const double left = ph::cross_in_plane(s.along, r);
    if (s.start[1] <= x[1] && end > x[1] && left > 0) ++winding;
    if (s.start[1] > x[1] && end <= x[1] && left < 0) --winding;
  }
  const double sign = winding > 0 ? -1 : 1;
  // On a side itself the difference has no direction
  if (!(least > 1e-12)) return {sign * least, normal};
  return {sign * least, ph::point<2>(sign / least * away)};
}

}  // namespace explorer
