#include "scene.hpp"

#include "outline.hpp"
#include "settings.hpp"

#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <cmath>
#include <numbers>

namespace explorer {
namespace {

constexpr const char* expected_in_plane =
    "none, plane:X,Y,NX,NY, solid:X,Y,RADIUS, hollow:X,Y,RADIUS, edge:X,Y,NX,NY,NX,NY or "
    "outline:X,Y,X,Y,X,Y,...";
constexpr const char* expected_in_space =
    "none, plane:X,Y,Z,NX,NY,NZ, solid:X,Y,Z,RADIUS, hollow:X,Y,Z,RADIUS or box:X,Y,Z,X,Y,Z (two corners)";

// The kind of a scene and its numbers.
struct parsed {
  std::string kind;
  std::vector<double> numbers;
};

template <int D>
parsed parse(const std::string& text) {
  const std::string expected = D == 2 ? expected_in_plane : expected_in_space;
  const std::size_t colon = std::min(text.find(':'), text.size());
  parsed p{text.substr(0, colon), {}};
  if (p.kind == "none" && colon == text.size()) return p;
  if (colon == text.size()) refuse("scene", text, expected);
  p.numbers = numbers_of("scene " + p.kind, std::string_view(text).substr(colon + 1));
  for (const double x : p.numbers)
    if (!std::isfinite(x)) refuse("scene", text, "finite numbers");
  const std::size_t n = p.numbers.size();
  const bool fits = p.kind == "plane"                         ? n == 2 * D
                    : p.kind == "solid" || p.kind == "hollow" ? n == D + 1
                    : p.kind == "edge"                        ? D == 2 && n == 6
                    : p.kind == "outline"                     ? D == 2 && n >= 6 && n % 2 == 0
                    : p.kind == "box"                         ? D == 3 && n == 6
                                                              : false;
  if (!fits) refuse("scene", text, expected);
  return p;
}

template <int D>
ph::point<D> point_at(const parsed& p, std::size_t first) {
  return ph::point<D>(p.numbers.data() + first);
}

// The corners of an edge: its own one and two far along its faces; those of an outline.
std::vector<ph::point<2>> corners_of(const parsed& p) {
  std::vector<ph::point<2>> corners;
  if (p.kind == "outline") {
    for (std::size_t i = 0; i < p.numbers.size(); i += 2) corners.push_back(point_at<2>(p, i));
    return corners;
  }
  constexpr double far_off = 10;  // [m], beyond any handle
  const ph::point<2> corner = point_at<2>(p, 0);
  ph::point<2> a = ph::direction_of(point_at<2>(p, 2)), b = ph::direction_of(point_at<2>(p, 4));
  if (ph::cross_in_plane(a, b) < 0) std::swap(a, b);
  if (!(std::abs(ph::cross_in_plane(a, b)) > 1e-6))
    refuse("scene edge", number_text(a[0]) + "," + number_text(a[1]), "normals in two directions");
  // Counter-clockwise with the inside left of each side: along face a to the corner, then along face b
  return {corner + far_off * ph::point<2>(a[1], -a[0]), corner, corner + far_off * ph::point<2>(-b[1], b[0])};
}

void add_point(std::vector<double>& points, double x, double y, double z = 0) {
  for (const double c : {x, y, z}) points.push_back(c);
}

void add_circle(std::vector<double>& points, const ph::point<2>& centre, double radius) {
  constexpr int sides = 128;
  for (int k = 0; k < sides; ++k)
    for (const int at : {k, k + 1}) {
      const double a = 2 * std::numbers::pi * at / sides;
      add_point(points, centre[0] + radius * std::cos(a), centre[1] + radius * std::sin(a));
    }
}

// Triangles of a quadrilateral a b c d.
void add_quadrilateral(std::vector<double>& points, const ph::point<3>& a, const ph::point<3>& b,
                       const ph::point<3>& c, const ph::point<3>& d) {
  for (const ph::point<3>& x : {a, b, c, a, c, d}) add_point(points, x[0], x[1], x[2]);
}

// A plane through p with normal n, as far as `reach` about the point of it below `middle`.
void add_plane(std::vector<double>& points, const ph::point<3>& p, const ph::point<3>& normal,
               const ph::point<3>& middle, double reach) {
  const ph::point<3> n = ph::direction_of(normal), at = middle - n * n.dot(middle - p);
  const ph::point<3> aside = std::abs(n[0]) < 0.9 ? ph::point<3>(1, 0, 0) : ph::point<3>(0, 1, 0);
  const ph::point<3> u = ph::direction_of(ph::point<3>(aside - n * n.dot(aside)));
  const ph::point<3> v = ph::cross(n, u);
  add_quadrilateral(points, at - reach * u - reach * v, at + reach * u - reach * v,
                    at + reach * u + reach * v, at - reach * u + reach * v);
}

void add_ball(std::vector<double>& points, const ph::point<3>& centre, double radius) {
  constexpr int slices = 24, stacks = 12;
  const auto on = [&](int i, int j) {
    const double a = 2 * std::numbers::pi * i / slices, b = std::numbers::pi * j / stacks;
    return ph::point<3>(
        centre + radius * ph::point<3>(std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)));
  };
  for (int i = 0; i < slices; ++i)
    for (int j = 0; j < stacks; ++j)
      add_quadrilateral(points, on(i, j), on(i + 1, j), on(i + 1, j + 1), on(i, j + 1));
}

void add_box(std::vector<double>& points, const ph::point<3>& low, const ph::point<3>& high) {
  const auto corner = [&](int bits) {
    return ph::point<3>((bits & 1) != 0 ? high[0] : low[0], (bits & 2) != 0 ? high[1] : low[1],
                        (bits & 4) != 0 ? high[2] : low[2]);
  };
  constexpr int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                               {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& f : faces)
    add_quadrilateral(points, corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3]));
}

}  // namespace

