#include "scene.hpp"

#include "settings.hpp"

#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace explorer {
namespace {

constexpr const char* expected_in_plane =
    "none, plane:X,Y,NX,NY, solid:X,Y,RADIUS, hollow:X,Y,RADIUS or outline:X,Y,X,Y,X,Y,...";
constexpr const char* expected_in_space =
    "none, plane:X,Y,Z,NX,NY,NZ, solid:X,Y,Z,RADIUS or hollow:X,Y,Z,RADIUS";

bool fits(const std::string& kind, std::size_t count, std::size_t d) {
  if (kind == "plane") return count == 2 * d;
  if (kind == "solid" || kind == "hollow") return count == d + 1;
  return d == 2 && kind == "outline" && count >= 6 && count % 2 == 0;
}

// A polygon with these corners, either way round, solid inside.
ph::mesh_solid<2> polygon_of(const std::vector<double>& x) {
  const int n = static_cast<int>(x.size() / 2);
  ph::mesh_parameters<2> sides;
  for (int i = 0; i < n; ++i) {
    sides.vertices.emplace_back(x.data() + 2 * i);
    sides.facets.push_back({i, (i + 1) % n});
  }
  if (ph::mesh<2>(sides).content() < 0)
    for (auto& side : sides.facets) std::swap(side[0], side[1]);
  return ph::mesh_solid<2>(ph::mesh<2>(sides));
}

template <int D>
any_shape<D> shape_of(const std::string& kind, const std::vector<double>& x) {
  using point = ph::point<D>;
  if (kind == "plane") return any_shape<D>(ph::half_space<D>(point(x.data()), point(x.data() + D)));
  if constexpr (D == 2)
    if (kind == "outline") return any_shape<2>(polygon_of(x));
  const auto inside = kind == "solid" ? ph::filling::solid : ph::filling::hollow;
  return any_shape<D>(ph::ball<D>(point(x.data()), x.back(), inside));
}

void add(std::vector<double>& points, std::initializer_list<place> all) {
  for (const place& x : all) points.insert(points.end(), x.data(), x.data() + 3);
}

void add_quadrilateral(std::vector<double>& points, const place& a, const place& b, const place& c,
                       const place& d) {
  add(points, {a, b, c, a, c, d});
}

// A plane through p with normal n, as far as `reach` about the point of it next to `middle`.
void add_plane(std::vector<double>& points, const place& p, const place& normal, const place& middle,
               double reach) {
  const place n = ph::direction_of(normal), at = middle - n * n.dot(middle - p);
  const place aside = std::abs(n[0]) < 0.9 ? place(1, 0, 0) : place(0, 1, 0);
  const place u = reach * ph::direction_of(place(aside - n * n.dot(aside))), v = ph::cross(n, u);
  add_quadrilateral(points, at - u - v, at + u - v, at + u + v, at - u + v);
}

place on_circle(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

void add_ball(std::vector<double>& points, const place& centre, double radius) {
  constexpr int slices = 24, stacks = 12;
  const auto on = [&](int i, int j) {
    const double b = std::numbers::pi * j / stacks;
    return place(centre + radius * (std::sin(b) * on_circle(2 * std::numbers::pi * i / slices) +
                                    place(0, 0, std::cos(b))));
  };
  for (int i = 0; i < slices; ++i)
    for (int j = 0; j < stacks; ++j)
      add_quadrilateral(points, on(i, j), on(i + 1, j), on(i + 1, j + 1), on(i, j + 1));
}

}  // namespace

wall_shape::wall_shape(const std::string& text, int dimension) : kind_(text.substr(0, text.find(':'))) {
  if (text == "none") return;
  const std::string expected = dimension == 2 ? expected_in_plane : expected_in_space;
  if (kind_ == text) refuse("scene", text, expected);
  numbers_ = numbers_of("scene " + kind_, std::string_view(text).substr(kind_.size() + 1));
  for (const double x : numbers_)
    if (!std::isfinite(x)) refuse("scene", text, "finite numbers");
  if (!fits(kind_, numbers_.size(), std::size_t(dimension))) refuse("scene", text, expected);
  if (dimension == 2) shape_ = shape_of<2>(kind_, numbers_);
  else shape_ = shape_of<3>(kind_, numbers_);
}

double wall_shape::distance(const place& x) const {
  if (const auto* flat = shape<2>()) return flat->distance(x.head<2>());
  const auto* solid = shape<3>();
  return solid == nullptr ? std::numeric_limits<double>::infinity() : solid->distance(x);
}

place wall_shape::gradient(const place& x) const {
  if (const auto* flat = shape<2>()) {
    const ph::point<2> n = flat->gradient(x.head<2>());
    return {n[0], n[1], 0};
  }
  const auto* solid = shape<3>();
  return solid == nullptr ? place(place::Zero()) : place(solid->gradient(x));
}

std::vector<double> wall_shape::surface(const place& low, const place& high) const {
  std::vector<double> points;
  if (!*this) return points;
  const double reach = (high - low).head<2>().norm();
  const bool is_space = shape<3>() != nullptr, is_plane = kind_ == "plane";
  const std::size_t d = is_space ? 3 : 2;
  const auto at = [&](std::size_t k) {
    return place(numbers_[k], numbers_[k + 1], is_space ? numbers_[k + 2] : 0.0);
  };
  const place middle((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0), centre = at(0);
  if (is_space) {
    if (is_plane) add_plane(points, centre, at(d), middle, reach / 2);
    else add_ball(points, centre, numbers_.back());
  } else if (is_plane) {
    const place n = ph::direction_of(at(d)), on = middle - n * n.dot(middle - centre);
    const place along = reach * place(-n[1], n[0], 0);
    add(points, {on - along, on + along});
  } else if (kind_ == "outline") {
    for (std::size_t i = 0; i < numbers_.size(); i += 2) add(points, {at(i), at((i + 2) % numbers_.size())});
  } else {
    constexpr int sides = 128;
    const auto on = [&](int k) {
      return place(centre + numbers_.back() * on_circle(2 * std::numbers::pi * k / sides));
    };
    for (int k = 0; k < sides; ++k) add(points, {on(k), on(k + 1)});
  }
  return points;
}

}  // namespace explorer