template <int D>
std::optional<any_shape<D>> shape_of(const std::string& text) {
  const parsed p = parse<D>(text);
  if (p.kind == "none") return std::nullopt;
  if (p.kind == "plane")
    return any_shape<D>(ph::half_space<D>(point_at<D>(p, 0), point_at<D>(p, std::size_t(D))));
  if (p.kind == "solid" || p.kind == "hollow")
    return any_shape<D>(ph::ball<D>(point_at<D>(p, 0), p.numbers.back(),
                                    p.kind == "solid" ? ph::filling::solid : ph::filling::hollow));
  if constexpr (D == 2) {
    return any_shape<2>(outline(corners_of(p)));
  } else {
    return any_shape<3>(ph::box<3>(point_at<3>(p, 0), point_at<3>(p, 3)));
  }
}
template std::optional<any_shape<2>> shape_of<2>(const std::string& text);
template std::optional<any_shape<3>> shape_of<3>(const std::string& text);

template <int D>
std::vector<double> surface_of(const std::string& text, const ph::point<2>& low, const ph::point<2>& high) {
  const parsed p = parse<D>(text);
  std::vector<double> points;
  if (p.kind == "none") return points;
  const double reach = (high - low).norm();
  if constexpr (D == 2) {
    if (p.kind == "plane") {
      const ph::point<2> n = ph::direction_of(point_at<2>(p, 2)), along(-n[1], n[0]);
      const ph::point<2> middle = (low + high) / 2, at = middle - n * n.dot(middle - point_at<2>(p, 0));
      for (const double way : {-reach, reach})
        add_point(points, at[0] + way * along[0], at[1] + way * along[1]);
    } else if (p.kind == "solid" || p.kind == "hollow") {
      add_circle(points, point_at<2>(p, 0), p.numbers.back());
    } else {
      const auto corners = corners_of(p);
      const std::size_t sides =
          p.kind == "edge" ? 2 : corners.size();  // the third side of an edge is far off
      for (std::size_t i = 0; i < sides; ++i)
        for (const auto& c : {corners[i], corners[(i + 1) % corners.size()]}) add_point(points, c[0], c[1]);
    }
  } else {
    const ph::point<3> middle((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0);
    if (p.kind == "plane") add_plane(points, point_at<3>(p, 0), point_at<3>(p, 3), middle, reach / 2);
    else if (p.kind == "box") add_box(points, point_at<3>(p, 0), point_at<3>(p, 3));
    else add_ball(points, point_at<3>(p, 0), p.numbers.back());
  }
  return points;
}
template std::vector<double> surface_of<2>(const std::string&, const ph::point<2>&, const ph::point<2>&);
template std::vector<double> surface_of<3>(const std::string&, const ph::point<2>&, const ph::point<2>&);

}  // namespace explorer
